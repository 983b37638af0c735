#include "generator/faces/cli/project.hpp"

#include <fmt/core.h>

#include "generator/faces/cli/exit.hpp"
#include "model/cost/devices/device.hpp"
#include "verilator_tb/engine_vectors.hpp"
#include "verilator_tb/test_vectors.hpp"

namespace mixcmp::cli {
namespace {

std::vector<std::string> names_of(const std::set<project::Tool>& tools) {
  std::vector<std::string> names;
  for (const project::Tool tool : tools) names.emplace_back(project::to_string(tool));
  return names;
}

std::string project_command(const ProjectOptions& options, CommandLine command) {
  return command.add("--project", text_of(names_of(options.tools)))
      .add("--vectors", std::to_string(options.vectors))
      .text();
}

}  // namespace

void add_project_options(const Verb& verb, ProjectOptions& options) {
  const Option tools =
      verb.list_option(
              "--project",
              [&options](const std::vector<std::string>& names) {
                for (const std::string& name : names) {
                  options.tools.insert(project::tool_named(name));
                }
              },
              "add scripts, constraints and a test bench for these tools: vivado, quartus, yosys, "
              "nextpnr, fusesoc, verilator, icarus (docs/projects.md)")
          .one_of(project::tool_names())
          .separated_by(',')
          .one_value_each();
  verb.option("--vectors", options.vectors,
              "comparisons of the scene's data in the test bench (default: 1000)")
      .check(whole(1, 1'000'000))
      .needs(tools);
}

Result<Done> check_project(const ProjectOptions& options, const LoadedScene& loaded) {
  for (const project::Tool tool : options.tools) {
    if (!project::runs_test_bench(tool)) continue;
    MIXCMP_DO(check_has_data(loaded, fmt::format("the test bench of --project {} needs "
                                                 "data to run on",
                                                 project::to_string(tool))));
  }
  return Done{};
}

void add_project(emit::GeneratedSystem& system, const ProjectOptions& options,
                 const LoadedScene& loaded, const design::Design& design,
                 const CommandLine& command) {
  if (options.tools.empty()) return;
  const devices::Device device = value_or_exit(devices::find_device(design.system.device));
  std::vector<emit::TestVector> vectors;
  emit::EngineVectors engine_vectors;
  if (loaded.data) {
    if (!system.signature.engine) {
      vectors = verilator_tb::test_vectors(design, *loaded.data, system.signature, options.vectors);
    }
    engine_vectors =
        verilator_tb::engine_vectors(design, *loaded.data, system.signature, options.vectors);
  }
  const project::ProjectSpec spec{system.signature, device, vectors, engine_vectors,
                                  project_command(options, command)};
  value_or_exit(
      emit::add_project_files(system, value_or_exit(project::project_files(spec, options.tools))));
}

}  // namespace mixcmp::cli
