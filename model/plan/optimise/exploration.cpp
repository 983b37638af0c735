#include "model/plan/optimise/exploration.hpp"

#include <fmt/format.h>

namespace mixcmp::optimise {
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

Result<Exploration> explore(const scene::Scene& scene, const devices::Device& device,
                            const measured::Characterisation& table,
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
        .title = given ? title : fmt::format("{}, clocks: {}", title, describe_clocks(example)),
        .clocks = clocks,
        .example = std::move(example),
        .scenario_1 = {},
        .worst = std::move(for_worst)};
    for (const DataSet& set : sets) {
      MIXCMP_TRY(own, optimise(scene, device, table, set.rates, counted));
      column.scenario_1.push_back(summary_of(own));
    }
    column.baseline_per_s = baseline_per_s(column.example);
    column.baseline_references = reference_count(column.example.reference_only);
    all.columns.push_back(std::move(column));
  }
  return all;
}

}  // namespace mixcmp::optimise
