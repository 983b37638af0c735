#pragma once

#include <string_view>

#include "generator/hardware/datapath/units.hpp"
#include "model/base/common/result.hpp"

namespace mixcmp::datapath {

/// The delay table of a device (model/cost/devices/NAME.toml), by name or by the path of a device
/// file.
Result<DelayTable> delays_of(std::string_view device);

}  // namespace mixcmp::datapath
