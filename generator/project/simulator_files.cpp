#include "generator/project/builders.hpp"

namespace mixcmp::project {

std::vector<GeneratedFile> icarus_files(const ProjectSpec& spec) {
  Values values = common_values(spec, "#");
  values["SOURCES"] = source_list(spec, " \\\n  .rtl/", "");
  return {script_from("icarus/run", "icarus_run", values)};
}

std::vector<GeneratedFile> verilator_files(const ProjectSpec& spec) {
  const Values values = common_values(spec, "#");
  return {script_from("verilator/lint", "verilator_lint", values),
          script_from("verilator/run", "verilator_run", values)};
}

}  // namespace mixcmp::project
