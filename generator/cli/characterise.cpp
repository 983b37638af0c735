#include "generator/components/characterise.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "generator/cli/characterise_options.hpp"
#include "generator/cli/exit.hpp"
#include "generator/cli/output.hpp"
#include "generator/cli/planning.hpp"
#include "generator/cli/verbs.hpp"
#include "generator/components/shortlist.hpp"
#include "generator/report/json_text.hpp"
#include "model/common/file.hpp"
#include "model/common/output_file.hpp"
#include "model/number/lane_format.hpp"

namespace mixcmp::cli {
namespace {

namespace fs = std::filesystem;
using components::CharacteriseReport;

std::string duration(double seconds) {
  const int whole = static_cast<int>(seconds);
  return whole < 3600 ? fmt::format("{}:{:02}", whole / 60, whole % 60)
                      : fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

void tell_progress(int finished, int jobs, double seconds) {
  const std::string left =
      finished == 0 ? "" : ", about " + duration(seconds / finished * (jobs - finished)) + " left";
  show_progress(fmt::format("{} of {} jobs, {}{}", finished, jobs, duration(seconds), left));
}

/// The settings on which the components' RTL and its measurement depend, by name.
std::vector<std::pair<std::string, std::string>> spec_of(const scene::Scene& scene,
                                                         const std::string& tools) {
  const scene::ReducedSpec& reduced = scene.reduced;
  const scene::SystemSpec& system = scene.system;
  return {
      {"f", scene.f_text()},
      {"g", scene.g_text()},
      {"reference",
       fmt::format("{}, {}", scene.reference.format.name(), to_string(scene.reference.subnormals))},
      {"lanes", fmt::format("{}, {}", to_string(reduced.rounding), to_string(reduced.subnormals))},
      {"target_mhz", fmt::format("{}", system.target_mhz)},
      {"order", std::string(to_string(system.order))},
      {"operands", std::string(to_string(system.operands))},
      {"tag_bits", std::to_string(system.tag_bits)},
      {"counter_bits", std::to_string(system.counter_bits)},
      {"tools", tools}};
}

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
    const std::string what = scene::to_string(lane.key.bound) + " " + to_string(lane.key.inputs);
    auto kind = std::find_if(found.begin(), found.end(),
                             [&](const MissingKind& known) { return known.what == what; });
    if (kind == found.end()) kind = found.insert(kind, {.what = what, .first = lane.key.format});
    kind->last = lane.key.format;
    ++kind->count;
    kind->reason = lane.reason.to_string();
  }
  return found;
}

/// Whether the table stays as it is, or is not made.
bool nothing_measured(const CharacteriseReport& report) {
  return report.components == 0 || report.table.rows.empty();
}

void print_text(const CharacteriseReport& report, const fs::path& table) {
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
  if (report.dropped > 0) print(fmt::format("; {} outdated rows dropped", report.dropped));
  print("\n");
}

nlohmann::ordered_json json_of(const characterise::Measurement& row) {
  nlohmann::ordered_json json = {{"kind", to_string(row.key.kind)},
                                 {"name", row.key.name},
                                 {"format", row.key.format},
                                 {"inputs", to_string(row.key.inputs)},
                                 {"bound", scene::to_string(row.key.bound)},
                                 {"multipliers", row.key.multipliers},
                                 {"ports", row.key.ports},
                                 {"latency_cycles", row.latency_cycles},
                                 {"luts", row.area.luts},
                                 {"registers", row.area.registers},
                                 {"dsps", row.area.dsps},
                                 {"memories", row.area.memories},
                                 {"carries", row.area.carries},
                                 {"shift_luts", row.area.shift_luts},
                                 {"clock", nullptr},
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

void print_json(const CharacteriseReport& report, const fs::path& table) {
  nlohmann::ordered_json json = {{"scene", report.table.scene},
                                 {"device", report.table.device},
                                 {"table", table.string()},
                                 {"components", report.components},
                                 {"synthesised", report.synthesised},
                                 {"kept", report.kept},
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
  for (const characterise::Measurement& row : report.table.rows)
    json["rows"].push_back(json_of(row));
  print(report::json_text(json));
}

/// Refuses a table that was measured for another target_mhz: it decides where registers go in all
/// RTL.
Result<Done> check_target(const characterise::Characterisation& table, const fs::path& path,
                          const scene::Scene& scene) {
  const std::string wanted = fmt::format("{}", scene.system.target_mhz);
  for (const auto& [name, text] : table.spec) {
    if (name != "target_mhz" || text == wanted) continue;
    return Error{
        .file = path.string(),
        .field = "target_mhz",
        .message = "none of its rows would stay",
        .received = text,
        .accepted = fmt::format("--target-mhz {}, or another path by -o for {}", text, wanted)};
  }
  return Done{};
}

/// The table that the file holds; none where there is no file yet. A table of another scene or
/// device is an error, so that it is not written over.
Result<std::optional<characterise::Characterisation>> previous_table(const fs::path& path,
                                                                     const scene::Scene& scene,
                                                                     const std::string& device) {
  std::error_code failed;
  const bool is_table = fs::is_regular_file(path, failed) && fs::file_size(path, failed) > 0;
  if (!is_table) return std::optional<characterise::Characterisation>();
  MIXCMP_TRY(table, characterise::read_characterisation(path));
  if (table.scene == scene.name && table.device == device) {
    MIXCMP_TRY(comparable, check_target(table, path, scene));
    return std::optional(std::move(table));
  }
  return Error{.file = path.string(),
               .message = "is a table of something else",
               .received = fmt::format("{} on {}", table.scene, table.device),
               .accepted = fmt::format("{} on {}, or another path by -o", scene.name, device)};
}

bool is_same_measurement(const characterise::Measurement* one,
                         const characterise::Measurement* other) {
  if (one == nullptr || other == nullptr) return one == other;
  return one->hash == other->hash && one->tools == other->tools &&
         one->timing_seeds == other->timing_seeds;
}

/// Keeps rows that another run has put into the table while this one measured, unless this run has
/// measured the same components anew.
void adopt_new_rows(characterise::Characterisation& table,
                    const characterise::Characterisation& now,
                    const characterise::Characterisation& before) {
  std::vector<characterise::Measurement> others;
  for (const characterise::Measurement& row : now.rows) {
    const characterise::Measurement* old = before.find(row.key);
    const characterise::Measurement* own = table.find(row.key);
    const bool is_new = !is_same_measurement(old, &row);
    const bool measured_here = own != nullptr && !is_same_measurement(old, own);
    if (is_new && !measured_here) others.push_back(row);
  }
  for (characterise::Measurement& row : others) {
    std::erase_if(table.rows,
                  [&](const characterise::Measurement& own) { return own.key == row.key; });
    table.rows.push_back(std::move(row));
  }
  std::sort(table.rows.begin(), table.rows.end(),
            [](const characterise::Measurement& a, const characterise::Measurement& b) {
              return a.key < b.key;
            });
}

void write_table(CharacteriseReport& report, const CharacteriseCommand& command,
                 const scene::Scene& scene, const fs::path& path,
                 const std::optional<characterise::Characterisation>& before) {
  const FolderLock held = lock_folder(fs::absolute(path).parent_path());
  const auto now = value_or_exit(previous_table(path, scene, report.table.device));
  if (now) adopt_new_rows(report.table, *now, before.value_or(characterise::Characterisation()));
  report.table.command = characterise_command_line(command);
  std::set<std::string> tools;
  for (const characterise::Measurement& row : report.table.rows) tools.insert(row.tools);
  std::string used;
  for (const std::string& each : tools) used += (used.empty() ? "" : "; ") + each;
  report.table.spec = spec_of(scene, used);
  value_or_exit(write_file(path, to_csv(report.table)));
}

void tell_failures(const CharacteriseReport& report) {
  for (const characterise::FailedJob& job : report.failed) {
    const std::string kept = job.directory.empty() ? "" : "\n  kept in " + job.directory.string();
    tell(fmt::format("{}: {}{}", job.label, job.message, kept));
  }
  if (report.interrupted_by != 0) {
    tell(
        "interrupted; what is finished is in the store, the same command "
        "goes on from there");
  }
}

/// "fixed_norm of 10, 11, 12; running_4 rounded of 9, 10": the precisions of each kind of lane.
std::string kinds_of(const std::set<characterise::ComponentKey>& lanes) {
  std::map<std::string, std::set<int>> formats;
  for (const characterise::ComponentKey& lane : lanes) {
    const std::string kind = scene::to_string(lane.bound) + (lane.inputs ? " " : "");
    formats[kind + to_string(lane.inputs)].insert(
        LaneFormat::parse(lane.format).value().precision());
  }
  std::vector<std::string> kinds;
  for (const auto& [kind, precisions] : formats) {
    kinds.push_back(fmt::format("{} of {}", kind, fmt::join(precisions, ", ")));
  }
  return fmt::format("{}", fmt::join(kinds, "; "));
}

/// Leaves those lanes in the query that look promising, and says which, and how long they take.
void choose_quickly(const CharacteriseCommand& command, const LoadedScene& loaded,
                    const devices::Device& device, components::CharacteriseOptions& options) {
  components::ComponentQuery& query = options.query;
  const auto [first, last] = std::minmax_element(query.precisions.begin(), query.precisions.end());
  const auto rates = optimise::Rates::of(
      value_or_exit(measure_rates(loaded, {query.inputs.begin(), query.inputs.end()},
                                  {.first_precision = *first, .last_precision = *last})));
  components::ComponentMaker maker(loaded.scene, loaded.data ? &*loaded.data : nullptr);
  const auto found = value_or_exit(components::shortlist(maker, query, device, rates));
  query.lanes = found.lanes;
  if (found.lanes.empty()) {
    fail({.field = "--quick",
          .message = "none of the lanes exists and has a recomputation rate",
          .received = fmt::format("--bounds {}", command.bounds),
          .accepted = "bounds and precisions of lanes that the scene can have"});
  }
  tell(fmt::format(
      "quick: {} of {} lanes look promising, {}; {}about {} on {} processor{}", found.lanes.size(),
      found.candidates, kinds_of(found.lanes),
      options.synthesis.effort == characterise::TimingEffort::area_only ? "" : "without clocks ",
      duration(found.seconds / options.workers), options.workers, options.workers == 1 ? "" : "s"));
}

void run(const CharacteriseCommand& command) {
  const LoadedScene loaded = value_or_exit(load(command.scene));
  const devices::Device device = value_or_exit(devices::find_device(loaded.scene.system.device));
  components::CharacteriseOptions options =
      value_or_exit(characterise_options(command, loaded.scene));
  options.progress = tell_progress;
  if (command.quick) choose_quickly(command, loaded, device, options);
  const fs::path path =
      command.output.empty()
          ? optimise::default_table(command.scene.scene, loaded.scene.variant, device.name)
          : command.output;
  std::vector<fs::path> inputs = inputs_of(command.scene, loaded.scene);
  inputs.push_back(options.store);
  for (const char* of_sqlite : {"-journal", "-wal", "-shm"}) {
    inputs.push_back(options.store.string() + of_sqlite);
  }
  value_or_exit(check_outputs({path}, inputs));
  value_or_exit(make_writable_folder(fs::absolute(path).parent_path()));
  const auto previous = value_or_exit(previous_table(path, loaded.scene, device.name));
  CharacteriseReport report =
      value_or_exit(components::characterise(loaded.scene, loaded.data ? &*loaded.data : nullptr,
                                             device, options, previous ? &*previous : nullptr));
  show_progress("");
  if (report.interrupted_by == 0 && !nothing_measured(report)) {
    write_table(report, command, loaded.scene, path, previous);
  }
  command.scene.json ? print_json(report, path) : print_text(report, path);
  tell_failures(report);
  if (report.interrupted_by != 0) throw Exit::interrupted(report.interrupted_by);
  if (!report.failed.empty()) throw Exit(ExitCode::mistake);
  if (report.components == 0) {
    tell("nothing was measured: no component that was asked for exists");
    throw Exit(ExitCode::mistake);
  }
  if (options.synthesis.effort == characterise::TimingEffort::timing)
    end_if_router_is_missing(device);
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
