#pragma once

#include <filesystem>
#include <string>

#include "model/common/result.hpp"

namespace mixcmp::model {

Result<Done> check_readable(const std::filesystem::path& path);

/// All bytes of a regular file.
Result<std::string> read_file(const std::filesystem::path& path);

/// Writes where the path leads, a pipe or a device too. What is interrupted leaves half of a file:
/// for folders that nobody else reads.
Result<Done> write_in_place(const std::filesystem::path& path, const std::string& text);

}  // namespace mixcmp::model
