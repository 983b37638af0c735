#include "model/plan/optimise/exact_lanes.hpp"

#include "model/design/design.hpp"
#include "model/scene/lane_bound.hpp"

namespace mixcmp::optimise {

bool is_exact(const scene::Scene& scene, const measured::Lane& lane) {
  if (!scene.has_fixed_operands() || !lane.format.fixed_point) return false;
  scene::ReducedSpec reduced = scene::with_bound(scene.reduced, lane.bound);
  reduced.fixed_point = lane.format.fixed_point;
  const Result<design::Lane> made = design::design_lane(scene, reduced, nullptr);
  const auto* fixed = made.ok() ? std::get_if<fixed::FixedLane>(&*made) : nullptr;
  return fixed != nullptr && fixed::is_exact(*fixed);
}

}  // namespace mixcmp::optimise
