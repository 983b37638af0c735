#include "model/optimise/crossover.hpp"

#include <algorithm>
#include <limits>

namespace mixcmp::model {
namespace {

double cheapest(const std::vector<Area>& kinds, const Area& usable) {
  double share = std::numeric_limits<double>::infinity();
  for (const Area& kind : kinds) share = std::min(share, device_share(kind, usable));
  return share;
}

}  // namespace

double device_share(const Area& component, const Area& usable) {
  double largest = 0;
  for (const Resource& resource : bounded_resources) {
    const int amount = component.*resource.amount;
    if (amount == 0) continue;
    const int available = usable.*resource.amount;
    if (available == 0) return std::numeric_limits<double>::infinity();
    largest = std::max(largest, static_cast<double>(amount) / available);
  }
  return largest;
}

std::optional<int> crossover_precision(const std::map<int, std::vector<Area>>& lanes,
                                       const std::vector<Area>& references, const Area& usable) {
  const double reference = cheapest(references, usable);
  std::optional<int> crossover;
  for (auto kinds = lanes.rbegin(); kinds != lanes.rend(); ++kinds) {
    if (cheapest(kinds->second, usable) <= reference) break;
    crossover = kinds->first;
  }
  return crossover;
}

}  // namespace mixcmp::model
