#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "generator/hardware/emit/system.hpp"
#include "model/base/common/file.hpp"
#include "model/base/common/folder_lock.hpp"
#include "model/base/common/output_file.hpp"
#include "model/base/common/scratch_folder.hpp"

namespace mixcmp::emit {
namespace {

namespace fs = std::filesystem;

/// The files that the signature of a previous output names, with the signature, the file list and
/// the constraint. It reads only some fields, so signatures of other versions serve as well.
std::set<fs::path> files_of_previous_output(const fs::path& directory) {
  std::set<fs::path> names;
  std::error_code unreadable;
  for (const fs::directory_entry& entry : entries_of(directory, unreadable)) {
    if (entry.path().extension() != ".json" || !entry.is_regular_file(unreadable)) continue;
    std::ifstream stream(entry.path());
    const nlohmann::json signature = nlohmann::json::parse(stream, nullptr, false);
    if (!signature.is_object() || !signature.contains("generator_version")) continue;
    for (const char* list : {"files", "cells", "project"}) {
      for (const nlohmann::json& file : signature.value(list, nlohmann::json::array())) {
        if (file.is_string()) names.insert(file.get<std::string>());
      }
    }
    const std::string top = entry.path().stem().string();
    for (const char* extension : {".json", ".f", ".sdc"}) names.insert(top + extension);
  }
  return names;
}

/// The folders below the output's folder that these files are in.
std::set<fs::path> folders_of(const std::set<fs::path>& files) {
  std::set<fs::path> folders;
  for (const fs::path& file : files) {
    for (fs::path folder = file.parent_path(); folder.has_relative_path();
         folder = folder.parent_path()) {
      folders.insert(folder);
    }
  }
  return folders;
}

/// A folder that is about to be replaced, and the parts of a previous output in it.
struct Replaced {
  fs::path directory;
  std::set<fs::path> files;
  std::set<fs::path> folders;
};

Error foreign_file(const Replaced& replaced, const fs::path& name) {
  return {.file = replaced.directory.string(),
          .message =
              "will not be replaced: it holds a file that is not of a previous output of generate",
          .received = name.string(),
          .accepted = "a new or empty directory, or a previous output of generate"};
}

/// Refuses a folder, `below` that of the output, with anything that no earlier output lists.
Result<Done> check_entries(const Replaced& replaced, const fs::path& below) {
  const fs::path folder = replaced.directory / below;
  // The old output is removed after the exchange, file by file, which needs these permissions.
  if (access(folder.c_str(), R_OK | W_OK | X_OK) != 0) return cannot_write(folder, errno);
  std::error_code failed, unknown;
  for (const fs::directory_entry& entry : entries_of(folder, failed)) {
    const fs::path name = below / entry.path().filename();
    const fs::file_status status = entry.symlink_status(unknown);
    if (fs::is_regular_file(status) && replaced.files.contains(name)) continue;
    if (!fs::is_directory(status) || !replaced.folders.contains(name)) {
      return foreign_file(replaced, name);
    }
    MIXCMP_DO(check_entries(replaced, name));
  }
  if (failed) return cannot_write(folder, failed.value());
  return Done{};
}

/// Refuses to replace a path such as a folder with a file that no earlier output lists: no file of
/// the user may be lost.
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
  Replaced replaced = {directory, files_of_previous_output(directory), {}};
  replaced.folders = folders_of(replaced.files);
  return check_entries(replaced, {});
}

/// Lets whoever may read a file also execute it.
Result<Done> make_executable(const fs::path& path) {
  std::error_code failed;
  const fs::perms readers =
      fs::status(path, failed).permissions() &
      (fs::perms::owner_read | fs::perms::group_read | fs::perms::others_read);
  const auto executors = static_cast<fs::perms>(static_cast<unsigned>(readers) >> 2u);
  if (!failed) fs::permissions(path, executors, fs::perm_options::add, failed);
  if (failed) return cannot_write(path, failed.value());
  return Done{};
}

/// Writes one file into the staged folder, or into a folder below it if the file's name has a
/// folder.
Result<Done> stage(const GeneratedFile& file, const fs::path& staged) {
  const fs::path path = staged / file.name;
  std::error_code failed;
  fs::create_directories(path.parent_path(), failed);
  if (failed) return cannot_write(path.parent_path(), failed.value());
  MIXCMP_DO(write_file(path, file.text));
  return file.is_script ? make_executable(path) : Done{};
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

/// An error about a staged file, with the path that the user knows.
Error in_place(Error error, const fs::path& path) {
  error.file = path.string();
  return error;
}

}  // namespace

Result<Done> write_system(const GeneratedSystem& system, const fs::path& requested) {
  std::error_code failed;
  // The path is resolved as the kernel does it: ".." behind a symbolic link is the parent of its
  // target.
  const fs::path absolute = fs::absolute(requested, failed);  // fails for an empty path
  fs::path named = failed ? fs::path() : fs::weakly_canonical(absolute, failed);
  if (failed) return cannot_write(requested, failed.value());
  // The path ends with the folder's name, whether or not the user wrote a final slash.
  if (!named.has_filename()) named = named.parent_path();
  MIXCMP_TRY(directory, follow_links(named));
  MIXCMP_DO(make_writable_folder(directory.parent_path()));
  MIXCMP_DO(check_replaceable(directory));
  MIXCMP_TRY(staging, ScratchFolder::make_in(directory.parent_path(), "staging"));
  for (const GeneratedFile& file : system.files) {
    const Result<Done> written = stage(file, staging.path());
    if (!written.ok()) return in_place(written.error(), directory / file.name);
  }
  MIXCMP_DO(set_permissions(staging.path(), directory));
  // After an exchange the staging path holds the previous output, which is then removed.
  return put_folder_in_place(staging.path(), directory);
}

}  // namespace mixcmp::emit
