#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "model/cost/devices/device.hpp"

namespace mixcmp::report {

/// The devices that come with the program, one a row, with their resources and other names.
std::string to_text(const std::vector<devices::KnownDevice>& known);
nlohmann::ordered_json to_json(const std::vector<devices::KnownDevice>& known);

}  // namespace mixcmp::report
