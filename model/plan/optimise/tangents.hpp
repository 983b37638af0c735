#pragma once

#include <vector>

namespace mixcmp::optimise {

/// y = slope x + offset.
struct Tangent {
  double slope = 0;
  double offset = 0;
};

/// A few linear lower bounds of the points (k, values[k]): the edges of their lower convex hull at
/// k = 0, 1, 2, 4, 8, ... Without points, the line y = 0.
std::vector<Tangent> lower_tangents(const std::vector<double>& values);

}  // namespace mixcmp::optimise
