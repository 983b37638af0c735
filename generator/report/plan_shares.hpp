#pragma once

#include <string>
#include <vector>

#include "model/optimise/optimise.hpp"

namespace mixcmp::report {

/// What one part of a system takes of a device.
struct PartShare {
  std::string name;
  devices::Area area;
};

/// The parts of a plan: each kind of lanes, the scoreboards around lanes, each kind of references,
/// and the crossbar with what else connects them. Of an engine: lanes, second tiers, what else is
/// theirs or their segments', references, the crossbar where there is one, and the rest. Together
/// they take what the plan uses.
std::vector<PartShare> shares_of(const optimise::PrecisionPlan& plan);

/// Whether the plan is one of an engine.
bool is_in_engine(const optimise::PrecisionPlan& plan);

}  // namespace mixcmp::report
