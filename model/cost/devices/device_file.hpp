#pragma once

#include <filesystem>
#include <string>

#include "model/cost/devices/device.hpp"

namespace mixcmp::devices {

/// Reads the text of a device file (docs/devices.md); `path` is for the errors, which name file,
/// line and field.
Result<Device> read_device(std::string text, const std::filesystem::path& path);

}  // namespace mixcmp::devices
