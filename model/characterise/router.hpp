#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "model/characterise/measurement.hpp"
#include "model/common/process.hpp"
#include "model/devices/device.hpp"

namespace mixcmp::model {

/// A design that cannot be packed, placed or routed: a property of it, in nextpnr's words. A tool
/// that breaks or runs out of time is an error instead.
struct Refusal {
  std::string reason;
};
using Packed = std::variant<int, Refusal>;
using Routed = std::variant<Clock, Refusal>;

/// The LUTs (iCE40: logic cells) that nextpnr packs `netlist` into, a file in `directory`.
Result<Packed> packed_luts(const Device& device, const std::filesystem::path& directory,
                           const std::string& netlist, const ToolLimits& limits);

/// Places and routes `netlist` once for each seed 1..seeds; reports and logs stay in `directory`.
/// Seeds that are refused are left out; a refusal where all are.
Result<Routed> route(const Device& device, const std::filesystem::path& directory,
                     const std::string& netlist, int seeds, const ToolLimits& limits);

/// The slowest clock of a nextpnr report, in MHz; none where no path joins registers. An error
/// where the report is not of nextpnr's form.
Result<std::optional<double>> routed_mhz(const nlohmann::json& report);

/// Median (of an even number the lower of both in the middle) and extremes.
Clock clock_over_seeds(std::vector<double> mhz);

}  // namespace mixcmp::model
