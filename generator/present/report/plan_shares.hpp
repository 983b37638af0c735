#pragma once

#include <string>
#include <vector>

#include "model/plan/optimise/optimise.hpp"

namespace mixcmp::report {

/// The area of one part of a system.
struct PartShare {
  std::string name;
  devices::Area area;
};

/// The parts of a plan: each kind of lanes, the scoreboards around lanes, each kind of references,
/// and the crossbar with the other connections. In an engine: lanes, second tiers, the other parts
/// of lanes and segments, references, the crossbar where there is one, and the rest. The areas add
/// up to that of the plan.
std::vector<PartShare> shares_of(const optimise::PrecisionPlan& plan);

/// Whether the plan is one of an engine.
bool is_in_engine(const optimise::PrecisionPlan& plan);

}  // namespace mixcmp::report
