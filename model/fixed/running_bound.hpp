#pragma once

#include <optional>
#include <vector>

#include "model/fixed/fixed_lane.hpp"

namespace mixcmp::fixed {

/// Eight steps are three bits in hardware: with a bit of a threshold they fit one table of a LUT.
inline constexpr int most_last_step = 7;

/// The thresholds of `difference` by steps of the magnitudes of `watched`, which it is computed
/// from; none if no step would have a smaller one. `bits`: those of the lane's format. Proof:
/// docs/fixed_point.md, theorem 9.
std::optional<RunningThresholds> running_thresholds(const std::vector<FixedNode>& nodes, int bits,
                                                    NodeId difference, std::vector<NodeId> watched);

/// The magnitude below which a watched number is in this step; it may also be just the negative of
/// that.
mpq_class magnitude_in_step(const FixedNode& watched, int step, int last_step);

}  // namespace mixcmp::fixed
