#pragma once

#include <string>
#include <vector>

#include "generator/hardware/emit/signature.hpp"
#include "model/cost/devices/device.hpp"

namespace mixcmp::emit {

/// The ports of the module to build: the engine's if there is one.
const std::vector<SignaturePort>& ports_to_build(const Signature& signature);

/// Lines of SDC (Synopsys Design Constraints, which Vivado and Quartus read) that describe the
/// surroundings of the ports. Outside of each port except the clock are a register and a wire to
/// it, with the delays of the device's table. Without these lines no tool looks at the path between
/// a port and the first register behind it.
std::vector<std::string> port_delays(const Signature& signature, const devices::Device& device);

}  // namespace mixcmp::emit
