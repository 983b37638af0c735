#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "model/base/common/result.hpp"
#include "model/cost/devices/device.hpp"

namespace mixcmp::characterise {

/// The area of one cell of the device (docs/devices.md). An unknown cell is an
/// error, since without it a design would look smaller.
Result<devices::Area> area_of_cell(std::string_view cell, const devices::Device& device);

/// The area of a design, summed over the cells that `stat -json` (Yosys 0.23 to 0.52) counts.
Result<devices::Area> area_of_statistics(const nlohmann::json& statistics,
                                         const devices::Device& device);

/// The area of one module of such a design; none of the modules below it counts. It may be empty.
Result<devices::Area> area_of_module(const nlohmann::json& statistics, const std::string& module,
                                     const devices::Device& device);

}  // namespace mixcmp::characterise
