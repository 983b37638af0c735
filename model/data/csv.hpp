#pragma once

#include <filesystem>
#include <span>

#include "model/data/table.hpp"

namespace mixcmp::model {

/// The named columns of a comma-separated file whose first record names its columns; quotes as in
/// RFC 4180. Other columns are not looked at. Empty lines are skipped.
Result<Table> read_csv(const std::filesystem::path& path, FloatFormat format,
                       std::span<const std::string> columns);

}  // namespace mixcmp::model
