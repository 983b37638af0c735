#pragma once

#include <optional>

#include "model/fixed/fixed_lane.hpp"

namespace mixcmp::fixed {

/// |x|^2 and s^2, both exact in fixed point.
struct NormSides {
  std::vector<NodeId> elements;  ///< of x
  NodeId radius;                 ///< s; thresholds take its absolute value if it may be negative
};

/// The two sides, if `sum` is a sum of squares (or one square) and `square` a square.
std::optional<NormSides> norm_sides(const std::vector<FixedNode>& nodes, NodeId sum, NodeId square);

/// The thresholds of `difference`, |x|^2 - s^2. Proof: docs/fixed_point.md, theorem 4.
NormThresholds norm_thresholds(const std::vector<FixedNode>& nodes, const NormSides& sides,
                               const FixedNode& difference);

}  // namespace mixcmp::fixed
