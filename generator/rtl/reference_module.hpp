#pragma once

#include <string>
#include <vector>

#include "generator/datapath/schedule.hpp"
#include "generator/rtl/module.hpp"
#include "model/expression/typed_graph.hpp"

namespace mixcmp::rtl {

/// The reference datapath: ports aclk, one per input, verdict[1:0]. Free-running, initiation
/// interval 1, latency schedule.latency_cycles, no reset. `header` is left to the caller.
Module reference_module(std::string name, const std::vector<std::string>& inputs,
                        const TypedGraph& reference, const datapath::Schedule& schedule);

}  // namespace mixcmp::rtl
