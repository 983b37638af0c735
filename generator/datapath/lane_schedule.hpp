#pragma once

#include "generator/datapath/schedule.hpp"
#include "model/design/lane.hpp"

namespace mixcmp::datapath {

/// Schedules a lane of either number system.
Schedule schedule_lane(const design::Lane& lane, scene::Multipliers multipliers,
                       const DelayTable& delays, double target_mhz);

}  // namespace mixcmp::datapath
