#include "model/plan/optimise/front.hpp"

#include <algorithm>

namespace mixcmp::optimise {

const FrontPoint* knee_of(const std::vector<FrontPoint>& front) {
  constexpr double near = 0.9;
  double most = 0;
  for (const FrontPoint& point : front) most = std::max(most, point.per_share());
  for (const FrontPoint& point : front) {
    if (point.per_share() >= near * most) return &point;
  }
  return nullptr;
}

}  // namespace mixcmp::optimise
