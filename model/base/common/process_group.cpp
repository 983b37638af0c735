#include "model/base/common/process_group.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <thread>
#include <utility>

#include "model/base/common/check.hpp"

namespace mixcmp::inline common {
namespace {

constexpr int exec_failed = 127;

/// Everything that the child needs, made before the fork. Between fork and exec, the child of a
/// process with several threads may only call async-signal-safe functions.
struct Preparation {
  std::vector<char*> arguments;
  std::vector<char*> environment;
  const char* directory;
  int streams[3];
  rlim_t memory_bytes;
};

bool names_same_variable(const char* entry, const std::string& other) {
  const std::size_t length = other.find('=') + 1;
  return std::strncmp(entry, other.c_str(), length) == 0;
}

Preparation prepare(const Launch& launch, int null) {
  Preparation made = {.arguments = {},
                      .environment = {},
                      .directory = launch.directory.c_str(),
                      .streams = {launch.input, launch.output, launch.errors},
                      .memory_bytes = launch.memory_bytes};
  for (int& stream : made.streams) stream = stream < 0 ? null : stream;
  for (const std::string& word : launch.command) {
    made.arguments.push_back(const_cast<char*>(word.c_str()));
  }
  made.arguments.push_back(nullptr);
  for (char** entry = environ; *entry != nullptr; ++entry) {
    bool replaced = false;
    for (const std::string& other : launch.environment) {
      replaced = replaced || names_same_variable(*entry, other);
    }
    if (!replaced) made.environment.push_back(*entry);
  }
  for (const std::string& entry : launch.environment) {
    made.environment.push_back(const_cast<char*>(entry.c_str()));
  }
  made.environment.push_back(nullptr);
  return made;
}

/// The largest file that a program may write, so that an endless one does not fill the disk.
constexpr rlim_t most_file_bytes = rlim_t{16} << 30;

enum class FailedStep { machine, directory, program };

/// A child sends this through a pipe if it cannot become the program.
struct StartFailure {
  int error = 0;  ///< errno
  FailedStep step = FailedStep::machine;
};

/// Becomes the program, or writes the reason why not into the pipe.
[[noreturn]] void become(const Preparation& made, int report) {
  setpgid(0, 0);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  signal(SIGXFSZ, SIG_DFL);
  for (int stream = 0; stream < 3; ++stream) dup2(made.streams[stream], stream);
  rlimit file = {};
  if (getrlimit(RLIMIT_FSIZE, &file) == 0) {
    file.rlim_cur = std::min(file.rlim_cur, most_file_bytes);
    setrlimit(RLIMIT_FSIZE, &file);
  }
  if (made.memory_bytes > 0) {
    const rlimit memory = {made.memory_bytes, made.memory_bytes};
    setrlimit(RLIMIT_AS, &memory);
  }
  const bool arrived = *made.directory == '\0' || chdir(made.directory) == 0;
  if (arrived) execvpe(made.arguments[0], made.arguments.data(), made.environment.data());
  const StartFailure failure = {errno, arrived ? FailedStep::program : FailedStep::directory};
  [[maybe_unused]] const ssize_t told = write(report, &failure, sizeof failure);
  _exit(exec_failed);
}

/// Closes all descriptors except its end of the pipe, waits for the pipe to close, and then kills
/// the group.
[[noreturn]] void watch(pid_t group, int lifeline) {
  setpgid(0, group);
  dup2(lifeline, STDIN_FILENO);
  close_range(STDIN_FILENO + 1, ~0U, 0);
  char nothing;
  while (read(STDIN_FILENO, &nothing, 1) < 0 && errno == EINTR) {
  }
  kill(-group, SIGKILL);
  _exit(0);
}

int reap(pid_t process) {
  int status = 0;
  pid_t ended = 0;
  do {
    ended = waitpid(process, &status, 0);
  } while (ended < 0 && errno == EINTR);
  MIXCMP_CHECK(ended == process);
  return status;
}

Error cannot_start(const Launch& launch, StartFailure failure) {
  const bool in_directory = failure.step == FailedStep::directory;
  const bool missing = failure.step == FailedStep::program && failure.error == ENOENT;
  return {.file = in_directory ? launch.directory.string() : "",
          .message = fmt::format("cannot run {}{}: {}", launch.command[0],
                                 in_directory ? " there" : "", std::strerror(failure.error)),
          .kind = missing ? ErrorKind::missing_tool : ErrorKind::mistake};
}

}  // namespace

Result<ProcessGroup> ProcessGroup::start(const Launch& launch) {
  const Descriptor null(open("/dev/null", O_RDWR | O_CLOEXEC));
  if (null.get() < 0) {
    return Error{.file = "/dev/null",
                 .message = fmt::format("cannot be opened: {}", std::strerror(errno))};
  }
  Pipe report, lifeline;
  if (!report.open() || !lifeline.open()) return cannot_start(launch, {errno});
  const Preparation made = prepare(launch, null.get());
  const pid_t program = fork();
  if (program < 0) return cannot_start(launch, {errno});
  if (program == 0) become(made, report.write_end.get());
  setpgid(program, program);  // as the child does; the watcher needs the group now
  const pid_t watcher = fork();
  if (watcher == 0) {
    lifeline.write_end.reset();
    watch(program, lifeline.read_end.get());
  }
  const int watcher_failure = errno;
  ProcessGroup group(program, watcher, std::move(lifeline.write_end));
  if (watcher < 0) return cannot_start(launch, {watcher_failure});
  setpgid(watcher, program);
  report.write_end.reset();
  StartFailure failure;
  if (read(report.read_end.get(), &failure, sizeof failure) == sizeof failure) {
    return cannot_start(launch, failure);
  }
  return group;
}

ProcessGroup::ProcessGroup(ProcessGroup&& other) noexcept
    : program_(std::exchange(other.program_, -1)),
      watcher_(std::exchange(other.watcher_, -1)),
      lifeline_(std::move(other.lifeline_)) {}

ProcessGroup::~ProcessGroup() {
  if (program_ < 0) return;
  kill(-program_, SIGKILL);
  wait();
}

bool ProcessGroup::wait_for(std::chrono::milliseconds patience) {
  constexpr std::chrono::milliseconds between_looks{2};
  const auto end = std::chrono::steady_clock::now() + patience;
  while (true) {
    siginfo_t ended = {};
    // The program stays a zombie, so its process id names the group until the whole group is
    // killed.
    waitid(P_PID, static_cast<id_t>(program_), &ended, WEXITED | WNOHANG | WNOWAIT);
    if (ended.si_pid != 0) return true;
    if (std::chrono::steady_clock::now() >= end) return false;
    std::this_thread::sleep_for(between_looks);
  }
}

int ProcessGroup::wait() {
  siginfo_t ended = {};
  while (waitid(P_PID, static_cast<id_t>(program_), &ended, WEXITED | WNOWAIT) < 0 &&
         errno == EINTR) {
  }
  kill(-program_, SIGKILL);
  lifeline_.reset();
  if (watcher_ > 0) reap(watcher_);
  return reap(std::exchange(program_, -1));
}

}  // namespace mixcmp::inline common
