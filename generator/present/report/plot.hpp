#pragma once

#include <string>
#include <utility>
#include <vector>

namespace mixcmp::report {

enum class CurveKind {
  measured,  ///< points with a line through them
  proven,    ///< a dashed line: a bound, or a level
};

struct CurveStyle {
  CurveKind kind = CurveKind::measured;
  int color = 0;            ///< of a few, repeated
  int mark = 7;             ///< gnuplot's number of the points' shape
  bool right_axis = false;  ///< values are on the axis at the right side
};

/// One curve of a picture.
struct Curve {
  std::string title;
  CurveStyle style;
  std::vector<std::pair<double, double>> points;
};

enum class Axis {
  logarithmic,
  linear,
};

struct Picture {
  std::string title, x_label, y_label;
  std::string axes;  ///< further commands of gnuplot, one per line
  std::vector<Curve> curves;
  Axis y_axis = Axis::logarithmic;
  Axis x_axis = Axis::linear;
};

/// The label of an axis of precisions.
inline constexpr const char* precision_axis = "L: digits of the reduced precision";

/// A gnuplot script, points included, that writes an SVG to standard output. Points of 0 and below
/// are left out where the y axis is logarithmic: gnuplot would break the line there.
std::string script(const Picture& picture);

/// The styles of measured and of proven curves, in one of a few colours.
CurveStyle measured_style(int color, int mark);
CurveStyle proven_style(int color);

}  // namespace mixcmp::report
