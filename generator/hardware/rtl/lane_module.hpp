#pragma once

#include <string>
#include <vector>

#include "generator/hardware/datapath/schedule.hpp"
#include "generator/hardware/rtl/datapath_builder.hpp"
#include "generator/hardware/rtl/module.hpp"
#include "model/design/lane.hpp"

namespace mixcmp::rtl {

/// A lane: ports aclk, one per input, verdict[1:0], decided. It is free-running, has no reset, an
/// initiation interval of 1, and the latency schedule.latency_cycles. `header` is left to the
/// caller.
Module lane_module(std::string name, const std::vector<std::string>& inputs,
                   const design::Lane& lane, const datapath::Schedule& schedule);
/// `ports`: one per input. For operands that were loaded: one per loaded input, then one per flag
/// that is read.
Module lane_module(std::string name, const std::vector<InputPort>& ports, const design::Lane& lane,
                   const datapath::Schedule& schedule);

/// A lane that decides every comparison, as a reference: without the port `decided`.
Module fixed_reference_module(std::string name, const std::vector<std::string>& inputs,
                              const fixed::FixedLane& lane, const datapath::Schedule& schedule);

}  // namespace mixcmp::rtl
