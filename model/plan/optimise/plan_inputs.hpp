#pragma once

#include <filesystem>
#include <functional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "model/comparison/data/comparisons.hpp"
#include "model/cost/measured/measurement.hpp"
#include "model/plan/optimise/optimise.hpp"
#include "model/plan/optimise/plan.hpp"
#include "model/scene/scene_source.hpp"

/// Reads the inputs of `optimise` from files and data, and makes the origin that a plan states.
namespace mixcmp::optimise {

/// The default path of a table, also the one that `characterise` writes: beside the scene's `file`,
/// characterisation/SCENE-DEVICE.csv, or SCENE-VARIANT-DEVICE.csv for a variant. If a scene's
/// second_tier.format is "none", its table has "-one-tier" in front of the device.
std::filesystem::path default_table(const std::filesystem::path& file, const scene::Scene& scene,
                                    const std::string& device);

/// Reads a table. A table of another device, scene or engine is an error.
Result<measured::Characterisation> read_table(const std::filesystem::path& path,
                                              const scene::Scene& scene,
                                              const devices::Device& device);

/// The scene with the table's target_mhz, which decides where registers go: generated systems must
/// have them where the measured ones had them. `path` is for an error.
Result<scene::Scene> with_target_of(const measured::Characterisation& table,
                                    const std::filesystem::path& path, scene::Scene scene);

/// The kinds of inputs that plans choose from: exact, rounded, and those of the table's lanes.
std::set<LaneInputs> inputs_of_lanes(const measured::Characterisation& table);

/// Recomputation rates of every kind of lane on these data, for these kinds of inputs, at the
/// precisions and with the bounds of `choice`, and those of the scene's second tier. A kind of
/// inputs has two profiles if lanes of few digits were counted on a sample
/// (`choice.samples_rates`). If bounds are given, lanes in fixed point are only among those of the
/// first kind. `progress` is that of profile::ProfileOptions.
Result<std::vector<profile::RateProfile>> measure_rates(
    const scene::Scene& scene, const data::Comparisons& data, const std::set<LaneInputs>& inputs,
    const OptimiseOptions& choice, const std::function<void(const std::string&, double)>& progress);

/// The origin that a plan file at `plan` states: the scene's path as seen from there, its
/// overrides, device and command. Each path must be one line of UTF-8.
Result<PlanSource> make_plan_source(const std::filesystem::path& scene,
                                    std::span<const std::string> overrides,
                                    const std::string& device, const std::filesystem::path& plan,
                                    std::string command);

}  // namespace mixcmp::optimise
