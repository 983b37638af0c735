#include "model/base/common/output_file.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <optional>
#include <utility>

#include "model/base/common/abandoned.hpp"
#include "model/base/common/descriptor.hpp"
#include "model/base/common/file.hpp"
#include "model/base/common/folder_lock.hpp"

namespace mixcmp::inline common {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t buffer_bytes = 1 << 16;
constexpr std::string_view unfinished_prefix = ".mixcmp-unfinished-";

/// The descriptor that a name such as /dev/stdout or /dev/fd/3 stands for; none for other names.
std::optional<int> named_descriptor(const fs::path& path) {
  if (path == "/dev/stdout") return STDOUT_FILENO;
  if (path == "/dev/stderr") return STDERR_FILENO;
  const fs::path folder = path.parent_path();
  if (folder != "/dev/fd" && folder != "/proc/self/fd") return std::nullopt;
  const std::string name = path.filename().string();
  int descriptor = -1;
  const auto [end, status] = std::from_chars(name.data(), name.data() + name.size(), descriptor);
  if (status != std::errc{} || end != name.data() + name.size()) return std::nullopt;
  return descriptor;
}

/// Standard output or standard error, if `path` leads to the same file or pipe. Replacing that file
/// would lose all later text.
std::optional<int> standard_stream(const fs::path& path) {
  struct stat file = {};
  if (stat(path.c_str(), &file) != 0) return std::nullopt;
  for (const int descriptor : {STDOUT_FILENO, STDERR_FILENO}) {
    struct stat open = {};
    if (fstat(descriptor, &open) != 0) continue;
    if (open.st_dev == file.st_dev && open.st_ino == file.st_ino) return descriptor;
  }
  return std::nullopt;
}

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

/// A new file that no other run has, locked as long as it is open. An unlocked one was left by a
/// killed run.
Result<std::pair<fs::path, Descriptor>> create_unfinished(const fs::path& path) {
  const fs::path folder = folder_of(path);
  // Each name is used once. If locks fail, a second file of the same name would replace the first
  // one as abandoned.
  static std::atomic<int> number = 0;
  for (;;) {
    const fs::path name = folder / fmt::format("{}{}-{}", unfinished_prefix, getpid(), number++);
    Descriptor file(::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (file.get() < 0 && errno != EEXIST) return cannot_write(path, errno);
    if (file.get() >= 0 && try_lock_new(file.get())) return std::pair(name, std::move(file));
  }
}

bool rename_path(const fs::path& from, const fs::path& to, unsigned int flags) {
  return renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), flags) == 0;
}

/// Moves a file to an unused path, also on file systems without RENAME_NOREPLACE.
bool move_to_free_path(const fs::path& from, const fs::path& to) {
  if (rename_path(from, to, RENAME_NOREPLACE)) return true;
  if (errno != EINVAL) return false;
  return link(from.c_str(), to.c_str()) == 0 && unlink(from.c_str()) == 0;
}

/// A replaced file keeps its owner and its permissions.
void keep_attributes(int descriptor, const struct stat& before) {
  if (fchown(descriptor, before.st_uid, before.st_gid) != 0 && errno != EPERM) return;
  fchmod(descriptor, before.st_mode & 07777);
}

}  // namespace

Error cannot_write(const fs::path& path, int failure) {
  return {.file = path.string(),
          .message = fmt::format("cannot be written: {}", std::strerror(failure))};
}

Result<fs::path> follow_links(fs::path path) {
  constexpr int most_links = 40;  // as in Linux
  std::error_code failed;
  for (int links = 0; fs::is_symlink(fs::symlink_status(path, failed)); ++links) {
    if (links == most_links) return cannot_write(path, ELOOP);
    const fs::path target = fs::read_symlink(path, failed);
    if (failed) return cannot_write(path, failed.value());
    path = target.is_absolute() ? target : path.parent_path() / target;
  }
  return path;
}

Result<OutputFile> OutputFile::open(const fs::path& requested) {
  auto named = named_descriptor(requested);
  if (!named) named = standard_stream(requested);
  if (named) {
    Descriptor file(fcntl(*named, F_DUPFD_CLOEXEC, STDERR_FILENO + 1));
    if (file.get() < 0) return cannot_write(requested, errno);
    return OutputFile(requested, requested, std::move(file));
  }
  MIXCMP_TRY(path, follow_links(requested));
  struct stat before = {};
  const bool exists = stat(path.c_str(), &before) == 0;
  if (!exists && errno != ENOENT) return cannot_write(requested, errno);
  if (exists && S_ISDIR(before.st_mode)) return cannot_write(requested, EISDIR);
  if (exists && access(path.c_str(), W_OK) != 0) return cannot_write(requested, errno);
  if (exists && !S_ISREG(before.st_mode)) {
    Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY));
    if (file.get() < 0) return cannot_write(requested, errno);
    return OutputFile(path, path, std::move(file));
  }
  remove_abandoned(folder_of(path), unfinished_prefix);
  MIXCMP_TRY(created, create_unfinished(path));
  if (exists) keep_attributes(created.second.get(), before);
  return OutputFile(path, created.first, std::move(created.second));
}

