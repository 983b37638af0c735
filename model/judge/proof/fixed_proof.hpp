#pragma once

#include "model/judge/proof/lane_proof.hpp"

namespace mixcmp::proof {

/// Proves a lane in fixed point by the theorems of docs/fixed_point.md. Gappa proves value and
/// error of every sum, difference, product and square from those of its operands, with one script
/// each. Value and error of a function are derived again from the words of its tables
/// (FunctionEnclosure), and must lie within those of the lane. Exact arithmetic shows that every
/// result fits its format, and that the thresholds lie beyond the error (theorem 3, in each step of
/// theorem 9) or satisfy theorem 4. It also checks the conditions of theorems 6 to 8: f and g are
/// homogeneous, common cuts drop enough bits, and a number beyond a reach decides. The proofs by
/// hand are those for operands (theorem 1), for absolute values, choices, dropped bits and limits
/// (theorem 2), for square roots (theorem 5), for functions (theorem 10), and those of theorems 4
/// and 6 to 9 from their conditions.
LaneProof prove_fixed(const fixed::FixedLane& lane, const Prove& prove);

}  // namespace mixcmp::proof
