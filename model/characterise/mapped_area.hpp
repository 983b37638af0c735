#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "model/common/result.hpp"
#include "model/devices/area.hpp"

namespace mixcmp::model {

/// What one cell of Yosys' technology libraries takes of the device (docs/devices.md). An error for
/// a cell that nobody has counted yet: left out it would make a design look smaller.
Result<Area> area_of_cell(std::string_view cell);

/// The sum over a design, from `stat -json` (Yosys 0.23 to 0.52).
Result<Area> area_of_statistics(const nlohmann::json& statistics);

}  // namespace mixcmp::model
