#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <set>

#include "generator/faces/cli/data_sets.hpp"
#include "generator/faces/cli/exit.hpp"
#include "generator/faces/cli/output.hpp"
#include "generator/faces/cli/planning.hpp"
#include "generator/faces/cli/report_maker.hpp"
#include "generator/faces/cli/verbs.hpp"
#include "generator/present/report/exploration_report.hpp"
#include "generator/present/report/json_text.hpp"
#include "generator/present/report/paper_tables.hpp"
#include "generator/present/report/plan_report.hpp"
#include "generator/software/baseline.hpp"
#include "model/base/common/file.hpp"
#include "model/base/common/output_file.hpp"
#include "model/base/common/scratch_folder.hpp"
#include "model/plan/optimise/exploration.hpp"
#include "model/plan/optimise/plan.hpp"
#include "model/scene/plan.hpp"

namespace mixcmp::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* own_data = "own";  ///< the name of the scene's data set, without --over

struct ExploreCommand {
  PlanningOptions planning;
  std::vector<std::string> devices;
  std::string over;  ///< "data.radius_max=5,10,25"
  fs::path output = "exploration";
  bool beside_paper = false;
  bool software = false;
  fs::path page;  ///< of HTML
};

/// The settings of --over, one per data set; without --over, one empty setting.
Result<std::vector<std::string>> sets_of(const ExploreCommand& command) {
  if (command.over.empty()) return std::vector<std::string>{""};
  return data_sets("--over", command.over);
}

/// The scene's options with one data set.
SceneOptions with_set(const ExploreCommand& command, const std::string& set) {
  return with_data_set(command.planning.scene, "--over", set);
}

/// The rates of one data set. They are kept in the output folder, so that an interrupted run can be
/// continued.
optimise::Rates rates_of(const ExploreCommand& command, const std::string& set,
                         const std::set<LaneInputs>& inputs) {
  const SceneOptions options = with_set(command, set);
  const LoadedScene loaded = value_or_exit(load(options));
  const std::string name = set.empty() ? own_data : set.substr(set.find('=') + 1);
  auto rates = tasks::keep_rates(options.request(), loaded, inputs, command.planning.choice,
                                 {command.output, name}, show_share);
  show_progress("");
  return value_or_exit(std::move(rates));
}

/// The throughput of software in double, and that of the kernel which is fastest on all cores.
std::vector<report::SoftwareThroughput> measure_software(const LoadedScene& loaded) {
  ScratchFolder scratch = value_or_exit(ScratchFolder::make());
  software::BaselineOptions options{.work = scratch.path()};
  options.progress = show_progress;
  const auto measured = software_baseline(loaded.scene, *loaded.data, options);
  if (!measured.ok()) scratch.keep_for(measured.error());
  const software::Baseline& baseline = value_or_exit(measured);
  show_progress("");
  if (!baseline.passed()) {
    tell("software and golden model disagree: see mixcmp baseline");
    throw Exit(ExitCode::refuted);
  }
  std::vector<report::SoftwareThroughput> all;
  for (const software::BaselineKernel* kernel : {&baseline.exact(), &baseline.fastest()}) {
    all.push_back({fmt::format("{}, {} cores, {}", baseline.processor, baseline.threads,
                               software::kernel_name(*kernel)),
                   kernel->one_core.best_per_s, kernel->all_cores.best_per_s});
  }
  if (&baseline.exact() == &baseline.fastest()) all.pop_back();
  return all;
}

using Columns = std::vector<std::pair<std::string, optimise::ClockChoice>>;

/// The columns of the tables: the clocks with which T(equ) is computed. The last one has those of
/// the command.
Columns columns_for(const std::optional<optimise::PublishedFigures>& published,
                    const optimise::ClockChoice& ours) {
  Columns columns;
  if (published) {
    const double lane = published->lane_mhz(), reference = published->reference_mhz;
    columns.push_back(
        {fmt::format("ours, the paper's clocks ({:.0f}, {:.0f} MHz)", lane, reference),
         {lane, reference, optimise::ClockDomains::separate}});
    columns.push_back({fmt::format("ours, one clock of {:.0f} MHz", reference),
                       {reference, reference, optimise::ClockDomains::single}});
  }
  columns.push_back({"ours", ours});
  return columns;
}

std::string command_of(const ExploreCommand& command) {
  return planning_command_line("explore", command.planning)
      .add_each("--on", command.devices)
      .add("--over", command.over)
      .add_flag("--beside-paper", command.beside_paper)
      .add_flag("--software", command.software)
      .text();
}

