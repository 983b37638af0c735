#include "model/scene/lane_bound.hpp"

#include <algorithm>

namespace mixcmp::scene {

Bound bound_of(const error::LanePart& part) {
  if (!part.certified()) return {.kind = BoundKind::profiled};
  const auto* absolute = std::get_if<error::AbsoluteBoundCriterion>(&part.criterion);
  if (absolute == nullptr) return {.kind = BoundKind::relative};
  if (absolute->bound.nodes.back().operation == error::BoundOperation::constant) {
    return {.kind = BoundKind::constant};
  }
  return {.kind = BoundKind::running, .digits = absolute->bound.format.precision};
}

std::optional<Bound> bound_of(const error::Lane& lane) {
  const Bound first = bound_of(lane.parts.front());
  const bool all_alike =
      std::all_of(lane.parts.begin(), lane.parts.end(),
                  [&](const error::LanePart& part) { return bound_of(part) == first; });
  return all_alike ? std::optional(first) : std::nullopt;
}

Bound bound_of(const fixed::FixedLane& lane) {
  return {.system = lane.format.is_block ? NumberSystem::block : NumberSystem::fixed,
          .kind = fixed::relies_on_grids(lane) ? BoundKind::grid
                  : has_norm(lane)             ? BoundKind::norm
                  : has_running(lane)          ? BoundKind::running
                                               : BoundKind::constant,
          .digits = lane.format.guard_digits};
}

std::vector<Bound> counted_bounds_of(const Scene& scene) {
  std::vector<Bound> bounds(counted_bounds().begin(), counted_bounds().end());
  if (scene.has_promised_grids()) bounds.push_back(grid_bound);
  return bounds;
}

ReducedSpec with_bound(const ReducedSpec& reduced, const Bound& bound) {
  ReducedSpec copy = reduced;
  if (!bound.is_fixed_point()) {
    copy.fixed_point.reset();
  } else if (copy.fixed_point || copy.format) {
    const int bits = copy.format ? copy.format->precision() : copy.fixed_point->bits;
    copy.fixed_point = bound.fixed_point(bits);
  }
  copy.is_profiled = bound.is_profiled();
  copy.error_bound = bound.is_profiled() ? std::nullopt : std::optional(bound.kind);
  if (bound.kind == BoundKind::running && !bound.is_fixed_point()) copy.bound_digits = bound.digits;
  return copy;
}

}  // namespace mixcmp::scene
