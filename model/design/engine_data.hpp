#pragma once

#include "model/data/comparisons.hpp"
#include "model/scene/scene.hpp"

namespace mixcmp::model {

/// Refuses data with more items or candidates than the engine holds with this number of lanes.
Result<Done> check_engine_data(const EngineSpec& engine, int lanes, const Comparisons& data);

}  // namespace mixcmp::model
