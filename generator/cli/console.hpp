#pragma once

#include <optional>
#include <string>

/// What a run says to the user beside its results, on standard error, and what it asks.
namespace mixcmp::cli {

/// Starts the clock by which a log gets its lines of progress.
void start_console();

/// Leaves out progress and notes from now on, as --quiet asks.
void be_quiet();

/// Writes "mixcmp: " and a line: an error, or a part that was not done.
void tell(const std::string& line);

/// Writes "mixcmp: note: " and a line that changes no result, unless --quiet was given.
void tell_note(const std::string& line);

/// Shows what is being done. On a terminal it is one line that the next one overwrites, and an
/// empty one clears it. Elsewhere, in a log, it is a line every so often, which begins with
/// "mixcmp: progress: ": the first after two seconds, the next ones 10 to 60 seconds apart, the
/// same one again where nothing new is shown.
void show_progress(const std::string& line);

/// Whether there is somebody to ask: standard input and standard error are a terminal.
bool can_ask();

/// Asks for one line of text; none at the end of the input.
std::optional<std::string> ask(const std::string& question);

}  // namespace mixcmp::cli
