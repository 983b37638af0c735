#pragma once

#include <algorithm>
#include <array>
#include <random>

#include "model/base/number/lane_inputs.hpp"

namespace mixcmp::test {

/// Exact and rounded inputs, and inputs of one digit more than a lane of this precision has. If the
/// reference has no more digits than those, the last are exact as well.
inline std::array<LaneInputs, 3> all_inputs(int lane_precision) {
  return {LaneInputs::exact, LaneInputs::of_digits(lane_precision + 1), LaneInputs::rounded};
}

/// Exact or rounded inputs, or of some digits between these precisions.
inline LaneInputs any_inputs(int lane_precision, int reference_precision, std::mt19937_64& random) {
  const int between = std::max(1, reference_precision - lane_precision);
  const auto more = static_cast<int>(random() % static_cast<unsigned>(between));
  switch (random() % 3) {
    case 0: return LaneInputs::exact;
    case 1: return LaneInputs::rounded;
    default: return LaneInputs::of_digits(lane_precision + more);
  }
}

}  // namespace mixcmp::test
