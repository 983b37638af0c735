#pragma once

#include <optional>
#include <vector>

#include "model/lane/fixed/fixed_lane.hpp"

namespace mixcmp::fixed {

/// The last step at most. Eight steps are three bits in hardware, so a LUT of few inputs finds each
/// bit of a threshold.
inline constexpr int most_last_step = 7;

/// The thresholds of `difference` by steps of the magnitudes of `watched`, from which it is
/// computed; none if no step would have a smaller threshold. `bits`: those of the lane's format.
/// Proof: docs/fixed_point.md, theorem 9.
std::optional<RunningThresholds> running_thresholds(const std::vector<FixedNode>& nodes, int bits,
                                                    NodeId difference, std::vector<NodeId> watched);

/// The limit of a watched number x in this step: -limit <= x < limit.
mpq_class magnitude_in_step(const FixedNode& watched, int step, int last_step);

}  // namespace mixcmp::fixed
