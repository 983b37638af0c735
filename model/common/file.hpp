#pragma once

#include <filesystem>
#include <string>

#include "model/common/result.hpp"

namespace mixcmp::model {

Result<Done> check_readable(const std::filesystem::path& path);

/// Reads all bytes of a regular file.
Result<std::string> read_file(const std::filesystem::path& path);

}  // namespace mixcmp::model
