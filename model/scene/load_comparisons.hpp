#pragma once

#include "model/data/comparisons.hpp"
#include "model/scene/scene.hpp"

namespace mixcmp::model {

/// Reads or generates what [data] names and arranges it into comparisons. Those of arg_min follow
/// from what the scene's reference says. A scene without [data] is an error.
Result<Comparisons> load_comparisons(const Scene& scene);

}  // namespace mixcmp::model
