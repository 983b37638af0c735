#include "model/base/common/file.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "model/base/common/descriptor.hpp"

namespace mixcmp::inline common {

std::vector<std::filesystem::directory_entry> entries_of(const std::filesystem::path& folder,
                                                         std::error_code& failed) {
  std::vector<std::filesystem::directory_entry> entries;
  for (std::filesystem::directory_iterator entry(folder, failed), end; !failed && entry != end;
       entry.increment(failed)) {
    entries.push_back(*entry);
  }
  return entries;
}

namespace {

/// Opens only regular files: a pipe would wait for a writer.
Result<Descriptor> open_to_read(const std::filesystem::path& path) {
  std::error_code failed;
  const std::filesystem::file_status status = std::filesystem::status(path, failed);
  const bool regular = std::filesystem::is_regular_file(status);
  Descriptor file(regular ? open(path.c_str(), O_RDONLY | O_CLOEXEC) : -1);
  if (file.get() >= 0) return file;
  const bool forbidden = failed == std::errc::permission_denied;
  return Error{.file = path.string(),
               .message = "cannot read the file",
               .received = forbidden                         ? "a folder that may not be searched"
                           : std::filesystem::exists(status) ? "no readable regular file"
                                                             : "no such file",
               .accepted = "a readable file"};
}

}  // namespace

bool path_exists(const std::filesystem::path& path) {
  std::error_code unknown;
  return std::filesystem::exists(path, unknown);
}

Result<Done> check_readable(const std::filesystem::path& path) {
  MIXCMP_TRY(file, open_to_read(path));
  return Done{};
}

Result<std::string> read_file(const std::filesystem::path& path) {
  MIXCMP_TRY(file, open_to_read(path));
  std::string text;
  std::array<char, 65536> block;
  while (true) {
    const ssize_t size = read(file.get(), block.data(), block.size());
    if (size == 0) return text;
    if (size > 0) {
      text.append(block.data(), static_cast<std::size_t>(size));
    } else if (errno != EINTR) {
      return Error{.file = path.string(),
                   .message = fmt::format("cannot be read: {}", std::strerror(errno))};
    }
  }
}

}  // namespace mixcmp::inline common
