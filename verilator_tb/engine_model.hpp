#pragma once

#include <optional>

#include "model/cost/performance/chain.hpp"
#include "model/cost/performance/pairwise.hpp"
#include "model/design/design.hpp"
#include "verilator_tb/report.hpp"

/// The performance model (docs/theory.md) of an engine, for the data of a simulation.
namespace mixcmp::verilator_tb {

/// The work of the engine for the whole set, from the numbers that the report has counted. The work
/// of a second tier is left out, since it is not counted.
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
