#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "model/base/common/process.hpp"
#include "model/cost/devices/device.hpp"
#include "model/cost/measured/measurement.hpp"

namespace mixcmp::characterise {

/// Why a design cannot be packed, placed or routed, in nextpnr's words. That is a property of the
/// design. A tool that fails or runs out of time is an error instead.
struct Refusal {
  std::string reason;
};
using Packed = std::variant<int, Refusal>;
using Routed = std::variant<measured::Clock, Refusal>;

/// The number of LUTs (iCE40: logic cells) into which nextpnr packs `netlist`, a file in
/// `directory`.
Result<Packed> packed_luts(const devices::Device& device, const std::filesystem::path& directory,
                           const std::string& netlist, const ToolLimits& limits);

/// Places and routes `netlist` once for each seed 1..seeds; reports and logs stay in `directory`.
/// Returns the clock over the seeds that succeed, or a refusal if none does.
Result<Routed> route(const devices::Device& device, const std::filesystem::path& directory,
                     const std::string& netlist, int seeds, const ToolLimits& limits);

/// The slowest clock of a nextpnr report, in MHz; none if no path joins registers. An error if the
/// report does not have nextpnr's form.
Result<std::optional<double>> routed_mhz(const nlohmann::json& report);

/// The median and the extremes of these clocks. The median of an even number of clocks is the lower
/// of the two in the middle.
measured::Clock clock_over_seeds(std::vector<double> mhz);

}  // namespace mixcmp::characterise
