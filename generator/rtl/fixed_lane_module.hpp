#pragma once

#include <string>
#include <vector>

#include "generator/datapath/schedule.hpp"
#include "generator/rtl/datapath_builder.hpp"
#include "generator/rtl/module.hpp"
#include "model/fixed/fixed_lane.hpp"

namespace mixcmp::rtl {

/// A lane in fixed point. Ports and timing are those of a lane in floating point; `header` is left
/// to the caller. `ports`: one per input. For operands that were loaded: one per loaded input, then
/// one per flag that is read.
Module lane_module(std::string name, const std::vector<InputPort>& ports,
                   const fixed::FixedLane& lane, const datapath::Schedule& schedule);

}  // namespace mixcmp::rtl
