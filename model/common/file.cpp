#include "model/common/file.hpp"

#include <fstream>
#include <iterator>

namespace mixcmp::model {

std::vector<std::filesystem::directory_entry> entries_of(const std::filesystem::path& folder,
                                                         std::error_code& failed) {
  std::vector<std::filesystem::directory_entry> entries;
  for (std::filesystem::directory_iterator entry(folder, failed), end; !failed && entry != end;
       entry.increment(failed)) {
    entries.push_back(*entry);
  }
  return entries;
}

bool path_exists(const std::filesystem::path& path) {
  std::error_code unknown;
  return std::filesystem::exists(path, unknown);
}

Result<Done> check_readable(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::is_regular_file(path, ignored) && std::ifstream(path)) return Done{};
  return Error{.file = path.string(),
               .message = "cannot read the file",
               .received = path_exists(path) ? "no readable regular file" : "no such file",
               .accepted = "a readable file"};
}

Result<std::string> read_file(const std::filesystem::path& path) {
  MIXCMP_TRY(readable, check_readable(path));
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  return text;
}

}  // namespace mixcmp::model
