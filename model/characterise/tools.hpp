#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "model/common/process.hpp"
#include "model/devices/device.hpp"

namespace mixcmp::model {

/// Whether a router, and not Yosys, gives the device's clocks.
bool is_routed(const Device& device);

/// Yosys; for ECP5 the command in $MIXCMP_YOSYS_ECP5 where that is set. Commands in the environment
/// are split at blanks.
Command yosys_command(const Device& device);

/// nextpnr-ecp5, or the command in $MIXCMP_NEXTPNR_ECP5 where that is set.
Command ecp5_router_command();

/// nextpnr-ice40 or nextpnr-ecp5. Only of devices that are routed.
Command router_command(const Device& device);

/// The line a tool prints of its version; an error that names the package where it does not run.
Result<std::string> yosys_version(const Device& device);
Result<std::string> router_version(const Device& device);

/// Runs a tool in `directory`, with its output in the file `log` there.
Result<Done> run_in(const std::filesystem::path& directory, const Command& command,
                    const std::string& log, const ToolLimits& limits);

/// What a tool left; an error names the file.
Result<nlohmann::json> read_json(const std::filesystem::path& path);

/// A member of what a tool left; null where there is none, or `object` is no object.
nlohmann::json member_of(const nlohmann::json& object, const char* key);

}  // namespace mixcmp::model
