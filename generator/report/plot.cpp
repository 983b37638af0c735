#include "generator/report/plot.hpp"

#include <fmt/format.h>

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

}  // namespace

std::string script(const Picture& picture) {
  std::string text = fmt::format(
      "set terminal svg size 900,560 font 'sans,13' noenhanced background '#ffffff'\n"
      "set title {}\nset xlabel {}\nset ylabel {}\n"
      "{}set grid xtics ytics lc rgb '#d8d8d8'\n"
      "set key outside right top\n{}",
      quoted(picture.title), quoted(picture.x_label), quoted(picture.y_label),
      picture.y_axis == Axis::linear ? "set yrange [0:*]\n"
                                     : "set logscale y 10\nset format y '%.0e'\n",
      picture.axes);
  std::string plots;
  int number = 0;
  for (const Curve& curve : picture.curves) {
    if (curve.points.empty()) continue;
    text += fmt::format("$c{} << EOD\n", number);
    for (const auto& [x, y] : curve.points) text += fmt::format("{} {}\n", x, y);
    text += "EOD\n";
    plots += fmt::format("{} $c{} with {} title {}", plots.empty() ? "" : ",", number, curve.style,
                         quoted(curve.title));
    ++number;
  }
  // A picture without points still has axes.
  if (plots.empty()) plots = " [4:52] [1e-9:1] 1e-10 notitle";
  return text + "plot" + plots + "\n";
}

std::string measured_style(int color, int point) {
  return fmt::format("linespoints lc rgb '{}' pt {} ps 0.5 lw 1.5", colors[color % 7], point);
}

std::string proven_style(int color) {
  return fmt::format("lines lc rgb '{}' dt 2 lw 1.2", colors[color % 7]);
}

}  // namespace mixcmp::report
