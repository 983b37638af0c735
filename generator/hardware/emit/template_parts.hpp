#pragma once

#include <vector>

#include "generator/hardware/rtl/module.hpp"

namespace mixcmp::emit {

/// The templates that a template with these parameters instantiates, each as often as it does. They
/// are read from the template's Verilog: its parameters decide which generate blocks exist. None if
/// the template refuses the parameters.
///
///     template_parts({"stream_tree", {{"INPUTS", 9}}}).size()  // 4 arbiters of up to 4 inputs
std::vector<rtl::TemplateInstance> template_parts(const rtl::TemplateInstance& instance);

}  // namespace mixcmp::emit
