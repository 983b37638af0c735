#include <fmt/core.h>
#include <fmt/ranges.h>

#include "generator/project/builders.hpp"

namespace mixcmp::project {
namespace {

/// From this number of lanes on, Icarus takes longer than half a minute to compile a system.
constexpr int large_system_lanes = 24;

std::string tested(const ProjectSpec& spec) {
  const std::string& top = spec.signature.top;
  if (!spec.tests_engine()) return "the test bench of " + top;
  if (spec.vectors.empty()) return "the test bench of " + spec.signature.engine->top;
  return fmt::format("the test benches of {} and of its engine", top);
}

/// The values of the scripts that run test benches: that of the system, then that of the engine
/// around it.
Values simulator_values(const ProjectSpec& spec) {
  Values values = common_values(spec, "#");
  const std::vector<std::string> benches = spec.benches();
  values["BENCHES"] = fmt::format("{}", fmt::join(benches, " "));
  values["TESTED"] = tested(spec);
  values["WAVES_REMARK"] = benches.size() > 1 ? " Waves are those of the engine." : "";
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
