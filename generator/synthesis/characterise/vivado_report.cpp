#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <sstream>

#include "generator/synthesis/characterise/vendor_parsers.hpp"
#include "model/base/common/quote.hpp"

namespace mixcmp::characterise {
namespace {

using measured::AreaStage;

/// The value of a field at the head of the report: "| Design       : top".
Result<ReportField> head_field(const ReportText& report, std::string_view name) {
  constexpr int head_lines = 20;
  for (int line = 1; line <= std::min(head_lines, report.size()); ++line) {
    const std::string& text = report.line(line);
    const std::size_t colon = text.find(':');
    if (!text.starts_with("| ") || colon == std::string::npos) continue;
    if (trimmed(text.substr(2, colon - 2)) == name) {
      return ReportField{trimmed(text.substr(colon + 1)), line};
    }
  }
  return report.missing(fmt::format("\"| {} : ...\" in its head", name));
}

struct NamedState {
  const char* name;
  AreaStage stage;
};
constexpr std::array design_states = {NamedState{"Synthesized", AreaStage::synthesised},
                                      NamedState{"Optimized", AreaStage::synthesised},
                                      NamedState{"Placed", AreaStage::placed},
                                      NamedState{"Fully Placed", AreaStage::placed},
                                      NamedState{"Physopt postPlace", AreaStage::placed},
                                      NamedState{"Routed", AreaStage::routed},
                                      NamedState{"Fully Routed", AreaStage::routed},
                                      NamedState{"Physopt postRoute", AreaStage::routed}};

Result<AreaStage> stage_of(const ReportText& report, const ReportField& state) {
  for (const NamedState& known : design_states) {
    if (state.text == known.name) return known.stage;
  }
  return report.error(state.line, "not a known state of a design", in_quotes(state.text),
                      "Synthesized, Optimized, Fully Placed, Routed, Physopt postRoute");
}

/// The columns of report_utilization -hierarchical for an area.
struct HierarchyColumns {
  std::size_t luts = 0, lut_memories = 0, shift_registers = 0, registers = 0;
  std::size_t blocks_36k = 0, blocks_18k = 0, dsps = 0;
  std::optional<std::size_t> ultra_memories;  ///< on devices that have URAM
};

Result<HierarchyColumns> hierarchy_columns(const ReportText& report, const ReportTable& table,
                                           int header) {
  HierarchyColumns columns;
  const std::pair<const char*, std::size_t*> wanted[] = {
      {"Total LUTs", &columns.luts},      {"LUTRAMs", &columns.lut_memories},
      {"SRLs", &columns.shift_registers}, {"FFs", &columns.registers},
      {"RAMB36", &columns.blocks_36k},    {"RAMB18", &columns.blocks_18k}};
  for (const auto& [name, place] : wanted) {
    const auto found = table.column(name);
    if (!found) {
      return report.error(header, "a column is missing", trimmed(report.line(header)), name);
    }
    *place = *found;
  }
  const auto dsps =
      table.columns_that([](const std::string& name) { return name.starts_with("DSP"); });
  if (dsps.size() != 1) {
    return report.error(header, "not one column of DSPs", fmt::format("{}", dsps.size()),
                        "DSP48 Blocks, DSP Blocks or DSP Slices");
  }
  columns.dsps = dsps.front();
  columns.ultra_memories = table.column("URAM");
  return columns;
}

Result<devices::Area> area_in_hierarchy(const ReportText& report, const ReportTable& table,
                                        const HierarchyColumns& columns, int line) {
  MIXCMP_TRY(luts, table.count(line, columns.luts));
  MIXCMP_TRY(lut_memories, table.count(line, columns.lut_memories));
  MIXCMP_TRY(shift_registers, table.count(line, columns.shift_registers));
  MIXCMP_TRY(registers, table.count(line, columns.registers));
  MIXCMP_TRY(blocks_36k, table.count(line, columns.blocks_36k));
  MIXCMP_TRY(blocks_18k, table.count(line, columns.blocks_18k));
  MIXCMP_TRY(dsps, table.count(line, columns.dsps));
  if (columns.ultra_memories) {
    MIXCMP_TRY(ultra, table.count(line, *columns.ultra_memories));
    if (ultra > 0) {
      return report.error(line, "blocks of UltraRAM, which no table counts",
                          fmt::format("{}", ultra), "0");
    }
  }
  return devices::Area{.luts = luts,
                       .registers = registers,
                       .dsps = dsps,
                       .memories = 2 * blocks_36k + blocks_18k,
                       .shift_luts = lut_memories + shift_registers};
}

/// Follows the indented names of instances, two blanks per level, and builds their paths.
class PathOfIndents {
public:
  /// The path of the instance in this cell, below the top.
  std::string enter(const std::string& cell) {
    const std::size_t blanks = cell.find_first_not_of(' ');
    const std::size_t level = (std::max<std::size_t>(blanks, 1) - 1) / 2;
    names_.resize(std::min(level, names_.size()));
    names_.push_back(trimmed(cell));
    std::string path;
    for (std::size_t k = 1; k < names_.size(); ++k) path += (k == 1 ? "" : "/") + names_[k];
    return path;
  }

private:
  std::vector<std::string> names_;
};

Result<std::vector<InstanceArea>> instances_in_hierarchy(const ReportText& report, int header) {
  const ReportTable table(report, header, '|');
  MIXCMP_TRY(columns, hierarchy_columns(report, table, header));
  std::vector<InstanceArea> instances;
  PathOfIndents paths;
  for (const int line : table.records()) {
    MIXCMP_TRY(cell, table.cell(line, 0));
    if (trimmed(cell).starts_with("(")) continue;  // a level's own logic, without its children
    MIXCMP_TRY(area, area_in_hierarchy(report, table, columns, line));
    instances.push_back({paths.enter(cell), area, line});
  }
  if (!instances.empty()) return instances;
  return report.error(header, "the table has no instances", "none", "one line for each instance");
}

int hierarchy_header(const ReportText& report) {
  for (int line = report.find("| Instance"); line != 0;
       line = report.find("| Instance", line + 1)) {
    const std::vector<std::string> cells = cells_of(report.line(line), '|');
    if (cells.size() > 2 && trimmed(cells[0]) == "Instance" && trimmed(cells[1]) == "Module") {
      return line;
    }
  }
  return 0;
}

Result<VendorReport> add_areas(const ReportText& report, VendorReport found) {
  MIXCMP_TRY(state, head_field(report, "Design State"));
  MIXCMP_TRY(stage, stage_of(report, state));
  found.stage = stage;
  const int header = hierarchy_header(report);
  if (header == 0) {
    return report.missing(
        "the table \"Utilization by Hierarchy\", which report_utilization -hierarchical prints "
        "(utilisation_by_instance.rpt)");
  }
  MIXCMP_TRY(instances, instances_in_hierarchy(report, header));
  found.instances = std::move(instances);
  return found;
}

/// Refuses a timing report with estimated wires, of a design that is not routed. Reports of older
/// versions do not name the design's state, but each path names that of its wires.
Result<Done> check_routed(const ReportText& report) {
  const Result<ReportField> state = head_field(report, "Design State");
  if (state.ok()) {
    MIXCMP_TRY(stage, stage_of(report, *state));
    if (stage != AreaStage::routed) {
      return report.error(state->line, "a timing before routing is no clock",
                          in_quotes(state->text), "Routed or Physopt postRoute");
    }
  }
  bool any_routed = false;
  for (int line = 1; line <= report.size(); ++line) {
    const std::string& text = report.line(line);
    if (text.find("net (fo=") == std::string::npos) continue;
    for (const char* guess : {", estimated)", ", unplaced)"}) {
      if (text.find(guess) == std::string::npos) continue;
      return report.error(line, "a timing before routing is no clock", in_quotes(trimmed(text)),
                          "a report after route_design");
    }
    any_routed = any_routed || text.find(", routed)") != std::string::npos;
  }
  if (any_routed || state.ok()) return Done{};
  return report.missing("a path whose wires are routed, or \"| Design State : Routed\"");
}

/// The line of values below "WNS(ns)", whose first word is the slack of the slowest path.
Result<double> worst_slack_ns(const ReportText& report) {
  const int section = report.find("| Design Timing Summary");
  const int header = section == 0 ? 0 : report.find("WNS(ns)", section);
  if (header == 0 || header + 2 > report.size()) {
    return report.missing("the section \"Design Timing Summary\" with WNS(ns)");
  }
  const std::string text = trimmed(report.line(header + 2));
  const auto slack = leading_number(text);
  if (slack) return *slack;
  return report.error(header + 2, "no slack", in_quotes(text.substr(0, text.find(' '))),
                      "a number of nanoseconds: paths between registers that aclk drives");
}

/// The period of aclk, from "aclk   {0.000 2.500}   5.000   200.000".
Result<double> period_ns(const ReportText& report) {
  const int section = report.find("| Clock Summary");
  if (section == 0) return report.missing("the section \"Clock Summary\"");
  for (int line = section; line <= report.size(); ++line) {
    const std::string& text = report.line(line);
    const std::size_t brace = text.find('}');
    if (!text.starts_with("aclk ") || brace == std::string::npos) continue;
    const auto period = leading_number(trimmed(text.substr(brace + 1)));
    if (period && *period > 0) return *period;
    return report.error(line, "no period", in_quotes(trimmed(text)), "nanoseconds, above 0");
  }
  return report.missing("the clock aclk in the section \"Clock Summary\"");
}

Result<VendorReport> add_clock(const ReportText& report, VendorReport found) {
  MIXCMP_TRY(routed, check_routed(report));
  MIXCMP_TRY(speed, head_field(report, "Speed File"));
  found.device += " " + speed.text.substr(0, speed.text.find(' '));
  found.stage = AreaStage::routed;
  MIXCMP_TRY(slack, worst_slack_ns(report));
  MIXCMP_TRY(period, period_ns(report));
  if (period - slack > 0) {
    found.mhz = 1000 / (period - slack);
    return found;
  }
  return report.error(report.find("WNS(ns)") + 2, "the slack is as long as the period",
                      fmt::format("{} of {} ns", slack, period), "less");
}

}  // namespace

Result<VendorReport> parse_vivado_report(const ReportText& report) {
  MIXCMP_TRY(tool, head_field(report, "Tool Version"));
  MIXCMP_TRY(design, head_field(report, "Design"));
  MIXCMP_TRY(device, head_field(report, "Device"));
  VendorReport found{.file = report.path(),
                     .vendor = Vendor::vivado,
                     .tool = version_of(tool.text),
                     .design = design.text,
                     .design_line = design.line,
                     .device = device.text,
                     .device_line = device.line,
                     .instances = {},
                     .mhz = {}};
  if (report.find("Timing Summary Report") != 0) return add_clock(report, std::move(found));
  return add_areas(report, std::move(found));
}

}  // namespace mixcmp::characterise
