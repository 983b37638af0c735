#include "generator/faces/cli/exit.hpp"

#include <cerrno>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "generator/present/report/json_text.hpp"
#include "model/base/common/output_file.hpp"

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
  Exit exit(code_of(error.kind));
  exit.error = error;
  throw exit;
}

// A failed write is ignored: the error is on standard error already.
void print_error_as_json(const Exit& exit) {
  if (!exit.error) return;
  const std::string text = report::json_text({{"error", report::to_json(*exit.error)}});
  std::fwrite(text.data(), 1, text.size(), stdout);
  std::fflush(stdout);
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

}  // namespace mixcmp::cli
