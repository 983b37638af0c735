#include "verilator_tb/verify.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cstdint>
#include <nlohmann/json.hpp>

#include "generator/cli/exit.hpp"
#include "generator/cli/options.hpp"
#include "generator/cli/result_table.hpp"
#include "generator/cli/verbs.hpp"
#include "generator/emit/system.hpp"

namespace mixcmp::cli {
namespace {

namespace fs = std::filesystem;
using model::golden::Verdict;

enum class TruthOption { off, recomputed, all };

struct VerifyCommand {
  SceneOptions scene;
  tb::VerifyOptions run;
  fs::path work;
  fs::path csv;
  std::set<Verdict> csv_verdicts = {Verdict::less, Verdict::equal, Verdict::greater,
                                    Verdict::unordered};
  std::uint64_t first = 0;   ///< 0: not asked for
  std::uint64_t sample = 0;  ///< 0: not asked for
  std::optional<std::uint64_t> only;
  TruthOption truth = TruthOption::off;
};

template <class Value>
using Spellings = std::map<std::string, Value>;

template <class Value>
CLI::Option* add_choice(CLI::App& verb, const std::string& flag, Value& value,
                        const Spellings<Value>& spellings, const std::string& help) {
  return verb.add_option(flag, value, help)
      ->transform(CLI::CheckedTransformer(spellings, CLI::ignore_case));
}

const Spellings<Verdict> verdict_spellings = {{"less", Verdict::less},
                                              {"equal", Verdict::equal},
                                              {"greater", Verdict::greater},
                                              {"unordered", Verdict::unordered}};

void add_options(CLI::App& verb, VerifyCommand& command) {
  add_scene_options(verb, command.scene);
  verb.add_option("--work", command.work,
                  "directory for the Verilog, the builds and the logs (default: TOP_simulation)");
  auto* first = verb.add_option("--first", command.first, "only the first N comparisons");
  auto* sample = verb.add_option("--sample", command.sample, "only N comparisons, spread over all");
  verb.add_option("--seed", command.run.selection.seed, "of --sample and of --traffic stressed");
  auto* only = verb.add_option("--only", command.only, "only comparison number N");
  first->excludes(sample)->excludes(only);
  sample->excludes(only);
  add_choice<tb::SimulatorKind>(
      verb, "--simulator", command.run.simulator,
      {{"verilator", tb::SimulatorKind::verilator}, {"icarus", tb::SimulatorKind::icarus}},
      "verilator, or icarus for small systems");
  add_choice<tb::TrafficKind>(
      verb, "--traffic", command.run.traffic,
      {{"full_rate", tb::TrafficKind::full_rate}, {"stressed", tb::TrafficKind::stressed}},
      "full_rate, or stressed: random gaps and backpressure");
  verb.add_option("--resets", command.run.resets, "resets in mid-stream");
  verb.add_option("--trace", command.run.waves,
                  "write waves: FST (VCD from icarus), beside it a GTKWave save file");
  add_choice<TruthOption>(verb, "--truth", command.truth,
                          {{"off", TruthOption::off},
                           {"recomputed", TruthOption::recomputed},
                           {"all", TruthOption::all}},
                          "hold verdicts also against exact arithmetic: off, recomputed, all");
  verb.add_option("--csv", command.csv, "write the verdicts as CSV");
  verb.add_option_function<std::vector<std::string>>(
          "--csv-verdict",
          [&command](const std::vector<std::string>& names) {
            command.csv_verdicts.clear();
            for (const std::string& name : names) {
              command.csv_verdicts.insert(verdict_spellings.at(name));
            }
          },
          "only these verdicts in the CSV: less, equal, greater, unordered")
      ->check(CLI::IsMember({"less", "equal", "greater", "unordered"}))
      ->allow_extra_args(false);
}

tb::Selection::Options selection(const VerifyCommand& command) {
  tb::Selection::Options options = command.run.selection;
  options.limit = std::max(command.first, command.sample);
  options.sampling = command.sample > 0 ? tb::Sampling::random : tb::Sampling::first;
  options.only = command.only;
  return options;
}

/// A line that is overwritten, on a terminal only.
void show_progress(const std::string& what) {
  if (isatty(STDERR_FILENO) != 0) fmt::print(stderr, "\r\x1b[K{}", what);
}

std::string repeat_command(const VerifyCommand& command) {
  std::string line = "mixcmp verify " + command.scene.scene.string();
  for (const std::string& setting : command.scene.settings) line += " --set '" + setting + "'";
  return line;
}

tb::VerifyOptions run_options(const VerifyCommand& command, const LoadedScene& loaded,
                              const fs::path& work) {
  tb::VerifyOptions options = command.run;
  options.work_dir = work / "build";
  options.selection = selection(command);
  options.traffic_seed = command.run.selection.seed;
  options.repeat_command = repeat_command(command);
  options.progress = show_progress;
  if (command.truth != TruthOption::off) {
    options.truth = {&loaded.scene.graph, command.truth == TruthOption::all
                                              ? tb::TruthScope::all
                                              : tb::TruthScope::recomputed};
  }
  return options;
}

tb::VerifyReport run_with_table(const model::Design& design, const model::Comparisons& data,
                                const fs::path& rtl, tb::VerifyOptions options,
                                const VerifyCommand& command) {
  if (command.csv.empty()) return value_or_exit(tb::verify(design, data, rtl, options));
  ResultTable table = value_or_exit(ResultTable::open(command.csv, data, command.csv_verdicts));
  options.on_result = [&table](const tb::VerifiedResult& result) { table.add(result); };
  tb::VerifyReport report = value_or_exit(tb::verify(design, data, rtl, options));
  value_or_exit(table.finish());
  return report;
}

void run(const VerifyCommand& command) {
  const LoadedScene loaded = value_or_exit(load(command.scene));
  if (!loaded.data) {
    value_or_exit<model::Done>(model::Error{.file = command.scene.scene.string(),
                                            .field = "data",
                                            .message = "verify needs data to run on",
                                            .received = "a scene without [data]",
                                            .accepted = "[data] with items or file"});
  }
  const model::Design design = value_or_exit(make_design(loaded.scene, &*loaded.data));
  const gen::GeneratedSystem system =
      value_or_exit(gen::generate_system(design, command_line("generate", command.scene)));
  const fs::path work =
      command.work.empty() ? fs::path(system.signature.top + "_simulation") : command.work;
  const fs::path rtl = work / "rtl";
  value_or_exit(gen::write_system(system, rtl));
  const tb::VerifyReport report =
      run_with_table(design, *loaded.data, rtl, run_options(command, loaded, work), command);
  show_progress("");
  fmt::print("{}", command.scene.json ? to_json(report).dump(2) + "\n" : to_text(report));
  if (!report.passed()) throw Exit{2};
}

}  // namespace

void add_verify(CLI::App& app) {
  CLI::App* verb = app.add_subcommand(
      "verify",
      "generate, simulate on the scene's data, hold every verdict against the golden model");
  auto command = std::make_shared<VerifyCommand>();
  add_options(*verb, *command);
  verb->callback([command] { run(*command); });
}

}  // namespace mixcmp::cli
