#include "generator/faces/cli/plan_set_report.hpp"

#include <fmt/format.h>

#include "generator/present/report/plan_fields.hpp"
#include "generator/present/report/units.hpp"
#include "generator/present/table/table.hpp"
#include "model/plan/optimise/plan_summary.hpp"

namespace mixcmp::cli {
namespace {

using table::Json;
using table::Table;
using tasks::Drift;
using tasks::PlanSetResult;

using Names = std::vector<std::string>;

std::string number_of(std::size_t plan) {
  return fmt::format("plan_{}", plan + 1);
}

/// Comparisons per second of each plan on each data set.
Table data_set_table(const PlanSetResult& result, const Names& sets) {
  const auto column = [](const std::string& name, const std::string& title) {
    return table::Column{name, title, 8, 2, "{:.2f}", report::giga, "{:.6g}"};
  };
  Table table{.columns = {column("best_per_s", "best")}};
  for (std::size_t k = 0; k < result.plans.size(); ++k) {
    table.columns.push_back(column(number_of(k) + "_per_s", fmt::format("plan {}", k + 1)));
  }
  table.columns.push_back({.name = "data", .title = "G/s on"});
  for (std::size_t s = 0; s < sets.size(); ++s) {
    table::Row& row = table.rows.emplace_back();
    row.cells.emplace_back(result.best_per_s[s]);
    for (const tasks::SetPlan& plan : result.plans) {
      row.cells.emplace_back(plan.at_set[s].throughput_per_s);
    }
    row.cells.emplace_back(sets[s]);
  }
  return table;
}

/// "0 to 0.21 %, 0.6 % and above"
std::string ranges_text(const std::vector<optimise::RateRange>& ranges) {
  std::string text;
  for (const auto& [from, to] : ranges) {
    if (!text.empty()) text += ", ";
    text += to >= 1 ? fmt::format("from {:.3g} %", from * 100)
                    : fmt::format("{:.3g} to {:.3g} %", from * 100, to * 100);
  }
  return text.empty() ? "at none" : text;
}

Table plan_table(const PlanSetResult& result) {
  Table table{.columns = {{"plan", "plan", 4, 0}, {"best_rates", "fastest at its R_R of", 26}}};
  const auto fields = pick(report::plan_fields(), {"precision", "lanes", "references", "kinds"});
  for (const auto& field : fields) table.columns.push_back(field.column);
  for (std::size_t k = 0; k < result.plans.size(); ++k) {
    table::Row& row = table.rows.emplace_back();
    row.cells = {k + 1, ranges_text(result.rule.best_rates(k))};
    const optimise::PlanSummary summary = summary_of(result.plans[k].plan());
    for (const auto& field : fields) row.cells.push_back(field.value(summary));
  }
  return table;
}

/// The time that a choice takes beyond that of a plan for each data set, as a part of the choice's.
double loss(const PlanSetResult& result, double seconds) {
  return 1 - result.least_seconds() / seconds;
}

std::string losses_text(const PlanSetResult& result) {
  std::string text = "lost against a plan for each data set, of as many comparisons from each:\n";
  for (std::size_t k = 0; k < result.seconds_with.size(); ++k) {
    text += fmt::format("  {} plan{} {:6.2f} %\n", k + 1,
                        k == 0 ? ": " : "s:", loss(result, result.seconds_with[k]) * 100);
  }
  if (result.single_seconds < result.seconds_with.front()) {
    text += fmt::format("  the best single plan of all interfaces ({}): {:.2f} %\n",
                        result.single_interface, loss(result, result.single_seconds) * 100);
  }
  return text;
}

/// The stream, block lengths as rows: comparisons per second, reconfigurations included.
Table drift_table(const PlanSetResult& result, std::size_t blocks) {
  const auto per_s = [](const std::string& name, const std::string& title) {
    return table::Column{name, title, 9, 2, "{:.2f}", report::giga, "{:.6g}"};
  };
  const auto count = [](const std::string& name) { return table::Column{name, "switches", 8}; };
  Table table{.columns = {{"comparisons", "a block", 9, 0, "{:.2e}", 1, "{}"},
                          per_s("single_per_s", "one plan"),
                          per_s("rule_per_s", "switched"),
                          count("rule_switches"),
                          per_s("foresight_per_s", "foresight"),
                          count("foresight_switches"),
                          per_s("free_per_s", "each best")}};
  for (const Drift& drift : result.drifts) {
    const double all = static_cast<double>(drift.comparisons) * static_cast<double>(blocks);
    table.rows.push_back(
        {.cells = {static_cast<double>(drift.comparisons), all / drift.single_seconds,
                   all / drift.rule.seconds, drift.rule.switches, all / drift.foresight.seconds,
                   drift.foresight.switches, all / drift.free_seconds}});
  }
  return table;
}

std::string drift_text(const PlanSetResult& result, const Names& blocks) {
  if (result.drifts.empty()) return "";
  return fmt::format(
             "\na stream of {} blocks, {} to {}, G/s with reconfigurations; \"one plan\" is the "
             "best single one for this\nstream, \"foresight\" knows it, \"each best\" has a plan "
             "for each block and pays nothing\n",
             blocks.size(), blocks.front(), blocks.back()) +
         to_text(drift_table(result, blocks.size()));
}

}  // namespace

Names plan_lines(const PlanSetResult& result) {
  Names lines;
  for (const tasks::SetPlan& each : result.plans) {
    const optimise::PlanSummary s = summary_of(each.plan());
    lines.push_back(
        fmt::format("L = {}, {} x {}: {}", s.precision, s.lanes, s.references, s.kinds));
  }
  return lines;
}

std::string to_text(const PlanSetResult& result, const Names& sets, const Names& blocks) {
  const tasks::PlannedSystem& first = result.plans.front().system;
  return fmt::format("{} on {}: {} plan{}, {}\n\n", first.found.scene, first.found.device.name,
                     result.plans.size(), result.plans.size() == 1 ? "" : "s", first.interface) +
         to_text(data_set_table(result, sets)) + "\n" + to_text(plan_table(result)) + "\n" +
         losses_text(result) +
         fmt::format("a reconfiguration takes {:.4g} s\n", result.rule.reconfiguration_seconds()) +
         drift_text(result, blocks);
}

Json to_json(const PlanSetResult& result, const Names& sets, const Names& blocks) {
  const tasks::PlannedSystem& first = result.plans.front().system;
  Json json = {{"scene", first.found.scene},
               {"device", first.found.device.name},
               {"interface", first.interface},
               {"reconfiguration_seconds", result.rule.reconfiguration_seconds()}};
  for (std::size_t k = 0; k < result.plans.size(); ++k) {
    const tasks::SetPlan& plan = result.plans[k];
    Json each = object_of(report::plan_fields(), summary_of(plan.plan()));
    each["settings"] = plan.system.settings;
    each["best_rates"] = result.rule.best_rates(k);
    for (const optimise::PlanAtRates& at : plan.at_set) {
      each["counted_rates"].push_back(at.counted_rate);
    }
    json["plans"].push_back(std::move(each));
  }
  json["data_sets"] = to_json(data_set_table(result, sets));
  for (const double seconds : result.seconds_with) json["losses"].push_back(loss(result, seconds));
  json["single_loss"] = loss(result, result.single_seconds);
  json["single_interface"] = result.single_interface;
  json["stream"] = to_json(drift_table(result, blocks.size()));
  return json;
}

}  // namespace mixcmp::cli
