#pragma once

#include "model/lane/fixed/reference_datapath.hpp"
#include "model/scene/scene.hpp"

namespace mixcmp::scene {

/// What judges evaluate in place of a scene's references: the comparison in the reference format or,
/// if references round in fixed point, their datapath. It is an error if there is no such lane.
Result<ReferenceDatapath> reference_model(const Scene& scene);

}  // namespace mixcmp::scene
