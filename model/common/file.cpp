#include "model/common/file.hpp"

#include <fstream>
#include <iterator>

namespace mixcmp::model {

Result<std::string> read_file(const std::filesystem::path& path) {
  std::error_code ignored;
  std::ifstream file(path, std::ios::binary);
  if (!std::filesystem::is_regular_file(path, ignored) || !file) {
    return Error{.file = path.string(),
                 .message = "cannot read the file",
                 .received = std::filesystem::exists(path, ignored) ? "no readable regular file"
                                                                    : "no such file",
                 .accepted = "a readable file"};
  }
  std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  return text;
}

}  // namespace mixcmp::model
