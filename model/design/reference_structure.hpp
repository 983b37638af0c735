#pragma once

#include <optional>

#include "model/scene/scene.hpp"

namespace mixcmp::design {

/// How a reference is built. Its results do not depend on it.
struct ReferenceStructure {
  scene::Multipliers multipliers = scene::Multipliers::embedded;
  int initiation_interval = 1;    ///< cycles from one comparison to the next, 1..64
  std::optional<int> target_mhz;  ///< for placing its registers; none: the system's

  /// The target if it differs from the system's.
  std::optional<int> own_target_mhz(double system_mhz) const {
    return target_mhz == system_mhz ? std::nullopt : target_mhz;
  }
};

}  // namespace mixcmp::design
