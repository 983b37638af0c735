#pragma once

#include <string>

#include "model/optimise/optimise.hpp"

namespace mixcmp::model {

/// A plan file (docs/scene_file.md) that `generate` and `verify` take in place of the scene.
/// `scene_file` is the scene's path as seen from the plan, `command` what makes the plan again.
std::string plan_toml(const Optimisation& optimisation, const PrecisionPlan& plan,
                      const std::string& scene_file, const std::string& command);

}  // namespace mixcmp::model
