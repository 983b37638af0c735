#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "generator/hardware/emit/system.hpp"
#include "generator/hardware/emit/test_vector.hpp"
#include "model/cost/devices/device.hpp"

/// The files that a user of another tool expects beside the Verilog: scripts, constraints, a test
/// bench.
namespace mixcmp::project {

/// The tools that a project can be written for.
enum class Tool { vivado, quartus, yosys, nextpnr, fusesoc, verilator, icarus };

std::string_view to_string(Tool tool);
std::vector<std::string> tool_names();
/// The tool of this name, which must be one of tool_names().
Tool tool_named(std::string_view name);
/// Whether the project of a tool runs the test bench, for which vectors are needed.
bool runs_test_bench(Tool tool);

/// The command that starts a tool on a system of this name in `directory`.
std::string start_command(Tool tool, const std::string& top, const std::string& directory);

/// The input of all files of a project.
struct ProjectSpec {
  const emit::Signature& signature;
  const devices::Device& device;
  /// Vector k is for lane k modulo the number of lanes. For a group of lanes, vectors fill whole
  /// words. Empty: there is an engine, or no data.
  const std::vector<emit::TestVector>& vectors;
  /// For the test bench of the engine, where there is one and there are vectors.
  const emit::EngineVectors& engine_vectors;
  /// The command that makes these files, for their heads.
  std::string command;

  /// The module to build, which is the engine's where there is one.
  const std::string& build_top() const;
  /// Whether there is a test bench of the engine.
  bool tests_engine() const { return !std::holds_alternative<std::monostate>(engine_vectors); }
  /// The name of the test bench, that of the engine where there is one; empty without data.
  std::string bench() const;
  /// The ports of that module.
  const std::vector<emit::SignaturePort>& build_ports() const;
};

/// The files for these tools, and the test bench and the templates for integration that come with
/// any tool. Error: a tool does not support the device. There must be vectors for a tool that
/// runs test benches.
Result<std::vector<emit::GeneratedFile>> project_files(const ProjectSpec& spec,
                                                       const std::set<Tool>& tools);

}  // namespace mixcmp::project
