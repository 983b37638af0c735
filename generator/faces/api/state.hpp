#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "generator/faces/api/mixcmp.hpp"
#include "model/base/common/result.hpp"
#include "model/comparison/data/comparisons.hpp"
#include "model/scene/scene.hpp"

/// The contents of the public values, and the conversion of errors to exceptions.
namespace mixcmp::api {

struct SceneState {
  scene::SceneSource source;
  std::vector<std::string> settings;
  scene::Scene scene;
  std::optional<data::Comparisons> data;
};

/// Lets the other sources of this folder see a scene's state.
struct Access {
  static const SceneState& state(const Scene& scene) { return *scene.state_; }
  static Scene make(SceneState state) {
    return Scene(std::make_shared<const SceneState>(std::move(state)));
  }
};

[[noreturn]] void fail(const mixcmp::Error& error);

/// The error with the file and line of the key that it names.
mixcmp::Error located(const mixcmp::Error& error, const SceneState& state);

/// Returns the value, or throws the error.
template <class T>
T value_or_throw(Result<T> result) {
  if (!result.ok()) fail(result.error());
  return std::move(result).value();
}

/// Returns the value, or throws the error with its place in the scene.
template <class T>
T value_or_throw(Result<T> result, const SceneState& state) {
  if (!result.ok()) fail(located(result.error(), state));
  return std::move(result).value();
}

/// The scene's data; throws where there are none, with this message.
const data::Comparisons& data_of(const SceneState& state, const std::string& why);

/// The origin that the head of an output states: the command that makes the output again, "mixcmp
/// VERB SCENE --set KEY=VALUE ...", with the scene's file name but no folder. A scene from a text
/// has no such command; its origin names the library.
std::string origin(const std::string& verb, const SceneState& state);

}  // namespace mixcmp::api
