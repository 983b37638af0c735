#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "generator/faces/cli/console.hpp"
#include "model/base/common/result.hpp"

namespace mixcmp::cli {

/// The exit codes of the program.
enum class ExitCode {
  done = 0,        ///< all that was asked for was done
  mistake = 1,     ///< it was not done: a mistake of the user's, a disk that is full
  refuted = 2,     ///< the answer is no: hardware and model differ, Gappa refuses a bound, no plan
                   ///< fits
  incomplete = 3,  ///< a part was not done: a tool or data are missing; stderr says which
};

/// Thrown by a verb to end the program; only main catches it.
struct Exit {
  int code;
  /// The reason why no result was printed. None if a result was printed, even one that tells of
  /// faults.
  std::optional<Error> error = {};

  explicit Exit(ExitCode meaning) : code(static_cast<int>(meaning)) {}
  /// Exit code 128 + signal, as shells report it.
  static Exit interrupted(int signal) {
    Exit exit(ExitCode::mistake);
    exit.code = 128 + signal;
    return exit;
  }
};

/// Prints the error on stderr and ends the program, with the code that the error's kind says. With
/// --json, main then prints the error as JSON on standard output: a verb calls this before it
/// prints a result, so that there is one object.
[[noreturn]] void fail(const Error& error);

/// The last words with --json of a run that has no result: an object with the key "error", on
/// standard output. Nothing is printed where `exit` has no error.
void print_error_as_json(const Exit& exit);

/// Returns the value, or ends the program as `fail` does.
template <class T>
T value_or_exit(Result<T> result) {
  if (!result.ok()) fail(result.error());
  return std::move(result).value();
}

/// Writes to standard output; ends the program where that cannot be written.
void print(const std::string& text);

/// Lists on stderr the parts that were asked for and not done.
void tell_not_done(const std::vector<std::string>& parts);
/// Lists the parts as tell_not_done does, and ends the program with ExitCode::incomplete. An empty
/// list has no effect.
void end_if_incomplete(const std::vector<std::string>& not_done);

}  // namespace mixcmp::cli
