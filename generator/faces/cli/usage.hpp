#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "model/base/common/result.hpp"

namespace mixcmp::cli {

/// The mistake in a command line: a word that is no verb, an option that the verb does not have, a
/// value that an option does not take.
Error usage_error(const CLI::App& app, const CLI::ParseError& error);

/// The verbs with commas between them, in the order in which main adds them.
std::string verb_names(const CLI::App& app);

}  // namespace mixcmp::cli
