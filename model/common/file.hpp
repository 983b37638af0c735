#pragma once

#include <filesystem>
#include <string>

#include "model/common/result.hpp"

namespace mixcmp::model {

Result<Done> check_readable(const std::filesystem::path& path);

/// All bytes of a regular file.
Result<std::string> read_file(const std::filesystem::path& path);

}  // namespace mixcmp::model
