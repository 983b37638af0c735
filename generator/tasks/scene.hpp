#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "model/comparison/data/comparisons.hpp"
#include "model/design/design.hpp"
#include "model/judge/workload/load_comparisons.hpp"
#include "model/scene/scene.hpp"

/// Use cases of the program and of the libraries. A task prints nothing and ends nothing: its
/// errors name the line of the scene, or the setting, that the user has to change.
namespace mixcmp::tasks {

/// A scene as a caller names it.
struct SceneRequest {
  scene::SceneSource source;
  std::vector<std::string> settings = {};  ///< "section.key=value"
};

/// Settings and then more of them, which win over the first.
std::vector<std::string> joined(std::vector<std::string> settings,
                                const std::vector<std::string>& more);

/// A scene with its data, if it names any.
struct LoadedScene {
  scene::Scene scene;
  std::optional<data::Comparisons> data;

  /// Null without data.
  const data::Comparisons* data_if_any() const { return data ? &*data : nullptr; }
};

/// Reads and validates the scene and loads its data. `progress` is called while the comparisons of
/// an arg_min are searched for.
Result<LoadedScene> load(const SceneRequest& request,
                         const workload::ComparisonProgress& progress = {});

/// A note on numbers of the data that the reference format does not keep; none if there are none.
std::optional<std::string> lost_numbers_note(const LoadedScene& loaded);

/// An error if there are no data. `why`: its message, such as "verify needs data to run on".
Result<Done> check_has_data(const LoadedScene& loaded, const std::string& why);

/// The error with the place where the user wrote the value at fault.
Error located(const Error& error, const SceneRequest& request);

/// The scene with the lanes of its chain, by design::with_chain_lanes. `data` may be null.
Result<scene::Scene> with_chain_lanes(const scene::Scene& scene, const data::Comparisons* data,
                                      const SceneRequest& request);

/// The design of the scene's system.
Result<design::Design> design_of(const SceneRequest& request, const LoadedScene& loaded);

/// The scene as it was loaded and, where it names no variant, each of its variants with the same
/// data.
Result<std::vector<LoadedScene>> load_formulations(const SceneRequest& request,
                                                   const LoadedScene& loaded);

/// The files that the scene is read from: its own, its plans, its device, its data.
Result<std::vector<std::filesystem::path>> inputs_of(const SceneRequest& request,
                                                     const scene::Scene& scene);

/// The origin that the head of an output states: the command that makes the output again, with the
/// scene's file name but no folder. A scene from a text has no such command; its origin names the
/// library.
std::string origin(const std::string& verb, const SceneRequest& request);

}  // namespace mixcmp::tasks
