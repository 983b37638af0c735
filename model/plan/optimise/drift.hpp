#pragma once

#include <cstdint>
#include <vector>

#include "model/plan/optimise/plan_set.hpp"
#include "model/plan/optimise/switching.hpp"

/// A stream of comparisons whose recomputation rates drift, through plans that are switched.
namespace mixcmp::optimise {

/// One block of the stream through each plan of a set.
struct BlockThroughPlan {
  double seconds = 0;  ///< per comparison
  double counted_rate = 0;
};
using StreamThroughPlans = std::vector<std::vector<BlockThroughPlan>>;  ///< [block][plan]

struct StreamTime {
  double seconds = 0;  ///< reconfigurations included
  int switches = 0;
};

/// The stream with the plans that a rule loads. Each block has so many comparisons. The counters
/// are read every `reading_seconds`, and at the end of each block.
StreamTime time_by_rule(SwitchingRule rule, const StreamThroughPlans& stream,
                        std::uint64_t comparisons, double reading_seconds);

/// The least time of any schedule that switches only between blocks: it knows the whole stream. The
/// first plan is loaded at the beginning, as with the rule.
StreamTime least_time(const StreamThroughPlans& stream, std::uint64_t comparisons,
                      double reconfiguration_seconds);

}  // namespace mixcmp::optimise
