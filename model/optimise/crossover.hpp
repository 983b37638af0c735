#pragma once

#include <map>
#include <optional>
#include <vector>

#include "model/devices/area.hpp"

namespace mixcmp::model {

/// What a component costs: the part of a device that it takes, of the bounded resource of which it
/// takes the largest part. A device filled with it alone holds 1 / cost of them. Infinite where it
/// takes what the device has not.
double device_share(const Area& component, const Area& usable);

/// The crossover precision of the paper's section V, L_max of Algorithm 1: the smallest L from
/// which on every kind of lane costs more than the cheapest reference, which needs no
/// recomputation. Where LUTs are what both run out of first, as in the paper, that is: takes more
/// LUTs. None: a lane of the highest precision is still cheaper, or there is nothing to compare.
std::optional<int> crossover_precision(const std::map<int, std::vector<Area>>& lanes,
                                       const std::vector<Area>& references, const Area& usable);

}  // namespace mixcmp::model
