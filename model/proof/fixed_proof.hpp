#pragma once

#include "model/proof/lane_proof.hpp"

namespace mixcmp::proof {

/// Proves value and error of every operation of a lane in fixed point from those of its operands,
/// one script each, and by exact arithmetic that its thresholds lie beyond the error (theorem 3 of
/// docs/fixed_point.md) or beyond what theorem 4 asks. By hand stay the conversion (theorem 1),
/// absolute values, choices, dropped bits and limits (theorem 2), square roots (theorem 5), the
/// scaling of block floating point (theorem 6, whose condition is checked), and theorem 4 itself.
LaneProof prove_fixed(const fixed::FixedLane& lane, const Prove& prove);

}  // namespace mixcmp::proof
