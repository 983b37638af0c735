#pragma once

#include <string>
#include <vector>

#include "generator/hardware/datapath/schedule.hpp"
#include "generator/hardware/rtl/module.hpp"
#include "model/design/design.hpp"

namespace mixcmp::rtl {

/// The reference datapath: ports aclk, one per input, verdict[1:0]. It is free-running, has no
/// reset, and has the latency schedule.latency_cycles. A folded reference also has a port "phase",
/// which counts the cycles of schedule.initiation_interval; a comparison starts in phase 0, and its
/// operands have to stay until schedule.last_operand_phase. `header` is left to the caller.
Module reference_module(std::string name, const std::vector<std::string>& inputs,
                        const design::ReferenceDatapath& reference,
                        const datapath::Schedule& schedule);

}  // namespace mixcmp::rtl
