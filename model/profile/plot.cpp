#include <fmt/format.h>

#include <iterator>
#include <string>
#include <utility>

#include "model/profile/report.hpp"

/// Points are written into the script, zeros left out: a logarithmic axis has no place for them,
/// and gnuplot breaks lines at what it cannot draw.
namespace mixcmp::model {
namespace {

/// One line of a picture.
struct Curve {
  std::string title;
  std::string style;  ///< of gnuplot
  std::vector<std::pair<int, double>> points;
};

struct Picture {
  std::string path, title, y_label;
  std::vector<Curve> curves;
};

/// For gnuplot's double quotes; enhanced text is off.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c == '\n' ? ' ' : c;
  }
  return result + "\"";
}

std::string script(const Picture& picture) {
  std::string text = fmt::format(
      "set terminal svg size 900,560 font 'sans,13' noenhanced background '#ffffff'\n"
      "set output {}\nset title {}\nset xlabel \"L: digits of the reduced precision\"\n"
      "set ylabel {}\nset logscale y 10\nset format y '%.0e'\n"
      "set grid xtics ytics lc rgb '#d8d8d8'\nset key outside right top\nset xtics 4\n",
      quoted(picture.path), quoted(picture.title), quoted(picture.y_label));
  std::string plots;
  int number = 0;
  for (const Curve& curve : picture.curves) {
    if (curve.points.empty()) continue;
    text += fmt::format("$c{} << EOD\n", number);
    for (const auto& [precision, value] : curve.points) {
      text += fmt::format("{} {}\n", precision, value);
    }
    text += "EOD\n";
    plots += fmt::format("{} $c{} with {} title {}", plots.empty() ? "" : ",", number, curve.style,
                         quoted(curve.title));
    ++number;
  }
  if (plots.empty()) plots = " NaN notitle";
  return text + "plot" + plots + "\n";
}

std::string measured(int color, int point) {
  static constexpr const char* colors[] = {"#1b6ca8", "#c8553d", "#588157", "#7b4b94",
                                           "#b08900", "#444444", "#2a9d8f"};
  return fmt::format("linespoints lc rgb '{}' pt {} ps 0.5 lw 1.5", colors[color % 7], point);
}

std::string proven(int color) {
  static constexpr const char* colors[] = {"#1b6ca8", "#c8553d", "#588157", "#7b4b94"};
  return fmt::format("lines lc rgb '{}' dt 2 lw 1.2", colors[color % 4]);
}

void add(Curve& curve, int precision, double value) {
  if (value > 0) curve.points.emplace_back(precision, value);
}

}  // namespace

std::string figure4_script(const ProfileReport& report, const std::string& path) {
  Picture picture{path, report.scene + ": largest relative error", "|f_L - f_T| / |f_T|", {}};
  int color = 0;
  for (const ErrorProfile& profile : report.errors) {
    const std::string inputs = fmt::format("{} inputs", to_string(profile.inputs));
    Curve f{"f, " + inputs, measured(color, 7), {}}, g{"g, " + inputs, measured(color + 1, 5), {}};
    Curve f_bound{"f proven, " + inputs, proven(color), {}};
    Curve g_bound{"g proven, " + inputs, proven(color + 1), {}};
    for (const ErrorAtPrecision& error : profile.precisions) {
      add(f, error.precision, error.f.get_d());
      add(g, error.precision, error.g.get_d());
      add(f_bound, error.precision, error.f_bound.value_or(0));
      add(g_bound, error.precision, error.g_bound.value_or(0));
    }
    for (Curve* curve : {&f, &f_bound, &g, &g_bound}) picture.curves.push_back(std::move(*curve));
    color += 2;
  }
  return script(picture);
}

std::string figure5_script(const ProfileReport& report, const std::string& path) {
  Picture picture{path, report.scene + ": recomputation rate", "undecided / comparisons", {}};
  for (const RateProfile& profile : report.rates) {
    int color = 0;
    for (const SystemProfile& system : profile.systems) {
      if (system.kind == SystemKind::lanes_alone) continue;
      const int point = profile.inputs == LaneInputs::exact ? 7 : 6;
      Curve curve{fmt::format("{}, {} inputs", system.name, to_string(profile.inputs)),
                  measured(color++, point),
                  {}};
      for (std::size_t k = 0; k < system.counts.size(); ++k) {
        add(curve, profile.first_precision + static_cast<int>(k),
            static_cast<double>(system.counts[k].undecided) /
                static_cast<double>(profile.comparisons));
      }
      picture.curves.push_back(std::move(curve));
    }
  }
  return script(picture);
}

}  // namespace mixcmp::model
