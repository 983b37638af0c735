#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "generator/present/page/chart.hpp"
#include "generator/present/page/share_bars.hpp"
#include "generator/present/report/plan_report.hpp"
#include "generator/present/report/plan_shares.hpp"
#include "generator/present/report/report_sections.hpp"
#include "generator/present/report/units.hpp"
#include "model/cost/performance/performance.hpp"
#include "model/plan/optimise/crossover.hpp"
#include "model/plan/optimise/plan_summary.hpp"

namespace mixcmp::report {
namespace {

using optimise::baseline_per_s;
using optimise::Optimisation;
using optimise::PlanSummary;
using optimise::PrecisionPlan;
using optimise::PublishedFigures;

std::string tip_of(const PlanSummary& s) {
  return fmt::format(
      "L = {}\np_L = {}, p_H = {}\n{:.2f} G comparisons/s at {:.1f} MHz\nrecomputation rate "
      "{:.3e}\n{}",
      s.precision, s.lanes, s.references, s.throughput_per_s / giga, s.clock_mhz,
      s.recomputation_rate, s.kinds);
}

/// A series with a point for each precision that has a plan.
page::Series series_of(const Optimisation& plans, const std::string& title, int color,
                       double (*value)(const PlanSummary&)) {
  page::Series series{title, color, page::Mark::line, {}};
  for (const PrecisionPlan& plan : plans.plans) {
    const PlanSummary s = summary_of(plan);
    if (s.precision == 0) continue;
    series.points.push_back({static_cast<double>(s.precision), value(s), tip_of(s)});
  }
  return series;
}

page::Chart throughput_chart(const Optimisation& plans,
                             const std::optional<PublishedFigures>& published) {
  page::Chart chart{.title = "Equivalent throughput of the best plan at each precision",
                    .x = {precision_axis, page::Scaling::linear, false, 1},
                    .y = {"T(equ), G comparisons/s", page::Scaling::linear},
                    .series = {series_of(plans, "T(equ)", 0, [](const PlanSummary& s) {
                      return s.throughput_per_s / giga;
                    })}};
  const auto level = [&](const std::string& title, double low, double high) {
    chart.bands.push_back({title, page::ChartBand::Across::y, low, high});
  };
  const double alone = baseline_per_s(plans) / giga;
  if (alone > 0) level(fmt::format("references alone, {:.3g}", alone), alone, alone);
  if (published) {
    level("the paper, scenario I", published->worst_per_s / giga, published->best_per_s / giga);
    level("the paper, references alone", published->baseline_per_s / giga,
          published->baseline_per_s / giga);
  }
  return chart;
}

page::Chart counts_chart(const Optimisation& plans,
                         const std::optional<PublishedFigures>& published) {
  page::Chart chart{
      .title = "Numbers of lanes and references of the best plan at each precision",
      .x = {precision_axis, page::Scaling::linear, false, 1},
      .y = {"datapaths", page::Scaling::logarithmic},
      .series = {series_of(plans, "p_L, lanes", 1,
                           [](const PlanSummary& s) { return static_cast<double>(s.lanes); }),
                 series_of(plans, "p_H, references", 2, [](const PlanSummary& s) {
                   return static_cast<double>(s.references);
                 })}};
  if (published) {
    chart.bands.push_back({"the paper, p_L", page::ChartBand::Across::y,
                           static_cast<double>(published->lanes_worst),
                           static_cast<double>(published->lanes_best)});
  }
  return chart;
}

page::ShareBars bars_of(const Optimisation& plans, const PrecisionPlan& best) {
  page::ShareBars bars{.title = "What each part of the best plan takes of the device",
                       .usable_name = fmt::format("usable (slack {:g})", plans.slack),
                       .segments = {},
                       .bars = {}};
  const std::vector<PartShare> parts = shares_of(best);
  for (const PartShare& part : parts) {
    bars.segments.push_back({part.name, static_cast<int>(bars.segments.size())});
  }
  const devices::Area usable = performance::usable(plans.device.available, plans.slack);
  for (const devices::Resource& resource : devices::bounded_resources) {
    if (plans.device.available.*resource.amount == 0) continue;
    page::ShareBar bar{.name = resource.name,
                       .available = static_cast<double>(plans.device.available.*resource.amount),
                       .usable = static_cast<double>(usable.*resource.amount),
                       .amounts = {}};
    for (const PartShare& part : parts) {
      bar.amounts.push_back(static_cast<double>(part.area.*resource.amount));
    }
    bars.bars.push_back(std::move(bar));
  }
  return bars;
}

/// The resource of which the plan uses the largest share of the usable amount.
std::string limit_of(const Optimisation& plans, const PlanSummary& best) {
  const devices::Area usable = performance::usable(plans.device.available, plans.slack);
  const auto [resource, share] = optimise::largest_share(best.used, usable);
  return resource == nullptr ? "none" : fmt::format("{}, {:.0f} %", resource->name, 100 * share);
}

void add_best(page::Section& section, const Optimisation& plans, const PrecisionPlan& plan) {
  const PlanSummary best = summary_of(plan);
  const double alone = baseline_per_s(plans);
  table::Lines figures = {{"L, precision of the lanes", fmt::format("{}", best.precision)},
                          {"p_L, lanes", fmt::format("{}", best.lanes)},
                          {"p_H, references", fmt::format("{}", best.references)},
                          {"G comparisons/s", fmt::format("{:.3g}", best.throughput_per_s / giga)},
                          {"limited by", limit_of(plans, best)}};
  if (alone > 0) {
    figures.push_back(
        {"times references alone", fmt::format("{:.2f}", best.throughput_per_s / alone)});
  }
  section.content.push_back(page::key_figures(figures));
  section.content.push_back(page::paragraph(best.kinds));
  section.content.push_back(
      page::note(fmt::format("On {} ({}), slack {:g}; clocks: {}.", plans.device.name,
                             plans.device.vendor_name, plans.slack, describe_clocks(plans))));
  section.content.push_back(
      page::figure(draw(bars_of(plans, plan)),
                   "What each part takes of the device, by the measured areas of the table."));
}

/// Throughput over the part of the device: below the knee the dashed line, the highest throughput
/// per area, is far above the front.
page::Chart front_chart(const Front& front) {
  constexpr double percent = 0.01;
  page::Series systems{"the best system", 0, page::Mark::line, {}};
  double most_per_share = 0;
  for (const optimise::FrontPoint& point : front) {
    systems.points.push_back(
        {point.share / percent, point.plan.throughput_per_s / giga,
         fmt::format("{:g} % of the device\n{}", point.share / percent, tip_of(point.plan))});
    most_per_share = std::max(most_per_share, point.per_share());
  }
  const double share = front.back().share;
  const std::string level = fmt::format("{:.3g} G/s per 1 %", percent * most_per_share / giga);
  page::Series highest{"highest throughput per area",
                       2,
                       page::Mark::dashed_line,
                       {{0, 0, level}, {share / percent, share * most_per_share / giga, level}}};
  page::Series knee{"knee", 1, page::Mark::points, {}};
  const optimise::FrontPoint& at = *knee_of(front);
  knee.points.push_back(
      {at.share / percent, at.plan.throughput_per_s / giga,
       fmt::format("knee: {:g} % of the device\n{}", at.share / percent, tip_of(at.plan))});
  return {.title = "Throughput of the best system in a part of the device",
          .x = {"part of the device, %", page::Scaling::linear},
          .y = {"T(equ), G comparisons/s", page::Scaling::linear},
          .series = {std::move(systems), std::move(highest), std::move(knee)}};
}

void add_front(page::Section& section, const std::optional<IfThere<Front>>& there) {
  if (!there) return;
  if (const auto* missing = std::get_if<Missing>(&*there)) {
    section.content.push_back(page::missing(missing->why, missing->command));
    return;
  }
  const auto& front = std::get<Front>(*there);
  if (front.empty()) return;
  section.content.push_back(page::figure(
      draw(front_chart(front)),
      "The best system, on predicted areas, in parts of the device, by mixcmp optimise. The knee "
      "is "
      "the smallest with 0.9 of the highest throughput per area; below it the reference, which is "
      "needed once, takes more of the area than it is worth."));
}

/// Adds a note if the scene has a system of its own that is not the plan's.
void add_difference(page::Section& section, const scene::Scene& scene, const PlanSummary& best) {
  const auto lanes = scene.lane_count(), references = scene.reference_count();
  if (!lanes || !references) return;
  const bool same = *lanes == best.lanes && *references == best.references;
  section.content.push_back(page::note(
      same ? std::string("The scene's own system has as many lanes and references.")
           : fmt::format("The scene itself asks for {} lanes and {} references, shown below under "
                         "\"The system\". mixcmp optimise -o writes this plan as a scene.",
                         *lanes, *references)));
}

}  // namespace

page::Section plan_section(const scene::Scene& scene, const IfThere<Optimisation>& there,
                           const std::optional<IfThere<Front>>& front,
                           const std::optional<PublishedFigures>& published) {
  page::Section section{"plan", "The plan", {}};
  if (const auto* missing = std::get_if<Missing>(&there)) {
    section.content.push_back(page::missing(missing->why, missing->command));
    add_front(section, front);
    return section;
  }
  const auto& plans = std::get<Optimisation>(there);
  const PrecisionPlan* best = plans.best();
  if (best != nullptr) {
    add_best(section, plans, *best);
    add_difference(section, scene, summary_of(*best));
  } else {
    section.content.push_back(page::missing("No precision has a feasible plan.", ""));
  }
  section.content.push_back(page::gallery(
      {page::figure(draw(throughput_chart(plans, published)),
                    "The best plan at each precision, by integer linear programming."),
       page::figure(draw(counts_chart(plans, published)),
                    "Its lanes and references; the axis is logarithmic.")}));
  add_front(section, front);
  section.content.push_back(
      page::details("The plan at every precision", page::draw(plan_table(plans))));
  for (const std::string& note : plans.notes)
    section.content.push_back(page::note("Note: " + note));
  return section;
}

}  // namespace mixcmp::report
