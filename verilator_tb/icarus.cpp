#include "verilator_tb/icarus.hpp"

#include <fmt/core.h>

#include "embedded/harness_files.hpp"
#include "embedded/vpi_harness_files.hpp"
#include "verilator_tb/bench.hpp"

namespace mixcmp::verilator_tb {

namespace {

using Ports = std::vector<emit::SignaturePort>;

std::string range(int width) {
  return width == 1 ? "" : fmt::format("[{}:0] ", width - 1);
}

/// The module around the top: variables that the harness sets, nets that it reads.
std::string testbench_text(const std::string& top, const Ports& ports) {
  std::string declarations, connections;
  for (const emit::SignaturePort& port : ports) {
    const bool is_output = port.direction == rtl::Direction::output;
    declarations +=
        fmt::format("  {} {}{};\n", is_output ? "wire" : "reg ", range(port.width), port.name);
    connections +=
        fmt::format("{}\n    .{}({})", connections.empty() ? "" : ",", port.name, port.name);
  }
  return fmt::format(
      "// Lets the harness drive the system: once a time unit it sets the inputs and reads what "
      "the\n"
      "// outputs became of those before.\n"
      "`default_nettype none\n\nmodule testbench;\n\n{}\n  {} system ({}\n  );\n\n"
      "  reg [8*1024-1:0] waves;\n\n  initial begin\n"
      "    if ($value$plusargs(\"trace=%s\", waves)) begin\n"
      "      $dumpfile(waves);\n      $dumpvars(0, system);\n    end\n"
      "    forever begin\n      $mixcmp_exchange;\n      #1;\n    end\n  end\n\nendmodule\n\n"
      "`default_nettype wire\n",
      declarations, top, connections);
}

/// The model's ports for the harness, in the place of Verilator's header.
std::string model_text(const Ports& ports) {
  std::string members, entries;
  for (const emit::SignaturePort& port : ports) {
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

/// The call of the compiler in a makefile, up to its files. Without debug information, objects do
/// not depend on their folder, and ccache finds them for each --work.
std::string compiler_call(bool ccache) {
  return fmt::format("{}g++ $$(iverilog-vpi --ccflags) -g0 -std=c++20 -Wall -O1",
                     ccache ? "ccache " : "");
}

/// The harness of one kind, compiled once for all systems.
ModelBuild harness_build(const char* main, const std::filesystem::path& work_dir,
                         const std::string& version) {
  ModelBuild build{.folder = {},
                   .product = "vpi_model.o",
                   .compile = {"-Dmain=harness_main", "-c", std::string("../") + main},
                   .inputs = {}};
  for (const EmbeddedFile& file : harness_files()) build.inputs.emplace_back(file.name, file.text);
  for (const EmbeddedFile& file : vpi_harness_files()) {
    build.inputs.emplace_back(file.name, file.text);
  }
  build.folder = work_folder(work_dir, "icarus-harness", version + compiler_call(false),
                             build.compile, build.inputs);
  return build;
}

/// How make compiles the system for vvp, and the harness that vvp loads. The harness's folder is
/// beside the system's.
std::string makefile(const Command& compile, const ModelBuild& harness, bool ccache) {
  const std::string compiler = compiler_call(ccache);
  const std::string folder = "../" + harness.folder.filename().string();
  return fmt::format(
      "# Builds obj/simulate: the system for vvp, and the harness that vvp loads.\n\n"
      "obj/simulate: obj/simulation obj/harness.vpi\n\tcp simulate $@ && chmod +x $@\n\n"
      "obj/simulation:\n\tmkdir -p obj && {0}\n\n"
      "obj/harness.vpi: {1}/{2}\n"
      "\tmkdir -p obj && {3} -I. -I{1} -c -o obj/model.o {1}/vpi_clocked_model.cpp\n"
      "\tg++ -o $@ obj/model.o {1}/obj/*.o $$(iverilog-vpi --ldflags) $$(iverilog-vpi --ldlibs)\n\n"
      "{1}/{2}:\n\tmkdir -p {1}/obj && cd {1}/obj && {3} {4} && {3} -c ../vpi_model.cpp\n"
      "\ttouch $@\n",
      shell_line(compile), folder, build_stamp, compiler, shell_line(harness.compile));
}

/// The program that the host starts. It becomes vvp, so that whoever kills it kills the simulation.
/// vvp runs in the folder of the waves: its $dumpfile takes only ASCII names, and that folder may
/// have any name.
constexpr const char* launcher =
    "#!/bin/sh\n"
    "# Runs the system with its harness, which reads the words. trace=FILE: writes also waves.\n"
    "set -eu\n"
    "objects=$(cd -P \"$(dirname \"$0\")\" && pwd -P)\n"
    "for word in \"$@\"; do\n"
    "  file=${word#trace=}\n"
    "  [ \"$file\" != \"$word\" ] || continue\n"
    "  cd -P \"$(dirname \"$file\")\"\n"
    "  set -- \"$@\" -fst \"+trace=$(basename \"$file\")\"\n"
    "done\n"
    "exec vvp -n \"-M$objects\" -mharness \"$objects/simulation\" \"$@\"\n";

/// Adds the Debian package to an error which says that a program of Icarus is missing. Other errors
/// stay as they are.
Error naming_the_package(Error error, const std::string& program) {
  if (error.kind != ErrorKind::missing_tool) return error;
  // Since iverilog ran already, apt-get takes the package for installed.
  error.accepted = program + ", on Debian: apt-get install --reinstall iverilog";
  return error;
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

Result<Executable> build_in_icarus(const System& system, const BuildOptions& options) {
  MIXCMP_TRY(version, tool_version({"iverilog", "-V"}, "iverilog"));
  MIXCMP_DO(check_programs());
  MIXCMP_TRY(sources, system_sources(system));
  const Bench bench = bench_of(system.signature);
  const ModelBuild harness = harness_build(bench.main, options.work_dir, version);
  ModelBuild build{
      .folder = {},
      .product = "simulate",
      .compile = {"iverilog", "-g2001", "-o", "obj/simulation", "-s", "testbench", "testbench.v"},
      .inputs = sources};
  for (const auto& [file, text] : sources) build.compile.push_back(file);
  build.inputs.emplace_back("system_model.hpp", bench.model);
  build.inputs.emplace_back("Vsystem.h", model_text(bench.ports));
  build.inputs.emplace_back("testbench.v", testbench_text(bench.top, bench.ports));
  build.inputs.emplace_back("simulate", launcher);
  build.inputs.emplace_back("build.mk", makefile(build.compile, harness, is_ccache_usable()));
  build.folder =
      work_folder(options.work_dir, bench.top + "-icarus", version, build.compile, build.inputs);
  return make_program(build, {harness}, options);
}

}  // namespace mixcmp::verilator_tb
