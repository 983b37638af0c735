#include <fmt/core.h>

#include <sstream>

#include "generator/project/builders.hpp"

namespace mixcmp::project {
namespace {

/// The synthesis command of a device as FuseSoC's tool for Yosys wants it: "synth_ice40 -dsp" is
/// the architecture ice40 with the option -dsp.
struct YosysOptions {
  std::string architecture;
  std::string options;  ///< "'-dsp', '-abc9'"
};

YosysOptions yosys_options(const std::string& synthesis) {
  std::istringstream words(synthesis);
  YosysOptions result;
  words >> result.architecture;
  const std::string prefix = "synth_";
  if (result.architecture.starts_with(prefix)) result.architecture.erase(0, prefix.size());
  for (std::string word; words >> word;) {
    result.options += fmt::format("{}'{}'", result.options.empty() ? "" : ", ", word);
  }
  return result;
}

}  // namespace

std::vector<GeneratedFile> fusesoc_files(const ProjectSpec& spec) {
  Values values = common_values(spec, "#");
  const YosysOptions yosys = yosys_options(spec.device.synthesis);
  values["SOURCES"] = source_list(spec, "      - ", "\n");
  values["BENCH"] = spec.bench();
  values["DEVICE"] = spec.device.name;
  values["ARCHITECTURE"] = yosys.architecture;
  values["SYNTH_TARGET"] =
      yosys.architecture.empty() ? "" : fmt::format(", synth (Yosys, for {})", spec.device.name);
  values["SYNTHESIS_OPTIONS"] = yosys.options;
  values["VIVADO_PART"] = spec.device.vivado_part;
  std::vector<GeneratedFile> files = {
      file_from(spec.signature.top + ".core", "fusesoc.core", values)};
  if (!spec.device.vivado_part.empty()) {
    files.push_back(file_from("fusesoc/clock.xdc", "vivado_clock.xdc", values));
  }
  return files;
}

}  // namespace mixcmp::project
