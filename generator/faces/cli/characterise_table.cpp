#include "generator/faces/cli/characterise_table.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "generator/faces/cli/exit.hpp"
#include "generator/faces/cli/output.hpp"
#include "generator/faces/cli/planning.hpp"
#include "generator/synthesis/components/shortlist.hpp"
#include "model/base/common/output_file.hpp"
#include "model/base/number/lane_format.hpp"

namespace mixcmp::cli {
namespace {

namespace fs = std::filesystem;
using components::CharacteriseReport;

std::string duration(double seconds) {
  const int whole = static_cast<int>(seconds);
  return whole < 3600 ? fmt::format("{}:{:02}", whole / 60, whole % 60)
                      : fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

/// The settings on which the components' RTL and its measurement depend, by name.
std::vector<std::pair<std::string, std::string>> spec_of(const scene::Scene& scene,
                                                         const std::string& tools) {
  const scene::ReducedSpec& reduced = scene.reduced;
  const scene::SystemSpec& system = scene.system;
  std::vector<std::pair<std::string, std::string>> spec = {
      {"f", scene.f_text()},
      {"g", scene.g_text()},
      {"reference",
       fmt::format("{}, {}{}", scene.reference.format.name(), to_string(scene.reference.subnormals),
                   scene.reference.sums == Sums::fused ? ", sums fused" : "")},
      {"lanes", fmt::format("{}, {}", to_string(reduced.rounding), to_string(reduced.subnormals))},
      {"target_mhz", fmt::format("{}", system.target_mhz)},
      {"order", std::string(to_string(system.order))},
      {"operands", std::string(to_string(system.operands))},
      {"tag_bits", std::to_string(system.tag_bits)},
      {"counter_bits", std::to_string(system.counter_bits)},
      {"tools", tools}};
  if (system.engine.kind != scene::EngineKind::none) {
    spec.insert(spec.end() - 1, {"engine", measured::engine_text(scene)});
  }
  if (system.lanes_per_group > 1) {
    spec.insert(spec.end() - 1, {"lanes_per_group", std::to_string(system.lanes_per_group)});
  }
  return spec;
}

/// Refuses a table that was measured for another target_mhz, which decides where registers go in
/// all RTL, for another engine, or for other groups of lanes.
Result<Done> check_rows_can_stay(const measured::Characterisation& table, const fs::path& path,
                                 const scene::Scene& scene) {
  const std::string target = fmt::format("{}", scene.system.target_mhz);
  const std::string engine = measured::engine_text(scene);
  for (const auto& [name, text] : table.spec) {
    if (name == "target_mhz" && text != target) {
      return Error{
          .file = path.string(),
          .field = name,
          .message = "none of its rows would stay",
          .received = text,
          .accepted = fmt::format("--target-mhz {}, or another path by -o for {}", text, target)};
    }
    if (name == "engine" && !engine.empty() && text != engine) {
      return Error{.file = path.string(),
                   .field = name,
                   .message = "its rows are of another engine",
                   .received = text,
                   .accepted = fmt::format("{}, or another path by -o", engine)};
    }
  }
  return measured::check_groups(table, path, scene);
}

/// The table that the file holds; none where there is no file yet. A table of another scene or
/// device is an error, so that it is not written over.
Result<std::optional<measured::Characterisation>> previous_table(const fs::path& path,
                                                                 const scene::Scene& scene,
                                                                 const std::string& device) {
  std::error_code failed;
  const bool is_table = fs::is_regular_file(path, failed) && fs::file_size(path, failed) > 0;
  if (!is_table) return std::optional<measured::Characterisation>();
  MIXCMP_TRY(table, measured::read_characterisation(path));
  if (table.scene == scene.name && table.device == device) {
    MIXCMP_DO(check_rows_can_stay(table, path, scene));
    return std::optional(std::move(table));
  }
  return Error{.file = path.string(),
               .message = "is a table of something else",
               .received = fmt::format("{} on {}", table.scene, table.device),
               .accepted = fmt::format("{} on {}, or another path by -o", scene.name, device)};
}

bool is_same_measurement(const measured::Measurement* one, const measured::Measurement* other) {
  if (one == nullptr || other == nullptr) return one == other;
  return one->hash == other->hash && one->tools == other->tools &&
         one->timing_seeds == other->timing_seeds;
}

/// Keeps rows that another run has put into the table while this one measured, unless this run has
/// measured the same components anew.
void adopt_new_rows(measured::Characterisation& table, const measured::Characterisation& now,
                    const measured::Characterisation& before) {
  std::vector<measured::Measurement> others;
  for (const measured::Measurement& row : now.rows) {
    const measured::Measurement* old = before.find(row.key);
    const measured::Measurement* own = table.find(row.key);
    const bool is_new = !is_same_measurement(old, &row);
    const bool measured_here = own != nullptr && !is_same_measurement(old, own);
    if (is_new && !measured_here) others.push_back(row);
  }
  for (measured::Measurement& row : others) {
    std::erase_if(table.rows, [&](const measured::Measurement& own) { return own.key == row.key; });
    table.rows.push_back(std::move(row));
  }
  std::sort(
      table.rows.begin(), table.rows.end(),
      [](const measured::Measurement& a, const measured::Measurement& b) { return a.key < b.key; });
}

/// The command that made the rows which were there before, and the one that imports more.
std::string command_with_import(const std::string& before, const std::string& import) {
  if (before.empty() || before == import || before.ends_with(" && " + import)) {
    return before.empty() ? import : before;
  }
  return before + " && " + import;
}

void write_table(CharacteriseReport& report, const CharacteriseCommand& command,
                 const scene::Scene& scene, const fs::path& path,
                 const std::optional<measured::Characterisation>& before) {
  const FolderLock held = lock_folder(fs::absolute(path).parent_path());
  const auto now = value_or_exit(previous_table(path, scene, report.table.device));
  if (now) adopt_new_rows(report.table, *now, before.value_or(measured::Characterisation()));
  const std::string line = characterise_command_line(command).text();
  report.table.command =
      command.reports.empty() || !now ? line : command_with_import(now->command, line);
  std::set<std::string> tools;
  for (const measured::Measurement& row : report.table.rows) tools.insert(row.tools);
  std::string used;
  for (const std::string& each : tools) used += (used.empty() ? "" : "; ") + each;
  report.table.spec = spec_of(scene, used);
  value_or_exit(write_file(path, to_csv(report.table)));
}

/// "fixed_norm of 10, 11, 12; running_4 rounded of 9, 10": the precisions of each kind of lane.
std::string kinds_of(const std::set<measured::Lane>& lanes) {
  std::map<std::string, std::set<int>> formats;
  for (const measured::Lane& lane : lanes) {
    const std::string kind = to_string(lane.bound) + (lane.inputs ? " " : "");
    formats[kind + to_string(lane.inputs)].insert(lane.format.precision());
  }
  std::vector<std::string> kinds;
  for (const auto& [kind, precisions] : formats) {
    kinds.push_back(fmt::format("{} of {}", kind, fmt::join(precisions, ", ")));
  }
  return fmt::format("{}", fmt::join(kinds, "; "));
}

/// Leaves out the bounds of lanes that no plan of the scene may use: profiled ones where it wants
/// certified lanes, certified ones where it wants profiled lanes.
void leave_out_unusable(const scene::Scene& scene, components::ComponentQuery& query) {
  std::erase_if(query.bounds, [&](const Bound& bound) {
    return bound.is_profiled() != scene.reduced.is_profiled;
  });
}

/// Keeps the promising lanes in the query. Tells the user which they are, and how long they take.
void choose_quickly(const CharacteriseCommand& command, const LoadedScene& loaded,
                    const devices::Device& device, const optimise::Rates& rates,
                    components::CharacteriseOptions& options) {
  components::ComponentQuery& query = options.query;
  if (command.bounds == CharacteriseCommand().bounds) leave_out_unusable(loaded.scene, query);
  components::ComponentMaker maker(loaded.scene, loaded.data ? &*loaded.data : nullptr);
  const auto found = value_or_exit(components::shortlist(maker, query, device, rates));
  query.lanes = found.lanes;
  if (found.lanes.empty()) {
    fail({.field = "--quick",
          .message = "none of the lanes exists and has a recomputation rate",
          .received = fmt::format("--bounds {}", command.bounds),
          .accepted = "bounds and precisions of lanes that the scene can have"});
  }
  tell_note(fmt::format(
      "quick: {} of {} lanes look promising, {}; {}about {} on {} processor{}", found.lanes.size(),
      found.candidates, kinds_of(found.lanes),
      options.synthesis.effort == characterise::TimingEffort::area_only ? "" : "without clocks ",
      duration(found.seconds / options.workers), options.workers, options.workers == 1 ? "" : "s"));
}

/// The files of the store, and those that the scene is read from.
std::vector<fs::path> inputs_of_campaign(const CharacteriseCommand& command,
                                         const scene::Scene& scene,
                                         const components::CharacteriseOptions& options) {
  std::vector<fs::path> inputs = inputs_of(command.scene, scene);
  inputs.push_back(options.store);
  for (const char* of_sqlite : {"-journal", "-wal", "-shm"}) {
    inputs.push_back(options.store.string() + of_sqlite);
  }
  return inputs;
}

}  // namespace

void tell_progress(int finished, int jobs, double seconds) {
  const std::string left =
      finished == 0 ? "" : ", about " + duration(seconds / finished * (jobs - finished)) + " left";
  show_progress(fmt::format("{} of {} jobs, {}{}", finished, jobs, duration(seconds), left));
}

bool nothing_measured(const CharacteriseReport& report) {
  return report.components == 0 || report.table.rows.empty();
}

void end_if_unfinished(const CharacteriseReport& report) {
  for (const characterise::FailedJob& job : report.failed) {
    const std::string kept = job.directory.empty() ? "" : "\n  kept in " + job.directory.string();
    tell(fmt::format("{}: {}{}", job.label, job.message, kept));
  }
  if (report.interrupted_by != 0) {
    tell(
        "interrupted; what is finished is in the store, the same command "
        "goes on from there");
  }
  if (report.interrupted_by != 0) throw Exit::interrupted(report.interrupted_by);
  if (!report.failed.empty()) throw Exit(ExitCode::mistake);
}

fs::path table_of(const CharacteriseCommand& command, const scene::Scene& scene,
                  const devices::Device& device) {
  return command.output.empty() ? optimise::default_table(command.scene.scene, scene, device.name)
                                : command.output;
}

components::CharacteriseOptions prepared_options(const CharacteriseCommand& command,
                                                 const LoadedScene& loaded,
                                                 const devices::Device& device,
                                                 const optimise::Rates* counted) {
  components::CharacteriseOptions options =
      value_or_exit(characterise_options(command, loaded.scene));
  options.progress = tell_progress;
  if (command.quick) {
    const optimise::Rates rates = counted ? *counted : rates_of_choice(command, loaded);
    choose_quickly(command, loaded, device, rates, options);
  }
  return options;
}

optimise::Rates rates_of_choice(const CharacteriseCommand& command, const LoadedScene& loaded) {
  const components::ComponentQuery query =
      value_or_exit(characterise_options(command, loaded.scene)).query;
  const auto [first, last] = std::minmax_element(query.precisions.begin(), query.precisions.end());
  return optimise::Rates::of(
      value_or_exit(measure_rates(loaded, {query.inputs.begin(), query.inputs.end()},
                                  {.first_precision = *first, .last_precision = *last})));
}

CharacteriseReport measure_table(const CharacteriseCommand& command, const LoadedScene& loaded,
                                 const optimise::Rates* counted) {
  const devices::Device device = value_or_exit(devices::find_device(loaded.scene.system.device));
  const components::CharacteriseOptions options =
      prepared_options(command, loaded, device, counted);
  const data::Comparisons* data = loaded.data ? &*loaded.data : nullptr;
  const scene::Scene scene = value_or_exit(with_chain_lanes(loaded.scene, data, command.scene));
  const fs::path path = table_of(command, scene, device);
  check_place(path, inputs_of_campaign(command, scene, options));
  const auto previous = value_or_exit(previous_table(path, scene, device.name));
  CharacteriseReport report = value_or_exit(
      components::characterise(scene, data, device, options, previous ? &*previous : nullptr));
  show_progress("");
  if (report.interrupted_by == 0 && !nothing_measured(report)) {
    write_table(report, command, scene, path, previous);
  }
  return report;
}

void check_place(const fs::path& table, std::vector<fs::path> inputs) {
  value_or_exit(check_outputs({table}, inputs));
  value_or_exit(make_writable_folder(fs::absolute(table).parent_path()));
}

measured::Characterisation add_to_table(const CharacteriseCommand& command,
                                        const LoadedScene& loaded, const devices::Device& device,
                                        std::vector<measured::Measurement> rows) {
  const fs::path path = table_of(command, loaded.scene, device);
  const auto previous = value_or_exit(previous_table(path, loaded.scene, device.name));
  CharacteriseReport report;
  if (previous) report.table = *previous;
  report.table.device = device.name;
  report.table.scene = loaded.scene.name;
  for (measured::Measurement& row : rows) {
    std::erase_if(report.table.rows,
                  [&](const measured::Measurement& old) { return old.key == row.key; });
    report.table.rows.push_back(std::move(row));
  }
  std::sort(
      report.table.rows.begin(), report.table.rows.end(),
      [](const measured::Measurement& a, const measured::Measurement& b) { return a.key < b.key; });
  write_table(report, command, loaded.scene, path, previous);
  return std::move(report.table);
}

}  // namespace mixcmp::cli
