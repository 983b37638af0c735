#include "model/plan/optimise/drift.hpp"

#include <algorithm>
#include <cmath>

#include "model/base/common/check.hpp"

namespace mixcmp::optimise {

StreamTime time_by_rule(SwitchingRule rule, const StreamThroughPlans& stream,
                        std::uint64_t comparisons, double reading_seconds) {
  StreamTime time;
  for (const std::vector<BlockThroughPlan>& block : stream) {
    for (std::uint64_t left = comparisons; left > 0;) {
      const std::size_t loaded = rule.loaded();
      const BlockThroughPlan& through = block[loaded];
      const double of_reading = std::max(1.0, reading_seconds / through.seconds);
      const double count = std::min(std::floor(of_reading), static_cast<double>(left));
      const auto counted = static_cast<std::uint64_t>(count);
      left -= counted;
      time.seconds += count * through.seconds;
      const auto recomputed =
          static_cast<std::uint64_t>(std::llround(count * through.counted_rate));
      if (rule.next(counted, recomputed) == loaded) continue;
      time.seconds += rule.reconfiguration_seconds();
      ++time.switches;
    }
  }
  return time;
}

StreamTime least_time(const StreamThroughPlans& stream, std::uint64_t comparisons,
                      double reconfiguration_seconds) {
  MIXCMP_CHECK(!stream.empty());
  const auto is_less = [](const StreamTime& a, const StreamTime& b) {
    return a.seconds < b.seconds || (a.seconds == b.seconds && a.switches < b.switches);
  };
  const std::size_t plans = stream.front().size();
  std::vector<StreamTime> best(plans, {reconfiguration_seconds, 1});  // so far, by the last plan
  best.front() = {};
  for (const std::vector<BlockThroughPlan>& block : stream) {
    std::vector<StreamTime> next = best;
    for (std::size_t to = 0; to < plans; ++to) {
      for (const StreamTime& from : best) {
        const StreamTime switched{from.seconds + reconfiguration_seconds, from.switches + 1};
        if (is_less(switched, next[to])) next[to] = switched;
      }
      next[to].seconds += static_cast<double>(comparisons) * block[to].seconds;
    }
    best = std::move(next);
  }
  StreamTime least = best.front();
  for (const StreamTime& each : best) {
    if (is_less(each, least)) least = each;
  }
  return least;
}

}  // namespace mixcmp::optimise
