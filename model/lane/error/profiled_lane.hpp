#pragma once

#include <cstdint>

#include "model/lane/error/lane.hpp"

namespace mixcmp::error {

/// The largest relative errors of f and g among the profiled comparisons (the paper's RE_f and
/// RE_g, equation 4): a statistic, not a bound.
struct ProfiledError {
  mpq_class f;
  mpq_class g;
  std::uint64_t comparisons = 0;  ///< comparisons with a real f and g
  /// Comparisons left out of `f` (or `g`): the computed value is not finite, or it is not zero
  /// although the real value is.
  std::uint64_t f_unbounded = 0, g_unbounded = 0;
};

/// Makes a lane with the paper's criterion (IntervalCriterion) for each part. All parts have the
/// same relative errors, as constants rounded up to the lane's format.
Lane profiled_lane(const TypedGraph& graph, const mpq_class& relative_error_f,
                   const mpq_class& relative_error_g);

}  // namespace mixcmp::error
