#pragma once

#include <string_view>
#include <vector>

#include "generator/datapath/units.hpp"
#include "model/common/result.hpp"

namespace mixcmp::gen {

/// The delay table of a device's family, by device name ("virtex6-lx760").
model::Result<DelayTable> delays_of(std::string_view device);

/// Every device name that delays_of accepts.
std::vector<std::string_view> known_devices();

}  // namespace mixcmp::gen
