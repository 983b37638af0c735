#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "model/base/common/descriptor.hpp"
#include "model/base/common/result.hpp"

namespace mixcmp::inline common {

/// Writes a file whole or not at all. This program writes files in no other way. The text goes into
/// a file with its own name beside the final path, and `commit` moves it there. So half a file is
/// never at the final path, not even after an interrupt, with a full disk, or when a second run
/// writes the same path.
///
/// A symbolic link is followed. A pipe or a device is written directly and never replaced. The same
/// holds for the file behind standard output or standard error. Unfinished files that killed runs
/// left in the folder are removed by the next run that writes there.
class OutputFile {
public:
  static Result<OutputFile> open(const std::filesystem::path& path);
  OutputFile(OutputFile&& other) noexcept = default;
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  OutputFile& operator=(OutputFile&&) = delete;
  /// Without `commit`, the final path stays as it was before.
  ~OutputFile();

  /// A failure is stored, and returned by `write_out` or `commit`.
  void write(std::string_view text);
  /// Writes the text that is still in memory, so that `commit` needs no more space on the disk.
  /// Files that belong together are all written out before the first is committed.
  Result<Done> write_out();
  Result<Done> commit();
  /// As `commit`, but an error if a file of that name has appeared: nothing is replaced.
  Result<Done> commit_new();

private:
  OutputFile(std::filesystem::path path, std::filesystem::path unfinished, Descriptor file)
      : path_(std::move(path)), unfinished_(std::move(unfinished)), file_(std::move(file)) {}
  void flush();
  /// Moves a file to its final path; false, with errno set, if that is not possible.
  using Move = bool (*)(const std::filesystem::path& from, const std::filesystem::path& to);
  Result<Done> commit_with(Move move);

  std::filesystem::path path_;
  std::filesystem::path unfinished_;  ///< equal to path_ for pipes and devices
  Descriptor file_;                   ///< none: committed, or moved from
  std::string buffer_;
  int failure_ = 0;  ///< errno of the first write that failed
};

/// The target of a chain of symbolic links, whether or not it exists.
Result<std::filesystem::path> follow_links(std::filesystem::path path);

/// Moves a file that another program has completed to its final path, on the same file system. The
/// rules of OutputFile hold: links are followed, a replaced file keeps its owner and permissions,
/// and a file that may not be written is not replaced.
Result<Done> put_in_place(const std::filesystem::path& finished, const std::filesystem::path& path);

/// Moves a folder to its final path atomically: a reader finds either the old folder there or the
/// whole new one. Afterwards an old folder has the path `finished`. Both paths are on the same file
/// system.
Result<Done> put_folder_in_place(const std::filesystem::path& finished,
                                 const std::filesystem::path& path);

/// Copies a folder with all its contents, file by file through OutputFile.
Result<Done> copy_folder(const std::filesystem::path& folder, const std::filesystem::path& copy);

/// Writes a file that this program keeps for its own later runs, under a name of its choice. A link
/// or a pipe of that name is replaced: its target was not given as an output.
Result<Done> write_kept_file(const std::filesystem::path& path, std::string_view text);

/// Writes a whole text through OutputFile.
Result<Done> write_file(const std::filesystem::path& path, std::string_view text);

/// Writes a file that must not exist yet, whole or not at all.
Result<Done> write_new_file(const std::filesystem::path& path, std::string_view text);

/// "PATH: cannot be written: No space left on device", for an errno.
Error cannot_write(const std::filesystem::path& path, int failure);

}  // namespace mixcmp::inline common
