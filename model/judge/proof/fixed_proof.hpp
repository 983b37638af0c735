#pragma once

#include "model/judge/proof/lane_proof.hpp"

namespace mixcmp::proof {

/// Proves a lane in fixed point (theorems of docs/fixed_point.md). By Gappa, one script each: value
/// and error of every sum, difference, product and square, from those of its operands. By exact
/// arithmetic: that every result fits its format; that the thresholds lie beyond the error (theorem
/// 3, in each step of theorem 9) or satisfy theorem 4; and the conditions of theorems 6 to 8: f and
/// g are homogeneous, common cuts drop enough bits, and a number beyond a reach decides. By hand
/// stay operands (theorem 1), absolute values, choices, dropped bits and limits (theorem 2), square
/// roots (theorem 5), and that theorems 4 and 6 to 9 follow from these.
LaneProof prove_fixed(const fixed::FixedLane& lane, const Prove& prove);

}  // namespace mixcmp::proof
