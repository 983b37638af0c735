#include "model/common/process.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstring>
#include <deque>
#include <fstream>
#include <thread>

extern char** environ;

namespace mixcmp::model {

namespace {

/// posix_spawn's file actions, owned.
class FileActions {
public:
  FileActions() { posix_spawn_file_actions_init(&actions_); }
  FileActions(const FileActions&) = delete;
  FileActions& operator=(const FileActions&) = delete;
  ~FileActions() { posix_spawn_file_actions_destroy(&actions_); }
  posix_spawn_file_actions_t* get() { return &actions_; }

  void log_output(const std::filesystem::path& log) {
    posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, log.c_str(),
                                     O_WRONLY | O_CREAT | O_TRUNC, 0644);
    posix_spawn_file_actions_adddup2(&actions_, STDOUT_FILENO, STDERR_FILENO);
  }

private:
  posix_spawn_file_actions_t actions_;
};

Result<pid_t> start(const Command& command, FileActions& actions) {
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  pid_t process = 0;
  const int failure =
      posix_spawnp(&process, words[0], actions.get(), nullptr, words.data(), environ);
  if (failure == 0) return process;
  return Error{.message = fmt::format("cannot run {}: {}", command[0], strerror(failure))};
}

bool quotes_needed(const std::string& word) {
  return word.empty() || word.find_first_of(" \t\n'\"\\$`*?[]{}()<>|&;!#~") != std::string::npos;
}

/// Waits for the process, telling every second how long it has been.
int wait_for(pid_t process, const std::string& tool, const Progress& progress) {
  using Clock = std::chrono::steady_clock;
  const auto start_time = Clock::now();
  auto told = start_time;
  int status = 0;
  while (waitpid(process, &status, WNOHANG) == 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    if (!progress || Clock::now() - told < std::chrono::seconds(1)) continue;
    told = Clock::now();
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(told - start_time);
    progress(fmt::format("{}: {} s", tool, seconds.count()));
  }
  return status;
}

}  // namespace

Result<Child> Child::spawn(const Command& command, const std::filesystem::path& log) {
  int sockets[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets) != 0) {
    return Error{.message = fmt::format("no socket: {}", strerror(errno))};
  }
  FileActions actions;
  posix_spawn_file_actions_adddup2(actions.get(), sockets[1], STDIN_FILENO);
  actions.log_output(log);
  auto process = start(command, actions);
  close(sockets[1]);
  if (process.ok()) return Child(*process, sockets[0]);
  close(sockets[0]);
  return process.error();
}

Child::Child(Child&& other) noexcept
    : process_(std::exchange(other.process_, -1)), socket_(std::exchange(other.socket_, -1)) {}

Child::~Child() {
  if (process_ < 0) return;
  close(socket_);  // ends a simulator that waits for us
  for (int attempt = 0; attempt < 100; ++attempt) {
    if (waitpid(process_, nullptr, WNOHANG) != 0) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  kill(process_, SIGKILL);
  waitpid(process_, nullptr, 0);
}

bool Child::send(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t done = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(done));
  }
  return true;
}

bool Child::receive(std::span<std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t done = ::recv(socket_, bytes.data(), bytes.size(), 0);
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(done));
  }
  return true;
}

Result<Done> run_tool(const Command& command, const std::filesystem::path& directory,
                                    const std::filesystem::path& log, const Progress& progress) {
  FileActions actions;
  posix_spawn_file_actions_addopen(actions.get(), STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  actions.log_output(log);
  posix_spawn_file_actions_addchdir_np(actions.get(), directory.c_str());
  MIXCMP_TRY(process, start(command, actions));
  const int status = wait_for(process, command[0], progress);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return Done{};
  return Error{.file = log.string(),
                      .message = fmt::format(
                          "{} failed; the command was\n  cd {} && {}\nand the log ends with\n{}",
                          command[0], directory.string(), to_shell(command), last_lines(log, 20))};
}

Result<std::string> tool_version(const std::string& tool, const std::string& version_option,
                                        const std::string& package) {
  char name[] = "/tmp/mixcmp-version-XXXXXX";
  const int file = mkstemp(name);
  if (file >= 0) close(file);
  const auto run = run_tool({tool, version_option}, "/", name, {});
  std::ifstream stream(name);
  std::string line;
  std::getline(stream, line);
  std::filesystem::remove(name);
  if (run.ok()) return line;
  return Error{.message =
                          fmt::format("{} does not run; on Debian: apt install {}", tool, package)};
}

std::string last_lines(const std::filesystem::path& file, std::size_t count) {
  std::ifstream stream(file);
  std::deque<std::string> lines;
  for (std::string line; std::getline(stream, line);) {
    lines.push_back(line);
    if (lines.size() > count) lines.pop_front();
  }
  std::string text;
  for (const std::string& line : lines) text += "  " + line.substr(0, 300) + "\n";
  return text;
}

std::string to_shell(const Command& command) {
  std::string text;
  for (const std::string& word : command) {
    if (!text.empty()) text += ' ';
    if (!quotes_needed(word)) {
      text += word;
      continue;
    }
    text += '\'';
    for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    text += '\'';
  }
  return text;
}

}  // namespace mixcmp::model
