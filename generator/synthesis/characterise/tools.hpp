#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "model/base/common/process.hpp"
#include "model/cost/devices/device.hpp"

namespace mixcmp::characterise {

/// A program of nextpnr. YoWASP's Python package of the same program, which runs anywhere, has
/// "yowasp-" before the name, and so has the program in it.
struct Router {
  devices::TimingTool tool;
  const char* program;    ///< "nextpnr-ecp5"
  const char* package;    ///< Debian 12's, else the Python package
  const char* devices;    ///< the devices whose clocks it determines
  const char* free_pins;  ///< its option to place pins by itself; empty: it needs a netlist without
  const char* lut;        ///< the name of LUTs in its report of utilisation
  const char* result;     ///< its option that names the routed design
};

/// The commands of Yosys after which a netlist has no ports. Its clock is then a net without a
/// driver, which nextpnr times as any other.
inline constexpr const char* remove_ports = "delete -port w:*\n";

/// All routers that the program can run.
std::span<const Router> routers();

/// The router that determines the device's clocks; null if none does.
const Router* router_of(const devices::Device& device);
inline bool is_routed(const devices::Device& device) {
  return router_of(device) != nullptr;
}

/// An error if Yosys does not synthesise for the device. It says why.
Result<Done> check_is_synthesised(const devices::Device& device);

/// The command for Yosys: the program of PATH, else YoWASP's.
Command yosys_command();

/// The command for Yosys; for ECP5 $MIXCMP_YOSYS_ECP5 if that is set. Commands in the environment
/// are split at blanks.
Command yosys_command(const devices::Device& device);

/// The command for a router: that of its variable if it is set ($MIXCMP_NEXTPNR_ECP5, and so on),
/// else the program of PATH, else YoWASP's.
Command router_command(const Router& router);

/// The line in which a tool prints its version. If the tool does not run, the error names its
/// package.
Result<std::string> yosys_version(const devices::Device& device);
Result<std::string> router_version(const Router& router);

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
