#pragma once

#include <vector>

#include "generator/hardware/rtl/module.hpp"
#include "generator/synthesis/characterise/netlist_check.hpp"

namespace mixcmp::components {

/// The parts that synthesis cannot do without in the last of these modules, which instantiates the
/// others:
///
/// - `nets`: the result of each unit. In a folded datapath also each value that waits, and the
///   operands of each unit that several operations share. A result in floating point needs two bits
///   of its fraction that vary: a product by a factor stuck at zero still has a sign, an exponent,
///   and one bit that tells a NaN. Other nets need one bit. A net of constants is not needed.
/// - `dsps`: the multipliers that templates instantiate one by one. These products are not
///   counted: those with a constant, small ones, which Yosys makes of logic, and those of fixed
///   point that are wider than a multiplier.
///
///     needed_parts({lane}).dsps  // 4 in a lane with four squares of 13 bits, on DSP48E1
characterise::NeededParts needed_parts(const std::vector<rtl::Module>& modules);

/// The multipliers among `dsps` that one instance of a template has. Operands that are not
/// connected vary.
int embedded_products(const rtl::Instance& instance);

}  // namespace mixcmp::components
