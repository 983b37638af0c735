#pragma once

#include <filesystem>
#include <functional>

#include "model/base/common/descriptor.hpp"
#include "model/base/common/result.hpp"

namespace mixcmp::inline common {

/// Called when a run has to wait for a folder that another run holds.
using Waiting = std::function<void(const std::filesystem::path& folder)>;

/// Holds a work folder that runs share. A second run that wants it waits until the first one ends,
/// in whatever way. The lock is on the folder itself (flock); no file is left behind.
class FolderLock {
public:
  /// Makes the folder if there is none. `waiting` is called once if another run holds it.
  static Result<FolderLock> take(const std::filesystem::path& folder, const Waiting& waiting = {});

private:
  explicit FolderLock(Descriptor folder) : folder_(std::move(folder)) {}

  Descriptor folder_;
};

/// Makes the folder and its parents if they are missing. An error names the folder and the reason
/// why nothing can be written into it.
Result<Done> make_writable_folder(const std::filesystem::path& folder);

}  // namespace mixcmp::inline common
