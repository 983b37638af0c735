#pragma once

#include <filesystem>
#include <utility>
#include <vector>

#include "model/base/common/result.hpp"

namespace mixcmp::inline common {

/// Files of an earlier run that new results make stale. They are moved aside, and come back with
/// the object's end unless they are removed for good.
class StaleFiles {
public:
  StaleFiles() = default;
  StaleFiles(StaleFiles&& other) noexcept = default;
  StaleFiles(const StaleFiles&) = delete;
  StaleFiles& operator=(const StaleFiles&) = delete;
  StaleFiles& operator=(StaleFiles&&) = delete;
  ~StaleFiles();

  /// Removes the files that killed runs set aside in a folder that this run has locked.
  static void clear_abandoned(const std::filesystem::path& folder);

  /// All files must be of one folder, which this run has locked.
  Result<Done> set_aside(const std::filesystem::path& file);
  void remove();

private:
  std::vector<std::pair<std::filesystem::path, std::filesystem::path>> moved_;  ///< from, to
};

}  // namespace mixcmp::inline common
