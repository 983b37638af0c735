#include "generator/faces/cli/console.hpp"

#include <fmt/core.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <mutex>
#include <string_view>
#include <thread>

namespace mixcmp::cli {
namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr std::string_view clear_line = "\r\x1b[K";
constexpr std::string_view red = "\x1b[1;31m", cyan = "\x1b[1;36m", plain = "\x1b[0m";

std::string_view variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? std::string_view() : std::string_view(value);
}

/// Tells when a log gets its next line of progress.
class LogPace {
public:
  bool is_due() {
    const Clock::time_point now = Clock::now();
    if (now < next_) return false;
    next_ = now + std::clamp(Seconds(now - start_) / 4, Seconds(10), Seconds(60));
    return true;
  }

private:
  using Time = std::chrono::time_point<Clock, Seconds>;
  const Clock::time_point start_ = Clock::now();
  Time next_ = start_ + Seconds(2);
};

/// Standard error and its properties. Thread-safe.
class Console {
public:
  void be_quiet() {
    const std::lock_guard held(mutex_);
    quiet_ = true;
  }

  void tell(const std::string& line) {
    const std::lock_guard held(mutex_);
    write(colored("mixcmp:", red) + " " + line + "\n");
  }

  void note(const std::string& line) {
    const std::lock_guard held(mutex_);
    if (quiet_) return;
    write(std::string(overwrites_ ? clear_line : "") + "mixcmp: " + colored("note:", cyan) + " " +
          line + "\n");
  }

  void show_progress(const std::string& line) {
    const std::lock_guard held(mutex_);
    if (quiet_) return;
    if (overwrites_) return write(std::string(clear_line) + line);
    shown_ = line;
    if (!reminder_.joinable()) start_reminder();
    log_if_due();
  }

  void ask(const std::string& question) {
    const std::lock_guard held(mutex_);
    write(question);
  }

private:
  // A failed write is ignored: there is no other place to report it.
  static void write(const std::string& text) {
    std::fwrite(text.data(), 1, text.size(), stderr);
    std::fflush(stderr);
  }

  void log_if_due() {
    if (shown_.empty() || quiet_ || !pace_.is_due()) return;
    write("mixcmp: progress: " + shown_ + "\n");
  }

  /// Starts the thread that repeats the current action in a log where nothing new is shown, as
  /// while a tool runs. It takes no signals: these are for the threads that wait for them.
  void start_reminder() {
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    reminder_ = std::jthread([this](const std::stop_token& stop) {
      std::unique_lock held(mutex_);
      while (!stopped_.wait_for(held, stop, std::chrono::seconds(1), [] { return false; })) {
        if (stop.stop_requested()) return;
        log_if_due();
      }
    });
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
  }

  std::string colored(std::string_view word, std::string_view color) const {
    if (!colors_) return std::string(word);
    return std::string(color) + std::string(word) + std::string(plain);
  }

  std::mutex mutex_;
  bool quiet_ = false;
  /// A terminal without a name, or with the name "dumb", moves no cursor and has no colors.
  const bool overwrites_ =
      isatty(STDERR_FILENO) != 0 && !variable("TERM").empty() && variable("TERM") != "dumb";
  const bool colors_ = overwrites_ && variable("NO_COLOR").empty();  // https://no-color.org
  LogPace pace_;
  std::string shown_;  ///< in a log: the current action
  std::condition_variable_any stopped_;
  std::jthread reminder_;  ///< declared last: it ends before the members that it uses
};

/// The process has one standard error, and so one console.
Console& console() {
  static Console only;
  return only;
}

}  // namespace

void start_console() {
  console();
}

void be_quiet() {
  console().be_quiet();
}

void tell(const std::string& line) {
  console().tell(line);
}

void tell_note(const std::string& line) {
  console().note(line);
}

void show_progress(const std::string& line) {
  console().show_progress(line);
}

void show_share(const std::string& action, double share) {
  show_progress(fmt::format("{}: {:.0f} %", action, share * 100));
}

bool can_ask() {
  return isatty(STDIN_FILENO) != 0 && isatty(STDERR_FILENO) != 0;
}

std::optional<std::string> ask(const std::string& question) {
  console().ask(question);
  std::string answer;
  if (!std::getline(std::cin, answer)) return std::nullopt;
  return answer;
}

}  // namespace mixcmp::cli
