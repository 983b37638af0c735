#include <fmt/core.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "generator/cli/exit.hpp"
#include "generator/cli/verbs.hpp"
#include "model/characterise/tools.hpp"
#include "model/common/process.hpp"

namespace mixcmp::cli {
namespace {

enum class Need {
  required,  ///< a verb needs it
  optional,  ///< beyond Debian 12, or no verb needs it
};

struct Tool {
  const char* name;
  model::Command version_command;
  const char* package;   ///< of Debian
  const char* disables;  ///< what is missing without it
  Need need = Need::required;
};

std::vector<Tool> tools() {
  model::Command ecp5_router = model::ecp5_router_command();
  ecp5_router.emplace_back("--version");
  return {
      {"verilator", {"verilator", "--version"}, "verilator", "verify"},
      {"make", {"make", "--version"}, "make", "verify"},
      {"g++", {"g++", "--version"}, "g++", "verify, baseline"},
      {"ccache",
       {"ccache", "--version"},
       "ccache",
       "nothing; builds of simulations take longer",
       Need::optional},
      {"iverilog", {"iverilog", "-V"}, "iverilog", "verify --simulator icarus"},
      {"yosys",
       {"yosys", "-V"},
       "yosys",
       "characterise, route, check --costs, the lint and formal tests"},
      {"nextpnr-ice40",
       {"nextpnr-ice40", "--version"},
       "nextpnr-ice40",
       "the clocks of iCE40 devices in characterise and route"},
      {"nextpnr-ecp5", ecp5_router, "nextpnr-ecp5",
       "the clocks of ECP5 devices in characterise and route (Debian 12: docs/devices.md)",
       Need::optional},
      {"glpsol",
       {"glpsol", "--version"},
       "glpk-utils",
       "the tests of plans by a second solver",
       Need::optional},
      {"gappa",
       {"gappa", "--version"},
       "gappa",
       "check --prove, and the machine check of error bounds before generate"},
      {"gnuplot", {"gnuplot", "--version"}, "gnuplot-nox", "the pictures of profile and explore"},
      // gtkwave itself answers on a display alone.
      {"gtkwave",
       {"which", "gtkwave"},
       "gtkwave",
       "looking at the waves of verify --trace",
       Need::optional},
  };
}

std::string fault(const Tool& tool, const model::Error& error) {
  if (error.kind == model::ErrorKind::missing_tool) {
    return fmt::format("missing: apt-get install {}; disables {}", tool.package, tool.disables);
  }
  return fmt::format("{}; disables {}", error.to_string(), tool.disables);
}

void run(bool json) {
  nlohmann::ordered_json report = nlohmann::ordered_json::array();
  std::string text;
  bool complete = true;
  for (const Tool& tool : tools()) {
    const auto version = model::tool_version(tool.version_command, tool.package);
    const bool required = tool.need == Need::required;
    report.push_back({{"tool", tool.name},
                      {"found", version.ok()},
                      {"required", required},
                      {"version", version.ok() ? *version : ""},
                      {"package", tool.package},
                      {"disables", tool.disables}});
    text += fmt::format("{:<13} {}\n", tool.name,
                        version.ok() ? *version : fault(tool, version.error()));
    complete = complete && (version.ok() || !required);
  }
  print(json ? report.dump(2) + "\n" : text);
  if (complete) return;
  tell("tools that verbs need are missing or do not work");
  throw Exit(ExitCode::incomplete);
}

}  // namespace

void add_doctor(CLI::App& app) {
  CLI::App* verb =
      app.add_subcommand("doctor", "which tools are there, what each missing disables");
  auto json = std::make_shared<bool>(false);
  verb->add_flag("--json", *json, "print the result as JSON");
  verb->callback([json] { run(*json); });
}

}  // namespace mixcmp::cli
