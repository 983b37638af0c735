#include "model/base/common/stale_files.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <string_view>
#include <system_error>

#include "model/base/common/abandoned.hpp"

namespace mixcmp::inline common {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view prefix = ".mixcmp-stale-";

}  // namespace

StaleFiles::~StaleFiles() {
  std::error_code ignored;
  for (const auto& [from, to] : moved_) fs::rename(to, from, ignored);
}

void StaleFiles::clear_abandoned(const fs::path& folder) {
  remove_abandoned(folder, prefix);
}

Result<Done> StaleFiles::set_aside(const fs::path& file) {
  const fs::path aside =
      file.parent_path() / fmt::format("{}{}-{}", prefix, getpid(), file.filename().string());
  std::error_code failed;
  fs::rename(file, aside, failed);
  if (failed) {
    return Error{.file = file.string(),
                 .message = "is of an earlier run, and cannot be removed: " + failed.message()};
  }
  moved_.emplace_back(file, aside);
  return Done{};
}

void StaleFiles::remove() {
  std::error_code ignored;
  for (const auto& [from, to] : moved_) fs::remove(to, ignored);
  moved_.clear();
}

}  // namespace mixcmp::inline common
