#pragma once

#include <string>
#include <vector>

#include "generator/hardware/emit/signature.hpp"
#include "model/cost/devices/device.hpp"

namespace mixcmp::emit {

/// The ports of the module to build: the engine's if there is one.
const std::vector<SignaturePort>& ports_to_build(const Signature& signature);

/// The surroundings of the ports, in lines of SDC (Synopsys Design Constraints, which Vivado and
/// Quartus read): a register for each port but the clock, and a wire to it, by the device's delay
/// table. Without these lines no tool looks at the path between a port and the first register
/// behind it.
std::vector<std::string> port_delays(const Signature& signature, const devices::Device& device);

}  // namespace mixcmp::emit
