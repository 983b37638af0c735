#pragma once

#include "model/error/error_analysis.hpp"

namespace mixcmp::model {

/// An error names a divisor that may be zero: its quotient ends only where the format does, and a
/// constant that bounds its error would be worth nothing.
Result<Done> check_divisors(const TypedGraph& graph, const std::vector<RangeCheck>& checks);

/// The largest value that a bound can take where every operand passes its check: interval analysis
/// of the computed values puts numbers in the place of magnitudes. An error names the operation
/// whose range stands in the way (a divisor that may be zero, an input without a range), and what
/// helps.
Result<mpq_class> constant_bound(const TypedGraph& graph, const ErrorAnalysis& analysis,
                                 const AbsolutePart& bound, const std::vector<RangeCheck>& checks);

}  // namespace mixcmp::model
