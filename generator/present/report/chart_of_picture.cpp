#include "generator/present/report/chart_of_picture.hpp"

#include <fmt/format.h>

#include "model/base/common/check.hpp"

namespace mixcmp::report {
namespace {

page::Scaling scaling_of(Axis axis) {
  switch (axis) {
    case Axis::logarithmic: return page::Scaling::logarithmic;
    case Axis::linear: return page::Scaling::linear;
  }
  MIXCMP_CHECK(false);
}

page::Mark mark_of(CurveKind kind) {
  switch (kind) {
    case CurveKind::measured: return page::Mark::line;
    case CurveKind::proven: return page::Mark::dashed_line;
  }
  MIXCMP_CHECK(false);
}

/// The part of a label before the colon: "L" of "L: digits of the reduced precision".
std::string short_label(const std::string& label) {
  return label.substr(0, label.find(':'));
}

}  // namespace

std::string number_text(double value, Axis axis) {
  return axis == Axis::logarithmic ? fmt::format("{:.3e}", value) : fmt::format("{:.4g}", value);
}

page::Chart chart_of(const Picture& picture) {
  const bool of_precisions = picture.x_label == precision_axis;
  page::Chart chart{
      .title = picture.title,
      .x = {picture.x_label, scaling_of(picture.x_axis), !of_precisions, of_precisions ? 1.0 : 0.0},
      .y = {picture.y_label, scaling_of(picture.y_axis)},
      .series = {}};
  for (const Curve& curve : picture.curves) {
    MIXCMP_CHECK(!curve.style.right_axis);
    page::Series series{curve.title, curve.style.color, mark_of(curve.style.kind), {}};
    for (const auto& [x, y] : curve.points) {
      series.points.push_back(
          {x, y,
           fmt::format("{}\n{} = {:.6g}\n{}: {}", curve.title, short_label(picture.x_label), x,
                       picture.y_label, number_text(y, picture.y_axis))});
    }
    if (!series.points.empty()) chart.series.push_back(std::move(series));
  }
  return chart;
}

}  // namespace mixcmp::report
