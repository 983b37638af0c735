#include "model/base/common/scratch_folder.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <stdlib.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "model/base/common/abandoned.hpp"

namespace mixcmp::inline common {
namespace {

namespace fs = std::filesystem;

Error cannot_make(const fs::path& parent) {
  return {.file = parent.string(),
          .message = fmt::format("no folder can be made there: {}", std::strerror(errno))};
}

}  // namespace

Result<ScratchFolder> ScratchFolder::make() {
  const char* chosen = std::getenv("TMPDIR");
  const fs::path parent = chosen == nullptr || *chosen == '\0' ? "/tmp" : chosen;
  auto folder = make_in(parent, "scratch");
  if (folder.ok()) return folder;
  Error error = folder.error();
  error.field = "TMPDIR";
  error.accepted = "TMPDIR set to a folder that can be written, or not set (/tmp)";
  return error;
}

Result<ScratchFolder> ScratchFolder::make_in(const fs::path& parent, const std::string& stem) {
  const std::string prefix = fmt::format(".mixcmp-{}.", stem);
  remove_abandoned(parent, prefix);
  while (true) {
    std::string name = (fs::absolute(parent) / (prefix + "XXXXXX")).string();
    if (mkdtemp(name.data()) == nullptr) return cannot_make(parent);
    Descriptor lock(open(name.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (lock.get() < 0 && errno != ENOENT) return cannot_make(parent);
    if (lock.get() >= 0 && try_lock_new(lock.get())) return ScratchFolder(name, std::move(lock));
  }
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  if (lock_.get() >= 0 && !kept_) fs::remove_all(path_, ignored);
  // A kept folder is locked until the process ends: this run, like others, removes unlocked ones.
  if (kept_) lock_.release();
}

void ScratchFolder::keep_for(const Error& error) {
  std::error_code failed;
  const bool is_named = error.to_string().find(path_.string()) != std::string::npos;
  kept_ = kept_ || (is_named && !std::filesystem::is_empty(path_, failed));
}

}  // namespace mixcmp::inline common
