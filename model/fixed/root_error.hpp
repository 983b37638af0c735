#pragma once

#include <optional>

#include "model/fixed/fixed_lane.hpp"

/// Square roots in fixed point. Proof: docs/fixed_point.md, theorem 5.
namespace mixcmp::fixed {

/// The square root of value >= 0, rounded up, to 64 digits or more.
mpq_class root_above(const mpq_class& value);
/// The square root of value >= 0, rounded down, likewise.
mpq_class root_below(const mpq_class& value);

/// Whether neither the number computed nor the real one that it stands for can be negative.
bool is_nonnegative(const std::vector<FixedNode>& nodes, NodeId id);

/// Encloses the root of what was computed less the root of the real number, before bits are
/// dropped. The radicand is nonnegative.
Range root_error(const std::vector<FixedNode>& nodes, NodeId radicand);

}  // namespace mixcmp::fixed
