#include <fmt/core.h>

#include "generator/project/builders.hpp"

namespace mixcmp::project {
namespace {

/// From this number of lanes on, Icarus takes longer than half a minute to compile a system.
constexpr int large_system_lanes = 24;

/// The values of the scripts that run the test bench.
Values simulator_values(const ProjectSpec& spec) {
  Values values = common_values(spec, "#");
  values["BENCH"] = spec.bench();
  values["TESTED"] = "the test bench of " + spec.build_top();
  return values;
}

/// Shell that says how long Icarus takes; empty for a small system.
std::string remark_on_size(const emit::Signature& signature) {
  if (signature.lanes < large_system_lanes) return "";
  return fmt::format(
      "echo \"{} lanes: Icarus may take minutes to compile them; verilator/run is faster\" >&2\n",
      signature.lanes);
}

}  // namespace

std::vector<GeneratedFile> icarus_files(const ProjectSpec& spec) {
  Values values = simulator_values(spec);
  values["SOURCES"] = source_list(spec, " \\\n    .rtl/", "");
  values["LARGE_REMARK"] = remark_on_size(spec.signature);
  return {script_from("icarus/run", "icarus_run", values)};
}

std::vector<GeneratedFile> verilator_files(const ProjectSpec& spec) {
  const Values values = simulator_values(spec);
  return {script_from("verilator/lint", "verilator_lint", values),
          script_from("verilator/run", "verilator_run", values)};
}

}  // namespace mixcmp::project
