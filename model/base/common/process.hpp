#pragma once

#include <atomic>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string_view>

#include "model/base/common/descriptor.hpp"
#include "model/base/common/process_group.hpp"

namespace mixcmp::inline common {

/// Called with a description of the current work, for a line on a terminal.
using Progress = std::function<void(const std::string&)>;

/// Limits that may end a tool early.
struct ToolLimits {
  int seconds = 0;                               ///< wall time; 0: no limit
  const std::atomic<bool>* cancelled = nullptr;  ///< becomes true to end the tool; null: never
};

/// One run of a tool.
struct ToolRun {
  Command command;
  std::filesystem::path directory;  ///< working directory
  std::filesystem::path log;        ///< takes its standard output and standard error
  ToolLimits limits = {};
  Progress progress = {};  ///< called every second with the time so far
};

/// Runs a tool to its end. Its temporary files go to a folder in its directory (TMPDIR), which is
/// removed after the run or, if this process is killed, by the next run there. If the tool fails,
/// the error names the log and shows the end of it.
Result<Done> run_tool(const ToolRun& run);

struct Captured {
  bool in_time = true;
  int status = 0;  ///< as waitpid gives it
  std::string output;
  std::string errors;

  bool succeeded() const { return in_time && status == 0; }
};

/// "was ended by signal 9", "failed with exit code 3", for a status as waitpid gives it.
std::string how_it_ended(int status);

struct CaptureOptions {
  std::string_view input = {};
  double seconds = 10;             ///< wall time after which the program is killed
  std::uint64_t memory_bytes = 0;  ///< 0: no limit
};

/// Runs a program and keeps its output in memory; an error if that is more than 64 MiB.
Result<Captured> capture(const Command& command, const CaptureOptions& options = {});

/// Whether PATH has an executable file of this name.
bool is_in_path(const std::string& program);

/// The command that installs a package of Debian, or of Python if its name begins with "yowasp-".
///     install_command("make") == "apt-get install make"
std::string install_command(const std::string& package);

/// The first line of a tool's output that has the number of a version, on either stream. The
/// command consists of the tool and its option for that. If PATH has no such tool, the error is of
/// the kind `missing_tool` and names the package. A tool that exists and fails is another error.
Result<std::string> tool_version(const Command& command, const std::string& package);

/// A child process whose standard input is a socket to us, for both directions. Its standard output
/// and error go to a log file. The child ends with this object.
class Child {
public:
  static Result<Child> spawn(const Command& command, const std::filesystem::path& log);

  /// False if the child is gone.
  bool send(std::span<const std::byte> bytes);
  bool receive(std::span<std::byte> bytes);

  /// Waits until the child has ended by itself; it must know already that no more work follows.
  /// False if it does not end in time or its exit status is not 0.
  bool finish();

private:
  Child(ProcessGroup group, Descriptor socket)
      : group_(std::move(group)), socket_(std::move(socket)) {}

  ProcessGroup group_;
  Descriptor socket_;
};

/// The last lines of a file, for error messages.
std::string last_lines(const std::filesystem::path& file, std::size_t count);

/// A command as text for a shell.
std::string shell_line(const Command& command);

}  // namespace mixcmp::inline common
