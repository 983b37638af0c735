#pragma once

#include <filesystem>
#include <string>

#include "model/common/result.hpp"

namespace mixcmp::model {

/// Whether a file or a folder has this path; no if the path cannot be followed (a name too long, a
/// folder that may not be searched).
bool path_exists(const std::filesystem::path& path);

Result<Done> check_readable(const std::filesystem::path& path);

/// Reads all bytes of a regular file.
Result<std::string> read_file(const std::filesystem::path& path);

}  // namespace mixcmp::model
