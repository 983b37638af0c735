#pragma once

#include <filesystem>
#include <string>

#include "model/base/common/descriptor.hpp"
#include "model/base/common/result.hpp"

namespace mixcmp::inline common {

/// A new, empty folder for this process only, removed with this object. Folders that killed runs
/// left under the same stem are removed by the next run that makes one there.
class ScratchFolder {
public:
  /// Makes the folder in $TMPDIR, or in /tmp if that is not set.
  static Result<ScratchFolder> make();
  /// Makes the folder "PARENT/.mixcmp-STEM.XXXXXX".
  static Result<ScratchFolder> make_in(const std::filesystem::path& parent,
                                       const std::string& stem);
  ScratchFolder(ScratchFolder&& other) noexcept = default;
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ScratchFolder& operator=(ScratchFolder&&) = delete;
  ~ScratchFolder();

  const std::filesystem::path& path() const { return path_; }

  /// Keeps the folder for the user, until the next run removes it.
  void keep() { kept_ = true; }
  /// Keeps the folder if there is one and the error names a file in it.
  void keep_for(const Error& error);

private:
  ScratchFolder(std::filesystem::path path, Descriptor lock)
      : path_(std::move(path)), lock_(std::move(lock)) {}

  std::filesystem::path path_;
  Descriptor lock_;  ///< open and locked while the folder is ours; none: moved from
  bool kept_ = false;
};

}  // namespace mixcmp::inline common
