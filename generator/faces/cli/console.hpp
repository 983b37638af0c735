#pragma once

#include <optional>
#include <string>

/// Messages to the user beside the results of a run, on standard error, and questions.
namespace mixcmp::cli {

/// Starts the clock by which a log gets its lines of progress.
void start_console();

/// Leaves out progress and notes from now on, as --quiet asks.
void be_quiet();

/// Writes "mixcmp: " and a line: an error, or a part that was not done.
void tell(const std::string& line);

/// Writes "mixcmp: note: " and a line that changes no result, unless --quiet was given.
void tell_note(const std::string& line);

/// Shows the current action. On a terminal it is one line that the next one overwrites, and an
/// empty line clears it. In a log, lines begin with "mixcmp: progress: ". The first comes after two
/// seconds, the next ones 10 to 60 seconds apart; a line is repeated where nothing new is shown.
void show_progress(const std::string& line);

/// Shows the current action with the share of it that is done, 0..1.
void show_share(const std::string& action, double share);

/// Whether there is somebody to ask: standard input and standard error are a terminal.
bool can_ask();

/// Asks for one line of text; none at the end of the input.
std::optional<std::string> ask(const std::string& question);

}  // namespace mixcmp::cli