/// Adds the best plan to the results. `set`: its data set; empty: all of them.
void add_plan(ResultFiles& results, const ExploreCommand& command, const std::string& device,
              const std::string& set, const fs::path& path, const optimise::Optimisation& found) {
  const optimise::PrecisionPlan* best = found.best();
  const std::string name = path.filename().string();
  if (best == nullptr) return results.leave_out(name);
  PlanningOptions planning = command.planning;
  if (!set.empty()) planning.scene.settings.push_back(set);
  const optimise::PlanSource source = plan_source(planning, device, path, command_of(command));
  results.add(name, plan_toml(found, *best, source));
}

constexpr std::array exploration_files = {
    "figure3.svg", "figure7.csv", "figure7.svg",          "figure8.svg",          "figure9.csv",
    "figure9.svg", "tables.md",   "plan_scenario_1.toml", "plan_scenario_2.toml", "scenarios.csv"};

/// All files that the run writes, except for the kept rates: no scene and no table has a name like
/// theirs.
std::vector<fs::path> output_paths(const ExploreCommand& command,
                                   const std::vector<Planning>& known) {
  std::vector<fs::path> paths = {command.output / "report.md", command.page};
  for (const Planning& each : known) {
    const auto own = ResultFiles::paths(command.output / each.device.name, exploration_files);
    paths.insert(paths.end(), own.begin(), own.end());
  }
  return paths;
}

ResultFiles results_for(const ExploreCommand& command, const std::string& device,
                        const optimise::Exploration& exploration, const std::string& tables) {
  const fs::path folder = command.output / exploration.device.name;
  const optimise::ResultsAtClocks& ours = exploration.columns.back();
  // The first column has given clocks, if any has: then lanes without a measured clock also count.
  const optimise::Optimisation& areas = exploration.columns.front().example;
  const std::string& first = exploration.data_sets.front();
  ResultFiles results(folder, exploration_files);
  results.add("figure7.csv", report::figure7_csv(areas));
  results.add("figure9.csv", report::figure9_csv(ours.example));
  results.add("scenarios.csv", report::scenarios_csv(exploration));
  results.add("tables.md", tables);
  add_plan(results, command, device, first == own_data ? "" : first,
           folder / "plan_scenario_1.toml", ours.example);
  add_plan(results, command, device, "", folder / "plan_scenario_2.toml", ours.worst);
  results.add_picture("figure3.svg", script(report::figure3(ours.example)));
  results.add_picture("figure7.svg", script(report::figure7(areas)));
  results.add_picture("figure8.svg", script(report::figure8(ours.example)));
  results.add_picture("figure9.svg", script(report::figure9(ours.example)));
  return results;
}

std::set<std::string> notes_of_plans(const optimise::Exploration& exploration) {
  std::set<std::string> notes;
  for (const optimise::ResultsAtClocks& column : exploration.columns) {
    notes.insert(column.worst.notes.begin(), column.worst.notes.end());
    if (column.worst.best() == nullptr) notes.insert(column.title + ": no plan fits");
  }
  return notes;
}

/// Keeps the notes of the table, which were printed before, and of the plans, which are printed
/// here.
void take_notes(optimise::Exploration& exploration, const Planning& known) {
  exploration.notes = known.notes;
  for (const std::string& note : notes_of_plans(exploration)) {
    tell_note(fmt::format("{}: {}", exploration.device.name, note));
    exploration.notes.push_back(note);
  }
}

/// The devices of --on, each once; without it, the scene's.
std::vector<std::string> devices_of(const ExploreCommand& command, const scene::Scene& scene) {
  if (command.devices.empty()) return {scene.system.device};
  std::vector<std::string> devices;
  for (const std::string& device : command.devices) {
    const bool known = std::find(devices.begin(), devices.end(), device) != devices.end();
    if (known) continue;
    if (const auto found = devices::find_device(device); !found.ok()) {
      Error error = found.error();
      if (error.field == "system.device") error.field = "--on";
      fail(error);
    }
    devices.push_back(device);
  }
  return devices;
}

/// Loads a device and its table, from which its plans are made.
Planning planning_for(const ExploreCommand& command, const std::string& device,
                      const data::Comparisons* data) {
  PlanningOptions planning = command.planning;
  planning.scene.settings.push_back("system.device=" + device);
  const scene::Scene scene =
      value_or_exit(scene::load_scene(planning.scene.scene, planning.scene.settings));
  return value_or_exit(load_planning(planning, scene, data));
}

