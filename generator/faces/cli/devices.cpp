#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "generator/faces/cli/exit.hpp"
#include "generator/faces/cli/verb.hpp"
#include "generator/faces/cli/verbs.hpp"
#include "generator/present/report/device_report.hpp"
#include "generator/present/report/json_text.hpp"
#include "model/base/common/quote.hpp"
#include "model/cost/devices/device.hpp"
#include "model/cost/devices/parts.hpp"

namespace mixcmp::cli {
namespace {

/// The devices of which a name, the family or the clock's tool contains the pattern.
std::vector<devices::KnownDevice> matching(const std::string& pattern) {
  std::vector<devices::KnownDevice> known = devices::known_devices();
  std::erase_if(known, [text = devices::lower_case(pattern)](const devices::KnownDevice& each) {
    const std::string words =
        fmt::format("{} {} {} {}", each.device.name, each.device.family,
                    to_string(each.device.timing), fmt::join(each.other_names, " "));
    return words.find(text) == std::string::npos;
  });
  return known;
}

void run(const std::string& pattern, bool json) {
  const std::vector<devices::KnownDevice> found = matching(pattern);
  if (found.empty()) {
    fail({.field = "PATTERN",
          .message = "no device has this in its names",
          .received = in_quotes(pattern),
          .accepted = devices::candidates_for(pattern)});
  }
  print(json ? report::json_text(report::to_json(found)) : report::to_text(found));
}

}  // namespace

void add_devices(CLI::App& app) {
  const Verb verb(app, "devices", "list the devices that --device knows: parts and boards");
  auto pattern = std::make_shared<std::string>();
  auto json = std::make_shared<bool>(false);
  verb.option("PATTERN", *pattern,
              "letters of a part, board, family or tool of clocks (default: all)");
  verb.flag("--json", *json, "print the result as JSON");
  verb.when_chosen([pattern, json] { run(*pattern, *json); });
}

}  // namespace mixcmp::cli
