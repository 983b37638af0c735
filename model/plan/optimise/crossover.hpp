#pragma once

#include <map>
#include <optional>
#include <vector>

#include "model/cost/devices/area.hpp"

namespace mixcmp::optimise {

/// The cost of a component: the largest fraction that it takes of any bounded resource, so 1 / cost
/// of them fill the device. Infinite if the device lacks a resource that the component needs.
double device_share(const devices::Area& component, const devices::Area& usable);

/// The crossover precision of the paper's section V, L_max of Algorithm 1. From this L on, every
/// kind of lane costs more, by `device_share`, than the cheapest reference, which needs no
/// recomputation. If LUTs run out first for both, as in the paper, this compares LUTs. None if a
/// lane of the highest precision costs no more than a reference, or if there is nothing to compare.
std::optional<int> crossover_precision(const std::map<int, std::vector<devices::Area>>& lanes,
                                       const std::vector<devices::Area>& references,
                                       const devices::Area& usable);

}  // namespace mixcmp::optimise
