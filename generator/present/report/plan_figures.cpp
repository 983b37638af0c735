#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "generator/present/report/plan_report.hpp"
#include "generator/present/report/plot.hpp"
#include "generator/present/report/units.hpp"
#include "model/cost/performance/performance.hpp"
#include "model/plan/optimise/plan_summary.hpp"

namespace mixcmp::report {

using devices::Area;
using devices::bounded_resources;
using devices::Resource;
using measured::Measurement;
using optimise::Allocation;
using optimise::ClockDomains;
using optimise::LaneImplementation;
using optimise::Optimisation;
using optimise::PlanSummary;
using optimise::PrecisionPlan;
using optimise::ReferenceImplementation;
using optimise::ReferenceKind;
using performance::equivalent_throughput;

namespace {

/// One curve per kind of lane, of `value` for each of its rows; rows with value 0 are left out.
template <class Value>
std::vector<Curve> curves_by_kind(const Optimisation& optimisation, Value value) {
  std::map<std::string, Curve> curves;
  for (const PrecisionPlan& plan : optimisation.plans) {
    for (const LaneImplementation& lane : plan.lanes) {
      const measured::Lane& key = lane.lane();
      const std::string inputs = key.inputs ? describe(*key.inputs) + ", " : "";
      const std::string title =
          fmt::format("{}, {}{}", to_string(key.bound), inputs, to_string(key.multipliers));
      Curve& curve = curves[title];
      curve.title = title;
      const double y = value(lane.measured);
      if (y > 0) curve.points.emplace_back(plan.precision, y);
    }
  }
  std::vector<Curve> all;
  for (auto& [title, curve] : curves) {
    curve.style = measured_style(static_cast<int>(all.size()), all.size() < 7 ? 7 : 5);
    all.push_back(std::move(curve));
  }
  return all;
}

void add_level(Picture& picture, const Optimisation& optimisation, const std::string& title,
               double level, int color) {
  if (optimisation.plans.empty() || level <= 0) return;
  const double first = optimisation.plans.front().precision;
  const double last = optimisation.plans.back().precision;
  picture.curves.push_back({title, proven_style(color), {{first, level}, {last, level}}});
}

std::string where(const Optimisation& optimisation) {
  return optimisation.scene + " on " + optimisation.device.name;
}

Curve curve_of_plans(const Optimisation& optimisation, const std::string& title,
                     const CurveStyle& style, double (*value)(const PlanSummary&)) {
  Curve curve{title, style, {}};
  for (const PrecisionPlan& plan : optimisation.plans) {
    const PlanSummary s = summary_of(plan);
    if (s.precision != 0) curve.points.emplace_back(s.precision, value(s));
  }
  return curve;
}

CurveStyle on_right_axis(CurveStyle style) {
  style.right_axis = true;
  return style;
}

/// The plan's device filled with other ratios p_L / p_H: the plan's mix of lanes, and any number of
/// references of the kind that the plan has most of.
class OtherRatios {
public:
  explicit OtherRatios(const Optimisation& optimisation, const PrecisionPlan& plan)
      : optimisation_(optimisation), plan_(plan), chosen_(*plan.allocation()) {
    const auto& counts = chosen_.references;
    const auto most = std::max_element(counts.begin(), counts.end()) - counts.begin();
    reference_ = plan.problem.references[static_cast<std::size_t>(most)];
    for (std::size_t k = 0; k < counts.size(); ++k) {
      for (const Resource& resource : bounded_resources) {
        of_lanes_.*resource.amount -=
            counts[k] * (plan.problem.references[k].area.*resource.amount);
      }
    }
    for (const Resource& resource : bounded_resources) {
      of_lanes_.*resource.amount += chosen_.used.*resource.amount;
    }
  }

  /// The number of lanes that fit beside this many references and can be connected by their
  /// crossbars. Each lane has the average area of the plan's lanes, streams included.
  int lanes_beside(int references) const {
    const Area room = performance::usable(optimisation_.device.available, optimisation_.slack);
    const std::size_t ports = plan_.problem.communication.crossbar.size();
    double lanes = plan_.problem.max_lanes;
    if (ports > 0) lanes = std::min(lanes, static_cast<double>(ports - 1) * references);
    for (const Resource& resource : bounded_resources) {
      if (of_lanes_.*resource.amount <= 0) continue;
      const double left = room.*resource.amount -
                          static_cast<double>(references) * (reference_.area.*resource.amount);
      const double one = static_cast<double>(of_lanes_.*resource.amount) / chosen_.lane_count();
      lanes = std::min(lanes, left / one);
    }
    return std::max(0, static_cast<int>(lanes));
  }

