#pragma once

#include <filesystem>
#include <span>

#include "model/data/column_names.hpp"

namespace mixcmp::model {

/// The wanted columns of a NumPy .npy file (versions 1 to 3): floats of 2, 4 or 8 bytes and
/// integers of 1 to 8, either byte order. A plain array must be two-dimensional (C or Fortran
/// order), and all its columns go by number; those of a structured one-dimensional array are its
/// fields, by name or number, not counting the nameless ones that NumPy pads with. Other columns
/// are not looked at. Each value is rounded once to `format`.
Result<Table> read_npy(const std::filesystem::path& path, FloatFormat format,
                       std::span<const WantedColumn> wanted);

}  // namespace mixcmp::model
