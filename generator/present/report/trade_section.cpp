#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "generator/present/page/chart.hpp"
#include "generator/present/report/report_sections.hpp"
#include "generator/present/report/trade_report.hpp"
#include "generator/present/report/units.hpp"

namespace mixcmp::report {
namespace {

using optimise::LaneImplementation;
using optimise::Optimisation;
using profile::SchemeKind;
using profile::Trade;
using profile::TradePoint;

/// A kind of lane in a picture of area against rate.
struct Candidate {
  std::string series;
  page::ChartPoint point;  ///< x: LUTs; y: recomputation rate
  bool certified = true;
};

/// The points that no other one beats in both, by rising x.
std::vector<page::ChartPoint> front_of(const std::vector<Candidate>& candidates) {
  std::vector<page::ChartPoint> points;
  for (const Candidate& candidate : candidates) {
    if (candidate.certified) points.push_back(candidate.point);
  }
  std::sort(points.begin(), points.end(),
            [](const auto& a, const auto& b) { return std::pair(a.x, a.y) < std::pair(b.x, b.y); });
  std::vector<page::ChartPoint> front;
  for (page::ChartPoint& point : points) {
    if (front.empty() || point.y < front.back().y) front.push_back(std::move(point));
  }
  return front;
}

/// Leaves out lanes that recompute nothing, except the smallest of each series.
std::vector<Candidate> without_needless(std::vector<Candidate> candidates) {
  std::map<std::string, double> least;  // LUTs of a lane that recomputes nothing, by series
  for (const Candidate& candidate : candidates) {
    if (candidate.point.y > 0) continue;
    const auto [entry, is_new] = least.emplace(candidate.series, candidate.point.x);
    if (!is_new) entry->second = std::min(entry->second, candidate.point.x);
  }
  std::erase_if(candidates, [&](const Candidate& candidate) {
    return candidate.point.y <= 0 && candidate.point.x > least.at(candidate.series);
  });
  return candidates;
}

page::Chart chart_of_candidates(const std::string& title, const std::string& x_label,
                                const std::vector<Candidate>& candidates) {
  page::Chart chart{.title = title,
                    .x = {x_label, page::Scaling::logarithmic},
                    .y = {"recomputed / comparisons", page::Scaling::logarithmic},
                    .series = {},
                    .wide = true};
  std::map<std::string, std::size_t> known;
  std::vector<page::ChartPoint> front = front_of(candidates);
  chart.series.push_back({"Pareto front of certified lanes", 6, page::Mark::steps, {}});
  for (page::ChartPoint& point : front) point.tip = "on the front\n" + point.tip;
  for (const Candidate& candidate : candidates) {
    const auto [entry, is_new] = known.emplace(candidate.series, chart.series.size());
    if (is_new) {
      const int color = static_cast<int>(chart.series.size()) - 1;
      chart.series.push_back({candidate.series, color, page::Mark::points, {}});
    }
    chart.series[entry->second].points.push_back(candidate.point);
  }
  chart.series.front().points = std::move(front);
  return chart;
}

std::vector<Candidate> candidates_of(const Trade& trade) {
  std::vector<Candidate> candidates;
  for (const TradePoint& point : trade.points) {
    if (point.kind == SchemeKind::lanes_alone) continue;
    candidates.push_back(
        {point.scheme,
         {point.lane_luts, point.rate,
          fmt::format("{}, L = {}\n{:.0f} LUTs a lane ({})\nrecomputation rate {:.3e}\n{:.3f} "
                      "comparisons a cycle from 1000 LUTs\n{:.4g} wrong verdicts per million",
                      point.scheme, point.precision, point.lane_luts,
                      point.measured ? "measured" : "cost model", point.rate, point.per_kiloluts,
                      point.wrong_per_million)},
         point.kind == SchemeKind::certified});
  }
  return without_needless(std::move(candidates));
}

std::vector<Candidate> candidates_of(const Optimisation& plans) {
  std::vector<Candidate> candidates;
  for (const optimise::PrecisionPlan& plan : plans.plans) {
    for (const LaneImplementation& lane : plan.lanes) {
      const measured::Lane& key = lane.lane();
      const std::string kind = fmt::format(
          "{}{}{}", to_string(key.bound), key.inputs ? ", " + describe(*key.inputs) : "",
          key.multipliers ? fmt::format(", multipliers: {}", to_string(*key.multipliers)) : "");
      candidates.push_back(
          {kind,
           {static_cast<double>(lane.with_streams.luts), lane.kind.recomputation_rate,
            fmt::format("{}\n{} LUTs, {} DSPs, {} registers with its streams\nrecomputation rate "
                        "{:.3e}\n{:.1f} MHz",
                        lane.kind.name, lane.with_streams.luts, lane.with_streams.dsps,
                        lane.with_streams.registers, lane.kind.recomputation_rate,
                        lane.kind.clock_hz / optimise::hertz_per_mhz)},
           !key.bound.is_profiled()});
    }
  }
  return candidates;
}

void add_measured(page::Section& section, const Optimisation& plans) {
  const std::vector<Candidate> candidates = candidates_of(plans);
  if (candidates.empty()) return;
  section.content.push_back(page::heading("Measured lanes on " + plans.device.name));
  section.content.push_back(page::figure(
      draw(chart_of_candidates("Measured area of lanes against their recomputation rate",
                               "LUTs of a lane with its streams", candidates)),
      "Each point is a kind of lane of the scene's table of areas. Lanes whose products are in "
      "embedded multipliers need fewer LUTs; the plan weighs both."));
}

void add_modelled(page::Section& section, const Trade& trade) {
  section.content.push_back(
      page::heading(fmt::format("All kinds of lanes, {}", describe(trade.inputs))));
  section.content.push_back(page::figure(
      draw(chart_of_candidates("Area of lanes against their recomputation rate, by a cost model",
                               "LUTs of a lane (no DSPs)", candidates_of(trade))),
      "Areas by a rough cost model of only LUTs, to compare precisions and bounds with each "
      "other. "
      "Pointing at a mark, or the arrow keys on the picture, shows its numbers."));
  section.content.push_back(page::note(advice(trade, 0)));
}

}  // namespace

page::Section trade_section(const std::vector<Trade>& trades, const Optimisation* plans) {
  page::Section section{"trade", "The trade", {}};
  section.content.push_back(page::paragraph(
      "A narrow lane is small and leaves more to the references; a wide one is large and leaves "
      "less. No point below and left of the front is known."));
  if (plans != nullptr) add_measured(section, *plans);
  for (const Trade& trade : trades) add_modelled(section, trade);
  return section;
}

}  // namespace mixcmp::report
