#include "generator/tasks/scene.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <span>
#include <utility>

#include "generator/hardware/datapath/delays.hpp"
#include "model/base/common/command_line.hpp"
#include "model/base/common/quote.hpp"
#include "model/plan/profile/profiled_error.hpp"
#include "model/scene/error_location.hpp"
#include "model/scene/override_error.hpp"
#include "model/scene/plan.hpp"

namespace mixcmp::tasks {
namespace {

using Settings = std::span<const std::string>;

Result<Done> check_delays(const scene::Scene& scene, const SceneRequest& request) {
  const auto delays = datapath::delays_of(scene.system.device);
  if (delays.ok()) return Done{};
  Error error = delays.error();
  if (!error.file.empty()) return error;  // an error in the device file
  error.file = request.source.path.string();
  return located(error, request);
}

/// An error of the data with the place where the user wrote its cause. Errors in a data file stay
/// as they are; others may come from an override.
Error located_in_data(const Error& error, const data::DataSpec& data, const SceneRequest& request) {
  if (error.file == data.file.string() || error.file == data.with.string()) return error;
  const auto attempt = [&](Settings settings) -> std::optional<Error> {
    const Result<scene::Scene> scene = scene::load_scene(request.source, settings);
    if (!scene.ok()) return scene.error();
    if (!scene->data) return std::nullopt;
    const Result<data::Comparisons> comparisons = workload::load_comparisons(*scene);
    return comparisons.ok() ? std::nullopt : std::optional(comparisons.error());
  };
  return located(scene::with_setting(error, request.settings, attempt), request);
}

/// Makes the design with fewer settings; none: that succeeds.
std::optional<Error> design_error(const SceneRequest& request, Settings settings) {
  const auto read = scene::load_scene(request.source, settings);
  if (!read.ok()) return read.error();
  // Messages that suggest a command name all settings.
  scene::Scene scene = *read;
  scene.settings = request.settings;
  const Result<design::Design> attempt = design::make_design(scene, nullptr);
  if (attempt.ok()) return std::nullopt;
  return scene::with_location(attempt.error(), request.source, settings);
}

}  // namespace

Error located(const Error& error, const SceneRequest& request) {
  return scene::with_location(error, request.source, request.settings);
}

std::vector<std::string> joined(std::vector<std::string> settings,
                                const std::vector<std::string>& more) {
  settings.insert(settings.end(), more.begin(), more.end());
  return settings;
}

Result<LoadedScene> load(const SceneRequest& request,
                         const workload::ComparisonProgress& progress) {
  Result<scene::Scene> scene = scene::load_scene(request.source, request.settings);
  if (!scene.ok()) return located(scene.error(), request);
  LoadedScene loaded = {std::move(scene).value(), std::nullopt};
  MIXCMP_DO(check_delays(loaded.scene, request));
  if (!loaded.scene.data) return loaded;
  Result<data::Comparisons> data = workload::load_comparisons(loaded.scene, progress);
  if (!data.ok()) return located_in_data(data.error(), *loaded.scene.data, request);
  loaded.data = std::move(data).value();
  return loaded;
}

std::optional<std::string> lost_numbers_note(const LoadedScene& loaded) {
  if (!loaded.data) return std::nullopt;
  const data::LostNumbers lost = data::lost_numbers_of(*loaded.data);
  if (lost.count == 0) return std::nullopt;
  return fmt::format(
      "{} of the data's numbers are not kept: their format rounds them although they are whole, or "
      "they become 0 or, in a format without infinities, NaN. The first is {}. Verdicts and the "
      "truth are those of the numbers as they "
      "were "
      "read. A format of more digits or exponent bits, of the reference or the input, keeps them",
      lost.count, lost.first);
}

Result<Done> check_has_data(const LoadedScene& loaded, const std::string& why) {
  if (loaded.data) return Done{};
  return Error{.file = loaded.scene.path.string(),
               .field = "data",
               .message = why,
               .received = "a scene without [data]",
               .accepted = "[data] with items or file"};
}

Result<scene::Scene> with_chain_lanes(const scene::Scene& scene, const data::Comparisons* data,
                                      const SceneRequest& request) {
  Result<scene::Scene> chain = design::with_chain_lanes(scene, data);
  if (!chain.ok()) return located(chain.error(), request);
  return chain;
}

Result<design::Design> design_of(const SceneRequest& request, const LoadedScene& loaded) {
  auto design = design::make_design(loaded.scene, loaded.data_if_any(), profile::profile_error);
  if (design.ok()) return design;
  const Error error = located(design.error(), request);
  // The errors of a profiled bound are measured on the data, which takes too long to do again.
  const std::vector<scene::LaneGroupSpec> groups = loaded.scene.lane_groups();
  const bool certified = std::all_of(groups.begin(), groups.end(),
                                     [](const auto& group) { return !group.reduced.is_profiled; });
  if (!certified) return error;
  const auto attempt = [&](Settings settings) { return design_error(request, settings); };
  return located(scene::with_setting(error, request.settings, attempt), request);
}

Result<std::vector<LoadedScene>> load_formulations(const SceneRequest& request,
                                                   const LoadedScene& loaded) {
  std::vector<LoadedScene> formulations = {loaded};
  if (!loaded.scene.variant.empty()) return formulations;
  for (const std::string& variant : loaded.scene.variants) {
    const auto settings = joined(request.settings, {"comparison.variant=" + variant});
    auto scene = scene::load_scene(request.source, settings);
    if (!scene.ok() && loaded.scene.variants_are_moves) continue;
    if (!scene.ok()) return scene.error();
    formulations.push_back({std::move(scene).value(), loaded.data});
  }
  return formulations;
}

Result<std::vector<std::filesystem::path>> inputs_of(const SceneRequest& request,
                                                     const scene::Scene& scene) {
  MIXCMP_TRY(read, scene::read_scene_settings(request.source, request.settings));
  std::vector<std::filesystem::path> inputs = std::move(read.files);
  if (scene.system.device.ends_with(".toml")) inputs.emplace_back(scene.system.device);
  if (scene.data) inputs.insert(inputs.end(), {scene.data->file, scene.data->with});
  return inputs;
}

std::string origin(const std::string& verb, const SceneRequest& request) {
  const scene::SceneSource& source = request.source;
  if (!source.text) return CommandLine(verb, source.path.filename(), request.settings).text();
  std::string words = "the library of mixcmp, of a scene from a text";
  for (const std::string& setting : request.settings) words += " --set " + quoted(setting);
  return words;
}

}  // namespace mixcmp::tasks