  /// The equivalent throughput T(equ). In one clock domain references also run at the plan's clock.
  double throughput_per_s(int lanes, int references) const {
    const double lane = plan_.throughput_per_s() / chosen_.lane_count();
    const bool one_clock = plan_.problem.clocks == ClockDomains::single;
    const double reference =
        optimise::throughput_per_s(reference_, one_clock ? lane : optimise::any_clock);
    return equivalent_throughput({{.count = lanes,
                                   .throughput_per_s = lane,
                                   .recomputation_rate = plan_.recomputation_rate()}},
                                 {{.count = references, .throughput_per_s = reference}});
  }

private:
  const Optimisation& optimisation_;
  const PrecisionPlan& plan_;
  const Allocation& chosen_;
  ReferenceKind reference_;
  Area of_lanes_;  ///< the plan's area without its references
};

}  // namespace

Picture figure3(const Optimisation& optimisation) {
  Picture picture{where(optimisation) + ": equivalent throughput over p_L / p_H",
                  "p_L / p_H",
                  "T(equ), G comparisons/s",
                  "",
                  {},
                  Axis::linear,
                  Axis::logarithmic};
  const PrecisionPlan* best = optimisation.best();
  for (const PrecisionPlan& plan : optimisation.plans) {
    if (plan.allocation() == nullptr || (plan.precision % 2 != 0 && &plan != best)) continue;
    if (best != nullptr && plan.precision > best->precision) break;
    Curve curve{fmt::format("L = {}", plan.precision),
                measured_style(static_cast<int>(picture.curves.size()), 7),
                {}};
    const OtherRatios ratios(optimisation, plan);
    for (int references = 1; references <= plan.problem.max_references; ++references) {
      const int lanes = ratios.lanes_beside(references);
      if (lanes == 0) break;
      curve.points.emplace_back(static_cast<double>(lanes) / references,
                                ratios.throughput_per_s(lanes, references) / giga);
    }
    picture.curves.push_back(std::move(curve));
  }
  return picture;
}

Picture figure7(const Optimisation& optimisation) {
  Picture picture{where(optimisation) + ": area of a lane",
                  precision_axis,
                  "LUT",
                  "set xtics 4\n",
                  {},
                  Axis::linear};
  picture.curves = curves_by_kind(
      optimisation, [](const Measurement& row) { return static_cast<double>(row.area.luts); });
  int color = 0;
  for (const ReferenceImplementation& reference : optimisation.references) {
    add_level(picture, optimisation, "reference " + reference.kind.name, reference.kind.area.luts,
              color++);
  }
  return picture;
}

Picture figure8(const Optimisation& optimisation) {
  Picture picture{where(optimisation) + ": clock of a lane, " + describe_clocks(optimisation),
                  precision_axis,
                  "MHz",
                  "set xtics 4\n",
                  {},
                  Axis::linear};
  picture.curves = curves_by_kind(
      optimisation, [](const Measurement& row) { return row.clock ? row.clock->mhz : 0.0; });
  int color = 0;
  for (const ReferenceImplementation& reference : optimisation.references) {
    const auto& clock = reference.measured.clock;
    add_level(picture, optimisation, "reference " + reference.kind.name, clock ? clock->mhz : 0,
              color++);
  }
  return picture;
}

Picture figure9(const Optimisation& optimisation) {
  Picture picture{where(optimisation) + ": the best plan at each precision",
                  precision_axis,
                  "T(equ), G comparisons/s",
                  "set xtics 4\nset ytics nomirror\nset y2tics\nset y2range [0:*]\n"
                  "set y2label \"p_L, 10 p_H\"\n",
                  {},
                  Axis::linear};
  picture.curves = {
      curve_of_plans(optimisation, "T(equ)", measured_style(0, 7),
                     [](const PlanSummary& s) { return s.throughput_per_s / giga; }),
      curve_of_plans(optimisation, "p_L", on_right_axis(measured_style(1, 5)),
                     [](const PlanSummary& s) { return static_cast<double>(s.lanes); }),
      curve_of_plans(optimisation, "10 p_H", on_right_axis(measured_style(2, 9)),
                     [](const PlanSummary& s) { return 10.0 * s.references; })};
  add_level(picture, optimisation, "references alone", baseline_per_s(optimisation) / giga, 0);
  return picture;
}

}  // namespace mixcmp::report
