#pragma once

#include "model/fixed/fixed_lane.hpp"

/// What an operation makes of its operands, before bits are dropped. `b` is not read where there is
/// one operand. Proofs: docs/fixed_point.md, theorem 2.
namespace mixcmp::fixed {

/// Encloses the number computed.
Range exact_value(Operation operation, const Range& a, const Range& b);
/// Encloses its error.
Range exact_error(Operation operation, const FixedNode& a, const FixedNode& b);

/// Intersects a range with another. Where they have nothing in common, so that no comparison is
/// there, the range stays.
void narrow(Range& range, const Range& other);

/// The ends of a range rounded down to multiples of a unit.
Range rounded_down(const Range& value, const mpq_class& unit);

/// A common cut of `node` to magnitudes of `bits` bits that drops `most` bits at most. Proof:
/// docs/fixed_point.md, theorem 7.
Range cut_value(const FixedNode& node, int bits, int most);
Range cut_error(const FixedNode& node, int most);

}  // namespace mixcmp::fixed
