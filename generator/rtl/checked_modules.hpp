#pragma once

#include <functional>
#include <string>
#include <vector>

#include "generator/rtl/module.hpp"
#include "model/common/result.hpp"

namespace mixcmp::rtl {

/// The ports of a module that stands outside of a tree, a template say, with the widths that the
/// parameters of an instance give them. An error where there is no such module or parameter.
using OutsidePorts = std::function<Result<std::vector<Port>>(const Instance&)>;

/// What is wrong with a tree of modules, in words that name module, net or instance, and bits:
///   "top: pin b of product (fp_multiply) is not connected"
/// Empty if nothing is:
/// - every pin of an instance is connected, once, in its width, to a port that there is;
/// - every bit of a net has one driver and is read, but for nets with "unused" in their name;
/// - both sides of an assignment have one width, and bits are selected inside of a net;
/// - a register holds data, in a module that has no reset, and takes a value in every case;
/// - a name is a Verilog identifier, declared once and before it is used, and hides no other.
std::vector<std::string> faults_of(const std::vector<Module>& modules, const OutsidePorts& outside);

/// A tree of modules without a fault. Printers take no other.
class CheckedModules {
public:
  /// Ends the program, and says why, where the tree has a fault: that is a fault of the generator,
  /// which must not reach a file.
  CheckedModules(std::vector<Module> modules, const OutsidePorts& outside);

  const std::vector<Module>& modules() const { return modules_; }

private:
  std::vector<Module> modules_;
};

}  // namespace mixcmp::rtl
