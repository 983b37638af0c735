#pragma once

#include <cstdint>
#include <functional>

#include "model/data/comparisons.hpp"
#include "model/scene/scene.hpp"

namespace mixcmp::model {

/// Told how many of all comparisons of an arg_min are decided.
using ContestProgress = std::function<void(std::uint64_t done, std::uint64_t all)>;

/// Reads or generates what [data] names and arranges it into comparisons. Those of arg_min follow
/// from what the scene's reference says. A scene without [data] is an error.
Result<Comparisons> load_comparisons(const Scene& scene, const ContestProgress& progress = {});

}  // namespace mixcmp::model
