#include "generator/synthesis/characterise/tools.hpp"

#include <fmt/core.h>
#include <stdlib.h>

#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>

#include "model/base/common/check.hpp"
#include "model/base/common/file.hpp"

namespace mixcmp::characterise {
namespace {

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

bool is_routed(const devices::Device& device) {
  switch (device.timing) {
    case devices::TimingTool::none:
    case devices::TimingTool::yosys_sta: return false;
    case devices::TimingTool::nextpnr_ice40:
    case devices::TimingTool::nextpnr_ecp5: return true;
  }
  MIXCMP_CHECK(!"a timing tool of no enumerator");
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

Command yosys_command(const devices::Device& device) {
  if (device.timing != devices::TimingTool::nextpnr_ecp5) return {"yosys"};
  return command_from("MIXCMP_YOSYS_ECP5", "yosys");
}

Command ecp5_router_command() {
  return command_from("MIXCMP_NEXTPNR_ECP5", "nextpnr-ecp5");
}

Command router_command(const devices::Device& device) {
  MIXCMP_CHECK(is_routed(device));
  if (device.timing == devices::TimingTool::nextpnr_ice40) return {"nextpnr-ice40"};
  return ecp5_router_command();
}

Result<std::string> yosys_version(const devices::Device& device) {
  return tool_version(with(yosys_command(device), "-V"), "yosys");
}

Result<std::string> router_version(const devices::Device& device) {
  // Each tool is asked once: one that answers only sometimes must not do both in one run.
  static std::mutex mutex;
  static std::map<std::pair<Command, std::string>, Result<std::string>> answers;
  const Command command = with(router_command(device), "--version");
  const char* path = getenv("PATH");
  const std::pair asked(command, std::string(path == nullptr ? "" : path));
  const std::lock_guard lock(mutex);
  const auto known = answers.find(asked);
  if (known != answers.end()) return known->second;
  const bool ice40 = device.timing == devices::TimingTool::nextpnr_ice40;
  const auto answer = tool_version(
      command, ice40 ? "nextpnr-ice40" : "nextpnr-ecp5 (Debian 13; docs/devices.md for Debian 12)");
  return answers.emplace(asked, answer).first->second;
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
