#pragma once

#include <cstdint>
#include <functional>

#include "model/comparison/data/comparisons.hpp"
#include "model/scene/scene.hpp"

namespace mixcmp::workload {

/// Called with the number of comparisons of an arg_min that are decided so far, and of all.
using ComparisonProgress = std::function<void(std::uint64_t done, std::uint64_t all)>;

/// Reads or generates the data of [data] and arranges them into comparisons. Those of arg_min
/// depend on the verdicts of the scene's reference. A scene without [data] is an error.
Result<data::Comparisons> load_comparisons(const scene::Scene& scene,
                                           const ComparisonProgress& progress = {});

}  // namespace mixcmp::workload
