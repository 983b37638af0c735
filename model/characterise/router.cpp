#include "model/characterise/router.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <regex>

#include "model/characterise/tools.hpp"
#include "model/common/check.hpp"
#include "model/common/file.hpp"

namespace mixcmp::model {
namespace {

/// What differs between nextpnr's two architectures.
struct Architecture {
  const char* allow_unconstrained;
  const char* lut;  ///< in the list of utilisation
};

Architecture architecture_of(const Device& device) {
  MIXCMP_CHECK(is_routed(device));
  if (device.timing == TimingTool::nextpnr_ice40) {
    return {.allow_unconstrained = "--pcf-allow-unconstrained", .lut = "ICESTORM_LC"};
  }
  return {.allow_unconstrained = "--lpf-allow-unconstrained", .lut = "TRELLIS_COMB"};
}

Command call(const Device& device, const std::string& netlist,
             const std::vector<std::string>& options) {
  Command command = router_command(device);
  const auto append = [&](const std::vector<std::string>& words) {
    command.insert(command.end(), words.begin(), words.end());
  };
  append(device.timing_arguments);
  append({architecture_of(device).allow_unconstrained, "--json", netlist});
  append(options);
  return command;
}

/// nextpnr's own reason where it gave one; it is more use than the end of its log.
Error reason_of(const Error& failure, const std::filesystem::path& log) {
  const Result<std::string> text = read_file(log);
  static const std::regex reason("ERROR: ([^\n]*)");
  std::smatch found;
  if (!text.ok() || !std::regex_search(*text, found, reason)) return failure;
  return Error{.file = log.string(), .message = found[1]};
}

Result<double> route_once(const Device& device, const std::filesystem::path& directory,
                          const std::string& netlist, int seed, int seconds) {
  // The router serves the most critical path first whatever the target, as long as it is missed.
  constexpr const char* target_mhz = "400";
  const std::string report = fmt::format("route_{}.json", seed);
  const std::string log = fmt::format("route_{}.log", seed);
  const Command command = call(device, netlist,
                               {"--report", report, "--seed", std::to_string(seed), "--freq",
                                target_mhz, "--timing-allow-fail"});
  const auto ran = run_in(directory, command, log, seconds);
  if (!ran.ok()) return reason_of(ran.error(), directory / log);
  MIXCMP_TRY(parsed, read_json(directory / report));
  return routed_mhz(parsed);
}

}  // namespace

Result<int> packed_luts(const Device& device, const std::filesystem::path& directory,
                        const std::string& netlist, int seconds) {
  const auto ran = run_in(directory, call(device, netlist, {"--pack-only"}), "pack.log", seconds);
  if (!ran.ok()) return reason_of(ran.error(), directory / "pack.log");
  MIXCMP_TRY(log, read_file(directory / "pack.log"));
  const std::regex used(fmt::format("{}: *(\\d+)/", architecture_of(device).lut));
  std::smatch found;
  if (std::regex_search(log, found, used)) return std::stoi(found[1]);
  return Error{.file = (directory / "pack.log").string(),
               .message = "nextpnr did not say what it packed"};
}

Result<double> routed_mhz(const nlohmann::json& report) {
  std::optional<double> slowest;
  const nlohmann::json clocks = report.value("fmax", nlohmann::json::object());
  for (const auto& [name, clock] : clocks.items()) {
    const double mhz = clock.at("achieved").get<double>();
    slowest = std::min(mhz, slowest.value_or(mhz));
  }
  if (slowest) return *slowest;
  return Error{.message = "there is no path between registers"};
}

Clock clock_over_seeds(std::vector<double> mhz) {
  MIXCMP_CHECK(!mhz.empty());
  std::sort(mhz.begin(), mhz.end());
  return {.mhz = mhz[(mhz.size() - 1) / 2],
          .low_mhz = mhz.front(),
          .high_mhz = mhz.back(),
          .seeds = static_cast<int>(mhz.size()),
          .source = ClockSource::routed};
}

Result<Clock> route(const Device& device, const std::filesystem::path& directory,
                    const std::string& netlist, int seeds, int seconds) {
  std::vector<double> mhz;
  std::optional<Error> failure;
  for (int seed = 1; seed <= seeds; ++seed) {
    const Result<double> routed = route_once(device, directory, netlist, seed, seconds);
    if (routed.ok()) {
      mhz.push_back(*routed);
    } else if (!failure) {
      failure = routed.error();
    }
  }
  if (mhz.empty()) return failure.value_or(Error{.message = "no seed was asked for"});
  return clock_over_seeds(std::move(mhz));
}

}  // namespace mixcmp::model
