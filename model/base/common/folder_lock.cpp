#include "model/base/common/folder_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

#include "model/base/common/output_file.hpp"

namespace mixcmp::inline common {
namespace {

namespace fs = std::filesystem;

/// Locks the folder, waiting if another run holds it. Returns 0 or an errno.
int lock(int descriptor, const fs::path& folder, const Waiting& waiting) {
  if (flock(descriptor, LOCK_EX | LOCK_NB) == 0) return 0;
  if (errno != EWOULDBLOCK) return errno;
  if (waiting) waiting(folder);
  while (flock(descriptor, LOCK_EX) != 0) {
    if (errno != EINTR) return errno;
  }
  return 0;
}

}  // namespace

Result<Done> make_writable_folder(const fs::path& folder) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed) return cannot_write(folder, failed.value());
  if (access(folder.c_str(), W_OK | X_OK) != 0) return cannot_write(folder, errno);
  return Done{};
}

Result<FolderLock> FolderLock::take(const fs::path& folder, const Waiting& waiting) {
  while (true) {
    MIXCMP_DO(make_writable_folder(folder));
    Descriptor opened(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (opened.get() < 0) return cannot_write(folder, errno);
    if (const int failure = lock(opened.get(), folder, waiting); failure != 0) {
      return cannot_write(folder, failure);
    }
    // The run that held the folder may have removed or replaced it.
    struct stat locked = {}, now = {};
    if (fstat(opened.get(), &locked) != 0) return cannot_write(folder, errno);
    const bool there = stat(folder.c_str(), &now) == 0;
    if (!there && errno != ENOENT) return cannot_write(folder, errno);
    if (there && locked.st_ino == now.st_ino && locked.st_dev == now.st_dev) {
      return FolderLock(std::move(opened));
    }
  }
}

}  // namespace mixcmp::inline common
