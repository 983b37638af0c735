#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "model/characterise/measurement.hpp"
#include "model/devices/device.hpp"

namespace mixcmp::model {

/// The LUTs (iCE40: logic cells) that nextpnr packs `netlist` into, a file in `directory`.
Result<int> packed_luts(const Device& device, const std::filesystem::path& directory,
                        const std::string& netlist, int seconds);

/// Places and routes `netlist` once for each seed 1..seeds; reports and logs stay in `directory`.
/// An error where no seed can be routed.
Result<Clock> route(const Device& device, const std::filesystem::path& directory,
                    const std::string& netlist, int seeds, int seconds);

/// The slowest clock of a nextpnr report, in MHz. An error where no register has a clock.
Result<double> routed_mhz(const nlohmann::json& report);

/// Median (of an even number the lower of both in the middle) and extremes.
Clock clock_over_seeds(std::vector<double> mhz);

}  // namespace mixcmp::model
