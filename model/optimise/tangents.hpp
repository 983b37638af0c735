#pragma once

#include <vector>

namespace mixcmp::model {

/// y = slope x + offset.
struct Line {
  double slope = 0;
  double offset = 0;
};

/// A few lines that lie nowhere above the points (k, values[k]) and touch their lower convex hull:
/// of its edges those above 0, 1, 2, 4, 8, ... Without points: the line 0.
std::vector<Line> lines_below(const std::vector<double>& values);

}  // namespace mixcmp::model
