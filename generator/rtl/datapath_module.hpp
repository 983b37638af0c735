#pragma once

#include <string>
#include <vector>

#include "generator/datapath/schedule.hpp"
#include "generator/rtl/module.hpp"

namespace mixcmp::rtl {

/// The reduced-precision datapath: ports aclk, one per input, verdict[1:0], decided. Free-running,
/// initiation interval 1, latency schedule.latency_cycles, no reset. `header` is left to the
/// caller.
Module lane_module(std::string name, const std::vector<std::string>& inputs,
                   const error::Lane& lane, const datapath::Schedule& schedule);

/// The reference datapath: ports aclk, one per input, verdict[1:0]. Timing, reset and `header` are
/// those of lane_module.
Module reference_module(std::string name, const std::vector<std::string>& inputs,
                        const TypedGraph& reference, const datapath::Schedule& schedule);

}  // namespace mixcmp::rtl
