#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/plan/optimise/optimise.hpp"
#include "model/plan/optimise/plan_summary.hpp"
#include "model/plan/optimise/published.hpp"

/// Section VI of the paper: one device, many data sets, scenarios I and II.
namespace mixcmp::optimise {

struct DataSet {
  std::string name;  ///< "data.radius_max=25"; empty: the scene's own
  Rates rates;
};

/// The results for one choice of clocks: a column of Table IV.
struct ResultsAtClocks {
  std::string title;  ///< names the basis of the clocks, unless they are given
  ClockChoice clocks;
  Optimisation example;                 ///< for the first data set; drawn as figures 3 and 9
  std::vector<PlanSummary> scenario_1;  ///< one per data set, whose rates are known beforehand
  Optimisation worst;                   ///< scenario II: one plan for the highest rate of each kind
  double baseline_per_s = 0;            ///< comparisons per second with only references
  int baseline_references = 0;
};

struct Exploration {
  std::string scene;
  devices::Device device;
  std::vector<std::string> data_sets;
  std::vector<ResultsAtClocks> columns;
  std::vector<std::string> notes = {};  ///< for the user: about its table, then about its plans
};

/// Optimises for every data set under every choice of clocks. `sets` must not be empty; the figures
/// show its first data set.
Result<Exploration> explore(const scene::Scene& scene, const devices::Device& device,
                            const measured::Characterisation& table,
                            const std::vector<DataSet>& sets,
                            const std::vector<std::pair<std::string, ClockChoice>>& columns,
                            const OptimiseOptions& options);

}  // namespace mixcmp::optimise
