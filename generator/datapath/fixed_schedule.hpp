#pragma once

#include "generator/datapath/schedule.hpp"
#include "model/fixed/fixed_lane.hpp"

namespace mixcmp::datapath {

/// Schedules a lane in fixed point as schedule_lane does one in floating point. Then each operation
/// that has time to spare moves as late as possible, where that saves registers: a product is wider
/// than its operands, so it waits for the sum that it joins.
Schedule schedule_lane(const fixed::FixedLane& lane, scene::Multipliers multipliers,
                       const DelayTable& delays, double target_mhz);

}  // namespace mixcmp::datapath
