#pragma once

#include "model/lane/fixed/fixed_lane.hpp"

/// Value and error of an operation's result before bits are dropped. `b` is not read if there is
/// one operand. Proofs: docs/fixed_point.md, theorem 2.
namespace mixcmp::fixed {

/// Encloses the computed number.
Range exact_value(Operation operation, const Range& a, const Range& b);
/// Encloses its error.
Range exact_error(Operation operation, const FixedNode& a, const FixedNode& b);

/// The unit of an operation's exact result: the product of the factors' units, or the finer of two.
int unit_exponent_of(Operation operation, const FixedFormat& a, const FixedFormat& b);
/// The operation on one or two of the nodes (`b` is -1 for one), exact, in the format that holds
/// it.
FixedNode exact_node(const std::vector<FixedNode>& nodes, Operation operation, NodeId a,
                     NodeId b = -1);

/// Intersects a range with another. If they are disjoint, no comparison reaches the node, and the
/// range stays.
void narrow(Range& range, const Range& other);

/// The ends of a range rounded down to multiples of a unit.
Range rounded_down(const Range& value, const mpq_class& unit);

/// The format that holds a range of multiples of the unit.
FixedFormat format_of(const Range& value, int unit_exponent);

/// Drops `count` low bits of a result that has dropped none so far; nothing if `count` <= 0.
void drop_bits(FixedNode& node, int count);

/// A common cut of `node` to magnitudes of `bits` bits that drops `most` bits at most. Proof:
/// docs/fixed_point.md, theorem 7.
Range cut_value(const FixedNode& node, int bits, int most);
Range cut_error(const FixedNode& node, int most);

}  // namespace mixcmp::fixed
