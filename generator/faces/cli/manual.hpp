#pragma once

#include <string>

#include "generator/faces/cli/command_table.hpp"

namespace mixcmp::cli {

/// The manual page mixcmp(1) in roff: every verb with one line, and the exit codes.
std::string manual_page(const CommandTable& table);
/// The manual page mixcmp-VERB(1) in roff. `verb` is one of table.verbs.
std::string manual_page(const CommandTable& table, const CommandEntry& verb);

}  // namespace mixcmp::cli
