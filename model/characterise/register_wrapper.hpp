#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "model/common/result.hpp"

namespace mixcmp::characterise {

/// Verilog of a module `name` around `top` that has three pins: a shift register feeds every input
/// of `top`, and a registered tree of XORs folds every output into one. So a module of any width
/// fits a package, nothing in it is optimised away, and every path has registers at both ends. A
/// path of the wrapper is one wire and at most one LUT. `netlist` (Yosys' write_json) lists the
/// ports of `top`.
Result<std::string> register_wrapper(const nlohmann::json& netlist, const std::string& top,
                                     const std::string& clock_port, const std::string& name);

}  // namespace mixcmp::characterise
