#pragma once

#include <optional>

#include "model/design/design.hpp"
#include "model/performance/chain.hpp"
#include "model/performance/pairwise.hpp"
#include "verilator_tb/report.hpp"

/// What the performance model (docs/performance.md) says of an engine and of the data that it was
/// simulated on.
namespace mixcmp::verilator_tb {

/// What the whole set asked of the engine, by the numbers that the report has counted. They do not
/// tell what a second tier had to do; it is left out.
performance::PairwiseSet pairwise_set_of(const design::Design& design, const VerifyReport& report);

/// The lanes of an arg-min engine's design, with their streams.
performance::Chain chain_of(const design::Design& design);

/// The cycles to expect for the whole set, if reports and undecided pairs are spread evenly; none
/// for flags, whose beats the report does not count.
std::optional<double> expected_pairwise_cycles(const design::Design& design,
                                               const VerifyReport& report);

/// The cycles to expect for all rows, if as many comparisons as the report has counted are
/// undecided at random.
double expected_arg_min_cycles(const design::Design& design, const VerifyReport& report);

}  // namespace mixcmp::verilator_tb
