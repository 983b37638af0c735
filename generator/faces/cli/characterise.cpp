#include "generator/synthesis/components/characterise.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "generator/faces/cli/characterise_import.hpp"
#include "generator/faces/cli/characterise_table.hpp"
#include "generator/faces/cli/exit.hpp"
#include "generator/faces/cli/output.hpp"
#include "generator/faces/cli/verbs.hpp"
#include "generator/present/report/json_text.hpp"
#include "generator/synthesis/components/predicted_table.hpp"
#include "model/base/common/file.hpp"

namespace mixcmp::cli {
namespace {

namespace fs = std::filesystem;
using components::CharacteriseReport;

/// Lanes of one bound and one kind of inputs that do not exist, with the reason of one of them.
struct MissingKind {
  std::string what;
  std::string first, last;  ///< formats
  int count = 0;
  std::string reason;
};

std::vector<MissingKind> missing_kinds(const std::vector<components::MissingLane>& missing) {
  std::vector<MissingKind> found;
  for (const components::MissingLane& lane : missing) {
    const std::string what = to_string(lane.key.bound) + " " + to_string(lane.key.inputs);
    auto kind = std::find_if(found.begin(), found.end(),
                             [&](const MissingKind& known) { return known.what == what; });
    if (kind == found.end())
      kind = found.insert(kind, {.what = what, .first = lane.key.format.name()});
    kind->last = lane.key.format.name();
    ++kind->count;
    kind->reason = lane.reason.to_string();
  }
  return found;
}

using Predicted = std::vector<std::optional<devices::Area>>;  ///< of each row

/// None with a note if the library of unit areas cannot be read: the table has been measured.
Predicted predict(const CharacteriseReport& report, const LoadedScene& loaded,
                  const devices::Device& device) {
  Result<components::AreaPredictor> made = components::AreaPredictor::make(device);
  if (!made.ok()) {
    tell_note("areas are not compared with predicted ones: " + made.error().to_string());
    return Predicted(report.table.rows.size());
  }
  components::AreaPredictor predictor = std::move(made).value();
  return components::predicted_areas(predictor, report.table, loaded.scene, loaded.data_if_any());
}

/// How far a predicted area is from the measured one.
struct Miss {
  double luts = 0;  ///< part of the measured ones
  std::string label;
};

void print_misses(const CharacteriseReport& report, const Predicted& predicted) {
  std::vector<Miss> misses;
  for (std::size_t k = 0; k < predicted.size(); ++k) {
    const measured::Measurement& row = report.table.rows[k];
    if (!predicted[k] || row.area.luts == 0) continue;
    const double luts = row.area.luts;
    misses.push_back({std::abs(predicted[k]->luts - luts) / luts, components::label(row.key)});
  }
  if (misses.empty()) return;
  std::sort(misses.begin(), misses.end(),
            [](const Miss& a, const Miss& b) { return a.luts < b.luts; });
  print(
      fmt::format("LUTs of {} rows as optimise predicts them: {:.1f} % off in the median, {:.1f} "
                  "% at most ({})\n",
                  misses.size(), 100 * misses[misses.size() / 2].luts, 100 * misses.back().luts,
                  misses.back().label));
}

void print_text(const CharacteriseReport& report, const Predicted& predicted,
                const fs::path& table) {
  print(fmt::format("{} on {}: {} components, {} jobs run, {} failed\n", report.table.scene,
                    report.table.device, report.components, report.synthesised,
                    report.failed.size()));
  for (const MissingKind& kind : missing_kinds(report.missing)) {
    print(fmt::format("no lane: {} {} .. {} ({}): {}\n", kind.what, kind.first, kind.last,
                      kind.count, kind.reason));
  }
  for (const auto& [reason, components] : report.no_clock) {
    const std::string more =
        components.size() == 1 ? "" : fmt::format(" and {} more", components.size() - 1);
    print(fmt::format("no clock: {}{}: {}\n", components.front(), more, reason));
  }
  if (report.interrupted_by != 0) return;
  if (nothing_measured(report)) {
    const char* const left = path_exists(table) ? "is as it was" : "is not written";
    return print(fmt::format("{} {}\n", table.string(), left));
  }
  print(fmt::format("{} rows in {}", report.table.rows.size(), table.string()));
  if (report.kept > 0) print(fmt::format(", {} of them kept from before", report.kept));
  if (report.imported > 0) {
    print(fmt::format(", {} imported ones not measured anew", report.imported));
  }
  if (report.dropped > 0) print(fmt::format("; {} outdated rows dropped", report.dropped));
  print("\n");
  print_misses(report, predicted);
}

nlohmann::ordered_json with_prediction(const measured::Measurement& row,
                                       const std::optional<devices::Area>& predicted) {
  nlohmann::ordered_json json = json_of_row(row);
  if (!predicted) return json;
  json["predicted"] = {{"luts", predicted->luts},
                       {"registers", predicted->registers},
                       {"dsps", predicted->dsps},
                       {"memories", predicted->memories}};
  return json;
}

void print_json(const CharacteriseReport& report, const Predicted& predicted,
                const fs::path& table) {
  nlohmann::ordered_json json = {{"scene", report.table.scene},
                                 {"device", report.table.device},
                                 {"table", table.string()},
                                 {"components", report.components},
                                 {"synthesised", report.synthesised},
                                 {"kept", report.kept},
                                 {"imported", report.imported},
                                 {"dropped", report.dropped},
                                 {"interrupted", report.interrupted_by != 0},
                                 {"failed", nlohmann::ordered_json::array()},
                                 {"missing", nlohmann::ordered_json::array()},
                                 {"no_clock", report.no_clock},
                                 {"rows", nlohmann::ordered_json::array()}};
  for (const characterise::FailedJob& job : report.failed) {
    json["failed"].push_back({{"component", job.label},
                              {"message", job.message},
                              {"directory", job.directory.string()}});
  }
  for (const MissingKind& kind : missing_kinds(report.missing)) {
    json["missing"].push_back({{"lanes", kind.what},
                               {"first", kind.first},
                               {"last", kind.last},
                               {"count", kind.count},
                               {"reason", kind.reason}});
  }
  for (std::size_t k = 0; k < report.table.rows.size(); ++k) {
    json["rows"].push_back(with_prediction(report.table.rows[k], predicted[k]));
  }
  print(report::json_text(json));
}

void run(const CharacteriseCommand& command) {
  if (!command.reports.empty()) return import_reports(command);
  const LoadedScene loaded = value_or_exit(load(command.scene));
  const devices::Device device = value_or_exit(devices::find_device(loaded.scene.system.device));
  const CharacteriseReport report = measure_table(command, loaded);
  const fs::path path = table_of(command, loaded.scene, device);
  const Predicted predicted = predict(report, loaded, device);
  command.scene.json ? print_json(report, predicted, path) : print_text(report, predicted, path);
  end_if_unfinished(report);
  if (report.components == 0) {
    tell("nothing was measured: no component that was asked for exists");
    throw Exit(ExitCode::mistake);
  }
  if (!command.area_only) end_if_router_is_missing(device);
}

}  // namespace

void add_characterise(CLI::App& app) {
  const Verb verb(app, "characterise",
                  "measure area and clock of a scene's components on a device");
  auto command = std::make_shared<CharacteriseCommand>();
  add_characterise_options(verb, *command);
  verb.when_chosen([command] { run(*command); });
}

}  // namespace mixcmp::cli
