#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "generator/faces/api/mixcmp.hpp"
#include "generator/tasks/scene.hpp"
#include "model/base/common/result.hpp"

/// The contents of the public values, and the conversion of errors to exceptions.
namespace mixcmp::api {

struct SceneState {
  tasks::SceneRequest request;
  tasks::LoadedScene loaded;
};

/// Lets the other sources of this folder see a scene's state.
struct Access {
  static const SceneState& state(const Scene& scene) { return *scene.state_; }
  static Scene make(SceneState state) {
    return Scene(std::make_shared<const SceneState>(std::move(state)));
  }
};

[[noreturn]] void fail(const mixcmp::Error& error);

/// Returns the value, or throws the error.
template <class T>
T value_or_throw(Result<T> result) {
  if (!result.ok()) fail(result.error());
  return std::move(result).value();
}

/// Returns the value, or throws the error with its place in the scene.
template <class T>
T value_or_throw(Result<T> result, const SceneState& state) {
  if (!result.ok()) fail(tasks::located(result.error(), state.request));
  return std::move(result).value();
}

/// The scene's data; throws where there are none, with this message.
const data::Comparisons& data_of(const SceneState& state, std::string_view why);

}  // namespace mixcmp::api
