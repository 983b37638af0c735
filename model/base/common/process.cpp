#include "model/base/common/process.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <fstream>
#include <sstream>
#include <utility>

#include "model/base/common/output_file.hpp"
#include "model/base/common/scratch_folder.hpp"

namespace mixcmp::inline common {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

/// Opens a log anew. Anything in its place that is not a file (a link, a device) is replaced: a log
/// is read again, and belongs to its folder.
int open_log(const fs::path& log) {
  std::error_code failed;
  if (!fs::is_regular_file(fs::symlink_status(log, failed))) fs::remove(log, failed);
  return open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, 0644);
}

bool quotes_needed(const std::string& word) {
  return word.empty() || word.find_first_of(" \t\n'\"\\$`*?[]{}()<>|&;!#~") != std::string::npos;
}

/// Waits until a tool has ended. Returns the reason if it must be ended early, in words.
std::optional<std::string> wait_within(ProcessGroup& group, const ToolRun& run) {
  constexpr std::chrono::milliseconds between_looks{20};
  const auto start = Clock::now();
  std::int64_t told = 0;
  while (!group.wait_for(between_looks)) {
    const auto so_far =
        std::chrono::duration_cast<std::chrono::seconds>(Clock::now() - start).count();
    if (run.limits.cancelled != nullptr && *run.limits.cancelled) return "was interrupted";
    if (run.limits.seconds > 0 && so_far >= run.limits.seconds) {
      return fmt::format("took longer than {} s", run.limits.seconds);
    }
    if (run.progress && so_far > std::exchange(told, so_far)) {
      run.progress(fmt::format("{}: {} s", run.command[0], so_far));
    }
  }
  return std::nullopt;
}

/// The first line of a text, cut to the length of a report's line.
std::string first_line(const std::string& text) {
  constexpr std::size_t most = 200;
  return text.substr(0, std::min(text.find('\n'), most));
}

/// A file in memory with this content, for reading from its beginning.
Descriptor memory_file(std::string_view content) {
  Descriptor file(memfd_create("mixcmp", MFD_CLOEXEC));
  while (file.get() >= 0 && !content.empty()) {
    const ssize_t written = write(file.get(), content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return Descriptor();
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  if (file.get() >= 0) lseek(file.get(), 0, SEEK_SET);
  return file;
}

/// Appends the available bytes to `text`; false at the end of the stream.
bool take(int descriptor, std::string& text) {
  std::array<char, 65536> block;
  const ssize_t size = read(descriptor, block.data(), block.size());
  if (size < 0) return errno == EINTR;
  text.append(block.data(), static_cast<std::size_t>(size));
  return size > 0;
}

constexpr std::size_t most_captured_bytes = std::size_t{64} << 20;

/// The time until the deadline, 0 or more.
std::chrono::milliseconds time_until(Clock::time_point deadline) {
  const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now());
  return std::max(left, std::chrono::milliseconds{0});
}

/// Reads both streams until they end. If the program has ended, it reads until no more bytes come,
/// since processes that the program left may hold the streams open. False if time or room runs out
/// first.
bool take_all(int output, int errors, Clock::time_point deadline, ProcessGroup& program,
              Captured& captured) {
  constexpr std::int64_t look_ms = 100;
  std::array<pollfd, 2> open = {{{output, POLLIN, 0}, {errors, POLLIN, 0}}};
  const std::array<std::string*, 2> texts = {&captured.output, &captured.errors};
  while (open[0].fd >= 0 || open[1].fd >= 0) {
    const auto left = time_until(deadline).count();
    if (left == 0 || captured.output.size() + captured.errors.size() > most_captured_bytes) {
      return false;
    }
    const bool ended = program.wait_for(std::chrono::milliseconds{0});
    const int ready = poll(open.data(), open.size(), static_cast<int>(std::min(left, look_ms)));
    if (ready < 0 && errno != EINTR) return false;
    if (ready == 0 && ended) return true;
    for (std::size_t k = 0; k < open.size(); ++k) {
      const bool readable = open[k].fd >= 0 && open[k].revents != 0;
      if (readable && !take(open[k].fd, *texts[k])) open[k].fd = -1;
    }
  }
  return true;
}

Error no_descriptor(const char* what) {
  return {.message = fmt::format("no {}: {}", what, std::strerror(errno))};
}

}  // namespace

std::string how_it_ended(int status) {
  if (WIFSIGNALED(status)) return fmt::format("was ended by signal {}", WTERMSIG(status));
  return fmt::format("failed with exit code {}", WEXITSTATUS(status));
}

Result<Done> run_tool(const ToolRun& run) {
  const Descriptor log(open_log(run.log));
  if (log.get() < 0) return cannot_write(run.log, errno);
  MIXCMP_TRY(temporary, ScratchFolder::make_in(run.directory, "temporary"));
  MIXCMP_TRY(group, ProcessGroup::start({.command = run.command,
                                         .directory = run.directory,
                                         .environment = {"TMPDIR=" + temporary.path().string()},
                                         .output = log.get(),
                                         .errors = log.get()}));
  std::optional<std::string> failure = wait_within(group, run);
  if (!failure) {
    const int status = group.wait();
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return Done{};
    failure = how_it_ended(status);
  }
  return Error{
      .file = run.log.string(),
      .message = fmt::format("{} {}; the command was\n  cd {} && {}\nand the log ends with\n{}",
                             run.command[0], *failure, run.directory.string(),
                             shell_line(run.command), last_lines(run.log, 20))};
}

