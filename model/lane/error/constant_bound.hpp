#pragma once

#include "model/lane/error/error_analysis.hpp"

namespace mixcmp::error {

/// Checks that no divisor may be zero if every operand passes its check; an error names one that
/// may. A quotient whose divisor may be zero could be as large as the format allows, and a constant
/// that bounds its error would be useless.
Result<Done> check_divisors(const TypedGraph& graph, const std::vector<RangeCheck>& checks);

/// The largest value of `bound` if every operand passes its check. Each computed value in it is
/// replaced by an end of the range that interval analysis finds for that value. An error names an
/// operation whose range has no constant end (a divisor that may be zero, an input without a range)
/// and the remedy.
Result<mpq_class> constant_bound(const TypedGraph& graph, const ErrorAnalysis& analysis,
                                 const AbsoluteError& bound, const std::vector<RangeCheck>& checks);

}  // namespace mixcmp::error
