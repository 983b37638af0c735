#pragma once

#include <string>

#include "generator/rtl/module.hpp"

namespace mixcmp::gen {

/// The module as Verilog-2001, one file's text: this header is the only place that knows the
/// syntax.
std::string to_verilog(const rtl::Module& module);

/// The value of a parameter as an expression: "12", "9'h01f".
std::string to_verilog(const rtl::Parameter& parameter);

}  // namespace mixcmp::gen
