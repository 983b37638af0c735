#include "model/proof/gappa.hpp"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <utility>
#include <vector>

#include "model/common/check.hpp"

namespace mixcmp::model::proof {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int cannot_execute = 127;
constexpr rlim_t most_memory_bytes = rlim_t{2} << 30;

/// A pipe whose ends close with it and do not leak into other programs.
class Pipe {
public:
  Pipe() { MIXCMP_CHECK(pipe2(ends_.data(), O_CLOEXEC) == 0); }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  ~Pipe() {
    close_end(0);
    close_end(1);
  }
  int read_end() const { return ends_[0]; }
  int write_end() const { return ends_[1]; }
  void close_write_end() { close_end(1); }

private:
  void close_end(int end) {
    if (ends_[end] >= 0) close(ends_[end]);
    ends_[end] = -1;
  }

  std::array<int, 2> ends_ = {-1, -1};
};

/// A nameless file with this content, to be read from its beginning.
class Scratch {
public:
  explicit Scratch(const std::string& content) : file_(std::tmpfile()) {
    MIXCMP_CHECK(file_ != nullptr);
    MIXCMP_CHECK(std::fwrite(content.data(), 1, content.size(), file_) == content.size());
    MIXCMP_CHECK(std::fflush(file_) == 0);
    MIXCMP_CHECK(lseek(fileno(file_), 0, SEEK_SET) == 0);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch() { std::fclose(file_); }
  int descriptor() const { return fileno(file_); }

private:
  FILE* file_;
};

struct Outcome {
  bool in_time = true;
  int status = 0;  ///< as waitpid gives it
  std::string output;
  std::string errors;
};

[[noreturn]] void become(const std::vector<const char*>& arguments, int input, int output,
                         int errors) {
  dup2(input, STDIN_FILENO);
  dup2(output, STDOUT_FILENO);
  dup2(errors, STDERR_FILENO);
  const rlimit memory = {most_memory_bytes, most_memory_bytes};
  setrlimit(RLIMIT_AS, &memory);
  execvp(arguments[0], const_cast<char* const*>(arguments.data()));
  _exit(cannot_execute);
}

/// Appends what has come; false at its end.
bool take(int descriptor, std::string& text) {
  std::array<char, 65536> block;
  const ssize_t size = read(descriptor, block.data(), block.size());
  if (size < 0) return errno == EINTR;
  text.append(block.data(), static_cast<std::size_t>(size));
  return size > 0;
}

/// Reads both until they end; false if time runs out first.
bool take_all(int output, int errors, Clock::time_point deadline, Outcome& outcome) {
  std::array<pollfd, 2> open = {{{output, POLLIN, 0}, {errors, POLLIN, 0}}};
  const std::array<std::string*, 2> texts = {&outcome.output, &outcome.errors};
  while (open[0].fd >= 0 || open[1].fd >= 0) {
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    if (left <= 0) return false;
    if (poll(open.data(), open.size(), static_cast<int>(left)) < 0 && errno != EINTR) return false;
    for (std::size_t k = 0; k < open.size(); ++k) {
      const bool ready = open[k].fd >= 0 && open[k].revents != 0;
      if (ready && !take(open[k].fd, *texts[k])) open[k].fd = -1;
    }
  }
  return true;
}

/// `arguments` end with a null pointer. The program is gone when this returns.
Outcome run(const std::vector<const char*>& arguments, const std::string& input, double seconds) {
  const Scratch script(input);
  Pipe output, errors;
  const auto limit = std::chrono::duration<double>(seconds);
  const auto deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(limit);
  const pid_t child = fork();
  MIXCMP_CHECK(child >= 0);
  if (child == 0) become(arguments, script.descriptor(), output.write_end(), errors.write_end());
  output.close_write_end();
  errors.close_write_end();
  Outcome outcome;
  outcome.in_time = take_all(output.read_end(), errors.read_end(), deadline, outcome);
  if (!outcome.in_time) kill(child, SIGKILL);
  while (waitpid(child, &outcome.status, 0) < 0 && errno == EINTR) {
  }
  return outcome;
}

/// Whether it read the script and searched, in vain.
bool searched(const std::string& errors) {
  return errors.find("were not satisfied") != std::string::npos ||
         errors.find("no contradiction was found") != std::string::npos;
}

GappaVerdict verdict_of(const Outcome& outcome) {
  if (!outcome.in_time) return GappaVerdict::out_of_time;
  if (!WIFEXITED(outcome.status)) return GappaVerdict::broken;
  const bool doubts = outcome.errors.find("are not trivially equal") != std::string::npos;
  if (doubts) return GappaVerdict::not_proven;  // it would believe a script's false hint
  if (WEXITSTATUS(outcome.status) == 0) return GappaVerdict::proven;
  return searched(outcome.errors) ? GappaVerdict::not_proven : GappaVerdict::broken;
}

}  // namespace

std::optional<std::string> gappa_version() {
  constexpr double enough_seconds = 10;
  const Outcome outcome = run({"gappa", "--version", nullptr}, "", enough_seconds);
  const bool ran = outcome.in_time && WIFEXITED(outcome.status) && WEXITSTATUS(outcome.status) == 0;
  if (!ran) return std::nullopt;
  std::string text = outcome.output + outcome.errors;  // 1.4.1 prints it as an error
  text = text.substr(0, text.find('\n'));
  const std::size_t number = text.find_first_of("0123456789");
  return number == std::string::npos ? text : text.substr(number);
}

GappaRun run_gappa(const std::string& script, Certificate certificate, double seconds) {
  const bool coq = certificate == Certificate::coq;
  Outcome outcome = run({"gappa", coq ? "-Bcoq" : "-Bnull", nullptr}, script, seconds);
  const GappaVerdict verdict = verdict_of(outcome);
  return {.verdict = verdict,
          .message = std::move(outcome.errors),
          .certificate = verdict == GappaVerdict::proven ? std::move(outcome.output) : ""};
}

}  // namespace mixcmp::model::proof
