#include "generator/present/report/trade_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>

#include "generator/present/report/plot.hpp"

namespace mixcmp::report {

using profile::SchemeKind;
using profile::Trade;
using profile::TradePoint;

namespace {

using Json = nlohmann::ordered_json;

std::string_view to_string(SchemeKind kind) {
  switch (kind) {
    case SchemeKind::lanes_alone: return "lanes alone";
    case SchemeKind::profiled: return "profiled";
    case SchemeKind::certified: return "certified";
  }
  return "";
}

/// Gnuplot commands for a band below the numbers of the axis, in which points without a wrong
/// verdict are drawn.
std::string none_band(double floor) {
  const int lowest = static_cast<int>(std::ceil(std::log10(floor)));
  std::string tics;
  for (int k = lowest; k <= 6; ++k)
    tics += fmt::format("{}\"1e{:+03}\" 1e{}", tics.empty() ? "" : ", ", k, k);
  return fmt::format(
      "set yrange [{0}:*]\nunset mytics\nset ytics ({1})\n"
      "set label \"none\" at graph -0.06, first {2}\n"
      "set arrow from graph 0, first {3} to graph 1, first {3} nohead lc rgb '#888888'\n",
      floor / 500, tics, floor / 20, floor);
}

std::vector<std::string> schemes_of(const Trade& trade) {
  std::vector<std::string> schemes;
  for (const TradePoint& point : trade.points) {
    if (schemes.empty() || schemes.back() != point.scheme) schemes.push_back(point.scheme);
  }
  return schemes;
}

std::string cell(const TradePoint& point) {
  return fmt::format("  {:>6.3f}{} {:>8.3g}", point.per_kiloluts, point.measured ? "*" : " ",
                     point.wrong_per_million);
}

/// The upper edge of the band for points without a wrong verdict, in wrong verdicts per million: a
/// tenth of the least number above 0, at most 0.1.
double floor_of(const std::vector<Trade>& trades) {
  double least = 1;
  for (const Trade& trade : trades) {
    for (const TradePoint& point : trade.points) {
      if (point.wrong_per_million > 0) least = std::min(least, point.wrong_per_million);
    }
  }
  return least / 10;
}

}  // namespace

std::string to_text(const Trade& trade) {
  std::string text = fmt::format(
      "\ntrade, {}: comparisons a cycle from 1000 LUTs, and wrong verdicts per million\n"
      "reference: {:.0f} LUTs ({}), {:.3g} wrong per million; R_S = {}; * is a measured "
      "area\n{:>4}",
      describe(trade.inputs), trade.reference_luts,
      trade.reference_measured ? "measured" : "cost model", trade.reference_wrong_per_million,
      trade.slack, "L");
  const std::vector<std::string> schemes = schemes_of(trade);
  for (const std::string& scheme : schemes) text += fmt::format("  {:>16}", scheme);
  text += "\n    ";
  for (std::size_t k = 0; k < schemes.size(); ++k)
    text += fmt::format("  {:>7} {:>8}", "", "wrong");
  std::map<int, std::map<std::string, const TradePoint*>> rows;
  for (const TradePoint& point : trade.points) rows[point.precision][point.scheme] = &point;
  for (const auto& [precision, points] : rows) {
    text += fmt::format("\n{:>4}", precision);
    for (const std::string& scheme : schemes) {
      const auto found = points.find(scheme);
      text += found == points.end() ? fmt::format("  {:>16}", "-") : cell(*found->second);
    }
  }
  return text + "\n";
}

std::string advice(const Trade& trade, double accepted_per_million) {
  const std::string accepted =
      accepted_per_million > 0
          ? fmt::format("at most {} wrong verdicts per million", accepted_per_million)
          : "certified, no wrong verdict";
  const std::string unknown =
      trade.undetermined_per_million > 0
          ? fmt::format(
                " (and {:.4g} per million whose truth is undetermined, each counted as wrong)",
                trade.undetermined_per_million)
          : "";
  const TradePoint* point = cheapest(trade, accepted_per_million);
  if (point == nullptr)
    return fmt::format("{}: no scheme at any of these precisions{}\n", accepted, unknown);
  return fmt::format(
      "{}: cheapest at L = {}, scheme {}, {}: {:.4g} wrong per million on this data{}, "
      "recomputation rate {:.2e}, {:.3f} comparisons a cycle from 1000 LUTs\n",
      accepted, point->precision, point->scheme, describe(trade.inputs), point->wrong_per_million,
      unknown, point->rate, point->per_kiloluts);
}

Json to_json(const Trade& trade) {
  Json points = Json::array();
  for (const TradePoint& point : trade.points) {
    points.push_back({{"scheme", point.scheme},
                      {"kind", to_string(point.kind)},
                      {"precision", point.precision},
                      {"wrong_per_million", point.wrong_per_million},
                      {"rate", point.rate},
                      {"lane_luts", point.lane_luts},
                      {"area", point.measured ? "measured" : "model"},
                      {"comparisons_per_kiloluts", point.per_kiloluts}});
  }
  return {{"inputs", to_string(trade.inputs)},
          {"slack", trade.slack},
          {"reference_luts", trade.reference_luts},
          {"reference_area", trade.reference_measured ? "measured" : "model"},
          {"reference_wrong_per_million", trade.reference_wrong_per_million},
          {"undetermined_per_million", trade.undetermined_per_million},
          {"points", std::move(points)}};
}

std::string trade_csv(const std::vector<Trade>& trades) {
  std::string text =
      "inputs,scheme,precision,wrong_per_million,rate,lane_luts,reference_luts,area,"
      "comparisons_per_kiloluts\n";
  for (const Trade& trade : trades) {
    for (const TradePoint& point : trade.points) {
      fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{},{}\n",
                     to_string(trade.inputs), point.scheme, point.precision,
                     point.wrong_per_million, point.rate, point.lane_luts, trade.reference_luts,
                     point.measured ? "measured" : "model", point.per_kiloluts);
    }
  }
  return text;
}

std::string trade_script(const std::vector<Trade>& trades, const std::string& scene) {
  const double floor = floor_of(trades);
  Picture picture{.title = scene + ": accuracy against area",
                  .x_label = "comparisons a cycle from 1000 LUTs",
                  .y_label = "wrong verdicts per million",
                  .axes = none_band(floor),
                  .curves = {}};
  double none = floor;
  for (const Trade& trade : trades) {
    int color = 0;
    const TradePoint* before = nullptr;
    for (const TradePoint& point : trade.points) {
      if (before == nullptr || before->scheme != point.scheme) {
        const int mark = trade.inputs == LaneInputs::exact ? 7 : 6;
        // Points without a wrong verdict have another height for each scheme.
        none *= 0.6;
        picture.curves.push_back({fmt::format("{}, {}", point.scheme, describe(trade.inputs)),
                                  measured_style(color++, mark),
                                  {}});
      }
      picture.curves.back().points.emplace_back(point.per_kiloluts,
                                                std::max(point.wrong_per_million, none));
      before = &point;
    }
  }
  return script(picture);
}

}  // namespace mixcmp::report