/// Tables III and IV of one device.
std::string tables_of(const optimise::Exploration& exploration,
                      const std::optional<optimise::PublishedFigures>& published,
                      const std::vector<report::SoftwareThroughput>& software) {
  return "## " + exploration.device.name + "\n\n" +
         to_markdown(report::table3(exploration, published)) + "\n" +
         to_markdown(report::table4(exploration, published, software));
}

std::vector<optimise::DataSet> measure_sets(const ExploreCommand& command,
                                            const std::vector<std::string>& settings,
                                            const std::vector<Planning>& known) {
  std::set<LaneInputs> inputs;
  for (const Planning& each : known) inputs.merge(optimise::inputs_of_lanes(each.table));
  std::vector<optimise::DataSet> sets;
  for (const std::string& setting : settings) {
    sets.push_back({setting.empty() ? own_data : setting, rates_of(command, setting, inputs)});
  }
  return sets;
}

/// Refuses two devices of one name, since each has a folder with its name.
void check_device_names(const std::vector<Planning>& known) {
  std::set<std::string> names;
  for (const Planning& each : known) {
    if (names.insert(each.device.name).second) continue;
    fail({.field = "--on",
          .message = "two devices have one name, and their results would have one folder",
          .received = each.device.name,
          .accepted = "devices with names of their own"});
  }
}

/// Loads the scenes of all data sets, so that mistakes are found before any of them is measured.
std::vector<scene::Scene> scenes_of(const ExploreCommand& command,
                                    const std::vector<std::string>& settings) {
  std::vector<scene::Scene> scenes;
  for (const std::string& set : settings) {
    const SceneOptions options = with_set(command, set);
    const auto scene = scene::load_scene(options.scene, options.settings);
    if (!scene.ok()) fail(as_user_error(scene.error(), options));
    scenes.push_back(*scene);
  }
  return scenes;
}

/// All files that the run reads.
std::vector<fs::path> inputs_of(const ExploreCommand& command,
                                const std::vector<scene::Scene>& scenes,
                                const std::vector<Planning>& known) {
  std::vector<fs::path> inputs;
  const auto add = [&](const scene::Scene& scene) {
    const std::vector<fs::path> more = inputs_of(command.planning.scene, scene);
    inputs.insert(inputs.end(), more.begin(), more.end());
  };
  for (const scene::Scene& scene : scenes) add(scene);
  for (const Planning& each : known) {
    add(each.scene);
    inputs.push_back(each.table_path);
  }
  return inputs;
}

/// Names the folders of devices that an earlier run has left beside those of this one.
void tell_older_results(const fs::path& output, const std::vector<Planning>& known) {
  std::error_code failed;
  for (const fs::directory_entry& entry : entries_of(output, failed)) {
    const std::string name = entry.path().filename().string();
    const bool ours = std::any_of(known.begin(), known.end(),
                                  [&](const Planning& each) { return each.device.name == name; });
    if (ours || !path_exists(entry.path() / "scenarios.csv")) continue;
    tell_note(fmt::format("{} is of an earlier run", entry.path().string()));
  }
}

/// The report, the tables and the plans of all devices. They are collected here until all are made,
/// so that nothing is written of a run that fails.
struct Findings {
  std::string page;  ///< report.md
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  std::vector<ResultFiles> results;  ///< one for each device
  std::vector<optimise::Exploration> explorations;
  std::vector<std::string> not_done;
  bool feasible = true;
};

void add_device(Findings& findings, const ExploreCommand& command, const Planning& known,
                const std::vector<optimise::DataSet>& sets,
                const std::vector<report::SoftwareThroughput>& software) {
  const auto published =
      command.beside_paper ? optimise::published(known.device.name) : std::nullopt;
  if (command.beside_paper && !published) {
    findings.not_done.push_back("--beside-paper: the paper has no figures of " + known.device.name);
  }
  const optimise::OptimiseOptions& choice = command.planning.choice;
  optimise::Exploration exploration = value_or_exit(explore(
      known.scene, known.device, known.table, sets, columns_for(published, choice.clocks), choice));
  const std::string tables = tables_of(exploration, published, software);
  take_notes(exploration, known);
  findings.results.push_back(results_for(command, known.scene.system.device, exploration, tables));
  findings.page += "\n" + tables;
  findings.json.push_back(report::to_json(exploration));
  if (command.software) findings.json.back()["software"] = report::to_json(software);
  for (const optimise::ResultsAtClocks& column : exploration.columns) {
    findings.feasible = findings.feasible && column.worst.best() != nullptr;
  }
  findings.explorations.push_back(exploration);
}

