#include "generator/synthesis/characterise/logic_cells.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

namespace mixcmp::characterise {
namespace {

/// A net's number, or -1 - c for the constant c. An open port counts as the constant 0.
int net_of(const nlohmann::json& cell, const char* port) {
  const auto& connections = cell.at("connections");
  const auto found = connections.find(port);
  if (found == connections.end() || found->empty()) return -1;
  const auto& bit = found->front();
  return bit.is_number() ? bit.get<int>() : -1 - (bit.get<std::string>() == "1" ? 1 : 0);
}

using Adder = std::array<int, 3>;  ///< both operands and the carry that comes in

struct Ice40Netlist {
  std::map<int, int> readers;  ///< by net: number of cell inputs and module outputs
  std::map<int, int> lut_outputs;
  std::vector<int> register_inputs;
  std::vector<Adder> luts, carries;
};

void count_readers(const nlohmann::json& module, std::map<int, int>& readers) {
  for (const auto& [name, cell] : module.at("cells").items()) {
    for (const auto& [port, bits] : cell.at("connections").items()) {
      if (cell.at("port_directions").at(port) != "input") continue;
      for (const auto& bit : bits) readers[bit.is_number() ? bit.get<int>() : -1]++;
    }
  }
  for (const auto& [name, port] : module.at("ports").items()) {
    if (port.at("direction") != "output") continue;
    for (const auto& bit : port.at("bits")) readers[bit.is_number() ? bit.get<int>() : -1]++;
  }
}

Ice40Netlist read_netlist(const nlohmann::json& module) {
  Ice40Netlist netlist;
  count_readers(module, netlist.readers);
  for (const auto& [name, cell] : module.at("cells").items()) {
    const std::string type = cell.at("type");
    if (type == "SB_LUT4") {
      netlist.lut_outputs[net_of(cell, "O")]++;
      netlist.luts.push_back({net_of(cell, "I1"), net_of(cell, "I2"), net_of(cell, "I3")});
    }
    if (type.starts_with("SB_DFF")) netlist.register_inputs.push_back(net_of(cell, "D"));
    if (type == "SB_CARRY") {
      netlist.carries.push_back({net_of(cell, "I0"), net_of(cell, "I1"), net_of(cell, "CI")});
    }
  }
  return netlist;
}

}  // namespace

int ice40_logic_cells(const nlohmann::json& netlist, const std::string& top) {
  Ice40Netlist cells = read_netlist(netlist.at("modules").at(top));
  const auto shares_a_lut = [&](int net) {
    return net >= 0 && cells.lut_outputs.contains(net) && cells.readers[net] == 1;
  };
  const auto lonely_registers =
      std::count_if(cells.register_inputs.begin(), cells.register_inputs.end(),
                    [&](int net) { return !shares_a_lut(net); });
  std::vector<Adder> lonely_carries;
  std::sort(cells.luts.begin(), cells.luts.end());
  std::sort(cells.carries.begin(), cells.carries.end());
  std::set_difference(cells.carries.begin(), cells.carries.end(), cells.luts.begin(),
                      cells.luts.end(), std::back_inserter(lonely_carries));
  return static_cast<int>(cells.luts.size() + static_cast<std::size_t>(lonely_registers) +
                          lonely_carries.size());
}

}  // namespace mixcmp::characterise
