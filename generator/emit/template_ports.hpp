#pragma once

#include <vector>

#include "generator/rtl/checked_modules.hpp"
#include "model/common/result.hpp"

namespace mixcmp::emit {

/// The ports of a template, with the widths that the parameters of `instance` give them; read from
/// the head of the template's Verilog. An error where there is no such template or parameter, or
/// where a parameter's literal has another width than its declaration.
Result<std::vector<rtl::Port>> template_ports(const rtl::Instance& instance);

/// Checks a tree whose instances are of its own modules and of templates.
rtl::CheckedModules checked(std::vector<rtl::Module> modules);

}  // namespace mixcmp::emit
