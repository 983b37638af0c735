#pragma once

#include <optional>
#include <string>

#include "model/characterise/measurement.hpp"
#include "model/optimise/rates.hpp"
#include "model/scene/scene.hpp"

/// What a second tier changes in a plan. References are asked as often as the second tier's lanes
/// need them, and the first tier's lanes may leave no more undecided than the second tier takes.
namespace mixcmp::optimise {

/// The key of the second tier's lane in a table; none without a second tier. An error where the
/// scene's second tier cannot be built.
Result<std::optional<characterise::ComponentKey>> second_tier_key(const scene::Scene& scene);

/// The key of the rate of a lane's key. A second tier's rate is that of all.
RateKey rate_key(const characterise::ComponentKey& lane);

/// The most undecided pairs that a group of lanes may leave in a cycle, on average: the second tier
/// takes one a cycle, and a queue before it evens out bursts. At 0.79 the lanes waited in at most
/// 1.2 % of the cycles (measured of engines, docs/performance.md). The same limit holds for what a
/// second lane of a system of streams is asked.
inline constexpr double most_undecided_per_cycle = 0.8;

/// Whether the second tier keeps up with a group of lanes of this rate.
bool keeps_up(const Rate& first_tier, int lanes_per_group);

/// The second tier of a system of streams, as a plan has it.
struct SecondLanes {
  characterise::Measurement measured;  ///< one second lane with its streams
  devices::Area area;                  ///< that, and its ports at both crossbars
  int groups_served = 0;               ///< of the first lanes, at most, by each of them
  devices::Area area_per_group;        ///< `area` / `groups_served`, rounded up
  int count = 0;                       ///< in the best plan
};

/// "second lane q13 embedded"
std::string name_of(const SecondLanes& second);

/// The groups of lanes of this rate that a lane of the second tier serves at most; 0: not one.
int groups_served(const Rate& first_tier, int lanes_per_group);

/// The lanes of the second tier that so many groups need. A multiple of the references' number:
/// these are then asked equally often.
int second_lanes_for(int groups, int groups_served, int references);

}  // namespace mixcmp::optimise
