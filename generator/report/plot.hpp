#pragma once

#include <string>
#include <utility>
#include <vector>

namespace mixcmp::report {

/// One curve of a picture.
struct Curve {
  std::string title;
  std::string style;  ///< gnuplot's style, see measured_style
  std::vector<std::pair<double, double>> points;
};

enum class Axis {
  logarithmic,
  linear,
};

struct Picture {
  std::string title, x_label, y_label;
  std::string axes;  ///< further commands of gnuplot, a line each
  std::vector<Curve> curves;
  Axis y_axis = Axis::logarithmic;
};

/// The label of an axis of precisions.
inline constexpr const char* precision_axis = "L: digits of the reduced precision";

/// A gnuplot script, points included, that writes an SVG to standard output. The caller leaves out
/// points that a logarithmic axis cannot show: gnuplot would break the line there.
std::string script(const Picture& picture);

/// The styles of measured and of proven curves, in one of a few colours.
std::string measured_style(int color, int point);
std::string proven_style(int color);

}  // namespace mixcmp::report
