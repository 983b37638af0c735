#include "generator/tasks/planning.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "generator/hardware/emit/version.hpp"
#include "generator/present/report/profile_report.hpp"
#include "model/base/common/command_line.hpp"
#include "model/base/common/content_hash.hpp"
#include "model/base/common/file.hpp"
#include "model/base/common/output_file.hpp"
#include "model/cost/devices/device.hpp"
#include "model/scene/plan.hpp"

namespace mixcmp::tasks {
namespace {

namespace fs = std::filesystem;

components::TableAdvice advice(const PlanningRequest& request, const scene::Scene& scene,
                               const devices::Device& device, const fs::path& table) {
  CommandLine characterise("characterise", request.scene.source.path, {});
  characterise.add("--variant", scene.variant);
  if (scene.leaves_out_second_tier) characterise.add("--set", "second_tier.format=none");
  characterise.add("--device", device.name).add("-o", table.string());
  return {.field = request.table_option,
          .accepted = request.scene.source.text ? "what mixcmp characterise writes"
                                                : "what this makes: " + characterise.text()};
}

/// Adds a table's format, column names and numbers to a hash.
void add_to(ContentHash& hash, const data::Table& table) {
  hash.add(table.format.name());
  for (const std::string& column : table.columns) hash.add(column);
  for (const Bits value : table.values) hash.add(to_hex(value, table.format.width()));
}

/// A hash of all that rates depend on: the data, the inputs' digits, the precisions, and the
/// scene's settings, those of its plans included, without the numbers of datapaths and the system
/// around them.
Result<std::string> rates_hash(const SceneRequest& request, const LoadedScene& loaded,
                               const std::set<LaneInputs>& inputs,
                               const optimise::OptimiseOptions& choice) {
  ContentHash hash;
  hash.add(emit::version);
  MIXCMP_TRY(read, scene::read_scene_settings(request.source, request.settings));
  for (const settings::Setting& section : read.settings.root.entries) {
    const std::set<std::string> others = {"name", "system", "lanes", "references"};
    if (!others.contains(section.key)) hash.add(section.key).add(toml_value(section));
  }
  for (const data::Table& table : loaded.data->tables()) add_to(hash, table);
  for (const LaneInputs each : inputs) hash.add(to_string(each));
  hash.add(fmt::format("{}-{}", choice.first_precision, choice.last_precision));
  return hash.hex().substr(0, 8);
}

}  // namespace

fs::path table_of(const PlanningRequest& request, const scene::Scene& scene) {
  std::error_code failed;
  const bool is_folder = fs::is_directory(request.table, failed);
  if (!request.table.empty() && !is_folder) return request.table;
  const Result<devices::Device> device = devices::find_device(scene.system.device);
  const fs::path beside = optimise::default_table(request.scene.source.path, scene,
                                                  device.ok() ? device->name : scene.system.device);
  return is_folder ? request.table / beside.filename() : beside;
}

Result<components::Planning> load_planning(const PlanningRequest& request,
                                           const scene::Scene& scene,
                                           const data::Comparisons* data) {
  MIXCMP_TRY(chain, with_chain_lanes(scene, data, request.scene));
  MIXCMP_TRY(device, devices::find_device(scene.system.device));
  if (request.table.empty() && request.scene.source.text) {
    return Error{.field = request.table_option,
                 .message = "a scene from a text has no table beside it",
                 .received = "nothing",
                 .accepted = "the path of a table that mixcmp characterise wrote"};
  }
  const fs::path table = table_of(request, scene);
  return components::load_planning(chain, data, device, table,
                                   advice(request, scene, device, table));
}

Result<std::vector<profile::RateProfile>> measure_rates(const LoadedScene& loaded,
                                                        const std::set<LaneInputs>& inputs,
                                                        const optimise::OptimiseOptions& choice,
                                                        const StepProgress& progress) {
  MIXCMP_DO(check_has_data(loaded, "recomputation rates are measured on data"));
  return optimise::measure_rates(loaded.scene, *loaded.data, inputs, choice, progress);
}

Result<optimise::Rates> keep_rates(const SceneRequest& request, const LoadedScene& loaded,
                                   const std::set<LaneInputs>& inputs,
                                   const optimise::OptimiseOptions& choice, const KeptRates& kept,
                                   const StepProgress& progress) {
  MIXCMP_DO(check_has_data(loaded, "recomputation rates are measured on data"));
  MIXCMP_TRY(hash, rates_hash(request, loaded, inputs, choice));
  std::string name = kept.name;
  std::replace(name.begin(), name.end(), '/', '_');
  const fs::path file = kept.folder / fmt::format("rates-{}-{}.csv", name, hash);
  if (path_exists(file)) return optimise::Rates::read(file);
  MIXCMP_TRY(rates, measure_rates(loaded, inputs, choice, progress));
  const report::ProfileReport report{.scene = loaded.scene.name,
                                     .reference = loaded.scene.reference.format,
                                     .comparisons = loaded.data->size(),
                                     .errors = {},
                                     .rates = rates};
  MIXCMP_DO(write_file(file, report::figure5_csv(report)));
  return optimise::Rates::read(file);  // what a run that is continued finds
}

}  // namespace mixcmp::tasks
