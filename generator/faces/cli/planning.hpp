#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "generator/faces/cli/options.hpp"
#include "generator/tasks/optimise.hpp"
#include "generator/tasks/planning.hpp"

namespace mixcmp::cli {

/// The options that `optimise` and `explore` share.
struct PlanningOptions {
  SceneOptions scene;
  std::filesystem::path table;  ///< empty: beside the scene, see default_table
  optimise::OptimiseOptions choice;

  tasks::PlanningRequest request() const { return {scene.request(), table}; }
};

/// Whether --set or a shortcut sets this key.
bool is_set(const SceneOptions& options, const std::string& key);

void add_planning_options(const Verb& verb, PlanningOptions& options);

/// The verb with its scene and those options that differ from their defaults, as a command.
CommandLine planning_command_line(const std::string& verb, const PlanningOptions& options);

/// The origin that a plan file at `plan` states: its scene, overrides, device and command.
optimise::PlanSource plan_source(const PlanningOptions& options, const std::string& device,
                                 const std::filesystem::path& plan, std::string command);

/// The table that `options` names, or the default one.
std::filesystem::path table_of(const PlanningOptions& options, const scene::Scene& scene);

using components::Planning;

/// Refuses precisions and clocks by the names of their options.
Result<Done> check_options_of(const PlanningOptions& options);

/// Prints the planning's notes on stderr, with one on a target_mhz of the scene as given that is
/// set and differs from the table's.
void tell_notes_of(const Planning& planning, const scene::Scene& given,
                   const PlanningOptions& options);

/// Loads the device and the table, and tells its notes. Arguments and errors are those of
/// components::load_planning.
Result<Planning> load_planning(const PlanningOptions& options, const scene::Scene& scene,
                               const data::Comparisons* data);

/// A search for the best system. Components of the best plan are synthesised for their areas only.
tasks::OptimiseRequest search_request(const PlanningOptions& options, bool predict_only);

/// Ends the program if the components of the plan could not be synthesised.
void end_if_not_confirmed(const tasks::OptimiseResult& result);

/// Recomputation rates of every kind of lane on the scene's data, for these kinds of inputs, at the
/// precisions of `choice`. It is an error if the scene has no data.
Result<std::vector<profile::RateProfile>> measure_rates(const LoadedScene& loaded,
                                                        const std::set<LaneInputs>& inputs,
                                                        const optimise::OptimiseOptions& choice);

}  // namespace mixcmp::cli
