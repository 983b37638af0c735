#pragma once

#include <vector>

#include "generator/rtl/module.hpp"
#include "model/devices/area.hpp"

namespace mixcmp::rtl {

/// The registers and embedded multipliers that synthesis cannot do without in the last of these
/// modules, which instantiates the others; all else is 0. Lower bounds:
///
/// - `registers` are flip-flops and shift registers of one LUT, counted together. Each unit
///   registers its result. In a folded datapath a register holds each value that waits, and others
///   the operands of each unit that several operations share. Ranks inside of units and delay lines
///   are not counted: shift registers hold many bits in one LUT. An embedded multiplier of fixed
///   point may take the registers around it in, so that 139 are not counted for each.
/// - `dsps` are the multipliers that templates instantiate one by one. Products with a constant are
///   not counted, nor small ones, which Yosys makes of logic, nor those of fixed point that are
///   wider than a multiplier.
///
///     least_area({lane}).dsps  // 4 in a lane with four squares of 13 bits, on DSP48E1
devices::Area least_area(const std::vector<Module>& modules);

}  // namespace mixcmp::rtl
