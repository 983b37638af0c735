#include "model/plan/optimise/drift.hpp"

#include <cmath>

#include "model/base/common/check.hpp"

namespace mixcmp::optimise {

StreamTime with_rule(SwitchingRule rule, const StreamThroughPlans& stream,
                     std::uint64_t comparisons, int readings) {
  StreamTime time;
  for (const std::vector<BlockThroughPlan>& block : stream) {
    std::uint64_t before = 0;
    for (int k = 1; k <= readings; ++k) {
      const auto until =
          static_cast<std::uint64_t>(static_cast<double>(comparisons) * k / readings);
      const std::uint64_t count = until - before;
      before = until;
      const std::size_t loaded = rule.loaded();
      const BlockThroughPlan& through = block[loaded];
      time.seconds += static_cast<double>(count) * through.seconds;
      const double recomputed = static_cast<double>(count) * through.counted_rate;
      if (rule.next(count, static_cast<std::uint64_t>(std::llround(recomputed))) == loaded)
        continue;
      time.seconds += rule.reconfiguration_seconds();
      ++time.switches;
    }
  }
  return time;
}

StreamTime with_foresight(const StreamThroughPlans& stream, std::uint64_t comparisons,
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
