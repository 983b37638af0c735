#pragma once

#include <filesystem>

#include "model/comparison/data/table.hpp"

namespace mixcmp::data {

/// Reads the atoms of a Protein Data Bank file as spheres: columns cx, cy, cz, r in angstrom, where
/// r is the van der Waals radius. Labels are like "A 151 MET CA". It reads the ATOM and HETATM
/// records of the first MODEL, waters included. If an atom has alternate locations, the first one
/// with the highest occupancy counts.
Result<Table> read_pdb(const std::filesystem::path& path, FloatFormat format);

}  // namespace mixcmp::data
