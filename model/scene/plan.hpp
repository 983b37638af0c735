#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "model/scene/scene.hpp"
#include "model/scene/settings.hpp"

namespace mixcmp::model {

struct SceneSettings {
  Settings settings;
  std::optional<PlanReport> plan;
};

/// Reads a scene, or a plan: a file with the top-level key `scene`, whose sections are laid over
/// that scene's, or that plan's, key by key. [[lanes]] and [[references]] replace the scene's, and
/// what they or system.lanes and system.references say replaces the scene's other way to say it.
/// Overrides come last.
Result<SceneSettings> read_scene_settings(const std::filesystem::path& path,
                                          std::span<const std::string> overrides);

}  // namespace mixcmp::model
