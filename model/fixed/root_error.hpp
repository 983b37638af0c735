#pragma once

#include <optional>

#include "model/fixed/fixed_lane.hpp"

/// Square roots in fixed point. Proof: docs/fixed_point.md, theorem 5.
namespace mixcmp::fixed {

/// The digits of roots of bounds, which are rounded outward.
inline constexpr int root_digits = 64;

/// Whether neither the number computed nor the real one that it stands for can be negative.
bool is_nonnegative(const std::vector<FixedNode>& nodes, NodeId id);

/// Encloses the root of what was computed less the root of the real number, before bits are
/// dropped. The radicand is nonnegative.
Range root_error(const std::vector<FixedNode>& nodes, NodeId radicand);

}  // namespace mixcmp::fixed
