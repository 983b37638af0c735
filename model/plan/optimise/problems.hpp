#pragma once

#include <optional>
#include <vector>

#include "model/plan/optimise/candidates.hpp"
#include "model/plan/optimise/crossbars.hpp"

namespace mixcmp::optimise {

/// Cycles from one comparison to the next, or in groups from one word to the next. With refetched
/// operands the tags of a lane's stream are read once for each result and once more for each
/// request (rtl_templates/stream/README.md).
double cycles_per_word(const scene::Scene& scene, double recomputation_rate);

std::vector<ReferenceImplementation> references_of(const PlanningInputs& inputs, const Rows& rows,
                                                   Findings& findings);

/// The parts of all systems among which plans choose.
struct PlanParts {
  const devices::Device& device;
  const Crossbars& crossbars;
  const std::vector<ReferenceImplementation>& references;
};

/// The best plan with these lanes of one precision: of streams, with a second tier if the scene has
/// one, of a pairwise engine or of an arg-min engine. None if no lane has a known rate that holds
/// for its exponent bits.
std::optional<PrecisionPlan> best_plan(const PlanningInputs& inputs, const PlanParts& parts,
                                       int precision, const Rows& lanes, Findings& findings);

}  // namespace mixcmp::optimise
