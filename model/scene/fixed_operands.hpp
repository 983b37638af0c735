#pragma once

#include "model/base/settings/settings.hpp"
#include "model/scene/scene.hpp"

namespace mixcmp::scene {

/// Checks that systems of the scene can take its operands if some of them are in fixed point: lanes
/// are in fixed point as well, references are not folded, and the inputs of one column of an
/// engine's items have one format. Errors name the setting.
Result<Done> check_fixed_operands(const settings::Settings& settings, const Scene& scene);

}  // namespace mixcmp::scene
