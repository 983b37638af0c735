#pragma once

#include <map>
#include <optional>
#include <vector>

#include "model/devices/area.hpp"

namespace mixcmp::model {

/// The cost of a component: the largest fraction that it takes of any bounded resource, so that 1 /
/// cost of them fill the device. Infinite where the device lacks a resource that it needs.
double device_share(const Area& component, const Area& usable);

/// The crossover precision of the paper's section V, L_max of Algorithm 1: the smallest L from
/// which on every kind of lane costs more, by `device_share`, than the cheapest reference, which
/// needs no recomputation. Where LUTs run out first for both, as in the paper, this compares LUTs.
/// None where a lane of the highest precision costs no more than a reference, or there is nothing
/// to compare.
std::optional<int> crossover_precision(const std::map<int, std::vector<Area>>& lanes,
                                       const std::vector<Area>& references, const Area& usable);

}  // namespace mixcmp::model
