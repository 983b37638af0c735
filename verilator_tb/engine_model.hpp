#pragma once

#include <memory>

#include "model/cost/performance/chain.hpp"
#include "model/cost/performance/pairwise_flow.hpp"
#include "model/design/design.hpp"
#include "verilator_tb/report.hpp"

/// The performance model (docs/theory.md) of an engine, for the data of a simulation.
namespace mixcmp::verilator_tb {

/// The numbers of a pairwise engine's design. `undecided` is the share that the report counted.
performance::PairwiseEngine pairwise_engine_of(const design::Design& design,
                                               const VerifyReport& report);

/// The lanes of an arg-min engine's design, with their streams.
performance::Chain chain_of(const design::Design& design);

/// The cycles to expect for the whole set (performance::PairwiseFlow). The work of a second tier is
/// left out.
double expected_pairwise_cycles(const design::Design& design, const VerifyReport& report,
                                std::shared_ptr<const performance::PairwiseData> data);

/// The cycles to expect for all rows, if as many comparisons as the report has counted are
/// undecided at random.
double expected_arg_min_cycles(const design::Design& design, const VerifyReport& report);

}  // namespace mixcmp::verilator_tb
