#pragma once

#include "model/comparison/data/comparisons.hpp"
#include "model/scene/scene.hpp"

namespace mixcmp::design {

/// Refuses data with more items or candidates than the engine holds with this number of lanes.
Result<Done> check_engine_data(const scene::EngineSpec& engine, int lanes,
                               const data::Comparisons& data);

}  // namespace mixcmp::design
