#include "generator/project/builders.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

#include "generator/hardware/emit/constraints.hpp"
#include "generator/hardware/emit/version.hpp"

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
          {"PERIOD_NS", fmt::format("{:.3f}", 1000 / spec.signature.target_mhz)},
          {"PORT_DELAYS",
           fmt::format("{}", fmt::join(emit::port_delays(spec.signature, spec.device), "\n"))}};
}

std::string in_capitals(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char letter) { return std::toupper(letter); });
  return name;
}

void add_counter_values(const emit::Signature& signature,
                        const std::vector<emit::SignaturePort>& ports, Values& values) {
  const auto width_of = [&](const std::string& name) {
    const auto port = std::find_if(ports.begin(), ports.end(),
                                   [&](const auto& each) { return each.name == name; });
    return port == ports.end() ? 0 : port->width;
  };
  const int address_bits = width_of("s_axi_araddr");
  const bool counts = signature.counter_bits > 0;
  values["COUNTS"] = counts ? "yes" : "";
  values["COUNTED_UNIT"] = signature.lanes_per_group > 1 ? "group" : "lane";
  values["COUNTER_OUTPUTS"] = counts && address_bits == 0 ? "yes" : "";
  values["COUNTER_PORT"] = address_bits > 0 ? "yes" : "";
  values["COUNTER_ADDRESS_BITS"] = std::to_string(address_bits);
  // The counters of a system inside an engine whose port widens them are narrow.
  const bool is_narrow = address_bits == 0 && !signature.counter_map.empty();
  values["COUNTER_BITS"] = std::to_string(
      is_narrow ? width_of("comparisons") / emit::group_count(signature) : signature.counter_bits);
  values["COUNTED_ANSWERS"] = is_narrow && width_of("answers") > 0 ? "yes" : "";
  int number = 0;
  std::string wires;
  for (const emit::SignatureCounters& counters : signature.counter_map) {
    wires += fmt::format(
        "  wire [{0}*COUNTER_BITS-1:0] {1} =\n"
        "      counts[{2}*COUNTER_BITS +: {0}*COUNTER_BITS];\n",
        counters.count, counters.name, number);
    number += counters.count;
  }
  values["COUNTERS"] = std::to_string(number);
  values["COUNTER_WIRES"] = wires;
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
