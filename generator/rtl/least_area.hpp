#pragma once

#include <vector>

#include "generator/rtl/module.hpp"
#include "model/devices/area.hpp"

namespace mixcmp::rtl {

/// The registers and embedded multipliers that synthesis cannot do without in the last of these
/// modules, which instantiates the others; all else is 0. Lower bounds:
///
/// - `registers` are flip-flops and shift registers of one LUT, counted together. Each unit
///   registers its result. In a folded datapath registers also hold each value that waits, and the
///   operands of each unit that several operations share. Ranks inside of units and delay lines are
///   not counted, because a shift register holds many bits in one LUT. An embedded multiplier may
///   absorb the registers around it, so 139 are subtracted for each product of fixed point.
/// - `dsps` are the multipliers that templates instantiate one by one. These products are not
///   counted: those with a constant, small ones, which Yosys makes of logic, and those of fixed
///   point that are wider than a multiplier.
///
///     least_area({lane}).dsps  // 4 in a lane with four squares of 13 bits, on DSP48E1
devices::Area least_area(const std::vector<Module>& modules);

}  // namespace mixcmp::rtl
