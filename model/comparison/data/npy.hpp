#pragma once

#include <filesystem>
#include <span>

#include "model/comparison/data/column_names.hpp"

namespace mixcmp::data {

/// Reads the wanted columns of a NumPy .npy file (versions 1 to 3): floats of 2, 4 or 8 bytes and
/// integers of 1, 2, 4 or 8, in either byte order. A plain array must be two-dimensional (C or
/// Fortran order), and its columns are wanted by number. The columns of a structured
/// one-dimensional array are its fields, by name or number; nameless padding fields are not
/// counted. Other columns are ignored. Each value is rounded once to `format`.
Result<Table> read_npy(const std::filesystem::path& path, FloatFormat format,
                       std::span<const WantedColumn> wanted);

}  // namespace mixcmp::data
