#pragma once

#include <string>

#include "generator/cli/command_table.hpp"

namespace mixcmp::cli {

/// Scripts that complete verbs, options, words and paths of `mixcmp` in three shells. They hold
/// everything themselves: no key pressed starts the program.
std::string bash_completion(const CommandTable& table);
std::string zsh_completion(const CommandTable& table);
std::string fish_completion(const CommandTable& table);

}  // namespace mixcmp::cli
