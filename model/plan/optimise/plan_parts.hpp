#pragma once

#include <set>

#include "model/plan/optimise/optimise.hpp"

namespace mixcmp::optimise {

/// The components on whose areas a feasible plan of this scene depends, by their keys in `table`.
/// A row of the table whose key is not among them does not change the plan's own counts. The ports
/// of the crossbars are exactly those of the plan; the table may lack that number.
std::set<measured::ComponentKey> components_of(const PrecisionPlan& plan, const Optimisation& found,
                                               const scene::Scene& scene,
                                               const measured::Characterisation& table);

}  // namespace mixcmp::optimise
