#pragma once

#include <filesystem>
#include <span>

#include "model/comparison/data/column_names.hpp"

namespace mixcmp::data {

/// Reads the wanted columns, by name or number, of a comma-separated file whose first record names
/// its columns; quotes are as in RFC 4180. It is an error if a column that is wanted by number has
/// a number as its name: then the file has no header, and its first row would be lost. Other
/// columns are ignored. Empty lines are skipped.
Result<Table> read_csv(const std::filesystem::path& path, FloatFormat format,
                       std::span<const WantedColumn> wanted);

}  // namespace mixcmp::data
