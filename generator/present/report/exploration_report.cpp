#include "generator/present/report/exploration_report.hpp"

#include "generator/present/report/plan_fields.hpp"

namespace mixcmp::report {

using optimise::Exploration;
using optimise::PlanSummary;
using optimise::ResultsAtClocks;
using table::Fields;
using table::Json;

Json to_json(const Exploration& exploration) {
  Json columns = Json::array();
  for (const ResultsAtClocks& column : exploration.columns) {
    Json scenario_1 = Json::object();
    for (std::size_t k = 0; k < exploration.data_sets.size(); ++k) {
      scenario_1[exploration.data_sets[k]] = object_of(plan_fields(), column.scenario_1[k]);
    }
    columns.push_back({{"title", column.title},
                       {"references_alone", column.baseline_references},
                       {"references_alone_per_s", column.baseline_per_s},
                       {"scenario_1", std::move(scenario_1)},
                       {"scenario_2", object_of(plan_fields(), summary_of(column.worst))},
                       {"notes", column.worst.notes}});
  }
  return {{"scene", exploration.scene},
          {"device", exploration.device.name},
          {"columns", std::move(columns)}};
}

Json to_json(const std::vector<SoftwareThroughput>& software) {
  table::Table all = table::named_table({"title", "one_core_per_s", "all_cores_per_s"});
  for (const SoftwareThroughput& each : software) {
    all.rows.push_back({{each.title, each.one_core_per_s, each.all_cores_per_s}});
  }
  return to_json(all);
}

std::string scenarios_csv(const Exploration& exploration) {
  table::Table table;
  const auto add = [&](const std::string& set, const ResultsAtClocks& column, const char* scenario,
                       const PlanSummary& plan) {
    const double alone = column.baseline_per_s;
    const Fields<PlanSummary> fields =
        table::constant<PlanSummary>({"data_set"}, set) +
        table::constant<PlanSummary>({.name = "clocks", .in_csv = "\"{}\""}, column.title) +
        table::constant<PlanSummary>({"scenario"}, scenario) + plan_figures() +
        table::constant<PlanSummary>({.name = "gain", .in_csv = "{:.4g}"},
                                     alone > 0 ? plan.throughput_per_s / alone : 0);
    append(table, table_of(fields, {plan}));
  };
  for (const ResultsAtClocks& column : exploration.columns) {
    for (std::size_t k = 0; k < exploration.data_sets.size(); ++k) {
      add(exploration.data_sets[k], column, "I", column.scenario_1[k]);
    }
    add("worst of all", column, "II", summary_of(column.worst));
  }
  return to_csv(table);
}

}  // namespace mixcmp::report
