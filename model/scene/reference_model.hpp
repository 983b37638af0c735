#pragma once

#include "model/base/settings/settings.hpp"
#include "model/lane/fixed/reference_datapath.hpp"
#include "model/scene/scene.hpp"

namespace mixcmp::scene {

/// The datapath whose verdicts judges expect of references: the comparison in the reference format
/// or the lane in fixed point that the scene asks for. It is an error if there is no such lane,
/// which load_scene finds.
Result<fixed::ReferenceDatapath> reference_model(const Scene& scene);

/// Refuses a reference in fixed point that f and g do not have. Errors name the setting.
Result<Done> check_reference_model(const settings::Settings& settings, const Scene& scene);

}  // namespace mixcmp::scene
