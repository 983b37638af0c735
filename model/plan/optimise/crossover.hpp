#pragma once

#include <map>
#include <optional>
#include <vector>

#include "model/cost/devices/area.hpp"

namespace mixcmp::optimise {

/// The bounded resource of which a component takes the largest fraction. Null: it takes none.
struct LargestShare {
  const devices::Resource* resource = nullptr;
  double share = 0;  ///< infinite if the device lacks the resource
};
LargestShare largest_share(const devices::Area& component, const devices::Area& usable);

/// The cost of a component: its largest share, so 1 / cost of them fill the device.
double device_share(const devices::Area& component, const devices::Area& usable);

/// The crossover precision of the paper's section V, L_max of Algorithm 1. From this L on, every
/// kind of lane costs more, by `device_share`, than the cheapest reference, which needs no
/// recomputation. If LUTs run out first for both, as in the paper, this compares LUTs. None if a
/// lane of the highest precision costs no more than a reference, or if there is nothing to compare.
std::optional<int> crossover_precision(const std::map<int, std::vector<devices::Area>>& lanes,
                                       const std::vector<devices::Area>& references,
                                       const devices::Area& usable);

}  // namespace mixcmp::optimise
