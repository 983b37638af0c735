#include <fmt/core.h>

#include <algorithm>
#include <cctype>

#include "generator/synthesis/characterise/vendor_parsers.hpp"
#include "model/base/common/quote.hpp"

namespace mixcmp::characterise {
namespace {

using measured::AreaStage;

/// A summary that begins at a line with this title, with lines such as "; Device ; 5CSEBA6U23I7 ;".
class SummarySection {
public:
  static Result<SummarySection> find(const ReportText& report, const std::string& title) {
    const int line = report.find("; " + title);
    if (line == 0) return report.missing(fmt::format("the section \"{}\"", title));
    return SummarySection(report, title, line);
  }

  Result<ReportField> field(bool (*wanted)(const std::string& name),
                            const std::string& description) const {
    for (int line = first_ + 2; line <= report_->size(); ++line) {
      const std::vector<std::string> field = cells_of(report_->line(line), ';');
      if (field.size() != 2) break;
      if (wanted(trimmed(field[0]))) return ReportField{trimmed(field[1]), line};
    }
    return report_->missing(fmt::format("\"{}\" in the section \"{}\"", description, title_));
  }

private:
  SummarySection(const ReportText& report, std::string title, int first)
      : report_(&report), title_(std::move(title)), first_(first) {}

  const ReportText* report_;
  std::string title_;
  int first_;
};

/// Whether this is the name of a version, such as "Quartus Prime Version" or "Quartus II 64-Bit
/// Version".
bool is_version(const std::string& name) {
  return name.starts_with("Quartus") && name.ends_with("Version");
}

/// The tool of a version text such as "18.1.0 Build 625 09/12/2018 SJ Lite Edition", which follows
/// "Version " in timing reports.
std::string tool_of(const std::string& text) {
  const std::string prefix = "Version ";
  return "Quartus " + version_of(text.starts_with(prefix) ? text.substr(prefix.size()) : text);
}

/// The path of an instance. Quartus Standard writes
/// "|top|lane_channel:g_lanes[0].channel|lane:lane" for the path that Quartus Pro writes as
/// "g_lanes[0].channel|lane", and "|" for the top.
std::string path_of(const std::string& full_name, const std::string& top) {
  std::string path;
  std::size_t start = 0;
  bool is_first = true;
  while (start <= full_name.size()) {
    const std::size_t end = std::min(full_name.find('|', start), full_name.size());
    std::string name = full_name.substr(start, end - start);
    start = end + 1;
    if (name.empty()) continue;
    const bool is_top = is_first && name == top;
    is_first = false;
    if (is_top) continue;
    name = name.substr(name.find(':') == std::string::npos ? 0 : name.find(':') + 1);
    path += (path.empty() ? "" : "/") + name;
  }
  return path;
}

/// Whether a column of this name counts memories: "M9Ks", "M10Ks", "M20Ks".
bool counts_memories(const std::string& name) {
  return name.size() > 3 && name.starts_with("M") && name.ends_with("Ks") &&
         std::isdigit(static_cast<unsigned char>(name[1])) != 0;
}

/// The columns of "Fitter Resource Utilization by Entity" for an area.
struct EntityColumns {
  std::size_t path = 0, luts = 0, registers = 0, dsps = 0;
  std::vector<std::size_t> memories;
  std::optional<std::size_t> lut_memories;
};

/// The first of these columns that the table has.
Result<std::size_t> one_of(const ReportText& report, const ReportTable& table, int header,
                           std::initializer_list<const char*> names) {
  std::string accepted;
  for (const char* name : names) {
    if (const auto found = table.column(name)) return *found;
    accepted += (accepted.empty() ? "" : " or ") + std::string(name);
  }
  return report.error(header, "a column is missing", "a table without it", accepted);
}

Result<EntityColumns> entity_columns(const ReportText& report, const ReportTable& table,
                                     int header) {
  MIXCMP_TRY(path, one_of(report, table, header, {"Full Hierarchy Name"}));
  MIXCMP_TRY(luts, one_of(report, table, header, {"ALMs needed [=A-B+C]", "Logic Cells"}));
  MIXCMP_TRY(registers, one_of(report, table, header, {"Dedicated Logic Registers"}));
  MIXCMP_TRY(dsps, one_of(report, table, header, {"DSP Blocks", "DSP Elements"}));
  return EntityColumns{path,
                       luts,
                       registers,
                       dsps,
                       table.columns_that(counts_memories),
                       table.column("ALMs used for memory")};
}

Result<devices::Area> area_of_entity(const ReportTable& table, const EntityColumns& columns,
                                     int line) {
  MIXCMP_TRY(luts, table.count(line, columns.luts));
  MIXCMP_TRY(registers, table.count(line, columns.registers));
  MIXCMP_TRY(dsps, table.count(line, columns.dsps));
  devices::Area area{.luts = luts, .registers = registers, .dsps = dsps};
  for (const std::size_t column : columns.memories) {
    MIXCMP_TRY(blocks, table.count(line, column));
    area.memories += blocks;
  }
  if (columns.lut_memories) {
    MIXCMP_TRY(alms, table.count(line, *columns.lut_memories));
    area.shift_luts = alms;
  }
  return area;
}

Result<std::vector<InstanceArea>> instances_by_entity(const ReportText& report,
                                                      const std::string& top) {
  const std::string title = "Fitter Resource Utilization by Entity";
  const int section = report.find("; " + title);
  const int header = section == 0 ? 0 : report.find("; Compilation Hierarchy Node", section);
  if (header == 0) return report.missing(fmt::format("the section \"{}\"", title));
  const ReportTable table(report, header, ';');
  MIXCMP_TRY(columns, entity_columns(report, table, header));
  std::vector<InstanceArea> instances;
  for (const int line : table.records()) {
    MIXCMP_TRY(name, table.cell(line, columns.path));
    MIXCMP_TRY(area, area_of_entity(table, columns, line));
    instances.push_back({path_of(trimmed(name), top), area, line});
  }
  if (!instances.empty()) return instances;
  return report.error(header, "the table has no instances", "none", "one line for each instance");
}

/// The lowest restricted clock of aclk over the corners that the report has.
Result<double> lowest_mhz(const ReportText& report) {
  std::optional<double> lowest;
  int header = report.find("; Restricted Fmax");
  for (; header != 0; header = report.find("; Restricted Fmax", header + 1)) {
    const ReportTable table(report, header, ';');
    const auto clock = table.column("Clock Name");
    const auto restricted = table.column("Restricted Fmax");
    if (!clock || !restricted) continue;
    for (const int line : table.records()) {
      MIXCMP_TRY(name, table.cell(line, *clock));
      if (trimmed(name) != "aclk") continue;
      MIXCMP_TRY(text, table.cell(line, *restricted));
      const auto mhz = leading_number(trimmed(text));
      if (!mhz || *mhz <= 0 || !trimmed(text).ends_with(" MHz")) {
        return report.error(line, "no clock", in_quotes(trimmed(text)), "such as 251.26 MHz");
      }
      lowest = std::min(lowest.value_or(*mhz), *mhz);
    }
  }
  if (lowest) return *lowest;
  return report.missing("a section \"Fmax Summary\" with the clock aclk");
}

bool is_named(const std::string& name, const char* wanted) {
  return name == wanted;
}

Result<VendorReport> with_tool(const ReportText& report, const SummarySection& summary) {
  MIXCMP_TRY(version, summary.field(is_version, "Quartus ... Version"));
  return VendorReport{.file = report.path(),
                      .vendor = Vendor::quartus,
                      .tool = tool_of(version.text),
                      .design = {},
                      .device = {},
                      .stage = AreaStage::routed,
                      .instances = {},
                      .mhz = {}};
}

void set_names(VendorReport& found, const ReportField& design, const ReportField& device) {
  found.design = design.text;
  found.design_line = design.line;
  found.device = device.text;
  found.device_line = device.line;
}

/// Refuses the timing of a netlist that is not final: Quartus Pro names the snapshot.
Result<Done> check_final(const ReportText& report, const SummarySection& summary) {
  const auto snapshot =
      summary.field([](const std::string& name) { return is_named(name, "Snapshot"); }, "Snapshot");
  if (!snapshot.ok() || snapshot->text == "final") return Done{};
  return report.error(snapshot->line, "a timing before routing is no clock",
                      in_quotes(snapshot->text), "final");
}

}  // namespace

Result<VendorReport> parse_quartus_fit(const ReportText& report) {
  MIXCMP_TRY(summary, SummarySection::find(report, "Fitter Summary"));
  MIXCMP_TRY(found, with_tool(report, summary));
  MIXCMP_TRY(status,
             summary.field([](const std::string& name) { return is_named(name, "Fitter Status"); },
                           "Fitter Status"));
  if (!status.text.starts_with("Successful")) {
    return report.error(status.line, "the fitter did not succeed", in_quotes(status.text),
                        "Successful");
  }
  MIXCMP_TRY(
      design,
      summary.field([](const std::string& name) { return is_named(name, "Top-level Entity Name"); },
                    "Top-level Entity Name"));
  MIXCMP_TRY(device, summary.field([](const std::string& name) { return is_named(name, "Device"); },
                                   "Device"));
  set_names(found, design, device);
  MIXCMP_TRY(instances, instances_by_entity(report, found.design));
  found.instances = std::move(instances);
  return found;
}

Result<VendorReport> parse_quartus_timing(const ReportText& report) {
  const std::string title = report.find("; TimeQuest Timing Analyzer Summary") == 0
                                ? "Timing Analyzer Summary"
                                : "TimeQuest Timing Analyzer Summary";
  MIXCMP_TRY(summary, SummarySection::find(report, title));
  MIXCMP_TRY(found, with_tool(report, summary));
  MIXCMP_DO(check_final(report, summary));
  MIXCMP_TRY(design,
             summary.field([](const std::string& name) { return is_named(name, "Revision Name"); },
                           "Revision Name"));
  MIXCMP_TRY(device,
             summary.field([](const std::string& name) { return is_named(name, "Device Name"); },
                           "Device Name"));
  set_names(found, design, device);
  MIXCMP_TRY(mhz, lowest_mhz(report));
  found.mhz = mhz;
  return found;
}

}  // namespace mixcmp::characterise
