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
/// and the crossbar with what else connects them. Of a pairwise engine: lanes, second tiers, what
/// else is in their segments, references, and the rest. Together they take what the plan uses.
std::vector<PartShare> shares_of(const optimise::PrecisionPlan& plan);

}  // namespace mixcmp::report
