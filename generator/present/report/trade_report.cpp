#include "generator/present/report/trade_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "generator/present/report/plot.hpp"
#include "generator/present/table/table.hpp"

namespace mixcmp::report {

using profile::SchemeKind;
using profile::Trade;
using profile::TradePoint;
using table::Fields;
using table::Json;
using table::Table;

namespace {

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

const char* source_of(bool measured) {
  return measured ? "measured" : "model";
}

const Fields<TradePoint>& point_fields() {
  static const Fields<TradePoint> fields = {
      {{"scheme"}, &TradePoint::scheme},
      {{"kind"}, [](const TradePoint& point) { return to_string(point.kind); }},
      {{"precision"}, &TradePoint::precision},
      {{"wrong_per_million"}, &TradePoint::wrong_per_million},
      {{"rate"}, &TradePoint::rate},
      {{"lane_luts"}, &TradePoint::lane_luts},
      {{"area"}, [](const TradePoint& point) { return source_of(point.measured); }},
      {{"comparisons_per_kiloluts"}, &TradePoint::per_kiloluts}};
  return fields;
}

/// The columns of the CSV, with those that all points have in common.
Fields<TradePoint> csv_fields(const Trade& trade) {
  const auto& fields = point_fields();
  return table::constant<TradePoint>({"inputs"}, to_string(trade.inputs)) +
         pick(fields, {"scheme", "precision", "wrong_per_million", "rate", "lane_luts"}) +
         table::constant<TradePoint>({"reference_luts"}, trade.reference_luts) +
         pick(fields, {"area", "comparisons_per_kiloluts"});
}

/// Adds cells of schemes without a point at this precision.
void fill_to(std::vector<Json>& row, std::size_t columns) {
  while (row.size() < columns) row.push_back(row.size() % 2 == 1 ? Json("") : Json());
}

/// A row for each precision, with two columns for each scheme.
Table by_precision(const Trade& trade) {
  Table table{.columns = {{"precision", "L", 4, 0}}, .rows = {}};
  std::map<int, std::vector<Json>> rows;
  for (const TradePoint& point : trade.points) {
    if (table.columns.back().group != point.scheme) {
      table.columns.push_back({.name = {}, .width = 7, .group = point.scheme});
      table.columns.push_back({{}, "wrong", 8, 1, "{:.3g}", 1, "{}", point.scheme});
    }
    std::vector<Json>& row = rows[point.precision];
    if (row.empty()) row.push_back(point.precision);
    fill_to(row, table.columns.size() - 2);
    row.push_back(fmt::format("{:.3f}{}", point.per_kiloluts, point.measured ? "*" : " "));
    row.push_back(point.wrong_per_million);
  }
  for (auto& [precision, row] : rows) {
    fill_to(row, table.columns.size());
    table.rows.push_back({std::move(row)});
  }
  return table;
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
  return fmt::format(
             "\ntrade, {}: comparisons a cycle from 1000 LUTs, and wrong verdicts per million\n"
             "reference: {:.0f} LUTs ({}), {:.3g} wrong per million; R_S = {}; * is a measured "
             "area\n",
             describe(trade.inputs), trade.reference_luts,
             trade.reference_measured ? "measured" : "cost model",
             trade.reference_wrong_per_million, trade.slack) +
         to_text(by_precision(trade));
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
  return {{"inputs", to_string(trade.inputs)},
          {"slack", trade.slack},
          {"reference_luts", trade.reference_luts},
          {"reference_area", source_of(trade.reference_measured)},
          {"reference_wrong_per_million", trade.reference_wrong_per_million},
          {"undetermined_per_million", trade.undetermined_per_million},
          {"points", to_json(table_of(point_fields(), trade.points))}};
}

std::string trade_csv(const std::vector<Trade>& trades) {
  Table table = table_of(csv_fields({}), {});
  for (const Trade& trade : trades) append(table, table_of(csv_fields(trade), trade.points));
  return to_csv(table);
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
