#pragma once

#include <filesystem>
#include <optional>

namespace mixcmp::inline common {

/// The folder for results that later runs may use: $XDG_CACHE_HOME/mixcmp, or $HOME/.cache/mixcmp
/// if $XDG_CACHE_HOME is not an absolute path. None if neither is (XDG Base Directory
/// Specification).
std::optional<std::filesystem::path> cache_folder();

}  // namespace mixcmp::inline common
