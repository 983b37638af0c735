#pragma once

#include <optional>

#include "model/lane/fixed/fixed_lane.hpp"

/// Square roots in fixed point. Proof: docs/fixed_point.md, theorem 5.
namespace mixcmp::fixed {

/// Digits of roots of bounds, which are rounded outward.
inline constexpr int root_digits = 64;

/// Whether both the computed number and the real one that it stands for are nonnegative.
bool is_nonnegative(const std::vector<FixedNode>& nodes, NodeId id);

/// Encloses the root of the computed radicand less the root of the real one, before bits are
/// dropped. The radicand is nonnegative.
Range root_error(const std::vector<FixedNode>& nodes, NodeId radicand);

}  // namespace mixcmp::fixed
