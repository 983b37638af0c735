#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "model/base/common/result.hpp"

namespace mixcmp::characterise {

/// A port of the wrapped module.
struct WrappedPort {
  std::string name;
  bool is_input = true;
  int width = 1;
};

/// Verilog of a module `name` around `top` that has three pins. A shift register feeds every input
/// of `top`, and a registered tree of XORs folds every output into one. So a module of any width
/// fits a package, no part of it is optimised away, and every path has registers at both ends. A
/// path of the wrapper is one wire and at most one LUT. An error means that `top` has no output.
Result<std::string> register_wrapper(const std::vector<WrappedPort>& ports, const std::string& top,
                                     const std::string& clock_port, const std::string& name);

/// Wraps a module whose ports `netlist` (Yosys' write_json) lists.
Result<std::string> register_wrapper(const nlohmann::json& netlist, const std::string& top,
                                     const std::string& clock_port, const std::string& name);

}  // namespace mixcmp::characterise
