#pragma once

#include <string>

#include "generator/rtl/module.hpp"

namespace mixcmp::emit {

/// Prints a module as the text of one Verilog-2001 file. The rtl:: tree itself knows no syntax.
std::string to_verilog(const rtl::Module& module);

/// The value of a parameter as an expression: "12", "9'h01f".
std::string to_verilog(const rtl::Parameter& parameter);

}  // namespace mixcmp::emit
