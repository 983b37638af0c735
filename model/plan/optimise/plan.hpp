#pragma once

#include <string>

#include "model/base/settings/settings.hpp"
#include "model/plan/optimise/optimise.hpp"

namespace mixcmp::optimise {

/// The inputs from which a plan was found, as the plan file names them.
struct PlanSource {
  std::string scene_file;              ///< path of the scene as seen from the plan file
  settings::Setting::Table overrides;  ///< keys given by --set, by section; the plan repeats them
  std::string device;                  ///< as system.device names it
  std::string command;                 ///< the command that makes the plan again
  std::string areas = {};              ///< "predicted", "measured", ...; empty: a table's
};

/// A plan file (docs/scene_file.md), which `generate` and `verify` take instead of the scene.
std::string plan_toml(const Optimisation& optimisation, const PrecisionPlan& plan,
                      const PlanSource& source);

}  // namespace mixcmp::optimise
