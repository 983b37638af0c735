#pragma once

#include <optional>

#include "model/plan/optimise/optimise.hpp"
#include "model/plan/optimise/rates.hpp"
#include "model/scene/scene.hpp"

namespace mixcmp::optimise {

/// A plan on data other than those that it was made for.
struct PlanAtRates {
  /// Equation 8 of the paper: below T(equ) of the plan if its references cannot keep up.
  double throughput_per_s = 0;
  /// Recomputations per comparison, as the system's counters count them: requests to a reference or
  /// to a second tier; in a pairwise engine the pairs that references decide.
  double counted_rate = 0;
};

/// The plan, which must be feasible, where its lanes have these rates. None if a rate is unknown.
/// At the rates that the plan was made for it has the plan's throughput.
///
/// - Streams: a reference serves its groups of lanes in turn (performance::round_robin_throughput).
/// - Second lanes, and a pairwise engine: all references share the load.
/// - Arg-min engine: all lanes wait for the reference with the highest load.
std::optional<PlanAtRates> at_rates(const PrecisionPlan& plan, const scene::Scene& scene,
                                    const Rates& rates);

}  // namespace mixcmp::optimise
