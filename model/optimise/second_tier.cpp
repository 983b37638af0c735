#include "model/optimise/second_tier.hpp"

#include "model/design/design.hpp"

namespace mixcmp::optimise {

Result<std::optional<RateKey>> second_tier_rate_key(const scene::Scene& scene) {
  MIXCMP_TRY(tier, design::design_second_tier(scene));
  if (!tier) return std::optional<RateKey>();
  const auto& lane = std::get<fixed::FixedLane>(tier->lane);
  return std::optional(RateKey{.inputs = LaneInputs::exact,
                               .bound = scene::bound_choice(lane),
                               .precision = scene.second_tier->fixed_point->bits});
}

bool keeps_up(const Rate& first_tier, int lanes_per_group) {
  return first_tier.value() * lanes_per_group <= most_undecided_per_cycle;
}

}  // namespace mixcmp::optimise
