#pragma once

#include <filesystem>
#include <span>

#include "model/data/table.hpp"

namespace mixcmp::model {

/// The named columns of a NumPy .npy file (versions 1 to 3): floats of 2, 4 or 8 bytes and integers
/// of 1 to 8, either byte order. A plain array must be two-dimensional (C or Fortran order), its
/// columns being `columns` in order; a structured one-dimensional array is read by field name, and
/// fields of other names are not looked at. Each value is rounded once to `format`.
Result<Table> read_npy(const std::filesystem::path& path, FloatFormat format,
                       std::span<const std::string> columns);

}  // namespace mixcmp::model
