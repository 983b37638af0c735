#include "model/plan/optimise/second_tier.hpp"

#include "model/base/number/lane_format.hpp"
#include "model/design/design.hpp"
#include "model/scene/lane_bound.hpp"

namespace mixcmp::optimise {

Result<std::optional<measured::Lane>> second_tier_lane(const scene::Scene& scene) {
  MIXCMP_TRY(tier, design::design_second_tier(scene));
  if (!tier) return std::optional<measured::Lane>();
  const auto& lane = std::get<fixed::FixedLane>(tier->lane);
  return std::optional(measured::Lane{.format = {{}, scene.second_tier->fixed_point},
                                      .inputs = {},
                                      .bound = scene::bound_of(lane),
                                      .multipliers = scene.second_tier->multipliers});
}

RateKey rate_key(const measured::Lane& lane) {
  return {.inputs = lane.inputs.value_or(LaneInputs::exact),
          .bound = lane.bound,
          .precision = lane.format.precision()};
}

bool keeps_up(const Rate& first_tier, int lanes_per_group) {
  return first_tier.value() * lanes_per_group <= most_undecided_per_cycle;
}

std::string name_of(const SecondLanes& second) {
  const measured::Lane& lane = *measured::lane_of(second.measured.key);
  const std::string multipliers(to_string(lane.multipliers));
  return "second lane " + lane.format.name() + (multipliers.empty() ? "" : " " + multipliers);
}

int groups_served(const Rate& first_tier, int lanes_per_group) {
  const double asked = first_tier.value() * lanes_per_group;
  const int most = settings::limits::lanes.most / lanes_per_group;
  return static_cast<int>(
      asked * most <= most_undecided_per_cycle ? most : most_undecided_per_cycle / asked);
}

int second_lanes_for(int groups, int groups_served, int references) {
  const int needed = (groups + groups_served - 1) / groups_served;
  return (needed + references - 1) / references * references;
}

}  // namespace mixcmp::optimise
