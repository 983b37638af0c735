#include "generator/datapath/lane_schedule.hpp"

#include "generator/datapath/fixed_schedule.hpp"

namespace mixcmp::datapath {

Schedule schedule_lane(const design::Lane& lane, scene::Multipliers multipliers,
                       const DelayTable& delays, double target_mhz) {
  return std::visit(
      [&](const auto& made) { return schedule_lane(made, multipliers, delays, target_mhz); }, lane);
}

}  // namespace mixcmp::datapath
