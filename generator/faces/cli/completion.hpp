#pragma once

#include <string>
#include <vector>

#include "generator/faces/cli/command_table.hpp"

namespace mixcmp::cli {

/// The first argument with which the program completes the words behind it.
inline constexpr const char* complete_option = "--complete";

/// The candidates for the last of these words, which follow `mixcmp` on the command line. Each is a
/// line with a tab and a help. Where files are wanted, the only line is ":path".
///
///     completions(table, {"generate", "--fo"});
///     // "--format\t...\n"
std::string completions(const CommandTable& table, const std::vector<std::string>& words);

/// The script with which bash, zsh or fish asks the program for candidates.
std::string completion_script(const std::string& shell);

}  // namespace mixcmp::cli
