#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "model/scene/scene.hpp"

namespace mixcmp::gen {

/// A way to bound a lane's errors, under the name that a profile gives it.
struct LaneBound {
  model::BoundKind bound = model::BoundKind::certified;
  model::ErrorBoundKind kind = model::ErrorBoundKind::relative;  ///< of a certified bound
  int digits = 4;                                                ///< of a running bound
};

/// "relative", "running_1" to "running_8", "constant", "profiled".
model::Result<LaneBound> find_lane_bound(std::string_view name);

/// The bounds of lanes that a profile counts.
const std::vector<std::string>& profiled_lane_bounds();

/// `reduced` with this bound.
model::ReducedSpec with_bound(const model::ReducedSpec& reduced, const LaneBound& bound);

}  // namespace mixcmp::gen
