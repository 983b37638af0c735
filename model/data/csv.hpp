#pragma once

#include <filesystem>
#include <span>

#include "model/data/column_names.hpp"

namespace mixcmp::model {

/// The wanted columns, by name or number, of a comma-separated file whose first record names its
/// columns; quotes as in RFC 4180. A column that is wanted by number may not be headed by one: that
/// file has no header, and its first row would be lost. Other columns are not looked at. Empty
/// lines are skipped.
Result<Table> read_csv(const std::filesystem::path& path, FloatFormat format,
                       std::span<const WantedColumn> wanted);

}  // namespace mixcmp::model
