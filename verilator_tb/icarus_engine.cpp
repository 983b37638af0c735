#include "verilator_tb/icarus_engine.hpp"

#include <fmt/core.h>

#include "embedded/harness_files.hpp"
#include "embedded/vpi_harness_files.hpp"
#include "verilator_tb/bench.hpp"
#include "verilator_tb/icarus.hpp"

namespace mixcmp::verilator_tb {

namespace {

std::string range(int width) {
  return width == 1 ? "" : fmt::format("[{}:0] ", width - 1);
}

/// The module around the engine: variables that the harness sets, nets that it reads.
std::string bench_text(const emit::SignatureEngine& engine) {
  std::string declarations, connections;
  for (const emit::SignaturePort& port : engine.ports) {
    const bool is_output = port.direction == rtl::Direction::output;
    declarations +=
        fmt::format("  {} {}{};\n", is_output ? "wire" : "reg ", range(port.width), port.name);
    connections +=
        fmt::format("{}\n    .{}({})", connections.empty() ? "" : ",", port.name, port.name);
  }
  return fmt::format(
      "// Lets the harness drive the engine: once a time unit it sets the inputs and reads what "
      "the\n"
      "// outputs became of those before.\n"
      "`default_nettype none\n\nmodule bench;\n\n{}\n  {} engine ({}\n  );\n\n"
      "  reg [8*1024-1:0] waves;\n\n  initial begin\n"
      "    if ($value$plusargs(\"trace=%s\", waves)) begin\n"
      "      $dumpfile(waves);\n      $dumpvars(0, engine);\n    end\n"
      "    forever begin\n      $mixcmp_exchange;\n      #1;\n    end\n  end\n\nendmodule\n\n"
      "`default_nettype wire\n",
      declarations, engine.top, connections);
}

/// The model's ports for the harness, in the place of Verilator's header.
std::string model_text(const emit::SignatureEngine& engine) {
  std::string members, entries;
  for (const emit::SignaturePort& port : engine.ports) {
    members += fmt::format("  std::array<std::uint8_t, {}> {} = {{}};\n",
                           (port.width + 31) / 32 * 4, port.name);
    entries += fmt::format("                  {{\"{0}\", {1}, {2}, {0}.data()}},\n", port.name,
                           port.direction == rtl::Direction::output, port.width);
  }
  return fmt::format(
      "#pragma once\n\n#include <array>\n#include <cstdint>\n\n#include \"vpi_model.hpp\"\n\n"
      "struct Vsystem : mixcmp::harness::VpiModel {{\n"
      "  Vsystem()\n      : VpiModel({{\n{}        }}) {{}}\n\n{}}};\n",
      entries, members);
}

std::string makefile(const Command& compile, const std::string& main) {
  return fmt::format(
      "# Builds obj/simulate: the engine for vvp, and the harness that it loads.\n\n"
      "obj/simulate: obj/simulation obj/harness.vpi\n\tcp simulate $@ && chmod +x $@\n\n"
      "obj/simulation:\n\tmkdir -p obj && {}\n\n"
      "obj/harness.vpi:\n\tmkdir -p obj && g++ $$(iverilog-vpi --ccflags) -std=c++20 -Wall -O1 "
      "-Dmain=harness_main -o $@ {} vpi_clocked_model.cpp vpi_model.cpp $$(iverilog-vpi --ldflags) "
      "$$(iverilog-vpi --ldlibs) -pthread\n",
      shell_line(compile), main);
}

/// The program that the host starts. It becomes vvp, so that whoever kills it kills the simulation.
/// vvp runs in the folder of the waves: its $dumpfile takes only ASCII names, and that folder may
/// have any name.
constexpr const char* launcher =
    "#!/bin/sh\n"
    "# Runs the engine with its harness, which reads the words. trace=FILE: writes also waves.\n"
    "set -eu\n"
    "objects=$(cd \"$(dirname \"$0\")\" && pwd)\n"
    "for word in \"$@\"; do\n"
    "  file=${word#trace=}\n"
    "  [ \"$file\" != \"$word\" ] || continue\n"
    "  cd \"$(dirname \"$file\")\"\n"
    "  set -- \"$@\" -fst \"+trace=$(basename \"$file\")\"\n"
    "done\n"
    "exec vvp -n \"-M$objects\" -mharness \"$objects/simulation\" \"$@\"\n";

SourceFiles inputs_of(const System& system, const Bench& bench, const SourceFiles& sources,
                      const Command& compile) {
  SourceFiles inputs = sources;
  for (const EmbeddedFile& file : harness_files()) inputs.emplace_back(file.name, file.text);
  for (const EmbeddedFile& file : vpi_harness_files()) inputs.emplace_back(file.name, file.text);
  inputs.emplace_back("system_model.hpp", bench.model);
  inputs.emplace_back("Vsystem.h", model_text(*system.signature.engine));
  inputs.emplace_back("bench.v", bench_text(*system.signature.engine));
  inputs.emplace_back("simulate", launcher);
  inputs.emplace_back("build.mk", makefile(compile, bench.main));
  return inputs;
}

/// Looks for the programs of Icarus that the makefile and the launcher call: a shell would not name
/// the package of a missing one.
Result<Done> check_programs() {
  for (const Command& call : {Command{"vvp", "-V"}, Command{"iverilog-vpi", "--ccflags"}}) {
    const auto run = capture(call);
    if (!run.ok()) return naming_the_package(run.error(), call[0]);
  }
  return Done{};
}

}  // namespace

Result<Executable> build_engine_in_icarus(const System& system, const BuildOptions& options) {
  MIXCMP_TRY(version, tool_version({"iverilog", "-V"}, "iverilog"));
  MIXCMP_DO(check_programs());
  MIXCMP_TRY(sources, system_sources(system));
  const Bench bench = bench_of(system.signature);
  ModelBuild build{
      .folder = {},
      .product = "simulate",
      .compile = {"iverilog", "-g2001", "-o", "obj/simulation", "-s", "bench", "bench.v"},
      .inputs = {}};
  for (const auto& [file, text] : sources) build.compile.push_back(file);
  build.inputs = inputs_of(system, bench, sources, build.compile);
  build.folder =
      work_folder(options.work_dir, bench.top + "-icarus", version, build.compile, build.inputs);
  return make_program(build, {}, options);
}

}  // namespace mixcmp::verilator_tb
