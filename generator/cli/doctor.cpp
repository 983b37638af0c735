#include <fmt/core.h>
#include <stdio.h>

#include <array>
#include <nlohmann/json.hpp>
#include <string>

#include "generator/cli/exit.hpp"
#include "generator/cli/verbs.hpp"

namespace mixcmp::cli {
namespace {

struct Tool {
  const char* name;
  const char* version_command;
  const char* package;   ///< of Debian
  const char* disables;  ///< what is missing without it
};

constexpr std::array<Tool, 12> tools = {{
    {"verilator", "verilator --version", "verilator", "verify"},
    {"make", "make --version", "make", "verify"},
    {"g++", "g++ --version", "g++", "verify, baseline"},
    {"ccache", "ccache --version", "ccache", "nothing; builds of simulations take longer"},
    {"iverilog", "iverilog -V 2>/dev/null", "iverilog", "verify --simulator icarus"},
    {"yosys", "yosys -V", "yosys", "characterise, check --costs, the lint and formal tests"},
    {"nextpnr-ice40", "command -v nextpnr-ice40 >&2 && nextpnr-ice40 --version 2>&1",
     "nextpnr-ice40", "the clocks of iCE40 devices in characterise"},
    {"nextpnr-ecp5",
     "set -- ${MIXCMP_NEXTPNR_ECP5:-nextpnr-ecp5}; "
     "command -v \"$1\" >&2 && \"$@\" --version 2>&1 | grep Version",
     "nextpnr-ecp5", "the clocks of ECP5 devices in characterise (Debian 12: docs/devices.md)"},
    {"glpsol", "glpsol --version", "glpk-utils", "the tests of plans by a second solver"},
    {"gappa", "gappa --version", "gappa",
     "check --prove, and the machine check of error bounds before generate"},
    {"gnuplot", "gnuplot --version", "gnuplot-nox", "the pictures of profile"},
    {"gtkwave", "command -v gtkwave", "gtkwave", "looking at the waves of verify --trace"},
}};

/// First line of what the command prints on its standard output; empty where it cannot run.
std::string first_line(const char* command) {
  FILE* pipe = popen(fmt::format("( {} ) 2>/dev/null", command).c_str(), "r");
  if (pipe == nullptr) return "";
  std::array<char, 256> line = {};
  const bool read = fgets(line.data(), line.size(), pipe) != nullptr;
  while (fgetc(pipe) != EOF) {
  }
  pclose(pipe);
  std::string text = read ? line.data() : "";
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

void run(bool json) {
  nlohmann::ordered_json report = nlohmann::ordered_json::array();
  for (const Tool& tool : tools) {
    const std::string version = first_line(tool.version_command);
    if (json) {
      report.push_back({{"tool", tool.name},
                        {"found", !version.empty()},
                        {"version", version},
                        {"package", tool.package},
                        {"disables", tool.disables}});
    } else if (version.empty()) {
      fmt::print("{:<13} missing: apt-get install {}; disables {}\n", tool.name, tool.package,
                 tool.disables);
    } else {
      fmt::print("{:<13} {}\n", tool.name, version);
    }
  }
  if (json) fmt::print("{}\n", report.dump(2));
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
