#pragma once

#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "generator/synthesis/components/planning.hpp"
#include "generator/tasks/scene.hpp"
#include "model/plan/optimise/optimise.hpp"
#include "model/plan/optimise/plan_inputs.hpp"

namespace mixcmp::tasks {

/// Called with the name of a step and the share of it that is done, 0..1.
using StepProgress = std::function<void(const std::string& step, double share)>;

/// A scene and the table of its components.
struct PlanningRequest {
  SceneRequest scene;
  /// A file, or a folder with tables of their default names (optimise::default_table). Empty: the
  /// folder "characterisation" beside the scene.
  std::filesystem::path table = {};
  std::string table_option = "--table";  ///< the name of `table` in errors
};

/// The table that the request names, or the default one.
std::filesystem::path table_of(const PlanningRequest& request, const scene::Scene& scene);

/// Loads the device and the table of a scene. `scene` is the request's, or one of its formulations;
/// `data` may be null. An error about the table names the command that makes it.
Result<components::Planning> load_planning(const PlanningRequest& request,
                                           const scene::Scene& scene,
                                           const data::Comparisons* data);

/// Recomputation rates of every kind of lane on the scene's data, for these kinds of inputs, at the
/// precisions of `choice`. It is an error if the scene has no data.
Result<std::vector<profile::RateProfile>> measure_rates(const LoadedScene& loaded,
                                                        const std::set<LaneInputs>& inputs,
                                                        const optimise::OptimiseOptions& choice,
                                                        const StepProgress& progress);

/// The folder and the name of rates that are kept.
struct KeptRates {
  std::filesystem::path folder;
  std::string name;
};

/// The rates in the file FOLDER/rates-NAME-HASH.csv or, where there is none, those that
/// measure_rates counts and writes there: an interrupted exploration can thus be continued. The
/// hash is that of all that rates depend on.
Result<optimise::Rates> keep_rates(const SceneRequest& request, const LoadedScene& loaded,
                                   const std::set<LaneInputs>& inputs,
                                   const optimise::OptimiseOptions& choice, const KeptRates& kept,
                                   const StepProgress& progress);

}  // namespace mixcmp::tasks
