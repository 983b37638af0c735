#pragma once

#include <cstdint>

#include "model/comparison/data/comparisons.hpp"
#include "model/lane/error/profiled_lane.hpp"

namespace mixcmp::profile {

/// Measures the maximum of |f_L - f_T| / |f_T| (the paper's equation 4) over all comparisons of the
/// data, or over `sample_count` of them. These are drawn without replacement by a pseudo-random
/// permutation of the indices that depends only on the seed. f_T is computed with MPFR, correct to
/// 128 bits (golden::TrueValues). Comparisons are skipped if f_T is zero, has no value or cannot be
/// determined, or if f_L is not finite.
error::ProfiledError profile_error(const Graph& graph, const TypedGraph& lane,
                                   const data::Comparisons& data, std::uint64_t sample_count,
                                   std::uint64_t seed);

}  // namespace mixcmp::profile
