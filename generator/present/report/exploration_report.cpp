#include "generator/present/report/exploration_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace mixcmp::report {

using optimise::Exploration;
using optimise::PlanSummary;
using optimise::ResultsAtClocks;

nlohmann::ordered_json to_json(const Exploration& exploration) {
  using Json = nlohmann::ordered_json;
  const auto json_of = [](const PlanSummary& s) {
    return Json{{"precision", s.precision},
                {"lanes", s.lanes},
                {"references", s.references},
                {"clock_mhz", s.clock_mhz},
                {"recomputation_rate", s.recomputation_rate},
                {"throughput_per_s", s.throughput_per_s},
                {"kinds", s.kinds}};
  };
  Json columns = Json::array();
  for (const ResultsAtClocks& column : exploration.columns) {
    Json scenario_1 = Json::object();
    for (std::size_t k = 0; k < exploration.data_sets.size(); ++k) {
      scenario_1[exploration.data_sets[k]] = json_of(column.scenario_1[k]);
    }
    columns.push_back({{"title", column.title},
                       {"references_alone", column.baseline_references},
                       {"references_alone_per_s", column.baseline_per_s},
                       {"scenario_1", std::move(scenario_1)},
                       {"scenario_2", json_of(summary_of(column.worst))},
                       {"notes", column.worst.notes}});
  }
  return {{"scene", exploration.scene},
          {"device", exploration.device.name},
          {"columns", std::move(columns)}};
}

nlohmann::ordered_json to_json(const std::vector<SoftwareThroughput>& software) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const SoftwareThroughput& each : software) {
    all.push_back({{"title", each.title},
                   {"one_core_per_s", each.one_core_per_s},
                   {"all_cores_per_s", each.all_cores_per_s}});
  }
  return all;
}

std::string scenarios_csv(const Exploration& exploration) {
  std::string text =
      "data_set,clocks,scenario,precision,lanes,references,clock_mhz,recomputation_rate,"
      "throughput_per_s,gain\n";
  const auto add = [&](const std::string& set, const ResultsAtClocks& column, const char* scenario,
                       const PlanSummary& s) {
    const double gain = column.baseline_per_s > 0 ? s.throughput_per_s / column.baseline_per_s : 0;
    text += fmt::format("{},\"{}\",{},{},{},{},{:.6g},{:.6g},{:.6g},{:.4g}\n", set, column.title,
                        scenario, s.precision, s.lanes, s.references, s.clock_mhz,
                        s.recomputation_rate, s.throughput_per_s, gain);
  };
  for (const ResultsAtClocks& column : exploration.columns) {
    for (std::size_t k = 0; k < exploration.data_sets.size(); ++k) {
      add(exploration.data_sets[k], column, "I", column.scenario_1[k]);
    }
    add("worst of all", column, "II", summary_of(column.worst));
  }
  return text;
}

}  // namespace mixcmp::report
