#pragma once

#include "model/data/comparisons.hpp"
#include "model/error/lane.hpp"
#include "model/scene/scene.hpp"

namespace mixcmp::model {

/// A scene with every choice made: what is built, and what the golden model evaluates.
struct Design {
  std::string name;
  std::vector<std::string> inputs;  ///< in the order they are packed
  Lane lane;
  Multipliers lane_multipliers = Multipliers::embedded;
  TypedGraph reference;
  Multipliers reference_multipliers = Multipliers::embedded;
  int lanes = 1;       ///< p_L
  int references = 1;  ///< p_H
  SystemSpec system;
};

/// Resolves the scene's choices. `data` is needed only where profiled constants must be measured;
/// an "auto" that nothing has resolved is an error that names the option to give.
Result<Design> make_design(const Scene& scene, const Comparisons* data);

}  // namespace mixcmp::model
