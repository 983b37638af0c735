#include "model/characterise/tools.hpp"

#include <fmt/core.h>
#include <stdlib.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "model/common/check.hpp"
#include "model/common/file.hpp"

namespace mixcmp::model {
namespace {

Command command_from(const char* variable, const std::string& otherwise) {
  const char* value = getenv(variable);
  std::istringstream words(value == nullptr ? "" : value);
  Command command;
  for (std::string word; words >> word;) command.push_back(word);
  if (command.empty()) command.push_back(otherwise);
  return command;
}

/// A folder of our own: two versions may be asked for at once.
Result<std::string> first_line(Command command, const std::string& option,
                               const std::string& package) {
  const std::string tool = command.back();
  command.push_back(option);
  std::string pattern = (std::filesystem::temp_directory_path() / "mixcmp.XXXXXX").string();
  MIXCMP_CHECK(mkdtemp(pattern.data()) != nullptr);
  const std::filesystem::path directory = pattern;
  const auto ran = run_tool(command, directory, directory / "version", {});
  const Result<std::string> text = read_file(directory / "version");
  std::filesystem::remove_all(directory);
  if (ran.ok() && text.ok()) return text->substr(0, text->find('\n'));
  return Error{.message = fmt::format("{} does not run", to_shell(command)),
               .accepted = fmt::format("{}, on Debian: apt-get install {}", tool, package)};
}

}  // namespace

bool is_routed(const Device& device) {
  switch (device.timing) {
    case TimingTool::none:
    case TimingTool::yosys_sta: return false;
    case TimingTool::nextpnr_ice40:
    case TimingTool::nextpnr_ecp5: return true;
  }
  MIXCMP_CHECK(!"a timing tool of no enumerator");
}

Command yosys_command(const Device& device) {
  if (device.timing != TimingTool::nextpnr_ecp5) return {"yosys"};
  return command_from("MIXCMP_YOSYS_ECP5", "yosys");
}

Command router_command(const Device& device) {
  MIXCMP_CHECK(is_routed(device));
  if (device.timing == TimingTool::nextpnr_ice40) return {"nextpnr-ice40"};
  return command_from("MIXCMP_NEXTPNR_ECP5", "nextpnr-ecp5");
}

Result<std::string> yosys_version(const Device& device) {
  return first_line(yosys_command(device), "-V", "yosys");
}

Result<std::string> router_version(const Device& device) {
  const bool ice40 = device.timing == TimingTool::nextpnr_ice40;
  return first_line(
      router_command(device), "--version",
      ice40 ? "nextpnr-ice40" : "nextpnr-ecp5 (Debian 13; docs/devices.md for Debian 12)");
}

Result<Done> run_in(const std::filesystem::path& directory, const Command& command,
                    const std::string& log, int seconds) {
  Command limited = {"timeout", std::to_string(seconds)};
  limited.insert(limited.end(), command.begin(), command.end());
  return run_tool(limited, directory, std::filesystem::absolute(directory / log), {});
}

Result<nlohmann::json> read_json(const std::filesystem::path& path) {
  MIXCMP_TRY(text, read_file(path));
  nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_discarded()) return json;
  return Error{.file = path.string(), .message = "not the JSON that the tool should have written"};
}

}  // namespace mixcmp::model
