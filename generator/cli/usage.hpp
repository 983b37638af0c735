#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace mixcmp::cli {

/// The one line that tells what is wrong with a command line: a word that is no verb, an option
/// that the verb does not have, a value that an option does not take.
std::string usage_error(const CLI::App& app, const CLI::ParseError& error);

}  // namespace mixcmp::cli
