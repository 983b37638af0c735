#pragma once

#include "model/lane/fixed/reference_datapath.hpp"
#include "model/scene/scene.hpp"

namespace mixcmp::scene {

/// The datapath whose verdicts judges expect of references: the comparison in the reference format
/// or the lane in fixed point that the scene asks for. It is an error if there is no such lane,
/// which load_scene finds.
Result<fixed::ReferenceDatapath> reference_model(const Scene& scene);

}  // namespace mixcmp::scene
