#include "generator/hardware/emit/constraints.hpp"

#include <fmt/core.h>

namespace mixcmp::emit {

const std::vector<SignaturePort>& ports_to_build(const Signature& signature) {
  return signature.engine ? signature.engine->ports : signature.ports;
}

std::vector<std::string> port_delays(const Signature& signature, const devices::Device& device) {
  const double outside_ns = device.delays.register_ns;
  std::vector<std::string> lines = {
      fmt::format("# Outside of each port a register and a wire to it: {:g} ns on {}.", outside_ns,
                  device.name)};
  for (const SignaturePort& port : ports_to_build(signature)) {
    if (port.name == "aclk") continue;
    const bool is_input = port.direction == rtl::Direction::input;
    lines.push_back(fmt::format("{} -clock aclk {:g} [get_ports {}]",
                                is_input ? "set_input_delay" : "set_output_delay", outside_ns,
                                port.name == "aresetn" ? port.name : port.name + "*"));
  }
  return lines;
}

}  // namespace mixcmp::emit
