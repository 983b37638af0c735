#pragma once

#include <string>
#include <vector>

#include "generator/present/page/axis.hpp"
#include "generator/present/page/element.hpp"

namespace mixcmp::page {

struct ChartPoint {
  double x;
  double y;
  std::string tip;  ///< shown where a reader points at it; the first line is its name
};

enum class Mark {
  line,         ///< points with a line through them
  dashed_line,  ///< a line without points: proven or given values, not measured ones
  points,       ///< points without a line
  steps,        ///< a line of horizontal and vertical pieces: a front
};

struct Series {
  std::string title;
  int color = 0;  ///< of colors: 0 and up, repeated
  Mark mark = Mark::line;
  std::vector<ChartPoint> points;
};

/// A level or a range of values across the whole chart, such as a published number.
struct ChartBand {
  enum class Across { x, y };  ///< the axis that the values are of

  std::string title;
  Across axis = Across::y;
  double low = 0;
  double high = 0;  ///< equal to `low` for a line
};

struct Chart {
  std::string title;  ///< describes the picture to readers who cannot see it
  AxisSpec x, y;
  std::vector<Series> series;
  std::vector<ChartBand> bands = {};
  bool wide = false;  ///< takes the width of two
};

/// The chart with its legend below. Its numbers are in the points' tips.
Element draw(const Chart& chart);

inline constexpr int color_count = 12;
/// The class of a colour: "c0" to "c11".
std::string color_class(int color);

}  // namespace mixcmp::page
