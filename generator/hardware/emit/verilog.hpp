#pragma once

#include <string>
#include <vector>

#include "generator/hardware/rtl/checked_modules.hpp"

namespace mixcmp::emit {

/// Prints each module as the text of one Verilog-2001 file, in their order. `prefix` stands before
/// the names of templates. The rtl:: tree itself knows no syntax.
std::vector<std::string> to_verilog(const rtl::CheckedModules& modules,
                                    const std::string& prefix = {});

/// A comment with a line for each of `lines`, as it stands at the head of a file.
std::string to_comment(const std::vector<std::string>& lines);

/// The value of a parameter as an expression: "12", "9'h01f".
std::string to_verilog(const rtl::Parameter& parameter);

}  // namespace mixcmp::emit
