#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "model/base/common/result.hpp"
#include "model/cost/devices/device.hpp"

namespace mixcmp::characterise {

/// A net in which synthesis must leave some bits that vary.
struct NeededNet {
  std::string name;      ///< in the flattened netlist: "g_lanes[0].lane.sum"
  int low_bits = 0;      ///< the bits that are looked at, from the lowest up
  int varying_bits = 1;  ///< the least number of them that are not constant
};

/// The parts of a module that synthesis cannot do without.
struct NeededParts {
  int dsps = 0;                 ///< embedded multipliers, as a lower bound
  std::vector<NeededNet> nets;  ///< the results of units
};

/// Refuses an area on `device` with fewer multipliers than `needed` has.
Result<Done> check_multipliers(const devices::Area& area, const NeededParts& needed,
                               const devices::Device& device);

/// Refuses a netlist (Yosys' write_json) in which one of the nets has fewer bits that vary than it
/// needs. Synthesis has then removed the unit that computed this net, as it does with units whose
/// inputs nothing drives. A net may be absent, since Yosys forgets the names of registers that it
/// joins to a shift register; a constant net keeps its name. But it is an error if an instance has
/// none of its nets.
///
/// If the netlist has embedded multipliers, unknown bits ("x") count as varying: registers inside a
/// multiplier leave such bits, and check_multipliers counts the multipliers.
///
///     check_nets(netlist, "reference", {{"product", 52, 2}}, false)
///     // product: synthesis has found ...: received 0 of 52 bits that vary; accepted at least 2
Result<Done> check_nets(const nlohmann::json& netlist, const std::string& top,
                        const std::vector<NeededNet>& nets, bool has_multipliers);

}  // namespace mixcmp::characterise
