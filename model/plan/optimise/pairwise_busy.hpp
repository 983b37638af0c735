#pragma once

#include <optional>

#include "model/plan/optimise/candidates.hpp"

/// In which part of their cycles the lanes of a planned pairwise engine compare, on the sets of the
/// scene's data (performance::PairwiseFlow).
namespace mixcmp::optimise {

/// The pairwise engine of a plan's allocation. All of its lanes leave as much undecided as those
/// that leave most.
performance::PairwiseEngine engine_of(const PrecisionPlan& plan, const scene::SystemSpec& system,
                                      const Allocation& chosen);

/// The part of their cycles in which the lanes of a pairwise engine compare. If idle lanes do not
/// count, the part in which no word waits. None if the rates do not know the pairs.
std::optional<double> busy_share(const performance::PairwiseEngine& engine, const Rates& rates,
                                 bool counts_idle_lanes);

/// The most groups of lanes for which a pairwise engine of the plan's lanes is planned: the fewest
/// that make 98 % of the pairs per cycle of the best number of them.
int most_useful_groups(const PrecisionPlan& plan, const PlanningInputs& inputs);

/// Counts the cycles in which the lanes of a solved plan compare nothing, in the plan and in its
/// bound.
void count_idle_cycles(PrecisionPlan& plan, const PlanningInputs& inputs);

}  // namespace mixcmp::optimise
