#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "model/base/common/process.hpp"
#include "model/cost/devices/device.hpp"

namespace mixcmp::characterise {

/// Whether a router, and not Yosys, determines the device's clocks.
bool is_routed(const devices::Device& device);

/// An error if Yosys does not synthesise for the device. It says why.
Result<Done> check_is_synthesised(const devices::Device& device);

/// The command for Yosys; for ECP5 $MIXCMP_YOSYS_ECP5 if that is set. Commands in the environment
/// are split at blanks.
Command yosys_command(const devices::Device& device);

/// The command for nextpnr-ecp5: $MIXCMP_NEXTPNR_ECP5 if that is set.
Command ecp5_router_command();

/// The command for the device's router. The device must be one for which `is_routed` holds.
Command router_command(const devices::Device& device);

/// The line in which a tool prints its version. If the tool does not run, the error names its
/// package.
Result<std::string> yosys_version(const devices::Device& device);
Result<std::string> router_version(const devices::Device& device);

/// Runs a tool in `directory`, with its output in the file `log` there.
Result<Done> run_in(const std::filesystem::path& directory, const Command& command,
                    const std::string& log, const ToolLimits& limits);

/// Reads a JSON file that a tool has written; an error names the file.
Result<nlohmann::json> read_json(const std::filesystem::path& path);

/// A member of a JSON object; null if there is none, or if `object` is no object.
nlohmann::json member_of(const nlohmann::json& object, const char* key);

/// Returns `found`; its error names `file`.
template <class T>
Result<T> in_file(Result<T> found, const std::filesystem::path& file) {
  if (found.ok()) return found;
  Error error = found.error();
  error.file = file.string();
  return error;
}

}  // namespace mixcmp::characterise
