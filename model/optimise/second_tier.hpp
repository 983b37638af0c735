#pragma once

#include <optional>

#include "model/optimise/rates.hpp"
#include "model/scene/scene.hpp"

/// What a second tier changes of a plan: references are asked as often as its lanes need them, and
/// the lanes before it may leave no more undecided than it takes.
namespace mixcmp::optimise {

/// The lanes whose recomputation rate is that of the scene's engine; none without a second tier.
/// An error where the scene's second tier cannot be built.
Result<std::optional<RateKey>> second_tier_rate_key(const scene::Scene& scene);

/// The most undecided pairs that a group of lanes may leave in a cycle, on average: the second tier
/// takes one a cycle, and a queue before it evens out what comes at once. At 0.8 lanes wait in 1 %
/// of the cycles or less (measured, docs/performance.md).
inline constexpr double most_undecided_per_cycle = 0.8;

/// Whether the second tier keeps up with a group of lanes of this rate.
bool keeps_up(const Rate& first_tier, int lanes_per_group);

}  // namespace mixcmp::optimise
