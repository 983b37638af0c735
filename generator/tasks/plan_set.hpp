#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "generator/tasks/optimise.hpp"
#include "model/plan/optimise/drift.hpp"
#include "model/plan/optimise/plan_at_rates.hpp"
#include "model/plan/optimise/plan_set.hpp"
#include "model/plan/optimise/switching.hpp"

namespace mixcmp::tasks {

/// Data of a scene: the settings that name them, and the data.
struct DataSet {
  std::vector<std::string> settings;  ///< beyond the request's: {"data.radius_max=25"}
  data::Comparisons data;
};

struct PlanSetRequest {
  /// The request for a single plan, without the settings of a data set, and without rates: they are
  /// counted. Nothing is synthesised.
  OptimiseRequest optimise;
  /// The scene's own data. A plan with them must be a valid scene, so its engine holds their items.
  std::optional<data::Comparisons> own = {};
  std::vector<DataSet> sets;    ///< at least one; each counts as much as the others
  std::vector<DataSet> stream;  ///< data in the order in which they arrive; may be empty
  int most_plans = 2;
  std::optional<double> reconfiguration_seconds;  ///< none: optimise::configuration_seconds
};

/// A plan that may be one of a set.
struct SetPlan {
  PlannedSystem system;
  std::size_t number = 0;                     ///< in system.found.plans
  std::vector<optimise::PlanAtRates> at_set;  ///< by data set

  const optimise::PrecisionPlan& plan() const { return system.found.plans[number]; }
};

/// A stream of the blocks of PlanSetRequest::stream, each with so many comparisons.
struct Drift {
  std::uint64_t comparisons = 0;  ///< of each block
  double single_seconds = 0;      ///< with the one plan that is the fastest for the whole stream
  optimise::StreamTime rule;
  optimise::StreamTime foresight;
  double free_seconds = 0;  ///< with the fastest plan for each block, without reconfigurations
};

struct PlanSetResult {
  std::vector<SetPlan> plans;        ///< those of the set; the first is loaded first
  std::vector<double> best_per_s;    ///< of each data set, of all plans with this interface
  std::vector<double> seconds_with;  ///< see PlanChoice::seconds: with one plan, with two, ...
  double single_seconds = 0;         ///< the same with the best plan of any interface
  std::string single_interface;      ///< of that plan
  optimise::SwitchingRule rule;
  std::vector<Drift> drifts;            ///< from short blocks to long ones; none without a stream
  std::vector<std::string> notes = {};  ///< for the user

  /// Seconds per comparison with a plan of its own for each data set, summed over the sets.
  double least_seconds() const;
};

/// Chooses the plans of one interface that together lose least over the data sets. The plans to
/// choose from are those that `optimise` finds for each data set and for the worst of all: the best
/// of each formulation and interface, and the best of each precision in the best system. Several
/// plans must have counters, which the rule reads.
Result<PlanSetResult> plan_set(const PlanSetRequest& request);

}  // namespace mixcmp::tasks
