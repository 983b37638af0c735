#include "generator/faces/cli/characterise_import.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "generator/faces/cli/characterise_table.hpp"
#include "generator/faces/cli/exit.hpp"
#include "generator/faces/cli/output.hpp"
#include "generator/hardware/emit/system.hpp"
#include "generator/present/report/json_text.hpp"
#include "generator/synthesis/characterise/vendor_report.hpp"
#include "generator/synthesis/components/imported_rows.hpp"
#include "generator/tasks/generate.hpp"
#include "model/base/common/file.hpp"
#include "model/base/common/quote.hpp"
#include "model/cost/measured/component_cells.hpp"

namespace mixcmp::cli {
namespace {

namespace fs = std::filesystem;
using characterise::Vendor;
using characterise::VendorReport;
using components::ImportedReports;
using components::ImportedRow;

Error error_at(const VendorReport& report, int line, std::string message, std::string received,
               std::string accepted) {
  return {.file = report.file.string(),
          .line = line,
          .message = std::move(message),
          .received = std::move(received),
          .accepted = std::move(accepted)};
}

const std::string& part_of(const devices::Device& device, Vendor vendor) {
  switch (vendor) {
    case Vendor::vivado: return device.vivado_part;
    case Vendor::quartus: return device.quartus_part;
  }
  MIXCMP_CHECK(!"a vendor of no enumerator");
}

/// Refuses a report of another device than the scene's, or of another design than the scene's
/// system.
Result<Done> check_origin(const VendorReport& report, const devices::Device& device,
                          const emit::Signature& signature) {
  const std::string& part = part_of(device, report.vendor);
  if (part.empty()) {
    return error_at(
        report, report.device_line,
        fmt::format("the scene's device {} is none of {}'s", device.name, to_string(report.vendor)),
        report.device, "a scene whose device file names the part");
  }
  if (!is_part(report, part)) {
    return error_at(report, report.device_line, "a report of another device", report.device,
                    fmt::format("{}, the scene's {}", part, device.name));
  }
  const std::string& top = signature.engine ? signature.engine->top : signature.top;
  if (report.design == top) return Done{};
  return error_at(report, report.design_line, "a report of another design", report.design, top);
}

/// Checks that the compiled RTL is that of the scene today, by the signature that the vendor's
/// script left beside the report.
Result<Done> check_rtl(const VendorReport& report, const emit::Signature& today) {
  const fs::path path = report.file.parent_path() / (today.top + ".json");
  if (!path_exists(path)) {
    return Error{.file = path.string(),
                 .message = "the signature of the compiled system is not beside its report",
                 .received = "no such file",
                 .accepted = "the folder as the script of generate --project leaves it"};
  }
  MIXCMP_TRY(compiled, emit::read_signature(path));
  if (compiled.spec_hash == today.spec_hash) return Done{};
  return Error{.file = path.string(),
               .field = "spec_hash",
               .message = "the reports are of other RTL than what the scene generates today",
               .received = compiled.spec_hash,
               .accepted = today.spec_hash + ": generate and compile the system again"};
}

/// The one report that has areas, or the one that has a clock; null where there is none.
Result<const VendorReport*> only_report(const std::vector<VendorReport>& reports, bool with_clock) {
  const VendorReport* found = nullptr;
  for (const VendorReport& report : reports) {
    if (report.mhz.has_value() != with_clock) continue;
    if (found != nullptr) {
      return error_at(report, 0, "a second report of the same kind",
                      "one already in " + found->file.string(), "one of areas and one of timing");
    }
    found = &report;
  }
  return found;
}

/// Refuses reports of two tools, or of two versions of one.
Result<Done> check_same_tool(const VendorReport& areas, const VendorReport& timing) {
  if (areas.tool == timing.tool) return Done{};
  return error_at(timing, 1, "the two reports are of different tools", timing.tool,
                  fmt::format("{}, as {}", areas.tool, areas.file.string()));
}

/// Refuses the timing of a routed design beside the areas of one that is not.
Result<Done> check_same_stage(const VendorReport& areas, const VendorReport& timing) {
  if (areas.stage == timing.stage) return Done{};
  return error_at(areas, 1, "the timing is of a routed design, and these areas are not",
                  std::string(to_string(areas.stage)),
                  fmt::format("{}, as {}", to_string(timing.stage), timing.file.string()));
}

Result<ImportedReports> read_reports(const std::vector<fs::path>& paths,
                                     const devices::Device& device,
                                     const emit::Signature& signature) {
  std::vector<VendorReport> reports;
  for (const fs::path& path : paths) {
    MIXCMP_TRY(report, characterise::read_vendor_report(path));
    MIXCMP_DO(check_origin(report, device, signature));
    MIXCMP_DO(check_rtl(report, signature));
    reports.push_back(std::move(report));
  }
  MIXCMP_TRY(areas, only_report(reports, false));
  MIXCMP_TRY(timing, only_report(reports, true));
  if (areas == nullptr) {
    return error_at(*timing, 0, "a clock without areas makes no row", "only a timing report",
                    "also the report of areas by instance");
  }
  ImportedReports imported{*areas, std::nullopt, part_of(device, areas->vendor)};
  if (timing == nullptr) return imported;
  MIXCMP_DO(check_same_tool(*areas, *timing));
  MIXCMP_DO(check_same_stage(*areas, *timing));
  imported.timing = *timing;
  return imported;
}

std::string_view in_words(measured::AreaStage stage) {
  switch (stage) {
    case measured::AreaStage::predicted:
    case measured::AreaStage::mapped: break;  // no vendor's
    case measured::AreaStage::synthesised: return "after synthesis, before placement";
    case measured::AreaStage::placed: return "placed, not routed";
    case measured::AreaStage::routed: return "placed and routed";
  }
  MIXCMP_CHECK(!"a stage of no vendor's tool");
}

void print_text(const std::vector<ImportedRow>& imported, const ImportedReports& reports,
                const measured::Characterisation& table, const fs::path& path) {
  const std::string clock =
      reports.timing ? fmt::format(", {:.1f} MHz", *reports.timing->mhz) : ", no clock";
  print(fmt::format("{} on {}: {} on {}, {}{}\n", table.scene, table.device, reports.areas.tool,
                    reports.part, in_words(reports.areas.stage), clock));
  for (const ImportedRow& each : imported) {
    const devices::Area& area = each.row.area;
    print(fmt::format("  {}: {} LUTs, {} registers, {} DSPs, {} memories, of {} instance{}\n",
                      components::label(each.row.key), area.luts, area.registers, area.dsps,
                      area.memories, each.instances, each.instances == 1 ? "" : "s"));
  }
  print(fmt::format("{} rows imported; {} rows in {}\n", imported.size(), table.rows.size(),
                    path.string()));
}

void print_json(const std::vector<ImportedRow>& imported, const measured::Characterisation& table,
                const fs::path& path) {
  nlohmann::ordered_json json = {{"scene", table.scene},
                                 {"device", table.device},
                                 {"table", path.string()},
                                 {"imported", nlohmann::ordered_json::array()}};
  for (const ImportedRow& each : imported) {
    json["imported"].push_back(json_of_row(each.row));
    json["imported"].back()["instances"] = each.instances;
  }
  print(report::json_text(json));
}

}  // namespace

nlohmann::ordered_json json_of_row(const measured::Measurement& row) {
  const measured::KeyCells key = cells_of(row.key);
  const measured::Reference* reference = reference_of(row.key);
  const bool is_fused = reference != nullptr && reference->sums == Sums::fused;
  const int interval = reference == nullptr ? 0 : reference->initiation_interval;
  const int target_mhz = reference == nullptr ? 0 : reference->target_mhz.value_or(0);
  nlohmann::ordered_json json = {{"kind", key.kind},
                                 {"name", reference == nullptr ? key.name : ""},
                                 {"format", key.format},
                                 {"inputs", key.inputs},
                                 {"bound", key.bound},
                                 {"multipliers", key.multipliers},
                                 {"sums", to_string(is_fused ? Sums::fused : Sums::composed)},
                                 {"initiation_interval", interval},
                                 {"target_mhz", target_mhz},
                                 {"ports", count_of(row.key).value_or(0)},
                                 {"latency_cycles", row.latency_cycles},
                                 {"luts", row.area.luts},
                                 {"registers", row.area.registers},
                                 {"dsps", row.area.dsps},
                                 {"memories", row.area.memories},
                                 {"carries", row.area.carries},
                                 {"shift_luts", row.area.shift_luts},
                                 {"clock", nullptr},
                                 {"area_stage", to_string(row.stage)},
                                 {"hash", row.hash},
                                 {"tools", row.tools}};
  if (row.clock) {
    json["clock"] = {{"mhz", row.clock->mhz},
                     {"low_mhz", row.clock->low_mhz},
                     {"high_mhz", row.clock->high_mhz},
                     {"seeds", row.clock->seeds},
                     {"source", to_string(row.clock->source)}};
  }
  return json;
}

void import_reports(const CharacteriseCommand& command) {
  const LoadedScene loaded = value_or_exit(load(command.scene));
  const devices::Device device = value_or_exit(devices::find_device(loaded.scene.system.device));
  const auto [design, system] = value_or_exit(
      with_shortcuts(tasks::build_system(command.scene.request(), loaded), command.scene));
  const ImportedReports reports =
      value_or_exit(read_reports(command.reports, device, system.signature));
  const std::vector<ImportedRow> imported = value_or_exit(components::imported_rows(
      loaded.scene, loaded.data ? &*loaded.data : nullptr, design, reports));
  const fs::path path = table_of(command, loaded.scene, device);
  std::vector<fs::path> inputs = inputs_of(command.scene, loaded.scene);
  inputs.insert(inputs.end(), command.reports.begin(), command.reports.end());
  check_place(path, std::move(inputs));
  std::vector<measured::Measurement> rows;
  for (const ImportedRow& each : imported) rows.push_back(each.row);
  const measured::Characterisation table = add_to_table(command, loaded, device, std::move(rows));
  command.scene.json ? print_json(imported, table, path)
                     : print_text(imported, reports, table, path);
}

}  // namespace mixcmp::cli
