#include "model/optimise/exploration.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace mixcmp::model {
namespace {

Rates worst_of(const std::vector<DataSet>& sets) {
  Rates worst;
  for (const DataSet& set : sets) worst.raise_to(set.rates);
  return worst;
}

int reference_count(const AllocationResult& alone) {
  const auto* chosen = std::get_if<Allocation>(&alone);
  return chosen == nullptr ? 0 : chosen->lane_count();
}

}  // namespace

Result<Exploration> explore(const Scene& scene, const Device& device, const Characterisation& table,
                            const std::vector<DataSet>& sets,
                            const std::vector<std::pair<std::string, ClockChoice>>& columns,
                            const OptimiseOptions& options) {
  MIXCMP_CHECK(!sets.empty());
  const Rates worst = worst_of(sets);
  Exploration all{.scene = scene.name, .device = device, .data_sets = {}, .columns = {}};
  for (const DataSet& set : sets) all.data_sets.push_back(set.name);
  for (const auto& [title, clocks] : columns) {
    OptimiseOptions counted = options;
    counted.clocks = clocks;
    MIXCMP_TRY(example, optimise(scene, device, table, sets.front().rates, counted));
    MIXCMP_TRY(for_worst, optimise(scene, device, table, worst, counted));
    const bool given = example.basis == ClockBasis::given;
    ResultsAtClocks column{
        .title = given ? title : fmt::format("{}, clocks: {}", title, to_string(example.basis)),
        .clocks = clocks,
        .example = std::move(example),
        .scenario_1 = {},
        .worst = std::move(for_worst)};
    for (const DataSet& set : sets) {
      MIXCMP_TRY(own, optimise(scene, device, table, set.rates, counted));
      column.scenario_1.push_back(summary_of(own));
    }
    column.baseline_per_s = model::baseline_per_s(column.example);
    column.baseline_references = reference_count(column.example.reference_only);
    all.columns.push_back(std::move(column));
  }
  return all;
}

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

}  // namespace mixcmp::model
