#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "generator/tasks/optimise.hpp"

namespace mixcmp::cli {

/// The best system of each interface, that of each formulation, the plans of the best of all at
/// every precision, its settings, and whether its areas are predicted.
std::string to_text(const tasks::OptimiseResult& result);
nlohmann::ordered_json to_json(const tasks::OptimiseResult& result);

/// "predicted", "partly measured" or "measured": the areas of the chosen plan.
const char* areas_of(const tasks::Confirmation& confirmation);

/// Comparisons per second in G/s, with two decimals and at least two digits: "48.58", "0.0031".
std::string giga_text(double per_s);

}  // namespace mixcmp::cli
