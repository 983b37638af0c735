#pragma once

#include <cstdint>

#include "model/error/lane.hpp"

namespace mixcmp::error {

/// The largest relative errors of f and g that were seen (the paper's RE_f and RE_g, equation 4):
/// a statistic, not a bound.
struct ProfiledError {
  mpq_class f;
  mpq_class g;
  std::uint64_t comparisons = 0;  ///< that have a real f and g
  /// Comparisons left out of `f` (or `g`), since the computed value is not finite, or is not zero
  /// where the real one is.
  std::uint64_t f_unbounded = 0, g_unbounded = 0;
};

/// Makes a lane with the paper's criterion (IntervalCriterion) for each part, by the same relative
/// errors. These become constants, rounded up to the lane's format.
Lane profiled_lane(const TypedGraph& graph, const mpq_class& relative_error_f,
                   const mpq_class& relative_error_g);

}  // namespace mixcmp::error
