#pragma once

#include <optional>
#include <string>

#include "generator/faces/cli/options.hpp"

namespace mixcmp::cli {

/// A note that a design plainly does not fit the scene's device, by the table of areas beside the
/// scene or, without a table, by the rough cost model; nullopt where it may fit.
std::optional<std::string> fit_note(const LoadedScene& loaded, const design::Design& design);

}  // namespace mixcmp::cli
