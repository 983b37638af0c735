#include "model/plan/optimise/crossover.hpp"

#include <algorithm>
#include <limits>

namespace mixcmp::optimise {
namespace {

double cheapest(const std::vector<devices::Area>& kinds, const devices::Area& usable) {
  double share = std::numeric_limits<double>::infinity();
  for (const devices::Area& kind : kinds) share = std::min(share, device_share(kind, usable));
  return share;
}

}  // namespace

LargestShare largest_share(const devices::Area& component, const devices::Area& usable) {
  LargestShare largest;
  for (const devices::Resource& resource : devices::bounded_resources) {
    const int amount = component.*resource.amount;
    if (amount == 0) continue;
    const int available = usable.*resource.amount;
    const double share = available == 0 ? std::numeric_limits<double>::infinity()
                                        : static_cast<double>(amount) / available;
    if (share > largest.share) largest = {&resource, share};
  }
  return largest;
}

double device_share(const devices::Area& component, const devices::Area& usable) {
  return largest_share(component, usable).share;
}

std::optional<int> crossover_precision(const std::map<int, std::vector<devices::Area>>& lanes,
                                       const std::vector<devices::Area>& references,
                                       const devices::Area& usable) {
  const double reference = cheapest(references, usable);
  std::optional<int> crossover;
  for (auto kinds = lanes.rbegin(); kinds != lanes.rend(); ++kinds) {
    if (cheapest(kinds->second, usable) <= reference) break;
    crossover = kinds->first;
  }
  return crossover;
}

}  // namespace mixcmp::optimise
