#pragma once

#include <string>
#include <vector>

#include "model/plan/optimise/plan_summary.hpp"

namespace mixcmp::optimise {

/// The best system in a part of the device.
struct FrontPoint {
  double share = 1;  ///< of the whole device: 0.8 where a system may fill all that R_S = 0.2 leaves
  PlanSummary plan;
  std::vector<std::string> settings;  ///< those that make its scene

  double per_share() const { return plan.throughput_per_s / share; }
};

/// The smallest part of the device in which 0.9 of the highest throughput per area is reached; null
/// without points.
const FrontPoint* knee_of(const std::vector<FrontPoint>& front);

}  // namespace mixcmp::optimise
