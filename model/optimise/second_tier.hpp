#pragma once

#include <optional>

#include "model/characterise/measurement.hpp"
#include "model/optimise/rates.hpp"
#include "model/scene/scene.hpp"

/// What a second tier changes in a plan. References are asked as often as the second tier's lanes
/// need them, and the first tier's lanes may leave no more undecided than the second tier takes.
namespace mixcmp::optimise {

/// The key of the second tier's lane in a table; none without a second tier. An error where the
/// scene's second tier cannot be built.
Result<std::optional<characterise::ComponentKey>> second_tier_key(const scene::Scene& scene);

/// The key of the rate of a lane's key. A second tier's rate is that of the whole engine.
RateKey rate_key(const characterise::ComponentKey& lane);

/// The most undecided pairs that a group of lanes may leave in a cycle, on average: the second tier
/// takes one a cycle, and a queue before it evens out bursts. At 0.79 the lanes waited in at most
/// 1.2 % of the cycles (measured, docs/performance.md).
inline constexpr double most_undecided_per_cycle = 0.8;

/// Whether the second tier keeps up with a group of lanes of this rate.
bool keeps_up(const Rate& first_tier, int lanes_per_group);

}  // namespace mixcmp::optimise