/// Makes the page of --page: the sections that `report` has for the scene, and all that was
/// explored.
std::string html_page(Findings& findings, const ExploreCommand& command, const LoadedScene& loaded,
                      const std::vector<report::SoftwareThroughput>& software) {
  ReportChoice choice{
      .without = {"front"}, .beside_paper = command.beside_paper, .command = command_of(command)};
  ReportMaker maker(command.planning, loaded, std::move(choice));
  page::Page page = maker.make();
  page.sections.push_back(
      report::exploration_section(findings.explorations, software, command.beside_paper));
  findings.not_done.insert(findings.not_done.end(), maker.not_done().begin(),
                           maker.not_done().end());
  return to_html(page);
}

/// Writes the results of all devices at once, so that report.md and the folders always tell of the
/// same run.
void write_files(Findings& findings, const fs::path& page_path) {
  OutputFile page = value_or_exit(OutputFile::open(page_path));
  page.write(findings.page);
  value_or_exit(page.write_out());
  for (ResultFiles& files : findings.results) files.write_out();
  for (ResultFiles& files : findings.results) {
    const std::vector<std::string> missing = files.commit();
    findings.not_done.insert(findings.not_done.end(), missing.begin(), missing.end());
  }
  value_or_exit(page.commit());
}

/// Loads the devices and their tables, and checks all that the run reads and writes.
std::vector<Planning> plannings_for(const ExploreCommand& command, const LoadedScene& loaded,
                                    const std::vector<std::string>& settings) {
  const std::vector<scene::Scene> scenes = scenes_of(command, settings);
  std::vector<Planning> known;
  for (const std::string& device : devices_of(command, loaded.scene)) {
    known.push_back(planning_for(command, device, &*loaded.data));
  }
  check_device_names(known);
  value_or_exit(check_outputs(output_paths(command, known), inputs_of(command, scenes, known)));
  return known;
}

/// Finds mistakes before the long measurements.
void run(const ExploreCommand& command) {
  const LoadedScene loaded = value_or_exit(load(command.planning.scene));
  if (loaded.scene.variant.empty() && !loaded.scene.variants.empty()) {
    tell_note("variants left out: explore plans [comparison], or what --variant names");
  }
  value_or_exit(check_has_data(loaded, "recomputation rates are measured on data"));
  if (!command.over.empty()) check_ranges("--over", loaded.scene);
  const std::vector<std::string> settings = value_or_exit(sets_of(command));
  const std::vector<Planning> known = plannings_for(command, loaded, settings);
  value_or_exit(check_writable({command.page}));
  const FolderLock held = lock_folder(command.output);
  const std::vector<optimise::DataSet> sets = measure_sets(command, settings, known);
  std::vector<report::SoftwareThroughput> software;
  if (command.software) software = measure_software(loaded);

  Findings findings{.page = fmt::format("# {}: plans\n", loaded.scene.name)};
  for (const Planning& each : known) add_device(findings, command, each, sets, software);
  const fs::path page = command.output / "report.md";
  const std::string html =
      command.page.empty() ? "" : html_page(findings, command, loaded, software);
  write_files(findings, page);
  if (!command.page.empty()) value_or_exit(write_file(command.page, html));
  tell_older_results(command.output, known);
  if (command.planning.scene.json) {
    print(report::json_text(findings.json));
  } else {
    print(fmt::format("{}\n{}\n", findings.page, page.string()));
  }
  if (!findings.feasible) {
    tell_not_done(findings.not_done);
    throw Exit(ExitCode::refuted);
  }
  end_if_incomplete(findings.not_done);
}

}  // namespace

void add_explore(CLI::App& app) {
  const Verb verb(app, "explore",
                  "the best plans over data sets and devices: the paper's "
                  "figures 3, 7, 8, 9 and tables III, IV");
  auto command = std::make_shared<ExploreCommand>();
  add_planning_options(verb, command->planning);
  verb.option("--on", command->devices, "a device; may be repeated (default: the scene's)")
      .one_value_each();
  verb.option("--over", command->over,
              "data sets, by a key of the scene: data.radius_max=5,10,25; scenario I plans for "
              "each, II for the worst");
  verb.flag("--beside-paper", command->beside_paper,
            "beside the paper's published figures and with its clocks, on its two devices; the "
            "scene should be its benchmark");
  verb.flag("--software", command->software,
            "also measure the comparison in software on this machine: see mixcmp baseline");
  verb.option("--page", command->page,
              "also write this HTML file: the page of mixcmp report, and all that was explored");
  verb.option("-o,--output", command->output,
              "folder for figures, tables, plans and rates; rates found there are used again "
              "(default: exploration)");
  verb.when_chosen([command] { run(*command); });
}

}  // namespace mixcmp::cli
