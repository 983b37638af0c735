#pragma once

#include <cstdint>

#include "model/data/comparisons.hpp"
#include "model/error/lane.hpp"

namespace mixcmp::model {

/// Maximum of |f_L - f_T| / |f_T| (the paper's equation 4) over comparisons of the data, f_T with
/// MPFR, right to 128 digits (golden::TrueValues). A statistic, not a bound. Comparisons whose f_T
/// is zero, has no value or cannot be told, or whose f_L is not finite, are skipped.
struct ProfiledError {
  mpq_class f;
  mpq_class g;
  std::uint64_t comparisons = 0;  ///< how many were measured
};

/// Measures every comparison, or `sample_count` of them without replacement: a pseudo-random
/// permutation of the indices, so that the sample depends on the seed alone.
ProfiledError profile_error(const Graph& graph, const TypedGraph& lane, const Comparisons& data,
                            std::uint64_t sample_count, std::uint64_t seed);

/// The lane with the paper's decision; the constants are rounded up to the lane's format.
Lane profiled_lane(TypedGraph graph, const mpq_class& relative_error_f,
                   const mpq_class& relative_error_g);

}  // namespace mixcmp::model
