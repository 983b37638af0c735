#pragma once

#include <optional>

#include "model/scene/scene.hpp"

namespace mixcmp::design {

/// How a reference is built. Its results do not depend on it.
struct ReferenceStructure {
  scene::Multipliers multipliers = scene::Multipliers::embedded;
  int initiation_interval = 1;    ///< cycles from one comparison to the next, 1..64
  std::optional<int> target_mhz;  ///< that its registers are placed for; none: the system's
};

}  // namespace mixcmp::design
