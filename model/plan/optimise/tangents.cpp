#include "model/plan/optimise/tangents.hpp"

#include <cstddef>

namespace mixcmp::optimise {
namespace {

double slope_between(const std::vector<double>& values, std::size_t a, std::size_t b) {
  return (values[b] - values[a]) / static_cast<double>(b - a);
}

/// Corners of the lower convex hull, from left to right.
std::vector<std::size_t> lower_hull(const std::vector<double>& values) {
  std::vector<std::size_t> hull;
  for (std::size_t k = 0; k < values.size(); ++k) {
    while (hull.size() >= 2 && slope_between(values, hull[hull.size() - 2], hull.back()) >=
                                   slope_between(values, hull.back(), k)) {
      hull.pop_back();
    }
    hull.push_back(k);
  }
  return hull;
}

}  // namespace

std::vector<Tangent> lower_tangents(const std::vector<double>& values) {
  if (values.empty()) return {Tangent{}};
  if (values.size() == 1) return {Tangent{0, values[0]}};
  const std::vector<std::size_t> hull = lower_hull(values);
  std::vector<Tangent> tangents;
  std::size_t wanted = 0;
  for (std::size_t corner = 1; corner < hull.size(); ++corner) {
    if (hull[corner] <= wanted) continue;
    const double slope = slope_between(values, hull[corner - 1], hull[corner]);
    tangents.push_back({slope, values[hull[corner]] - slope * static_cast<double>(hull[corner])});
    while (wanted < hull[corner]) wanted = wanted == 0 ? 1 : 2 * wanted;
  }
  return tangents;
}

}  // namespace mixcmp::optimise
