#include "generator/faces/cli/doctor.hpp"

#include <fmt/core.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "generator/faces/cli/exit.hpp"
#include "generator/faces/cli/verb.hpp"
#include "generator/faces/cli/verbs.hpp"
#include "generator/present/report/json_text.hpp"
#include "generator/synthesis/characterise/tools.hpp"
#include "model/base/common/process.hpp"
#include "model/base/common/quote.hpp"
#include "model/judge/proof/gappa.hpp"

namespace mixcmp::cli {
namespace {

enum class Need {
  required,  ///< a verb needs it
  optional,  ///< beyond Debian 12, or no verb needs it
};

struct Tool {
  const char* name;
  std::function<Result<std::string>()> version;  ///< an error says why the tool is unusable
  const char* package;                           ///< as install_command takes it
  std::string disables;                          ///< the functions that are missing without it
  Need need = Need::required;
};

std::function<Result<std::string>()> asks(Command command, const char* package) {
  return [command = std::move(command), package] { return tool_version(command, package); };
}

/// Looks for a program that has no version to ask for: gtkwave prints its own only where there is a
/// display, iverilog-vpi none.
std::function<Result<std::string>()> finds(const char* program) {
  return [program]() -> Result<std::string> {
    if (is_in_path(program)) return std::string("there; not asked for its version");
    return Error{.message = fmt::format("{} does not run", program),
                 .kind = ErrorKind::missing_tool};
  };
}

Tool row_of(const characterise::Router& router) {
  return {
      router.program, [&router] { return characterise::router_version(router); }, router.package,
      fmt::format("the clocks of {} devices in characterise and route", router.devices),
      std::string_view(router.package).starts_with("yowasp-") ? Need::optional : Need::required};
}

std::vector<Tool> tools() {
  std::vector<Tool> all = {
      {"verilator", asks({"verilator", "--version"}, "verilator"), "verilator", "verify"},
      {"make", asks({"make", "--version"}, "make"), "make", "verify"},
      {"g++", asks({"g++", "--version"}, "g++"), "g++", "verify, baseline"},
      {"ccache", asks({"ccache", "--version"}, "ccache"), "ccache",
       "nothing; builds of simulations take longer", Need::optional},
      {"iverilog", asks({"iverilog", "-V"}, "iverilog"), "iverilog", "verify --simulator icarus"},
      {"vvp", asks({"vvp", "-V"}, "iverilog"), "iverilog", "verify --simulator icarus"},
      {"iverilog-vpi", finds("iverilog-vpi"), "iverilog", "verify --simulator icarus"},
      {"yosys", asks({characterise::yosys_command().front(), "-V"}, "yosys"), "yosys",
       "characterise, route, check --costs, the lint and formal tests"},
      {"glpsol", asks({"glpsol", "--version"}, "glpk-utils"), "glpk-utils",
       "the tests of plans by a second solver", Need::optional},
      {"gappa", proof::gappa_version, "gappa",
       "check --prove, and the machine check of error bounds before generate"},
      {"coqc", asks({"coqc", "--version"}, "coq"), "coq",
       "the test of the theorems' proofs, with libcoq-flocq", Need::optional},
      {"gnuplot", asks({"gnuplot", "--version"}, "gnuplot-nox"), "gnuplot-nox",
       "the pictures of profile and explore"},
      {"tclsh", finds("tclsh"), "tcl", "the tests of scripts for Vivado and Quartus",
       Need::optional},
      {"ghdl", asks({"ghdl", "--version"}, "ghdl"), "ghdl",
       "the test of component declarations in VHDL", Need::optional},
      {"gtkwave", finds("gtkwave"), "gtkwave", "looking at the waves of verify --trace",
       Need::optional},
  };
  for (const auto& router : characterise::routers()) all.push_back(row_of(router));
  return all;
}

std::string fault(const FoundTool& tool, const Error& error) {
  if (error.kind == ErrorKind::missing_tool) {
    return fmt::format("missing: {}; disables {}", install_command(tool.package), tool.disables);
  }
  return fmt::format("{}; disables {}", error.to_string(), tool.disables);
}

void run(bool json) {
  nlohmann::ordered_json report = nlohmann::ordered_json::array();
  std::string text;
  bool complete = true;
  for (const FoundTool& tool : find_tools()) {
    const Result<std::string>& version = tool.version;
    report.push_back({{"tool", tool.name},
                      {"found", version.ok()},
                      {"required", tool.required},
                      {"version", version.ok() ? *version : ""},
                      {"package", tool.package},
                      {"disables", tool.disables}});
    text += fmt::format("{:<27} {}\n", tool.name,
                        printable_line(version.ok() ? *version : fault(tool, version.error())));
    complete = complete && (version.ok() || !tool.required);
  }
  print(json ? report::json_text(report) : text);
  if (complete) return;
  tell("tools that verbs need are missing or do not work");
  throw Exit(ExitCode::incomplete);
}

}  // namespace

std::vector<FoundTool> find_tools() {
  std::vector<FoundTool> found;
  for (const Tool& tool : tools()) {
    found.push_back({.name = tool.name,
                     .version = tool.version(),
                     .package = tool.package,
                     .disables = tool.disables,
                     .required = tool.need == Need::required});
  }
  return found;
}

void add_doctor(CLI::App& app) {
  const Verb verb(app, "doctor", "which tools are there, what each missing disables");
  auto json = std::make_shared<bool>(false);
  verb.flag("--json", *json, "print the result as JSON");
  verb.when_chosen([json] { run(*json); });
}

}  // namespace mixcmp::cli
