#pragma once

#include <string>
#include <utility>
#include <vector>

namespace mixcmp::report {

/// One line of a picture.
struct Curve {
  std::string title;
  std::string style;  ///< of gnuplot
  std::vector<std::pair<double, double>> points;
};

enum class Axis {
  logarithmic,
  linear,
};

struct Picture {
  std::string title, x_label, y_label;
  std::string axes;  ///< further lines of gnuplot
  std::vector<Curve> curves;
  Axis y_axis = Axis::logarithmic;
};

/// A gnuplot script that writes an SVG to standard output. Points are written into it, those that a
/// logarithmic axis has no place for must have been left out: gnuplot breaks lines at what it
/// cannot draw.
std::string script(const Picture& picture);

/// Styles of what is measured and of what is proven, in one of a few colours.
std::string measured_style(int color, int point);
std::string proven_style(int color);

}  // namespace mixcmp::report
