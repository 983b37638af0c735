#pragma once

#include "model/cost/measured/measurement.hpp"
#include "model/scene/scene.hpp"

namespace mixcmp::optimise {

/// Whether a lane of the scene's systems has no error and so leaves nothing undecided, on any data.
bool is_exact(const scene::Scene& scene, const measured::Lane& lane);

}  // namespace mixcmp::optimise
