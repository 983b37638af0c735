#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "model/base/common/folder_lock.hpp"
#include "model/base/common/output_file.hpp"
#include "model/base/common/result.hpp"
#include "model/base/common/stale_files.hpp"
#include "model/cost/devices/device.hpp"

namespace mixcmp::cli {

/// Checks that no output is an input or another output; empty paths are no outputs.
Result<Done> check_outputs(const std::vector<std::filesystem::path>& outputs,
                           const std::vector<std::filesystem::path>& inputs);

/// Checks that each file can be written, before the measurements take their time.
Result<Done> check_writable(const std::vector<std::filesystem::path>& outputs);

/// Writes files that belong together, path and text each: all of them, or none if one cannot be
/// written. Ends the program if that fails.
void write_together(const std::vector<std::pair<std::filesystem::path, std::string>>& files);

/// Refuses a folder that is replaced as a whole and holds an input.
Result<Done> check_replaced_folder(const std::filesystem::path& folder,
                                   const std::vector<std::filesystem::path>& inputs);

/// Locks a work folder, which is made where there is none, for as long as the result lives. Tells
/// the user if another run must end first.
FolderLock lock_folder(const std::filesystem::path& folder);
void tell_waiting(const std::filesystem::path& folder);

/// The result files of one run in one folder. They are written when all of them are made, and take
/// their places when all of them are written, so that results of two runs never mix. The folder's
/// file .mixcmp-results lists them with a hash of each, by which a later run knows them.
class ResultFiles {
public:
  using Names = std::span<const char* const>;

  /// `names`: all files of the folder. Each is added or left out once.
  ResultFiles(std::filesystem::path folder, Names names)
      : folder_(std::move(folder)), names_(names) {}

  /// The final paths of the files of a folder, as outputs for `check_outputs`.
  static std::vector<std::filesystem::path> paths(const std::filesystem::path& folder, Names names);

  void add(const std::string& name, std::string text);
  /// Adds the picture that a gnuplot script draws. Ends the program where gnuplot fails. Where
  /// there is no gnuplot, `commit` returns this picture as not done.
  void add_picture(const std::string& name, const std::string& script);
  /// Declares that this run does not make the file: `commit` removes that of an earlier run. A file
  /// that is not as a run has left it is the user's, and stays.
  void leave_out(const std::string& name);

  /// Writes all files beside their places. Ends the program where one cannot be written.
  void write_out();
  /// Puts all files in their places. Returns descriptions of the parts that were not done.
  std::vector<std::string> commit();

private:
  struct File {
    std::string name;
    std::optional<std::string> text;  ///< nullopt: the file is left out
  };

  void put(const std::string& name, std::optional<std::string> text);
  void stage(const std::string& name, const std::string& text);
  void set_stale_aside(const std::string& known);

  std::filesystem::path folder_;
  Names names_;
  std::vector<File> files_;
  std::vector<OutputFile> written_;
  StaleFiles stale_;
  std::vector<std::string> not_done_;
};

/// Ends the program with ExitCode::incomplete where there is a router for the device but it is not
/// installed here.
void end_if_router_is_missing(const devices::Device& device);

}  // namespace mixcmp::cli
