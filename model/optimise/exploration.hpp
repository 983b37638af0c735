#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/optimise/optimise.hpp"
#include "model/optimise/plan_summary.hpp"
#include "model/optimise/published.hpp"

/// Section VI of the paper: one device, many data sets, scenarios I and II.
namespace mixcmp::model {

struct DataSet {
  std::string name;  ///< "data.radius_max=25"; empty: the scene's own
  Rates rates;
};

/// One way to count clocks, and what comes out of it: a column of Table IV.
struct ResultsAtClocks {
  std::string title;  ///< with what the clocks are worth, unless they are given
  ClockChoice clocks;
  Optimisation example;                 ///< of the first data set: figures 3 and 9
  std::vector<PlanSummary> scenario_1;  ///< one a data set: its rates are known beforehand
  Optimisation worst;                   ///< scenario II: one plan for the highest rate of each kind
  double baseline_per_s = 0;            ///< references alone
  int baseline_references = 0;
};

struct Exploration {
  std::string scene;
  Device device;
  std::vector<std::string> data_sets;
  std::vector<ResultsAtClocks> columns;
};

/// `sets` is not empty; the first is the one that figures are drawn of.
Result<Exploration> explore(const Scene& scene, const Device& device, const Characterisation& table,
                            const std::vector<DataSet>& sets,
                            const std::vector<std::pair<std::string, ClockChoice>>& columns,
                            const OptimiseOptions& options);

}  // namespace mixcmp::model