OutputFile::~OutputFile() {
  std::error_code ignored;
  if (file_.get() >= 0 && unfinished_ != path_) fs::remove(unfinished_, ignored);
}

void OutputFile::write(std::string_view text) {
  buffer_ += text;
  if (buffer_.size() >= buffer_bytes) flush();
}

void OutputFile::flush() {
  std::string_view rest = buffer_;
  while (failure_ == 0 && !rest.empty()) {
    const ssize_t written = ::write(file_.get(), rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) failure_ = errno;
    if (written > 0) rest.remove_prefix(static_cast<std::size_t>(written));
  }
  buffer_.clear();
}

Result<Done> OutputFile::write_out() {
  flush();
  if (failure_ != 0) return cannot_write(path_, failure_);
  return Done{};
}

Result<Done> OutputFile::commit() {
  return commit_with([](const fs::path& from, const fs::path& to) {
    return rename(from.c_str(), to.c_str()) == 0;
  });
}

Result<Done> OutputFile::commit_new() {
  return commit_with(move_to_free_path);
}

Result<Done> OutputFile::commit_with(Move move) {
  MIXCMP_CHECK(file_.get() >= 0);
  flush();
  // The lock on the unfinished file is held until it has its final name.
  if (failure_ == 0 && unfinished_ != path_ && !move(unfinished_, path_)) {
    failure_ = errno;
  }
  if (failure_ != 0) return cannot_write(path_, failure_);
  if (close(file_.release()) != 0) return cannot_write(path_, errno);
  return Done{};
}

Result<Done> put_in_place(const fs::path& finished, const fs::path& requested) {
  MIXCMP_TRY(path, follow_links(requested));
  struct stat before = {};
  if (stat(path.c_str(), &before) == 0) {
    if (access(path.c_str(), W_OK) != 0) return cannot_write(requested, errno);
    const Descriptor file(::open(finished.c_str(), O_RDONLY | O_CLOEXEC));
    keep_attributes(file.get(), before);
  }
  if (rename(finished.c_str(), path.c_str()) != 0) return cannot_write(requested, errno);
  return Done{};
}

Result<Done> put_folder_in_place(const fs::path& finished, const fs::path& path) {
  // Another run may make or remove the folder at the same time. Then this is tried again.
  while (true) {
    if (rename_path(finished, path, RENAME_EXCHANGE)) return Done{};
    if (errno != ENOENT) return cannot_write(path, errno);
    if (rename_path(finished, path, RENAME_NOREPLACE)) return Done{};
    if (errno != EEXIST) return cannot_write(path, errno);
  }
}

Result<Done> copy_folder(const fs::path& folder, const fs::path& copy) {
  MIXCMP_DO(make_writable_folder(copy));
  std::error_code failed;
  std::error_code unknown;
  for (const fs::directory_entry& entry : entries_of(folder, failed)) {
    const fs::path own = copy / entry.path().filename();
    if (entry.is_directory(unknown)) {
      MIXCMP_DO(copy_folder(entry.path(), own));
      continue;
    }
    MIXCMP_TRY(text, read_file(entry.path()));
    MIXCMP_DO(write_file(own, text));
  }
  if (failed) return cannot_write(copy, failed.value());
  return Done{};
}

Result<Done> write_kept_file(const fs::path& path, std::string_view text) {
  std::error_code failed;
  const fs::file_status before = fs::symlink_status(path, failed);
  if (fs::is_symlink(before) || fs::is_fifo(before)) fs::remove(path, failed);
  return write_file(path, text);
}

Result<Done> write_file(const fs::path& path, std::string_view text) {
  MIXCMP_TRY(file, OutputFile::open(path));
  file.write(text);
  return file.commit();
}

Result<Done> write_new_file(const fs::path& path, std::string_view text) {
  MIXCMP_TRY(file, OutputFile::open(path));
  file.write(text);
  return file.commit_new();
}

}  // namespace mixcmp::inline common
