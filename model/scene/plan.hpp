#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "model/base/settings/settings.hpp"
#include "model/scene/scene.hpp"
#include "model/scene/scene_source.hpp"

namespace mixcmp::scene {

struct SceneSettings {
  settings::Settings settings;
  std::optional<PlanNotes> plan;
  std::vector<std::filesystem::path> files;  ///< files read: plans first, the scene last
};

/// Reads a scene, or a plan and the scene below it. A plan is a file with the top-level key
/// `scene`, which names a scene or another plan. The plan's keys replace that file's, section by
/// section. If a plan gives the number of lanes, by [[lanes]] or by system.lanes, it replaces both
/// keys; the same holds for the number of references. Overrides are applied last.
Result<SceneSettings> read_scene_settings(const SceneSource& source,
                                          std::span<const std::string> overrides);

/// The scene that settings describe. Its data files are searched in the folder of
/// `read.settings.path`, a file that need not exist.
Result<Scene> interpret(SceneSettings read);

}  // namespace mixcmp::scene
