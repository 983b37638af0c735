#include "generator/present/report/plot.hpp"

#include <fmt/format.h>

#include "model/base/common/check.hpp"

namespace mixcmp::report {
namespace {

constexpr const char* colors[] = {"#1b6ca8", "#c8553d", "#588157", "#7b4b94",
                                  "#b08900", "#444444", "#2a9d8f"};

/// A text in gnuplot's double quotes, for titles without markup (`noenhanced`).
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c == '\n' ? ' ' : c;
  }
  return result + "\"";
}

std::string text_of(const CurveStyle& style) {
  const char* const color = colors[style.color % 7];
  const char* const axes = style.right_axis ? " axes x1y2" : "";
  switch (style.kind) {
    case CurveKind::measured:
      return fmt::format("linespoints lc rgb '{}' pt {} ps 0.5 lw 1.5{}", color, style.mark, axes);
    case CurveKind::proven: return fmt::format("lines lc rgb '{}' dt 2 lw 1.2{}", color, axes);
  }
  MIXCMP_CHECK(false);
}

/// The points of a curve that gnuplot can draw, one per line.
std::string drawn_points(const Curve& curve, const Picture& picture) {
  std::string text;
  for (const auto& [x, y] : curve.points) {
    if (y > 0 || picture.y_axis == Axis::linear) text += fmt::format("{} {}\n", x, y);
  }
  return text;
}

}  // namespace

std::string script(const Picture& picture) {
  std::string text = fmt::format(
      "set terminal svg size 900,560 font 'sans,13' noenhanced background '#ffffff'\n"
      "set title {}\nset xlabel {}\nset ylabel {}\n"
      "{}set grid xtics ytics lc rgb '#d8d8d8'\n"
      "set key outside right top\n{}{}",
      quoted(picture.title), quoted(picture.x_label), quoted(picture.y_label),
      picture.y_axis == Axis::linear ? "set yrange [0:*]\n"
                                     : "set logscale y 10\nset format y '%.0e'\n",
      picture.x_axis == Axis::linear ? "" : "set logscale x 10\n", picture.axes);
  std::string plots;
  int number = 0;
  for (const Curve& curve : picture.curves) {
    const std::string points = drawn_points(curve, picture);
    if (points.empty()) continue;
    text += fmt::format("$c{} << EOD\n{}EOD\n", number, points);
    plots += fmt::format("{} $c{} with {} title {}", plots.empty() ? "" : ",", number,
                         text_of(curve.style), quoted(curve.title));
    ++number;
  }
  // A picture without points still has axes.
  if (plots.empty()) plots = " [4:52] [1e-9:1] 1e-10 notitle";
  return text + "plot" + plots + "\n";
}

CurveStyle measured_style(int color, int mark) {
  return {.kind = CurveKind::measured, .color = color, .mark = mark};
}

CurveStyle proven_style(int color) {
  return {.kind = CurveKind::proven, .color = color};
}

}  // namespace mixcmp::report
