#pragma once

#include <optional>

#include "model/lane/fixed/fixed_lane.hpp"

namespace mixcmp::fixed {

/// |x|^2 and s^2, or |x|^2 and |y|^2; all exact in fixed point.
struct NormSides {
  std::vector<NodeId> elements;              ///< the elements of x
  NodeId radius;                             ///< s, never negative as computed; or |y|^2
  std::vector<NodeId> radius_elements = {};  ///< the elements of y; none: `radius` is s

  bool radius_is_squared() const { return !radius_elements.empty(); }
};

/// The two sides, if `sum` is a sum of squares (or one square) and `square` a square. The radius
/// may be negative: its absolute value replaces it.
std::optional<NormSides> norm_sides(const std::vector<FixedNode>& nodes, NodeId sum, NodeId square);

/// The two sides, if f and g are sums of squares.
std::optional<NormSides> two_norms(const std::vector<FixedNode>& nodes, NodeId f, NodeId g);

/// A node that is |x|^2 less low bits.
struct SquaredNorm {
  mpq_class error;    ///< a bound of the Euclidean norm of the errors of x
  mpq_class dropped;  ///< a bound of the dropped low bits' value
};
/// None if the node is not a sum of squares.
std::optional<SquaredNorm> squared_norm(const std::vector<FixedNode>& nodes, NodeId sum);

/// The thresholds of `difference`, |x|^2 - s^2 or |x|^2 - |y|^2. Proof: docs/fixed_point.md,
/// theorem 4.
NormThresholds norm_thresholds(const std::vector<FixedNode>& nodes, const NormSides& sides,
                               const FixedNode& difference);

/// An element of x with at least this square decides the part by itself: |x|^2 exceeds
/// the other side by the threshold. Proof: docs/fixed_point.md, theorem 8.
mpq_class far_square(const std::vector<FixedNode>& nodes, const FixedPart& part);

}  // namespace mixcmp::fixed
