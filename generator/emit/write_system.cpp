#include <fcntl.h>
#include <fmt/core.h>
#include <stdlib.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "generator/emit/system.hpp"

namespace mixcmp::gen {
namespace {

namespace fs = std::filesystem;
using model::Done;
using model::Error;
using model::Result;

Error write_error(const fs::path& path, std::string message) {
  return {.file = path.string(), .message = std::move(message)};
}

/// The file names that a previous output's signature claims, itself and its companions included.
/// Of another version's signature, whatever else it holds, these fields are enough.
std::set<std::string> files_of_previous_output(const fs::path& directory) {
  std::set<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(directory)) {
    if (entry.path().extension() != ".json") continue;
    std::ifstream stream(entry.path());
    const nlohmann::json signature = nlohmann::json::parse(stream, nullptr, false);
    if (!signature.is_object() || !signature.contains("generator_version")) continue;
    for (const nlohmann::json& file : signature.value("files", nlohmann::json::array())) {
      if (file.is_string()) names.insert(file.get<std::string>());
    }
    const std::string top = entry.path().stem().string();
    for (const char* extension : {".json", ".f", ".sdc"}) names.insert(top + extension);
  }
  return names;
}

/// Nothing of the user's may be lost: only what this program wrote is replaced.
Result<Done> check_replaceable(const fs::path& directory) {
  if (!fs::exists(directory)) return Done{};
  if (!fs::is_directory(directory)) {
    return Error{.file = directory.string(),
                 .message = "is not a directory",
                 .received = "a file",
                 .accepted = "a new or empty directory, or a previous output of generate"};
  }
  const std::set<std::string> ours = files_of_previous_output(directory);
  for (const fs::directory_entry& entry : fs::directory_iterator(directory)) {
    if (ours.count(entry.path().filename().string()) > 0) continue;
    return Error{.file = directory.string(),
                 .message = "will not be replaced: it holds a file that mixcmp did not write",
                 .received = entry.path().filename().string(),
                 .accepted = "a new or empty directory, or a previous output of generate"};
  }
  return Done{};
}

Result<Done> write_file(const fs::path& path, const std::string& text) {
  std::ofstream stream(path, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) return write_error(path, fmt::format("cannot be written: {}", std::strerror(errno)));
  return Done{};
}

/// A directory beside the final one, gone again when this goes out of scope.
class Staging {
public:
  static Result<Staging> make(const fs::path& directory) {
    std::string pattern = directory.string() + ".XXXXXX";
    if (mkdtemp(pattern.data()) == nullptr) {
      return write_error(directory, fmt::format("cannot be created: {}", std::strerror(errno)));
    }
    fs::permissions(pattern, fs::perms::owner_all | fs::perms::group_read | fs::perms::group_exec |
                                 fs::perms::others_read | fs::perms::others_exec);
    return Staging(pattern);
  }
  Staging(Staging&& other) noexcept : path_(std::exchange(other.path_, fs::path())) {}
  Staging(const Staging&) = delete;
  Staging& operator=(const Staging&) = delete;
  Staging& operator=(Staging&&) = delete;
  ~Staging() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove_all(path_, ignored);
  }
  const fs::path& path() const { return path_; }

private:
  explicit Staging(fs::path path) : path_(std::move(path)) {}
  fs::path path_;
};

/// One step for whoever looks: the new directory is there whole, or the old one still is.
Result<Done> put_in_place(const fs::path& staged, const fs::path& directory) {
  const unsigned int flags = fs::exists(directory) ? RENAME_EXCHANGE : RENAME_NOREPLACE;
  if (renameat2(AT_FDCWD, staged.c_str(), AT_FDCWD, directory.c_str(), flags) != 0) {
    return write_error(directory, fmt::format("cannot be put in place: {}", std::strerror(errno)));
  }
  return Done{};
}

}  // namespace

Result<Done> write_system(const GeneratedSystem& system, const fs::path& requested) {
  // With a name at its end, whether or not the user wrote a final slash.
  fs::path directory = fs::absolute(requested).lexically_normal();
  if (!directory.has_filename()) directory = directory.parent_path();
  std::error_code failed;
  fs::create_directories(directory.parent_path(), failed);
  if (failed) return write_error(directory, "cannot be created: " + failed.message());
  MIXCMP_TRY(replaceable, check_replaceable(directory));
  MIXCMP_TRY(staging, Staging::make(directory));
  for (const GeneratedFile& file : system.files) {
    MIXCMP_TRY(written, write_file(staging.path() / file.name, file.text));
  }
  // After an exchange the staging path holds the previous output, which then goes.
  return put_in_place(staging.path(), directory);
}

}  // namespace mixcmp::gen
