#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "model/base/common/descriptor.hpp"
#include "model/base/common/result.hpp"

namespace mixcmp::inline common {

/// A program and its arguments; the program is looked up in PATH.
using Command = std::vector<std::string>;

/// The command, the streams and the limits with which a program is started.
struct Launch {
  Command command;
  std::filesystem::path directory = {};       ///< working directory; empty: ours
  std::vector<std::string> environment = {};  ///< "NAME=value" each, over our own
  int input = -1;                             ///< descriptors of its standard streams;
  int output = -1;                            ///< -1: /dev/null
  int errors = -1;
  std::uint64_t memory_bytes = 0;  ///< limit of its address space; 0: none
};

/// Starts another program. This program starts others in no other way. The other program and all
/// its children form a process group, which ends with this object. It also ends with us, however we
/// end: a watcher in the group reads from a pipe that only we hold open, and kills the group when
/// the pipe closes.
class ProcessGroup {
public:
  /// An error of the kind `missing_tool` if PATH has no such program.
  static Result<ProcessGroup> start(const Launch& launch);
  ProcessGroup(ProcessGroup&& other) noexcept;
  ProcessGroup(const ProcessGroup&) = delete;
  ProcessGroup& operator=(const ProcessGroup&) = delete;
  ProcessGroup& operator=(ProcessGroup&&) = delete;
  /// Kills all processes that still run.
  ~ProcessGroup();

  /// Whether the program has ended within `patience`.
  bool wait_for(std::chrono::milliseconds patience);
  /// Waits until the program has ended, and kills the processes that it left. Returns its status as
  /// waitpid gives it.
  int wait();

private:
  ProcessGroup(pid_t program, pid_t watcher, Descriptor lifeline)
      : program_(program), watcher_(watcher), lifeline_(std::move(lifeline)) {}

  pid_t program_;  ///< the leader of the group; -1: waited for, or moved from
  pid_t watcher_;
  Descriptor lifeline_;  ///< our end of the watcher's pipe
};

}  // namespace mixcmp::inline common
