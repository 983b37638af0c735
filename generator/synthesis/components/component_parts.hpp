#pragma once

#include <vector>

#include "generator/hardware/rtl/module.hpp"
#include "model/cost/devices/area.hpp"
#include "model/cost/units/unit.hpp"

namespace mixcmp::components {

/// One instance of a template in a component.
struct Part {
  rtl::TemplateInstance instance;
  /// Registers behind it that an embedded multiplier, its only reader, has inside.
  int absorbed_registers = 0;
  /// Whether the adder of a multiplier block makes this sum. Its register is in the block if that
  /// holds the whole sum.
  bool is_absorbed = false;
  int kept_registers = 0;     ///< of an absorbed sum, outside of the block
  int passing_registers = 0;  ///< of a sum's low bits that need no adder
};

/// The parts of a component's hardware.
struct ComponentParts {
  std::vector<Part> instances;  ///< each as often as the hardware has it
  devices::Area statements;     ///< of the registers and selections between instances
};

/// The parts of the last of these modules, which instantiates the others and templates.
///
/// Yosys packs for DSP48: up to two registers in front of a multiplier's operands that nothing else
/// reads except a delay line, which gets its own, and a sum that is the only reader of the whole
/// product behind one register, with the sum's own register if that holds the whole sum (xilinx_dsp
/// of Yosys 0.23). Parts say which those would be.
ComponentParts parts_of(const std::vector<rtl::Module>& modules);

/// An instance as a unit: with all parameters of the template, and last EMBEDDED_PRODUCTS, the
/// number of multipliers that the instance surely has where the device has any.
units::Unit unit_of(const rtl::TemplateInstance& instance);
/// The instance that a unit is of.
rtl::TemplateInstance instance_of(const units::Unit& unit);

}  // namespace mixcmp::components
