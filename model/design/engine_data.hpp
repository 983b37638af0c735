#pragma once

#include "model/data/comparisons.hpp"
#include "model/scene/scene.hpp"

namespace mixcmp::model {

/// Refuses data that the scene's engine, with so many lanes, has no room for.
Result<Done> check_engine_data(const EngineSpec& engine, int lanes, const Comparisons& data);

}  // namespace mixcmp::model
