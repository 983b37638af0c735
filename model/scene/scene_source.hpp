#pragma once

#include <concepts>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

namespace mixcmp::scene {

/// The file of a scene or a plan, or a text that replaces its content.
struct SceneSource {
  template <std::convertible_to<std::filesystem::path> Path>
  SceneSource(Path file) : path(std::move(file)) {}
  /// `path` need not exist: errors name it, and paths in the text are relative to its folder.
  SceneSource(std::filesystem::path name, std::string content)
      : path(std::move(name)), text(std::move(content)) {}

  std::filesystem::path path;
  std::optional<std::string> text;
};

}  // namespace mixcmp::scene
