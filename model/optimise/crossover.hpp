#pragma once

#include <map>
#include <optional>
#include <vector>

#include "model/devices/area.hpp"

namespace mixcmp::optimise {

/// The cost of a component: the largest fraction that it takes of any bounded resource, so that 1 /
/// cost of them fill the device. Infinite where the device lacks a resource that it needs.
double device_share(const devices::Area& component, const devices::Area& usable);

/// The crossover precision of the paper's section V, L_max of Algorithm 1: the smallest L from
/// which on every kind of lane costs more, by `device_share`, than the cheapest reference, which
/// needs no recomputation. Where LUTs run out first for both, as in the paper, this compares LUTs.
/// None where a lane of the highest precision costs no more than a reference, or there is nothing
/// to compare.
std::optional<int> crossover_precision(const std::map<int, std::vector<devices::Area>>& lanes,
                                       const std::vector<devices::Area>& references,
                                       const devices::Area& usable);

}  // namespace mixcmp::optimise
