#include "generator/project/project.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "generator/hardware/emit/constraints.hpp"
#include "generator/project/builders.hpp"
#include "model/base/common/check.hpp"

namespace mixcmp::project {
namespace {

constexpr std::array all_tools = {Tool::vivado,  Tool::quartus,   Tool::yosys, Tool::nextpnr,
                                  Tool::fusesoc, Tool::verilator, Tool::icarus};

Result<std::vector<GeneratedFile>> files_for(Tool tool, const ProjectSpec& spec) {
  switch (tool) {
    case Tool::vivado: return vivado_files(spec);
    case Tool::quartus: return quartus_files(spec);
    case Tool::yosys: return yosys_files(spec);
    case Tool::nextpnr: return nextpnr_files(spec);
    case Tool::fusesoc: return fusesoc_files(spec);
    case Tool::verilator: return verilator_files(spec);
    case Tool::icarus: return icarus_files(spec);
  }
  MIXCMP_CHECK(!"a tool of no enumerator");
}

void append(std::vector<GeneratedFile>& files, std::vector<GeneratedFile> more) {
  std::move(more.begin(), more.end(), std::back_inserter(files));
}

}  // namespace

std::string_view to_string(Tool tool) {
  switch (tool) {
    case Tool::vivado: return "vivado";
    case Tool::quartus: return "quartus";
    case Tool::yosys: return "yosys";
    case Tool::nextpnr: return "nextpnr";
    case Tool::fusesoc: return "fusesoc";
    case Tool::verilator: return "verilator";
    case Tool::icarus: return "icarus";
  }
  MIXCMP_CHECK(!"a tool of no enumerator");
}

std::vector<std::string> tool_names() {
  std::vector<std::string> names;
  for (const Tool tool : all_tools) names.emplace_back(to_string(tool));
  return names;
}

Tool tool_named(std::string_view name) {
  const auto* const found = std::find_if(all_tools.begin(), all_tools.end(),
                                         [name](Tool tool) { return to_string(tool) == name; });
  MIXCMP_CHECK(found != all_tools.end());
  return *found;
}

bool runs_test_bench(Tool tool) {
  switch (tool) {
    case Tool::fusesoc:
    case Tool::verilator:
    case Tool::icarus: return true;
    case Tool::vivado:
    case Tool::quartus:
    case Tool::yosys:
    case Tool::nextpnr: return false;
  }
  MIXCMP_CHECK(!"a tool of no enumerator");
}

std::string start_command(Tool tool, const std::string& top, const std::string& directory) {
  switch (tool) {
    case Tool::vivado:
      return fmt::format("vivado -mode batch -source {}/vivado/synthesise.tcl", directory);
    case Tool::fusesoc:
      return fmt::format("fusesoc --cores-root {} run --target sim mixcmp:comparison:{}", directory,
                         top);
    case Tool::quartus:
    case Tool::yosys:
    case Tool::nextpnr:
    case Tool::verilator:
    case Tool::icarus: return fmt::format("{}/{}/run", directory, to_string(tool));
  }
  MIXCMP_CHECK(!"a tool of no enumerator");
}

const std::string& ProjectSpec::build_top() const {
  return signature.engine ? signature.engine->top : signature.top;
}

std::string ProjectSpec::bench() const {
  return vectors.empty() && !tests_engine() ? "" : build_top() + std::string(emit::bench_suffix);
}

const std::vector<emit::SignaturePort>& ProjectSpec::build_ports() const {
  return emit::ports_to_build(signature);
}

Result<std::vector<GeneratedFile>> project_files(const ProjectSpec& spec,
                                                 const std::set<Tool>& tools) {
  std::vector<GeneratedFile> files = integration_files(spec);
  if (!spec.vectors.empty()) append(files, testbench_files(spec));
  if (spec.tests_engine()) append(files, engine_testbench_files(spec));
  for (const Tool tool : tools) {
    MIXCMP_CHECK(!spec.bench().empty() || !runs_test_bench(tool));
    MIXCMP_TRY(more, files_for(tool, spec));
    append(files, std::move(more));
  }
  return files;
}

}  // namespace mixcmp::project
