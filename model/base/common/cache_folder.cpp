#include "model/base/common/cache_folder.hpp"

#include <cstdlib>

namespace mixcmp::inline common {

std::optional<std::filesystem::path> cache_folder() {
  const auto variable = [](const char* name) {
    const char* value = std::getenv(name);
    return std::filesystem::path(value == nullptr ? "" : value);
  };
  // The specification says to ignore a relative $XDG_CACHE_HOME.
  std::filesystem::path cache = variable("XDG_CACHE_HOME");
  if (!cache.is_absolute() && !variable("HOME").empty()) cache = variable("HOME") / ".cache";
  if (!cache.is_absolute()) return std::nullopt;
  return cache / "mixcmp";
}

}  // namespace mixcmp::inline common
