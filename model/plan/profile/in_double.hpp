#pragma once

#include "model/comparison/data/comparisons.hpp"
#include "model/lane/fixed/fixed_lane.hpp"
#include "model/scene/scene.hpp"

namespace mixcmp::profile {

/// A scene in fixed point whose operands double holds, though not its f and g.
struct InDouble {
  scene::Scene scene;      ///< in binary64, for lanes; a reference in that format would round
  data::Comparisons data;  ///< the same numbers in binary64
  fixed::FixedLane exact_reference;
};

/// Whether in_double can make one. Errors name the scene's file and setting.
Result<Done> check_in_double(const scene::Scene& scene);

/// Requires check_in_double.
InDouble in_double(const scene::Scene& scene, const data::Comparisons& data);

}  // namespace mixcmp::profile
