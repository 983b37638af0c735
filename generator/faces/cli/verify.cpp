#include "generator/faces/cli/verify.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <thread>

#include "generator/faces/cli/exit.hpp"
#include "generator/faces/cli/options.hpp"
#include "generator/faces/cli/output.hpp"
#include "generator/faces/cli/result_table.hpp"
#include "generator/faces/cli/simulations.hpp"
#include "generator/faces/cli/suite.hpp"
#include "generator/faces/cli/verbs.hpp"
#include "generator/hardware/emit/system.hpp"
#include "generator/present/report/json_text.hpp"
#include "model/base/common/content_hash.hpp"
#include "verilator_tb/counterexample.hpp"
#include "verilator_tb/junit.hpp"
#include "verilator_tb/verify.hpp"
#include "verilator_tb/waves.hpp"

namespace mixcmp::cli {
namespace {

namespace fs = std::filesystem;

const std::set<std::string> csv_verdict_names = {"less", "equal", "greater", "unordered",
                                                 std::string(ResultTable::undecided)};

enum class TruthOption { off, recomputed, all };

struct VerifyCommand {
  SceneOptions scene;
  fs::path suite;
  double minutes = 0;  ///< of the suite; 0: as the suite says
  fs::path junit;
  verilator_tb::VerifyOptions run;
  int jobs = 0;  ///< 0: not asked for
  fs::path work;
  fs::path csv;
  std::set<std::string> csv_verdicts = csv_verdict_names;
  std::uint64_t first = 0;   ///< 0: not asked for
  std::uint64_t sample = 0;  ///< 0: not asked for
  std::optional<std::uint64_t> only;
  TruthOption truth = TruthOption::off;
  bool no_counterexample = false;
};

template <class Value>
using Spellings = std::map<std::string, Value>;

template <class Value>
void add_choice(const Verb& verb, const std::string& flag, Value& value,
                const Spellings<Value>& spellings, const std::string& help) {
  std::vector<std::string> names;
  for (const auto& [name, meaning] : spellings) names.push_back(name);
  verb.text_option(
          flag, [&value, spellings](const std::string& name) { value = spellings.at(name); }, help)
      .one_of(names);
}

/// An error text unless the name ends in .fst: both simulators write FST, and the save file takes
/// the same name with another ending.
std::string fst_path(const std::string& text) {
  if (fs::path(text).extension() == ".fst") return "";
  return fmt::format("received {}; accepted a file that ends in .fst", text);
}

void add_suite_options(const Verb& verb, VerifyCommand& command) {
  verb.flag("--no-counterexample", command.no_counterexample,
            "after a failure, do not look for a shorter run that fails");
  verb.option("--junit", command.junit, "write a JUnit report, which CI servers read");
  const Option suite = verb.option("--suite", command.suite,
                                   "a file of many runs in place of SCENE; those that passed are "
                                   "not repeated (docs/verification.md)");
  verb.option("--minutes", command.minutes, "budget of time of --suite")
      .check(between(0.001, 1e6, "minutes"))
      .needs(suite);
  verb.keep_alone(suite, {"--help", "--quiet", "--junit", "--minutes", "--work", "--json"});
}

void add_selection_options(const Verb& verb, VerifyCommand& command) {
  const Option first =
      verb.option("--first", command.first, "only the first N comparisons").check(whole(1));
  const Option sample =
      verb.option("--sample", command.sample, "only N comparisons, spread over all")
          .check(whole(1));
  verb.option("--seed", command.run.selection.seed, "of --sample and of --traffic stressed")
      .check(whole(0));
  const Option only =
      verb.option("--only", command.only, "only comparison number N").check(whole(0));
  first.excludes(sample).excludes(only);
  sample.excludes(only);
}

void add_options(const Verb& verb, VerifyCommand& command) {
  add_scene_options(verb, command.scene, {}, SceneArgument::optional);
  verb.option("--work", command.work,
              "directory for the Verilog, the builds and the logs (default: TOP_simulation)");
  add_selection_options(verb, command);
  add_choice<verilator_tb::SimulatorKind>(
      verb, "--simulator", command.run.simulator,
      {{"verilator", verilator_tb::SimulatorKind::verilator},
       {"icarus", verilator_tb::SimulatorKind::icarus}},
      "verilator, or icarus for small systems (default: verilator)");
  add_choice<verilator_tb::JudgeKind>(
      verb, "--judge", command.run.judge,
      {{"emulator", verilator_tb::JudgeKind::emulator},
       {"mpfr", verilator_tb::JudgeKind::golden_model}},
      "who says what verdicts must be: the emulator, which is checked by MPFR in samples and where "
      "it matters; or mpfr for every comparison, as always with an engine (default: emulator)");
  add_choice<verilator_tb::TrafficKind>(
      verb, "--traffic", command.run.traffic,
      {{"full_rate", verilator_tb::TrafficKind::full_rate},
       {"stressed", verilator_tb::TrafficKind::stressed}},
      "full_rate, or stressed: random gaps and backpressure (default: full_rate)");
  verb.option("--jobs", command.jobs,
              "simulators side by side, where Verilator runs more than a share (default: one a "
              "processor)")
      .check(whole(1, 1024));
  verb.option("--share", command.run.share_size,
              "comparisons that Verilator simulates from one reset to the end; more are several "
              "simulations; not of Icarus or an engine (default: 1048576)")
      .check(whole(1));
  verb.text_option(
          "--portion",
          [&portion = command.run.portion](const std::string& text) {
            const Fraction given = fraction_of(text).value();
            portion = {.number = given.number - 1, .count = given.count};
          },
          "one of several portions of a long run, 2/8 the second of eight: each is made of whole "
          "simulations (mixcmp sweep)")
      .check(a_fraction());
  verb.option("--resets", command.run.resets, "resets in mid-stream, 0..1000000 (default: 0)")
      .check(whole(0, 1'000'000));
  verb.option("--trace", command.run.waves,
              "write waves to this .fst file, beside it a GTKWave save file")
      .check({fst_path, ""});
  add_choice<TruthOption>(
      verb, "--truth", command.truth,
      {{"off", TruthOption::off},
       {"recomputed", TruthOption::recomputed},
       {"all", TruthOption::all}},
      "hold verdicts also against exact arithmetic: off, recomputed, all (default: off)");
  const Option csv = verb.option("--csv", command.csv, "write the verdicts as CSV");
  verb.list_option(
          "--csv-verdict",
          [&command](const std::vector<std::string>& names) {
            command.csv_verdicts = {names.begin(), names.end()};
          },
          "only these verdicts in the CSV: less, equal, greater, unordered, undecided")
      .one_of({csv_verdict_names.begin(), csv_verdict_names.end()})
      .one_value_each()
      .needs(csv);
  add_suite_options(verb, command);
}

verilator_tb::Selection::Options selection(const VerifyCommand& command) {
  verilator_tb::Selection::Options options = command.run.selection;
  options.limit = std::max(command.first, command.sample);
  options.sampling =
      command.sample > 0 ? verilator_tb::Sampling::random : verilator_tb::Sampling::first;
  options.only = command.only;
  return options;
}

std::string repeat_command(const VerifyCommand& command) {
  std::string line = runnable_command("verify", command.scene);
  if (command.run.simulator == verilator_tb::SimulatorKind::icarus) line += " --simulator icarus";
  if (command.truth != TruthOption::off) line += " --truth all";
  return line;
}

/// The command that shows a short run of the same traffic as waves.
std::string waves_command(const VerifyCommand& command,
                          const verilator_tb::Selection::Options& selection) {
  std::string line = repeat_command(command);
  if (command.run.traffic == verilator_tb::TrafficKind::stressed) {
    line += fmt::format(" --traffic stressed --seed {}", command.run.selection.seed);
  }
  if (command.run.resets > 0) line += fmt::format(" --resets {}", command.run.resets);
  const verilator_tb::VerifyOptions defaults;
  if (command.run.share_size != defaults.share_size) {
    line += fmt::format(" --share {}", command.run.share_size);
  }
  line += selection.only ? fmt::format(" --only {}", *selection.only)
                         : fmt::format(" --first {}", selection.limit);
  return line + " --trace counterexample.fst";
}

/// Looks for a short run that also fails, and puts it into the report.
void add_counterexample(verilator_tb::VerifyReport& failed, const VerifyCommand& command,
                        const design::Design& design, const data::Comparisons& data,
                        const fs::path& rtl, const verilator_tb::VerifyOptions& options) {
  const auto rerun = [&](const verilator_tb::Selection::Options& selection) {
    verilator_tb::VerifyOptions again = options;
    again.selection = selection;
    again.waves.clear();
    again.repeat_command.clear();
    return verilator_tb::verify(design, data, rtl, again);
  };
  constexpr double seconds = 60;
  const auto search = verilator_tb::least_counterexample(failed, options.selection, rerun, seconds);
  if (!search.ok()) return tell("no counterexample was looked for: " + search.error().to_string());
  const auto& found = *search;
  if (!found) return;
  verilator_tb::LeastCounterexample& least = failed.counterexample.emplace();
  least.comparisons = found->selection.only
                          ? fmt::format("only comparison {}", *found->selection.only)
                          : fmt::format("the first {} comparisons", found->selection.limit);
  if (!found->report.mismatches.empty()) {
    least.mismatch = found->report.mismatches.front();
  } else if (!found->report.violations.empty()) {
    least.violation = found->report.violations.front();
  }
  least.waves = waves_command(command, found->selection);
}

/// Counts of every failure that the tests of the lanes' verdicts do not show; empty if there is
/// none.
std::string failure_besides_verdicts(const verilator_tb::VerifyReport& report) {
  std::string text;
  const auto add = [&](std::uint64_t count, const char* what) {
    if (count > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, what);
  };
  add(report.violation_count, "protocol violations");
  if (report.comparisons < report.requested) {
    add(report.requested - report.comparisons, "comparisons without a result");
  }
  add(report.emulator_errors, "errors of the emulator");
  std::uint64_t of_lanes = 0;
  for (const verilator_tb::GroupReport& group : report.groups) {
    of_lanes += group.mismatches;
    if (group.certified) add(group.wrong_by_lane, "wrong verdicts of certified lanes");
  }
  // Engines have mismatches of whole reports and rows, which no lane is counted with.
  if (report.mismatch_count > of_lanes) add(report.mismatch_count - of_lanes, "mismatches");
  if (text.empty() && of_lanes == 0 && !report.passed()) text = "see the report";
  return text;
}

/// The tests of a JUnit report: the verdicts of each kind of lane, and all else.
std::vector<verilator_tb::JUnitCase> tests_of(const verilator_tb::VerifyReport& report) {
  std::vector<verilator_tb::JUnitCase> tests;
  for (const verilator_tb::GroupReport& group : report.groups) {
    verilator_tb::JUnitCase& test = tests.emplace_back();
    test.name = "verdicts of lanes " + group.name;
    if (group.mismatches == 0) continue;
    test.outcome = verilator_tb::JUnitCase::Outcome::failed;
    test.message = fmt::format("{} mismatches", group.mismatches);
    test.details = to_text(report);
  }
  verilator_tb::JUnitCase& rest = tests.emplace_back();
  rest.name = "streams, counters and truth";
  rest.seconds = report.run_seconds;
  rest.message = failure_besides_verdicts(report);
  if (rest.message.empty()) return tests;
  rest.outcome = verilator_tb::JUnitCase::Outcome::failed;
  rest.details = to_text(report);
  return tests;
}

verilator_tb::VerifyOptions run_options(const VerifyCommand& command, const LoadedScene& loaded,
                                        const fs::path& work) {
  verilator_tb::VerifyOptions options = command.run;
  options.work_dir = work / "build";
  options.jobs = command.jobs > 0
                     ? command.jobs
                     : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  options.selection = selection(command);
  options.traffic_seed = command.run.selection.seed;
  options.repeat_command = repeat_command(command);
  options.progress = show_progress;
  options.waiting = tell_waiting;
  if (command.truth != TruthOption::off) {
    options.truth = {&loaded.scene.graph, command.truth == TruthOption::all
                                              ? verilator_tb::TruthScope::all
                                              : verilator_tb::TruthScope::recomputed};
  }
  return options;
}

verilator_tb::VerifyReport run_with_table(const design::Design& design,
                                          const data::Comparisons& data, const fs::path& rtl,
                                          verilator_tb::VerifyOptions options,
                                          const VerifyCommand& command) {
  if (command.csv.empty()) return value_or_exit(verilator_tb::verify(design, data, rtl, options));
  ResultTable table = value_or_exit(ResultTable::open(command.csv, data, command.csv_verdicts));
  options.on_result = [&table](const verilator_tb::VerifiedResult& result) { table.add(result); };
  verilator_tb::VerifyReport report =
      value_or_exit(verilator_tb::verify(design, data, rtl, options));
  value_or_exit(table.finish());
  return report;
}

/// Refuses a work folder in which Verilator cannot build: its makefiles take no path with blanks.
Result<Done> check_work(const VerifyCommand& command, const fs::path& work) {
  const std::string path = fs::absolute(work).string();
  if (command.run.simulator == verilator_tb::SimulatorKind::icarus) {
    // iverilog hands the paths of its temporary files to a shell, in double quotes.
    if (path.find_first_of("\"$`\\\n") == std::string::npos) return Done{};
    return Error{.field = "--work",
                 .message = "Icarus cannot compile where the path has one of \" $ ` \\",
                 .received = path,
                 .accepted = "--work with a path without these"};
  }
  if (path.find_first_of(" \t\n") == std::string::npos) return Done{};
  return Error{.field = "--work",
               .message = "Verilator cannot build where the path has blanks",
               .received = path,
               .accepted = "--work with a path without blanks, or --simulator icarus"};
}

/// Checks that the trace can be written, before the simulation takes its time.
Result<Done> check_trace(const fs::path& trace) {
  if (trace.empty()) return Done{};
  MIXCMP_TRY(possible, verilator_tb::WaveFile::open(trace));
  return Done{};
}

/// Writes the system into a folder of WORK/rtl whose name holds a hash of all its bytes. Runs of
/// different systems can thus share a work folder.
fs::path write_rtl(const emit::GeneratedSystem& system, const fs::path& work) {
  ContentHash hash;
  for (const emit::GeneratedFile& file : system.files) hash.add(file.name).add(file.text);
  const FolderLock held = lock_folder(work / "rtl");
  const fs::path folder =
      work / "rtl" / fmt::format("{}-{}", system.signature.top, hash.hex().substr(0, 16));
  value_or_exit(emit::write_system(system, folder));
  return folder;
}

void run(const VerifyCommand& command) {
  if (!command.suite.empty()) {
    return run_suite({.suite = command.suite,
                      .work = command.work,
                      .junit = command.junit,
                      .minutes = command.minutes,
                      .json = command.scene.json});
  }
  if (command.scene.scene.empty()) {
    fail({.field = "verify", .message = "nothing to verify", .accepted = "SCENE, or --suite FILE"});
  }
  const LoadedScene loaded = value_or_exit(load(command.scene));
  value_or_exit(check_has_data(loaded, "verify needs data to run on"));
  const design::Design design = value_or_exit(design_of(command.scene, loaded));
  const emit::GeneratedSystem system =
      value_or_exit(emit::generate_system(design, command_line("generate", command.scene)));
  const fs::path work =
      command.work.empty() ? fs::path(system.signature.top + "_simulation") : command.work;
  value_or_exit(check_work(command, work));
  const verilator_tb::VerifyOptions options = run_options(command, loaded, work);
  value_or_exit(check_request(design, *loaded.data, options));
  value_or_exit(check_outputs({command.csv, command.run.waves,
                               verilator_tb::save_file_beside(command.run.waves), command.junit},
                              inputs_of(command.scene, loaded.scene)));
  value_or_exit(check_trace(command.run.waves));
  value_or_exit(check_writable({command.junit}));
  const fs::path rtl = write_rtl(system, work);
  verilator_tb::VerifyReport report = run_with_table(design, *loaded.data, rtl, options, command);
  if (!report.passed() && !command.no_counterexample &&
      design.system.engine.kind == scene::EngineKind::none) {
    add_counterexample(report, command, design, *loaded.data, rtl, options);
  }
  keep_simulation(system.signature.spec_hash, report);
  report.inputs = data::input_sources(*loaded.data, loaded.scene.graph.inputs());
  show_progress("");
  if (!command.junit.empty()) {
    value_or_exit(
        write_file(command.junit, verilator_tb::junit_text(report.system, tests_of(report))));
  }
  print(command.scene.json ? report::json_text(to_json(report)) : to_text(report));
  if (!report.passed()) throw Exit(ExitCode::refuted);
}

}  // namespace

Result<Done> check_verify(const std::vector<std::string>& words) {
  VerifyCommand command;
  MIXCMP_DO(parse_words(words, [&](const Verb& verb) { add_options(verb, command); }));
  MIXCMP_TRY(loaded, load(command.scene));
  MIXCMP_DO(check_has_data(loaded, "verify needs data to run on"));
  MIXCMP_TRY(design, design_of(command.scene, loaded));
  return check_request(design, *loaded.data, run_options(command, loaded, {}));
}

void add_verify(CLI::App& app) {
  const Verb verb(
      app, "verify",
      "generate, simulate on the scene's data, hold every verdict against the model of its lane");
  auto command = std::make_shared<VerifyCommand>();
  add_options(verb, *command);
  verb.when_chosen([command] { run(*command); });
}

}  // namespace mixcmp::cli
