#pragma once

#include "generator/hardware/emit/system.hpp"
#include "generator/tasks/scene.hpp"

namespace mixcmp::tasks {

/// A design and its files.
struct BuiltSystem {
  design::Design design;
  emit::GeneratedSystem generated;
};

/// Makes the design of the scene's system and generates its files.
Result<BuiltSystem> build_system(const SceneRequest& request, const LoadedScene& loaded);

/// Builds the system, and lists in its signature the simulations on record. The files are the
/// output of `mixcmp generate`.
Result<BuiltSystem> generate(const SceneRequest& request, const LoadedScene& loaded);

}  // namespace mixcmp::tasks
