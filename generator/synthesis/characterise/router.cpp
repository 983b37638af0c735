#include "generator/synthesis/characterise/router.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <regex>

#include "generator/synthesis/characterise/tools.hpp"
#include "model/base/common/check.hpp"
#include "model/base/common/file.hpp"

namespace mixcmp::characterise {
namespace {

using measured::Clock;
using measured::ClockSource;

Command call(const devices::Device& device, const std::string& netlist,
             const std::vector<std::string>& options) {
  const Router* router = router_of(device);
  MIXCMP_CHECK(router != nullptr);
  Command command = router_command(*router);
  const auto append = [&](const std::vector<std::string>& words) {
    command.insert(command.end(), words.begin(), words.end());
  };
  append(device.timing_arguments);
  if (*router->free_pins != '\0') command.emplace_back(router->free_pins);
  append({"--json", netlist});
  append(options);
  return command;
}

/// Whether nextpnr's message says that a design is too large or too dense for wiring.
bool is_refusal(const std::string& message) {
  static const std::regex refusal(
      "(unable|failed) to (place|find (a )?(legal )?placement|route|pack|expand)"
      "|(placing|routing|packing) design failed|no bels remaining",
      std::regex::icase);
  return std::regex_search(message, refusal);
}

/// The reason in nextpnr's log, if there is one: it is more useful than the end of the log.
Result<Refusal> reason_of(const Error& failure, const std::filesystem::path& log) {
  const Result<std::string> text = read_file(log);
  static const std::regex reason("ERROR: ([^\n]*)");
  std::smatch found;
  if (!text.ok() || !std::regex_search(*text, found, reason)) return failure;
  if (is_refusal(found[1])) return Refusal{found[1]};
  return Error{.file = log.string(), .message = found[1]};
}

using Attempt = std::variant<double, Refusal>;

Result<Attempt> route_once(const devices::Device& device, const std::filesystem::path& directory,
                           const std::string& netlist, int seed, const ToolLimits& limits) {
  // The router serves the most critical path first, so any target that no design meets will do.
  constexpr const char* target_mhz = "400";
  const std::string report = fmt::format("route_{}.json", seed);
  const std::string log = fmt::format("route_{}.log", seed);
  const Command command = call(device, netlist,
                               {"--report", report, "--seed", std::to_string(seed), "--freq",
                                target_mhz, "--timing-allow-fail"});
  const auto ran = run_in(directory, command, log, limits);
  if (!ran.ok()) {
    MIXCMP_TRY(refusal, reason_of(ran.error(), directory / log));
    return Attempt(std::move(refusal));
  }
  MIXCMP_TRY(parsed, read_json(directory / report));
  MIXCMP_TRY(mhz, in_file(routed_mhz(parsed), directory / report));
  if (mhz) return Attempt(*mhz);
  return Attempt(Refusal{"there is no path between registers"});
}

}  // namespace

Result<Packed> packed_luts(const devices::Device& device, const std::filesystem::path& directory,
                           const std::string& netlist, const ToolLimits& limits) {
  const auto ran = run_in(directory, call(device, netlist, {"--pack-only"}), "pack.log", limits);
  if (!ran.ok()) {
    MIXCMP_TRY(refusal, reason_of(ran.error(), directory / "pack.log"));
    return Packed(std::move(refusal));
  }
  MIXCMP_TRY(log, read_file(directory / "pack.log"));
  const std::regex used(fmt::format("{}: *(\\d{{1,9}})/", router_of(device)->lut));
  std::smatch found;
  if (std::regex_search(log, found, used)) return Packed(std::stoi(found[1]));
  return Error{.file = (directory / "pack.log").string(),
               .message = "nextpnr did not say what it packed"};
}

Result<std::optional<double>> routed_mhz(const nlohmann::json& report) {
  const auto unreadable = [](const std::string& field, const nlohmann::json& received) {
    return Error{.field = field,
                 .message = "nextpnr's report has no clock here",
                 .received = received.dump(),
                 .accepted = "a number of MHz above 0"};
  };
  constexpr double most_mhz = 1e5;
  const nlohmann::json clocks = member_of(report, "fmax");
  if (!clocks.is_object()) return unreadable("fmax", clocks);
  std::optional<double> slowest;
  for (const auto& [name, clock] : clocks.items()) {
    const nlohmann::json achieved = member_of(clock, "achieved");
    const double mhz = achieved.is_number() ? achieved.get<double>() : 0;
    if (!(mhz > 0 && mhz <= most_mhz)) return unreadable("fmax." + name, achieved);
    slowest = std::min(mhz, slowest.value_or(mhz));
  }
  return slowest;
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

Result<Routed> route(const devices::Device& device, const std::filesystem::path& directory,
                     const std::string& netlist, int seeds, const ToolLimits& limits) {
  std::vector<double> mhz;
  Refusal refusal{"no seed was asked for"};
  for (int seed = 1; seed <= seeds; ++seed) {
    MIXCMP_TRY(routed, route_once(device, directory, netlist, seed, limits));
    if (const double* clock = std::get_if<double>(&routed)) {
      mhz.push_back(*clock);
    } else {
      refusal = std::get<Refusal>(routed);
    }
  }
  if (mhz.empty()) return Routed(std::move(refusal));
  return Routed(clock_over_seeds(std::move(mhz)));
}

}  // namespace mixcmp::characterise
