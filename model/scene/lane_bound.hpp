#pragma once

#include <optional>
#include <vector>

#include "model/base/number/bound.hpp"
#include "model/lane/error/certified_lane.hpp"
#include "model/lane/fixed/fixed_lane.hpp"
#include "model/scene/scene.hpp"

namespace mixcmp::scene {

/// How one part of a lane bounds its errors.
Bound bound_of(const error::LanePart& part);
/// How a lane bounds its errors; none if its parts use different ways.
std::optional<Bound> bound_of(const error::Lane& lane);
Bound bound_of(const fixed::FixedLane& lane);

/// The bounds that a profile counts of this scene: those of every scene and, with promised grids,
/// theirs.
std::vector<Bound> counted_bounds_of(const Scene& scene);

/// Returns a copy of `reduced` with this bound, in its number system. W of fixed point is that of
/// `reduced`, or the digits of its format.
ReducedSpec with_bound(const ReducedSpec& reduced, const Bound& bound);

}  // namespace mixcmp::scene
