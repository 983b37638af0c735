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

void run(const std::string& pattern, bool json) {
  const std::vector<devices::KnownDevice> found = devices::devices_with(pattern);
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
