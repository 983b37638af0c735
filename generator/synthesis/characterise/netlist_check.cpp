#include "generator/synthesis/characterise/netlist_check.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

namespace mixcmp::characterise {
namespace {

/// Tells whether Yosys maps products to the device's multipliers. On the iCE40 it does so only with
/// our own cells (`cells`); a command without cells of multipliers (cells.toml) never does.
bool maps_multipliers(const devices::Device& device) {
  const bool left_out = device.synthesis.find("-nodsp") != std::string::npos;
  const bool by_cells = device.synthesis.starts_with("synth_ice40");
  return device.available.dsps > 0 && device.cell_areas.have_dsps() && !left_out &&
         (!by_cells || device.cells == "ice40");
}

/// The number of a net's low bits that vary. A constant bit is a string ("0", "1", "x"), any other
/// the number of a wire. A wire that nothing drives counts as varying: a register that has become
/// part of a shift register leaves one. A register that has become part of a multiplier leaves "x".
/// Synthesis may have cut constant bits off a net's upper end.
int varying_bits(const nlohmann::json& bits, int low_bits, bool has_multipliers) {
  const std::size_t count = std::min(bits.size(), static_cast<std::size_t>(low_bits));
  int varying = 0;
  for (std::size_t k = 0; k < count; ++k) {
    varying += bits[k].is_number() || (has_multipliers && bits[k] == "x") ? 1 : 0;
  }
  return varying;
}

Error too_few_bits(const NeededNet& net, int varying) {
  return {.field = net.name,
          .message =
              "synthesis has found this net constant, so it has removed a part of the "
              "datapath",
          .received = fmt::format("{} of {} bits that vary", varying, net.low_bits),
          .accepted = fmt::format("at least {}", net.varying_bits)};
}

/// The instance that a net is in: "g_lanes[0].lane" for the net "g_lanes[0].lane.sum"; empty for a
/// net of the top itself.
std::string instance_of(const NeededNet& net) {
  const std::size_t dot = net.name.rfind('.');
  return dot == std::string::npos ? "" : net.name.substr(0, dot);
}

Error no_nets(const std::string& instance) {
  return {.field = instance,
          .message =
              "the netlist has none of the nets of this instance, so synthesis has removed "
              "it"};
}

}  // namespace

Result<Done> check_multipliers(const devices::Area& area, const NeededParts& needed,
                               const devices::Device& device) {
  if (!maps_multipliers(device) || area.dsps >= needed.dsps) return Done{};
  return Error{.field = "dsps",
               .message =
                   "synthesis has left fewer embedded multipliers than the schedule needs, "
                   "so it has removed a part of the datapath",
               .received = fmt::format("{}", area.dsps),
               .accepted = fmt::format("at least {}", needed.dsps)};
}

Result<Done> check_nets(const nlohmann::json& netlist, const std::string& top,
                        const std::vector<NeededNet>& nets, bool has_multipliers) {
  const nlohmann::json& names = netlist.at("modules").at(top).at("netnames");
  std::map<std::string, bool> found_in;  // by instance
  for (const NeededNet& net : nets) {
    const auto found = names.find(net.name);
    found_in[instance_of(net)] |= found != names.end();
    if (found == names.end()) continue;
    const int varying = varying_bits(found->at("bits"), net.low_bits, has_multipliers);
    if (varying < net.varying_bits) return too_few_bits(net, varying);
  }
  for (const auto& [instance, found] : found_in) {
    if (!found) return no_nets(instance);
  }
  return Done{};
}

}  // namespace mixcmp::characterise
