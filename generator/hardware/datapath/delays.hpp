#pragma once

#include <string_view>

#include "generator/hardware/datapath/units.hpp"
#include "model/base/common/result.hpp"

namespace mixcmp::datapath {

/// The delay table of a device, by any name that find_device knows or by the path of a device
/// file.
Result<DelayTable> delays_of(std::string_view device);

}  // namespace mixcmp::datapath
