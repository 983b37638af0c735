#include "generator/cli/exit.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>

#include "model/common/output_file.hpp"

namespace mixcmp::cli {

namespace {

ExitCode code_of(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::mistake:
    case ErrorKind::missing_column:
    case ErrorKind::unnamed_columns: return ExitCode::mistake;
    case ErrorKind::missing_tool: return ExitCode::incomplete;
    case ErrorKind::refuted: return ExitCode::refuted;
  }
  MIXCMP_CHECK(false);
}

}  // namespace

void fail(const Error& error) {
  show_progress("");
  tell(error.to_string());
  throw Exit(code_of(error.kind));
}

void print(const std::string& text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (written && std::fflush(stdout) == 0) return;
  fail(cannot_write("standard output", errno));
}

void tell_not_done(const std::vector<std::string>& parts) {
  for (const std::string& part : parts) tell("not done: " + part);
}

void end_if_incomplete(const std::vector<std::string>& not_done) {
  tell_not_done(not_done);
  if (!not_done.empty()) throw Exit(ExitCode::incomplete);
}

// A failed write is ignored: there is no other place to report it.
void tell(const std::string& line) {
  const std::string text = "mixcmp: " + line + "\n";
  std::fwrite(text.data(), 1, text.size(), stderr);
}

void show_progress(const std::string& line) {
  if (isatty(STDERR_FILENO) == 0) return;
  const std::string text = "\r\x1b[K" + line;
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

}  // namespace mixcmp::cli
