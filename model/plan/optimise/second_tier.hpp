#pragma once

#include <optional>
#include <string>

#include "model/cost/measured/measurement.hpp"
#include "model/plan/optimise/rates.hpp"
#include "model/scene/scene.hpp"

/// The effect of a second tier on a plan. References are asked as often as the second tier's lanes
/// need them, and the first tier's lanes may leave no more comparisons undecided than the second
/// tier takes.
namespace mixcmp::optimise {

/// The second tier's lane in a table; none without a second tier. An error if the scene's second
/// tier cannot be built.
Result<std::optional<measured::Lane>> second_tier_lane(const scene::Scene& scene);

/// The key of a lane's rate. A second lane's rate counts undecided ones among all
/// comparisons, not only among those that reach it.
RateKey rate_key(const measured::Lane& lane);

/// The most undecided pairs that a group of lanes may leave in a cycle, on average. The second tier
/// takes one a cycle, and a queue in front of it evens out bursts. At 0.79 the lanes waited in at
/// most 1.2 % of the cycles (measured on engines, docs/theory.md). The same limit holds for
/// the requests to a second lane in a system of streams.
inline constexpr double most_undecided_per_cycle = 0.8;

/// Whether the second tier keeps up with a group of lanes of this rate.
bool keeps_up(const Rate& first_tier, int lanes_per_group);

/// The second tier of a system of streams in a plan.
struct SecondLanes {
  measured::Measurement measured;  ///< one second lane with its streams
  devices::Area area;              ///< the lane, and its ports at both crossbars
  int groups_served = 0;           ///< groups of first lanes that each serves at most
  devices::Area area_per_group;    ///< `area` / `groups_served`, rounded up
  int count = 0;                   ///< in the best plan
};

/// "second lane q13 embedded"
std::string name_of(const SecondLanes& second);

/// The most groups of lanes of this rate that a lane of the second tier serves; 0: none.
int groups_served(const Rate& first_tier, int lanes_per_group);

/// The lanes of the second tier that `groups` groups need. It is a multiple of the number of
/// references, so these are asked equally often.
int second_lanes_for(int groups, int groups_served, int references);

}  // namespace mixcmp::optimise
