#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "generator/emit/system.hpp"
#include "model/common/file.hpp"
#include "model/common/folder_lock.hpp"
#include "model/common/output_file.hpp"
#include "model/common/scratch_folder.hpp"

namespace mixcmp::emit {
namespace {

namespace fs = std::filesystem;

/// The files that the signature of a previous output names, with the signature, the file list and
/// the constraint. It reads only two fields, so signatures of other versions serve as well.
std::set<std::string> files_of_previous_output(const fs::path& directory) {
  std::set<std::string> names;
  std::error_code unreadable;
  for (const fs::directory_entry& entry : entries_of(directory, unreadable)) {
    if (entry.path().extension() != ".json" || !entry.is_regular_file(unreadable)) continue;
    std::ifstream stream(entry.path());
    const nlohmann::json signature = nlohmann::json::parse(stream, nullptr, false);
    if (!signature.is_object() || !signature.contains("generator_version")) continue;
    for (const char* list : {"files", "cells"}) {
      for (const nlohmann::json& file : signature.value(list, nlohmann::json::array())) {
        if (file.is_string()) names.insert(file.get<std::string>());
      }
    }
    const std::string top = entry.path().stem().string();
    for (const char* extension : {".json", ".f", ".sdc"}) names.insert(top + extension);
  }
  return names;
}

/// Refuses what must not be replaced, such as a folder with a file that no earlier output lists:
/// no file of the user may be lost.
Result<Done> check_replaceable(const fs::path& directory) {
  std::error_code failed;
  const fs::file_status status = fs::status(directory, failed);
  if (!fs::status_known(status)) return cannot_write(directory, failed.value());
  if (!fs::exists(status)) return Done{};
  if (!fs::is_directory(status)) {
    return Error{.file = directory.string(),
                 .message = "is not a directory",
                 .received = "a file",
                 .accepted = "a new or empty directory, or a previous output of generate"};
  }
  if (fs::equivalent(directory, ".", failed)) {
    return Error{.file = directory.string(),
                 .message = "is the working directory, which cannot be replaced",
                 .accepted = "another directory"};
  }
  // The old output is removed after the exchange, file by file, which needs these permissions.
  if (access(directory.c_str(), R_OK | W_OK | X_OK) != 0) return cannot_write(directory, errno);
  const std::set<std::string> ours = files_of_previous_output(directory);
  std::error_code unknown;
  for (const fs::directory_entry& entry : entries_of(directory, failed)) {
    const bool known = ours.count(entry.path().filename().string()) > 0;
    if (known && fs::is_regular_file(entry.symlink_status(unknown))) continue;
    return Error{
        .file = directory.string(),
        .message =
            "will not be replaced: it holds a file that is not of a previous output of generate",
        .received = entry.path().filename().string(),
        .accepted = "a new or empty directory, or a previous output of generate"};
  }
  if (failed) return cannot_write(directory, failed.value());
  return Done{};
}

/// Gives the staged folder the permissions of the folder that it replaces, or those that the umask
/// gives a new folder.
Result<Done> set_permissions(const fs::path& staged, const fs::path& directory) {
  std::error_code failed;
  const fs::file_status before = fs::status(directory, failed);
  const fs::path sample = staged / "permissions";
  if (!fs::exists(before)) fs::create_directory(sample, failed);
  fs::permissions(
      staged, fs::exists(before) ? before.permissions() : fs::status(sample, failed).permissions(),
      failed);
  if (failed) return cannot_write(directory, failed.value());
  fs::remove(sample, failed);
  return Done{};
}

/// An error about a staged file, told of the path that the user knows.
Error in_place(Error error, const fs::path& path) {
  error.file = path.string();
  return error;
}

}  // namespace

Result<Done> write_system(const GeneratedSystem& system, const fs::path& requested) {
  std::error_code failed;
  // Resolve the path as the kernel does: ".." behind a symbolic link is the parent of its target.
  fs::path named = fs::weakly_canonical(fs::absolute(requested), failed);
  if (failed) return cannot_write(requested, failed.value());
  // The path ends with the folder's name, whether or not the user wrote a final slash.
  if (!named.has_filename()) named = named.parent_path();
  MIXCMP_TRY(directory, follow_links(named));
  MIXCMP_TRY(parent, make_writable_folder(directory.parent_path()));
  MIXCMP_TRY(replaceable, check_replaceable(directory));
  MIXCMP_TRY(staging, ScratchFolder::make_in(directory.parent_path(), "staging"));
  for (const GeneratedFile& file : system.files) {
    const Result<Done> written = write_file(staging.path() / file.name, file.text);
    if (!written.ok()) return in_place(written.error(), directory / file.name);
  }
  MIXCMP_TRY(opened, set_permissions(staging.path(), directory));
  // After an exchange the staging path holds the previous output, which then goes.
  return put_folder_in_place(staging.path(), directory);
}

}  // namespace mixcmp::emit
