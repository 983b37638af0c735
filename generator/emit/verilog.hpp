#pragma once

#include <string>

#include "generator/rtl/module.hpp"

namespace mixcmp::gen {

/// The module as Verilog-2001, one file's text: the only place that knows the syntax.
std::string to_verilog(const rtl::Module& module);

}  // namespace mixcmp::gen
