#pragma once

#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include "model/base/common/result.hpp"

namespace mixcmp::inline common {

/// The entries of a folder, in no order. A failure sets `failed` and leaves out all later entries.
std::vector<std::filesystem::directory_entry> entries_of(const std::filesystem::path& folder,
                                                         std::error_code& failed);

/// Whether a file or a folder has this path; false if the path cannot be followed (a name too long,
/// a folder that may not be searched).
bool path_exists(const std::filesystem::path& path);

Result<Done> check_readable(const std::filesystem::path& path);

/// Reads all bytes of a regular file; an error if that fails anywhere.
Result<std::string> read_file(const std::filesystem::path& path);

}  // namespace mixcmp::inline common
