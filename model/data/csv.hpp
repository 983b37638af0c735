#pragma once

#include <filesystem>
#include <span>

#include "model/data/column_names.hpp"

namespace mixcmp::model {

/// The wanted columns, by name or number, of a comma-separated file whose first record names its
/// columns; quotes as in RFC 4180. Other columns are not looked at. Empty lines are skipped.
Result<Table> read_csv(const std::filesystem::path& path, FloatFormat format,
                       std::span<const WantedColumn> wanted);

}  // namespace mixcmp::model
