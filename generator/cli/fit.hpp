#pragma once

#include <optional>
#include <string>

#include "generator/cli/options.hpp"

namespace mixcmp::cli {

/// Why a design plainly does not fit the scene's device: by the table of areas beside the scene,
/// else by the rough cost model. None where it may fit.
std::optional<std::string> fit_note(const LoadedScene& loaded, const model::Design& design);

}  // namespace mixcmp::cli
