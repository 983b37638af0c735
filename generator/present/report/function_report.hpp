#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "model/lane/fixed/fixed_lane.hpp"

namespace mixcmp::report {

/// The functions of a lane in fixed point, by the text of each: its certified error, that of the
/// polynomial without the argument's error, its pieces and degree.
std::vector<std::pair<std::string, std::string>> function_lines(const fixed::FixedLane& lane);

/// The same: `function`, `error` and `own_error` as [low, high], `pieces` and `degree`.
nlohmann::json functions_json(const fixed::FixedLane& lane);

}  // namespace mixcmp::report
