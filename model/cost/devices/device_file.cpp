#include "model/cost/devices/device_file.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "model/base/common/check.hpp"
#include "model/base/common/nearest.hpp"
#include "model/base/common/quote.hpp"
#include "model/base/settings/section.hpp"
#include "model/base/settings/settings.hpp"
#include "model/cost/devices/family.hpp"

namespace mixcmp::devices {
namespace {

const std::vector<std::string> section_names = {"device", "synthesis", "areas",
                                                "timing", "delays",    "sources"};

Result<Done> check_section_names(const settings::Settings& settings) {
  for (const settings::Setting& entry : settings.root.entries) {
    const auto& names = section_names;
    if (std::find(names.begin(), names.end(), entry.key) != names.end()) continue;
    const bool is_section = std::holds_alternative<settings::Setting::Table>(entry.value);
    return settings::mistake_at(entry, entry.key,
                                is_section ? "unknown section" : "a key outside of any section",
                                entry.key, list_with_nearest(entry.key, names));
  }
  return Done{};
}

/// Whether a device may have this name: tables and folders are named after devices.
bool is_file_name(const std::string& name) {
  constexpr auto accepted = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-+_.";
  return !name.empty() && name.front() != '.' &&
         name.find_first_not_of(accepted) == std::string::npos;
}

/// Reads the name of a part, which goes into scripts in Tcl.
void read_part(settings::Section& section, const std::string& key, std::string& part) {
  section.text(key, part);
  constexpr auto accepted = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_";
  if (part.find_first_not_of(accepted) == std::string::npos) return;
  section.fail(key, "not the name of a part", in_quotes(part), "letters, digits, - and _");
}

Result<Done> read_figures(const settings::Settings& settings, Device& device) {
  constexpr int most = 100'000'000;  // counts of a plan are products of areas and stay below 2^63
  settings::Section section(settings, "device");
  for (const char* key : {"name", "luts", "registers", "dsps", "memories"}) section.require(key);
  section.text("name", device.name);
  if (!is_file_name(device.name)) {
    section.fail("name", "not a name for files", in_quotes(device.name),
                 "letters, digits, - + _ and dots, not at its start");
  }
  section.text("family", device.family);
  section.find("part");  // with_family has followed it
  section.text("vendor_name", device.vendor_name);
  read_part(section, "vivado_part", device.vivado_part);
  read_part(section, "quartus_part", device.quartus_part);
  section.integer("technology_nm", device.technology_nm, 1, 1000);
  section.integer("luts", device.available.luts, 1, most);
  section.integer("registers", device.available.registers, 1, most);
  section.integer("dsps", device.available.dsps, 0, most);
  section.integer("memories", device.available.memories, 0, most);
  for (const char* key : {"multiplier_a_bits", "multiplier_b_bits"}) {
    if (device.available.dsps > 0) section.require(key);
  }
  section.number("target_mhz", device.delays.target_mhz, settings::limits::target_mhz.least,
                 settings::limits::target_mhz.most);
  section.integer("lut_inputs", device.delays.lut_inputs, 4, 8);
  device.delays.sum_selects = device.delays.lut_inputs < 6 ? 0 : 2;
  section.integer("sum_selects", device.delays.sum_selects, 0, 2);
  section.integer("multiplier_a_bits", device.delays.multiplier_size.a_bits, 2, 64);
  section.integer("multiplier_b_bits", device.delays.multiplier_size.b_bits, 2, 64);
  int sums = device.delays.multiplier_sums ? 1 : 0;
  section.integer("multiplier_sums", sums, 0, 1);
  device.delays.multiplier_sums = sums == 1;
  section.integer("memory_bits", device.delays.memory_block.bits, 1, most);
  section.integer("memory_read_ports", device.delays.memory_block.read_ports, 1, 2);
  if (const auto error = section.finish()) return *error;
  return Done{};
}

/// Checks that the text is one synthesis command. Yosys reads it as part of a script, in which the
/// refused characters end a command, begin a comment or start a shell.
void check_command(settings::Section& section, const std::string& key, const std::string& command) {
  if (section.find(key) == nullptr) return;
  const bool one_command = command.find_first_of(";\n\r!#") == std::string::npos;
  if (command.starts_with("synth") && one_command) return;
  section.fail(key, "not one synthesis command of Yosys", in_quotes(command),
               "synth_xilinx, synth_ecp5, synth_ice40 or another synth command with its options");
}

Result<Done> read_synthesis(const settings::Settings& settings, Device& device) {
  settings::Section section(settings, "synthesis");
  section.text("missing", device.no_synthesis);
  if (device.no_synthesis.empty()) section.require("command");
  section.text("command", device.synthesis);
  check_command(section, "command", device.synthesis);
  if (!device.no_synthesis.empty() && !device.synthesis.empty()) {
    section.fail("missing", "beside a command", in_quotes(device.no_synthesis),
                 "command, or the reason why it is missing");
  }
  section.text("cells", device.cells);
  if (!device.cells.empty() && device.cells != "ecp5" && device.cells != "ice40") {
    section.fail("cells", "not a family with cells of its own", in_quotes(device.cells),
                 "\"ecp5\", \"ice40\"");
  }
  if (const auto error = section.finish()) return *error;
  return Done{};
}

/// The areas of the cells that the command maps to, and those that the file adds or changes.
Result<CellAreas> read_areas(const settings::Settings& settings, const std::string& synthesis) {
  CellAreas areas = CellAreas::of(synthesis);
  const settings::Setting* section = settings.root.find("areas");
  if (section == nullptr) return areas;
  if (!std::holds_alternative<settings::Setting::Table>(section->value)) {
    return settings::mistake_at(*section, "areas", "not a section", section->shown(), "[areas]");
  }
  MIXCMP_DO(areas.add(*section));
  return areas;
}

void read_arguments(settings::Section& section, std::vector<std::string>& arguments) {
  const settings::Setting* setting = section.find("arguments");
  if (setting == nullptr) return;
  constexpr auto accepted = "an array of strings, one for each argument of nextpnr";
  const auto* array = std::get_if<settings::Setting::Array>(&setting->value);
  if (array == nullptr) {
    return section.fail("arguments", "wrong type", setting->shown(), accepted);
  }
  for (const settings::Setting& element : *array) {
    const auto* text = std::get_if<std::string>(&element.value);
    if (text == nullptr) {
      return section.fail("arguments", "wrong type", element.shown(), accepted);
    }
    arguments.push_back(*text);
  }
}

/// Checks that timing.synthesis suits the tool. yosys_sta needs it, for Xilinx: Yosys' library has
/// cell delays for no other vendor. A router takes the mapped netlist and does not need it.
void check_timing_synthesis(settings::Section& section, const Device& device) {
  const bool given = !device.timing_synthesis.empty();
  if (device.timing == TimingTool::yosys_sta) {
    if (device.timing_synthesis.starts_with("synth_xilinx")) return;
    return section.fail("synthesis", "of tool = \"yosys_sta\"",
                        given ? in_quotes(device.timing_synthesis) : "nothing",
                        "a synth_xilinx command, with -abc9");
  }
  if (!given) return;
  section.fail("synthesis", "only of tool = \"yosys_sta\"", in_quotes(device.timing_synthesis),
               "no synthesis here");
}

Result<Done> read_timing(const settings::Settings& settings, Device& device) {
  settings::Section section(settings, "timing");
  section.require("tool");
  section.choice("tool", device.timing,
                 {TimingTool::none, TimingTool::yosys_sta, TimingTool::nextpnr_ice40,
                  TimingTool::nextpnr_ecp5, TimingTool::nextpnr_nexus, TimingTool::nextpnr_gowin,
                  TimingTool::nextpnr_gatemate, TimingTool::nextpnr_machxo2});
  section.text("synthesis", device.timing_synthesis);
  check_command(section, "synthesis", device.timing_synthesis);
  check_timing_synthesis(section, device);
  read_arguments(section, device.timing_arguments);
  if (const auto error = section.finish()) return *error;
  return Done{};
}

Result<Done> read_delays(const settings::Settings& settings, DelayTable& delays) {
  struct Entry {
    const char* key;
    double DelayTable::*delay;
  };
  constexpr std::array<Entry, 6> entries = {{
      {"lut_ns", &DelayTable::lut_ns},
      {"carry_start_ns", &DelayTable::carry_start_ns},
      {"carry_ns_per_bit", &DelayTable::carry_ns_per_bit},
      {"multiplier_ns", &DelayTable::multiplier_ns},
      {"multiplier_add_ns", &DelayTable::multiplier_add_ns},
      {"register_ns", &DelayTable::register_ns},
  }};
  settings::Section section(settings, "delays");
  for (const Entry& entry : entries) {
    section.require(entry.key);
    section.number(entry.key, delays.*entry.delay, 0.001, 1000);
  }
  section.number("multiplier_input_ns", delays.multiplier_input_ns, 0, 1000);
  section.number("multiplier_output_ns", delays.multiplier_output_ns, 0, 1000);
  section.number("memory_ns", delays.memory_ns, 0, 1000);
  if (const auto error = section.finish()) return *error;
  return Done{};
}

Result<Done> read_sources(const settings::Settings& settings, std::vector<std::string>& sources) {
  settings::Section section(settings, "sources");
  for (const settings::Setting& entry : section.entries()) {
    std::string text;
    section.text(entry.key, text);
    sources.push_back(fmt::format("{}: {}", entry.key, text));
  }
  if (const auto error = section.finish()) return *error;
  return Done{};
}

}  // namespace

Result<Device> read_device(std::string text, const std::filesystem::path& path) {
  MIXCMP_TRY(file, settings::parse_settings(std::move(text), path));
  MIXCMP_DO(check_section_names(file));
  MIXCMP_TRY(settings, with_family(std::move(file)));
  Device device;
  MIXCMP_DO(read_figures(settings, device));
  MIXCMP_DO(read_synthesis(settings, device));
  MIXCMP_TRY(areas, read_areas(settings, device.synthesis));
  device.cell_areas = std::move(areas);
  MIXCMP_DO(read_timing(settings, device));
  MIXCMP_DO(read_delays(settings, device.delays));
  MIXCMP_DO(read_sources(settings, device.sources));
  return device;
}

std::string_view to_string(TimingTool tool) {
  switch (tool) {
    case TimingTool::none: return "none";
    case TimingTool::yosys_sta: return "yosys_sta";
    case TimingTool::nextpnr_ice40: return "nextpnr_ice40";
    case TimingTool::nextpnr_ecp5: return "nextpnr_ecp5";
    case TimingTool::nextpnr_nexus: return "nextpnr_nexus";
    case TimingTool::nextpnr_gowin: return "nextpnr_gowin";
    case TimingTool::nextpnr_gatemate: return "nextpnr_gatemate";
    case TimingTool::nextpnr_machxo2: return "nextpnr_machxo2";
  }
  MIXCMP_CHECK(!"a timing tool of no enumerator");
}

}  // namespace mixcmp::devices
