#pragma once

#include <filesystem>
#include <optional>

namespace mixcmp::inline common {

/// Where this program keeps what later runs may use: $XDG_CACHE_HOME/mixcmp, $HOME/.cache/mixcmp
/// where that is not set. None where neither is an absolute path (XDG Base Directory
/// Specification).
std::optional<std::filesystem::path> cache_folder();

}  // namespace mixcmp::inline common
