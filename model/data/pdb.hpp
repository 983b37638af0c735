#pragma once

#include <filesystem>

#include "model/data/table.hpp"

namespace mixcmp::model {

/// Atoms of a Protein Data Bank file as spheres: columns cx, cy, cz, r in angstrom, r the van der
/// Waals radius; labels as "A 151 MET CA". ATOM and HETATM records of the first MODEL, waters
/// included. Of an atom's alternate locations the one with the highest occupancy counts, the first
/// of equals.
Result<Table> read_pdb(const std::filesystem::path& path, FloatFormat format);

}  // namespace mixcmp::model
