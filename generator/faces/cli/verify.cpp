#include "generator/faces/cli/verify.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "generator/faces/cli/exit.hpp"
#include "generator/faces/cli/options.hpp"
#include "generator/faces/cli/output.hpp"
#include "generator/faces/cli/result_table.hpp"
#include "generator/faces/cli/suite.hpp"
#include "generator/faces/cli/verbs.hpp"
#include "generator/present/report/json_text.hpp"
#include "generator/tasks/verify.hpp"
#include "verilator_tb/junit.hpp"
#include "verilator_tb/waves.hpp"

namespace mixcmp::cli {
namespace {

namespace fs = std::filesystem;

const std::set<std::string> csv_verdict_names = {"less", "equal", "greater", "unordered",
                                                 std::string(ResultTable::undecided)};

struct VerifyCommand {
  SceneOptions scene;
  tasks::VerifyOptions task;
  fs::path suite;
  double minutes = 0;  ///< of the suite; 0: as the suite says
  fs::path junit;
  fs::path csv;
  std::set<std::string> csv_verdicts = csv_verdict_names;
  std::uint64_t first = 0;   ///< 0: not asked for
  std::uint64_t sample = 0;  ///< 0: not asked for
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
  verb.flag(
      "--no-counterexample", [&task = command.task] { task.find_counterexample = false; },
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
  verb.option("--seed", command.task.run.selection.seed, "of --sample and of --traffic stressed")
      .check(whole(0));
  const Option only =
      verb.option("--only", command.task.run.selection.only, "only comparison number N")
          .check(whole(0));
  first.excludes(sample).excludes(only);
  sample.excludes(only);
}

void add_options(const Verb& verb, VerifyCommand& command) {
  add_scene_options(verb, command.scene, {}, SceneArgument::optional);
  verb.option("--work", command.task.work,
              "directory for the Verilog, the builds and the logs (default: TOP_simulation)");
  add_selection_options(verb, command);
  add_choice<verilator_tb::SimulatorKind>(
      verb, "--simulator", command.task.run.simulator,
      {{"verilator", verilator_tb::SimulatorKind::verilator},
       {"icarus", verilator_tb::SimulatorKind::icarus}},
      "verilator, or icarus for small systems (default: verilator)");
  add_choice<verilator_tb::JudgeKind>(
      verb, "--judge", command.task.run.judge,
      {{"emulator", verilator_tb::JudgeKind::emulator},
       {"mpfr", verilator_tb::JudgeKind::golden_model}},
      "who says what verdicts must be: the emulator, which is checked by MPFR in samples and where "
      "it matters; or mpfr for every comparison, as always with an engine (default: emulator)");
  add_choice<verilator_tb::TrafficKind>(
      verb, "--traffic", command.task.run.traffic,
      {{"full_rate", verilator_tb::TrafficKind::full_rate},
       {"stressed", verilator_tb::TrafficKind::stressed}},
      "full_rate, or stressed: random gaps and backpressure (default: full_rate)");
  verb.option("--jobs", command.task.jobs,
              "simulators side by side, where a run is more than a share (default: one a "
              "processor)")
      .check(whole(1, 1024));
  verb.option("--share", command.task.run.share_size,
              "comparisons that one simulation makes from its reset to its end; more are several "
              "simulations; not of an engine (default: 1048576)")
      .check(whole(1));
  verb.text_option(
          "--portion",
          [&portion = command.task.run.portion](const std::string& text) {
            const Fraction given = fraction_of(text).value();
            portion = {.number = given.number - 1, .count = given.count};
          },
          "one of several portions of a long run, 2/8 the second of eight: each is made of whole "
          "simulations (mixcmp sweep)")
      .check(a_fraction());
  verb.option("--resets", command.task.run.resets, "resets in mid-stream, 0..1000000 (default: 0)")
      .check(whole(0, 1'000'000));
  verb.option("--trace", command.task.run.waves,
              "write waves to this .fst file, beside it a GTKWave save file")
      .check({fst_path, ""});
  add_choice<std::optional<verilator_tb::TruthScope>>(
      verb, "--truth", command.task.truth,
      {{"off", std::nullopt},
       {"recomputed", verilator_tb::TruthScope::recomputed},
       {"all", verilator_tb::TruthScope::all}},
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

tasks::VerifyOptions task_options(const VerifyCommand& command) {
  tasks::VerifyOptions options = command.task;
  verilator_tb::Selection::Options& selection = options.run.selection;
  selection.limit = std::max(command.first, command.sample);
  if (command.sample > 0) selection.sampling = verilator_tb::Sampling::random;
  options.run.progress = show_progress;
  options.run.waiting = tell_waiting;
  return options;
}

Result<tasks::Verification> verify_with_table(const VerifyCommand& command,
                                              const LoadedScene& loaded) {
  tasks::VerifyOptions options = task_options(command);
  std::optional<ResultTable> table;
  if (!command.csv.empty()) {
    MIXCMP_DO(check_has_data(loaded, "verify needs data to run on"));
    MIXCMP_TRY(opened, ResultTable::open(command.csv, *loaded.data, command.csv_verdicts));
    table.emplace(std::move(opened));
    options.run.on_result = [&table](const auto& result) { table->add(result); };
  }
  MIXCMP_TRY(found, with_shortcuts(tasks::verify(command.scene.request(), loaded, options),
                                   command.scene));
  if (table) MIXCMP_DO(table->finish());
  return found;
}

void run(const VerifyCommand& command) {
  if (!command.suite.empty()) {
    return run_suite({.suite = command.suite,
                      .work = command.task.work,
                      .junit = command.junit,
                      .minutes = command.minutes,
                      .json = command.scene.json});
  }
  if (command.scene.scene.empty()) {
    fail({.field = "verify", .message = "nothing to verify", .accepted = "SCENE, or --suite FILE"});
  }
  const LoadedScene loaded = value_or_exit(load(command.scene));
  const fs::path& waves = command.task.run.waves;
  value_or_exit(
      check_outputs({command.csv, waves, verilator_tb::save_file_beside(waves), command.junit},
                    inputs_of(command.scene, loaded.scene)));
  value_or_exit(check_writable({command.junit}));
  const auto [report, not_done] = value_or_exit(verify_with_table(command, loaded));
  show_progress("");
  for (const std::string& part : not_done) tell(part);
  if (!command.junit.empty()) {
    value_or_exit(write_file(
        command.junit, verilator_tb::junit_text(report.system, verilator_tb::junit_cases(report))));
  }
  print(command.scene.json ? report::json_text(to_json(report)) : to_text(report));
  if (!report.passed()) throw Exit(ExitCode::refuted);
}

}  // namespace

Result<Done> check_verify(const std::vector<std::string>& words) {
  VerifyCommand command;
  MIXCMP_DO(parse_words(words, [&](const Verb& verb) { add_options(verb, command); }));
  MIXCMP_TRY(loaded, load(command.scene));
  return with_shortcuts(tasks::check_verify(command.scene.request(), loaded, task_options(command)),
                        command.scene);
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