Result<Captured> capture(const Command& command, const CaptureOptions& options) {
  const Descriptor input = memory_file(options.input);
  Pipe output, errors;
  if (input.get() < 0) return no_descriptor("file in memory");
  if (!output.open() || !errors.open()) return no_descriptor("pipe");
  const auto limit = std::chrono::duration<double>(options.seconds);
  const auto deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(limit);
  Captured captured;
  MIXCMP_TRY(group, ProcessGroup::start({.command = command,
                                         .input = input.get(),
                                         .output = output.write_end.get(),
                                         .errors = errors.write_end.get(),
                                         .memory_bytes = options.memory_bytes}));
  output.write_end.reset();
  errors.write_end.reset();
  captured.in_time =
      take_all(output.read_end.get(), errors.read_end.get(), deadline, group, captured) &&
      group.wait_for(time_until(deadline));
  if (captured.in_time) captured.status = group.wait();
  if (captured.output.size() + captured.errors.size() <= most_captured_bytes) return captured;
  return Error{.message = fmt::format("{} prints too much", shell_line(command)),
               .received = "more than 64 MiB"};
}

namespace {

/// Whether any point in the line stands between two digits.
bool names_a_version(std::string_view line) {
  const auto digit = [&](std::size_t k) {
    return k < line.size() && line[k] >= '0' && line[k] <= '9';
  };
  for (std::size_t k = 1; k < line.size(); ++k) {
    if (line[k] == '.' && digit(k - 1) && digit(k + 1)) return true;
  }
  return false;
}

bool is_of_python(const std::string& package) {
  return package.starts_with("yowasp-");
}

/// The first line that names a version; empty if none does. YoWASP's programs print another line
/// before it when they run for the first time.
std::string version_line(const std::string& text) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (names_a_version(line)) return first_line(line);
  }
  return "";
}

}  // namespace

bool is_in_path(const std::string& program) {
  const char* path = getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');) {
    const fs::path file = fs::path(folder) / program;
    std::error_code failed;
    if (fs::is_regular_file(file, failed) && access(file.c_str(), X_OK) == 0) return true;
  }
  return false;
}

std::string install_command(const std::string& package) {
  return fmt::format("{} install {}", is_of_python(package) ? "pip" : "apt-get", package);
}

Result<std::string> tool_version(const Command& command, const std::string& package) {
  const Command tool(command.begin(), command.end() - 1);
  // On a busy machine even this can take longer than ten seconds.
  const Result<Captured> run = capture(command, {.seconds = 60});
  if (!run.ok() && run.error().kind == ErrorKind::missing_tool) {
    return Error{.message = fmt::format("{} does not run", shell_line(tool)),
                 .accepted = fmt::format("{}, {}: {}", tool.back(),
                                         is_of_python(package) ? "anywhere" : "on Debian",
                                         install_command(package)),
                 .kind = ErrorKind::missing_tool};
  }
  if (!run.ok()) return run.error();
  const std::string line = version_line(run->output.empty() ? run->errors : run->output);
  if (run->succeeded() && !line.empty()) return line;
  // Some tools need temporary files to print their version.
  if (const auto temporary = ScratchFolder::make(); !temporary.ok()) return temporary.error();
  const std::string how = !run->in_time      ? "does not end"
                          : run->succeeded() ? "prints no version"
                                             : how_it_ended(run->status);
  return Error{.message = fmt::format("{} {}", shell_line(command), how),
               .received = first_line(run->errors.empty() ? run->output : run->errors),
               .accepted = fmt::format("a {} that runs", tool.back())};
}

Result<Child> Child::spawn(const Command& command, const fs::path& log_path) {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) return no_descriptor("socket");
  Descriptor ours(ends[0]);
  const Descriptor theirs(ends[1]), log(open_log(log_path));
  if (log.get() < 0) return cannot_write(log_path, errno);
  MIXCMP_TRY(
      group,
      ProcessGroup::start(
          {.command = command, .input = theirs.get(), .output = log.get(), .errors = log.get()}));
  return Child(std::move(group), std::move(ours));
}

bool Child::finish() {
  constexpr std::chrono::minutes patience{10};  // packing a large waveform file takes long
  return group_.wait_for(patience) && group_.wait() == 0;
}

bool Child::send(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t done = ::send(socket_.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(done));
  }
  return true;
}

bool Child::receive(std::span<std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t done = ::recv(socket_.get(), bytes.data(), bytes.size(), 0);
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) return false;
    bytes = bytes.subspan(static_cast<std::size_t>(done));
  }
  return true;
}

std::string last_lines(const fs::path& file, std::size_t count) {
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

std::string shell_line(const Command& command) {
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

}  // namespace mixcmp::inline common
