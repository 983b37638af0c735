#pragma once

#include <functional>
#include <string>
#include <vector>

#include "generator/hardware/rtl/module.hpp"
#include "model/base/common/result.hpp"

namespace mixcmp::rtl {

/// The ports of a module outside of a tree, such as a template, with the widths that the parameters
/// of an instance give them. It is an error if the module or a parameter does not exist.
using OutsidePorts = std::function<Result<std::vector<Port>>(const Instance&)>;

/// The faults of a tree of modules, in words that name module, net or instance, and bits:
///   "top: pin b of product (fp_multiply) is not connected"
/// A tree has no fault if
/// - every port of an instance's module is connected once, in its width, and no other pin is;
/// - every bit of a net has one driver and, unless the net has "unused" in its name, a reader;
/// - both sides of an assignment have one width, and selected bits are bits of their net;
/// - a register is in a module without a reset, and takes a value in every case;
/// - a name is a Verilog identifier, declared once and before it is used, and hides no other.
std::vector<std::string> faults_of(const std::vector<Module>& modules, const OutsidePorts& outside);

/// A tree of modules without a fault. Printers take no other.
class CheckedModules {
public:
  /// Ends the program and names the faults if the tree has any. A fault is a mistake of the
  /// generator, and must not reach a file.
  CheckedModules(std::vector<Module> modules, const OutsidePorts& outside);

  const std::vector<Module>& modules() const { return modules_; }

private:
  std::vector<Module> modules_;
};

}  // namespace mixcmp::rtl
