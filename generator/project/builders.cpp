#include "generator/project/builders.hpp"

#include <fmt/core.h>

#include "generator/emit/version.hpp"

namespace mixcmp::project {

Values common_values(const ProjectSpec& spec, const std::string& comment) {
  std::string head;
  for (const std::string& line : emit::provenance(spec.signature, spec.command)) {
    head += (head.empty() ? "" : "\n") + comment + " " + line;
  }
  return {{"TOP", spec.signature.top},
          {"BUILD_TOP", spec.build_top()},
          {"VERSION", std::string(emit::version)},
          {"PROVENANCE", head},
          {"TARGET_MHZ", fmt::format("{:g}", spec.signature.target_mhz)},
          {"PERIOD_NS", fmt::format("{:.3f}", 1000 / spec.signature.target_mhz)}};
}

std::string joined(const std::vector<std::string>& lines, const std::string& before,
                   const std::string& after) {
  std::string text;
  for (const std::string& line : lines) {
    text += before;
    text += line;
    text += after;
  }
  return text;
}

std::string source_list(const ProjectSpec& spec, const std::string& before,
                        const std::string& after) {
  return joined(spec.signature.files, before, after);
}

GeneratedFile script_from(const std::string& name, const std::string& file, const Values& values) {
  return {.name = name, .text = fill_template(file, values), .is_script = true};
}

GeneratedFile file_from(const std::string& name, const std::string& file, const Values& values) {
  return {.name = name, .text = fill_template(file, values)};
}

}  // namespace mixcmp::project
