#pragma once

#include <string>
#include <vector>

#include "generator/datapath/schedule.hpp"
#include "generator/rtl/module.hpp"
#include "model/fixed/fixed_lane.hpp"

namespace mixcmp::rtl {

/// A lane in fixed point. Ports and timing are those of a lane in floating point; `header` is left
/// to the caller.
Module lane_module(std::string name, const std::vector<std::string>& inputs,
                   const fixed::FixedLane& lane, const datapath::Schedule& schedule);

}  // namespace mixcmp::rtl
