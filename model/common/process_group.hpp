#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "model/common/descriptor.hpp"
#include "model/common/result.hpp"

namespace mixcmp::inline common {

/// A program and its arguments; the program is looked up in PATH.
using Command = std::vector<std::string>;

/// What a program is started with.
struct Launch {
  Command command;
  std::filesystem::path directory = {};       ///< working directory; empty: ours
  std::vector<std::string> environment = {};  ///< "NAME=value" each, over our own
  int input = -1;                             ///< descriptors of its standard streams;
  int output = -1;                            ///< -1: /dev/null
  int errors = -1;
  std::uint64_t memory_bytes = 0;  ///< limit of its address space; 0: none
};

/// The one way in which this program starts another. The program and all that it starts live in a
/// process group of their own, which ends with this object; and with us, however we end: a watcher
/// in the group reads from a pipe that only we hold open, and kills the group when the pipe closes.
class ProcessGroup {
public:
  /// An error of the kind `missing_tool` where PATH has no such program.
  static Result<ProcessGroup> start(const Launch& launch);
  ProcessGroup(ProcessGroup&& other) noexcept;
  ProcessGroup(const ProcessGroup&) = delete;
  ProcessGroup& operator=(const ProcessGroup&) = delete;
  ProcessGroup& operator=(ProcessGroup&&) = delete;
  /// Kills what still runs.
  ~ProcessGroup();

  /// Whether the program has ended within `patience`.
  bool wait_for(std::chrono::milliseconds patience);
  /// Waits until the program has ended. What it left running is killed. Returns its status as
  /// waitpid gives it.
  int wait();

private:
  ProcessGroup(pid_t program, pid_t watcher, Descriptor lifeline)
      : program_(program), watcher_(watcher), lifeline_(std::move(lifeline)) {}

  pid_t program_;  ///< the leader of the group; -1: waited for, or moved from
  pid_t watcher_;
  Descriptor lifeline_;  ///< the end of the watcher's pipe that we hold
};

}  // namespace mixcmp::inline common
