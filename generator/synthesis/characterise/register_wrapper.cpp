#include "generator/synthesis/characterise/register_wrapper.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

namespace mixcmp::characterise {
namespace {

/// The total widths of a module's ports, and the connections of an instance.
struct Boundary {
  int inputs = 0;   ///< bits, without the clock
  int outputs = 0;  ///< bits
  std::string connections;

  void connect(const std::string& port, const std::string& net) {
    connections += fmt::format("{}    .\\{} ({})", connections.empty() ? "" : ",\n", port, net);
  }
};

Boundary boundary_of(const std::vector<WrappedPort>& ports, const std::string& clock_port) {
  Boundary boundary;
  for (const WrappedPort& port : ports) {
    if (port.name == clock_port) {
      boundary.connect(port.name, "clock");
      continue;
    }
    int& low = port.is_input ? boundary.inputs : boundary.outputs;
    boundary.connect(port.name, fmt::format("{}[{}:{}]", port.is_input ? "inputs" : "outputs",
                                            low + port.width - 1, low));
    low += port.width;
  }
  return boundary;
}

Result<std::vector<WrappedPort>> ports_of(const nlohmann::json& ports) {
  std::vector<WrappedPort> wrapped;
  for (const auto& [name, port] : ports.items()) {
    const std::string direction = port.at("direction");
    if (direction == "inout") {
      return Error{.message = "a port of two directions cannot be wrapped",
                   .received = name,
                   .accepted = "inputs and outputs"};
    }
    wrapped.push_back({.name = name,
                       .is_input = direction == "input",
                       .width = static_cast<int>(port.at("bits").size())});
  }
  return wrapped;
}

std::string shift_register(int bits) {
  if (bits == 0) return "";
  const std::string shifted =
      bits == 1 ? "serial" : fmt::format("{{inputs[{}:0], serial}}", bits - 2);
  return fmt::format("  reg [{}:0] inputs;\n  always @(posedge clock) inputs <= {};\n", bits - 1,
                     shifted);
}

/// One level of the tree: each register holds the XOR of four registers of the previous level.
std::string fold_level(int level, int from_bits, int bits) {
  std::string text =
      fmt::format("  reg [{}:0] fold{};\n  always @(posedge clock) begin\n", bits - 1, level);
  for (int k = 0; k < bits; ++k) {
    text += fmt::format("    fold{}[{}] <= ^fold{}[{}:{}];\n", level, k, level - 1,
                        std::min(4 * k + 3, from_bits - 1), 4 * k);
  }
  return text + "  end\n";
}

std::string fold(int bits) {
  std::string text =
      fmt::format("  reg [{}:0] fold0;\n  always @(posedge clock) fold0 <= outputs;\n", bits - 1);
  int level = 0;
  for (; bits > 1; bits = (bits + 3) / 4) {
    ++level;
    text += fold_level(level, bits, (bits + 3) / 4);
  }
  return text + fmt::format("  assign folded = fold{}[0];\n", level);
}

}  // namespace

Result<std::string> register_wrapper(const std::vector<WrappedPort>& ports, const std::string& top,
                                     const std::string& clock_port, const std::string& name) {
  const Boundary boundary = boundary_of(ports, clock_port);
  if (boundary.outputs == 0) {
    return Error{.message = "a module without outputs computes nothing",
                 .received = top,
                 .accepted = "a module with an output"};
  }
  return fmt::format(
      "module {} (input wire clock, input wire serial, output wire folded);\n{}"
      "  wire [{}:0] outputs;\n  {} wrapped (\n{}\n  );\n{}endmodule\n",
      name, shift_register(boundary.inputs), boundary.outputs - 1, top, boundary.connections,
      fold(boundary.outputs));
}

Result<std::string> register_wrapper(const nlohmann::json& netlist, const std::string& top,
                                     const std::string& clock_port, const std::string& name) {
  MIXCMP_TRY(ports, ports_of(netlist.at("modules").at(top).at("ports")));
  return register_wrapper(ports, top, clock_port, name);
}

}  // namespace mixcmp::characterise
