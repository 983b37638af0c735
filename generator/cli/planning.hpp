#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "generator/cli/options.hpp"
#include "model/optimise/optimise.hpp"
#include "model/optimise/plan.hpp"

namespace mixcmp::cli {

/// What `optimise` and `explore` share.
struct PlanningOptions {
  SceneOptions scene;
  std::filesystem::path table;  ///< empty: beside the scene, see default_table
  model::OptimiseOptions choice;
  bool separate_clocks = false;
};

void add_planning_options(const Verb& verb, PlanningOptions& options);

/// The verb, its scene and what of these options is not as usual, as a command.
std::string planning_command_line(const std::string& verb, const PlanningOptions& options);

/// What plans say of where they come from, for a plan file at `plan`.
model::PlanSource plan_source(const PlanningOptions& options, const std::string& device,
                              const std::filesystem::path& plan, std::string command);

/// characterisation/SCENE-DEVICE.csv beside the scene file, SCENE-VARIANT-DEVICE.csv of a variant:
/// where `characterise` writes, too.
std::filesystem::path default_table(const std::filesystem::path& scene, const std::string& variant,
                                    const std::string& device);

/// The table that `options` names, or the default one.
std::filesystem::path table_of(const PlanningOptions& options, const model::Scene& scene);

/// What plans are made of.
struct Planning {
  model::Scene scene;  ///< with the target_mhz that the table was measured for
  model::Device device;
  model::Characterisation table;
  std::filesystem::path table_path;
};
/// Notes on stderr how many rows were measured on other RTL than today's, and a target_mhz that is
/// set and not the table's. `data` may be null. Errors where the table is of another device or
/// scene.
model::Result<Planning> load_planning(const PlanningOptions& options, const model::Scene& scene,
                                      const model::Comparisons* data);

/// Recomputation rates of every kind of lane on the scene's data, for exact and for rounded inputs,
/// at the precisions of `choice`. Errors where the scene has no data.
model::Result<std::vector<model::RateProfile>> measure_rates(const LoadedScene& loaded,
                                                             const model::OptimiseOptions& choice);

}  // namespace mixcmp::cli
