#pragma once

#include <gmpxx.h>

#include <optional>
#include <span>
#include <vector>

#include "model/judge/golden/evaluate.hpp"
#include "model/lane/fixed/reference_datapath.hpp"

/// The golden model of lanes in fixed point, in GMP integers.
namespace mixcmp::golden {

/// The integer of every node, in its units. None if it depends on an operand that does not fit its
/// format, or on a value outside its limits. `inputs` are in lane.input_format, one per input.
std::vector<std::optional<mpz_class>> evaluate(const fixed::FixedLane& lane,
                                               std::span<const Bits> inputs);

/// Whether the lane takes this encoding for one of its inputs: a number of the format's sign and
/// magnitude or, in block floating point, any finite number of its sign.
bool takes(const fixed::FixedLane& lane, int input, Bits operand);

/// The decision of a lane in hardware, bit for bit.
LaneResult evaluate_lane(const fixed::FixedLane& lane, std::span<const Bits> inputs);

/// The verdict of a reference, bit for bit.
Verdict evaluate_reference(const fixed::ReferenceDatapath& reference, std::span<const Bits> inputs);

}  // namespace mixcmp::golden
