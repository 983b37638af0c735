#pragma once

#include <string>
#include <vector>

namespace mixcmp::project {

/// A port of a VHDL component. A Verilog port with a range, even [0:0], is a std_logic_vector.
struct VhdlPort {
  std::string name;
  bool is_input = true;
  bool is_vector = false;
  int width = 1;
};

/// The name as VHDL takes it: as it is, or as an extended identifier, "\a__b\".
std::string vhdl_name(const std::string& name);

/// A component declaration, indented by two blanks.
std::string vhdl_component(const std::string& module, const std::vector<VhdlPort>& ports);

}  // namespace mixcmp::project
