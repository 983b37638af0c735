#include "generator/cli/suite.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

#include "generator/cli/exit.hpp"
#include "generator/cli/options.hpp"
#include "generator/cli/output.hpp"
#include "generator/cli/suite_file.hpp"
#include "generator/report/json_text.hpp"
#include "model/common/content_hash.hpp"
#include "model/common/file.hpp"
#include "model/common/process.hpp"
#include "verilator_tb/junit.hpp"

namespace mixcmp::cli {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Outcome = verilator_tb::JUnitCase::Outcome;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The outcome of one run of the suite.
struct RunOutcome {
  Outcome outcome = Outcome::skipped;
  double seconds = 0;
  Json report;           ///< of `verify --json`; null where there is none
  fs::path report_file;  ///< empty where there is none
  std::string error;     ///< why it could not be run
};

/// The hash of the files that a run reads, this program included, and of its options; nothing where
/// the scene cannot be read. Versions of simulators and compilers are not in it.
std::optional<std::string> identity(const SuiteRun& run, const std::string& program) {
  SceneOptions options{.scene = run.scene, .settings = {}, .shortcuts = {}};
  for (std::size_t k = 0; k + 1 < run.options.size(); ++k) {
    if (run.options[k] == "--set") options.settings.push_back(run.options[k + 1]);
  }
  const auto scene = scene::load_scene(options.scene, options.settings);
  if (!scene.ok()) return std::nullopt;
  ContentHash hash;
  hash.add(program).add(run.scene.string());
  for (const std::string& word : run.options) hash.add(word);
  for (const fs::path& input : inputs_of(options, *scene)) {
    if (input.empty()) continue;
    const auto text = read_file(input);
    if (!text.ok()) return std::nullopt;
    hash.add(*text);
  }
  return hash.hex().substr(0, 16);
}

/// A report as `verify --json` prints it; null where the text is none.
Json report_in(const std::string& text) {
  const Json report = Json::parse(text, nullptr, false);
  return report.is_object() && report.contains("passed") ? report : Json();
}

class SuiteRunner {
public:
  SuiteRunner(const SuiteCommand& command, Suite suite)
      : command_(command),
        suite_(std::move(suite)),
        minutes_(command.minutes > 0 ? command.minutes : suite_.minutes),
        program_(value_or_exit(read_file("/proc/self/exe"))) {}

  std::vector<RunOutcome> run() {
    std::vector<RunOutcome> outcomes;
    for (const SuiteRun& one : suite_.runs) {
      show_progress(fmt::format("run {} of {}{}: {}", outcomes.size() + 1, suite_.runs.size(),
                                time_left(outcomes.size()), one.name));
      outcomes.push_back(outcome_of(one));
    }
    show_progress("");
    return outcomes;
  }

private:
  /// ", about 3 min left": as if all runs took equally long.
  std::string time_left(std::size_t done) const {
    if (done == 0) return "";
    const double rest = seconds_since(start_) / static_cast<double>(done) *
                        static_cast<double>(suite_.runs.size() - done);
    return fmt::format(", about {:.0f} min left", std::ceil(rest / 60));
  }

  RunOutcome outcome_of(const SuiteRun& one) const {
    const auto name = identity(one, program_);
    const fs::path kept = name ? command_.work / "suite" / (*name + ".json") : fs::path();
    if (const auto text = read_file(kept); name && text.ok()) {
      Json report = report_in(*text);
      if (report.is_object() && report["passed"] == true) {
        const double seconds =
            report.value("build_seconds", 0.0) + report.value("run_seconds", 0.0);
        return {Outcome::passed, seconds, std::move(report), kept, ""};
      }
    }
    const double left = minutes_ > 0 ? minutes_ * 60 - seconds_since(start_) : 1e9;
    return left <= 0 ? RunOutcome{} : verify(one, kept, left);
  }

  RunOutcome verify(const SuiteRun& one, const fs::path& kept, double seconds) const {
    Command words = {"/proc/self/exe", "verify", one.scene.string(), "--no-counterexample"};
    words.insert(words.end(), one.options.begin(), one.options.end());
    for (const std::string& word :
         {std::string("--json"), std::string("--work"), command_.work.string()}) {
      words.push_back(word);
    }
    const auto start = Clock::now();
    const Result<Captured> captured = capture(words, {.seconds = seconds});
    RunOutcome outcome{.seconds = seconds_since(start)};
    if (!captured.ok()) {
      outcome.outcome = Outcome::broken;
      outcome.error = captured.error().to_string();
      return outcome;
    }
    const Captured& run = *captured;
    if (!run.in_time) return outcome;
    outcome.report = report_in(run.output);
    if (!outcome.report.is_object()) {
      outcome.outcome = Outcome::broken;
      outcome.error = run.errors.empty() ? how_it_ended(run.status) : run.errors;
      return outcome;
    }
    outcome.outcome = run.succeeded() ? Outcome::passed : Outcome::failed;
    if (!kept.empty()) {
      value_or_exit(make_writable_folder(kept.parent_path()));
      value_or_exit(write_kept_file(kept, run.output));
      outcome.report_file = kept;
    }
    return outcome;
  }

  const SuiteCommand& command_;
  Suite suite_;
  double minutes_;
  std::string program_;
  Clock::time_point start_ = Clock::now();
};

const char* word_for(Outcome outcome) {
  switch (outcome) {
    case Outcome::passed: return "passed";
    case Outcome::failed: return "FAILED";
    case Outcome::broken: return "not run";
    case Outcome::skipped: return "no time";
  }
  return "";
}

std::string number(const Json& report, const char* key) {
  return report.is_object() ? report[key].dump() : "";
}

std::string table(const std::vector<SuiteRun>& runs, const std::vector<RunOutcome>& outcomes) {
  std::string text = fmt::format("{:<8} {:>12} {:>12} {:>12} {:>9}  {}\n", "result", "comparisons",
                                 "recomputed", "cycles", "seconds", "run");
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const RunOutcome& one = outcomes[k];
    text += fmt::format("{:<8} {:>12} {:>12} {:>12} {:>9.2f}  {}\n", word_for(one.outcome),
                        number(one.report, "comparisons"), number(one.report, "recomputations"),
                        number(one.report, "cycles"), one.seconds, runs[k].name);
  }
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const RunOutcome& one = outcomes[k];
    if (one.outcome == Outcome::broken) text += fmt::format("\n{}\n{}", runs[k].name, one.error);
    if (one.outcome != Outcome::failed) continue;
    text += fmt::format("\n{}\n  report: {}\n", runs[k].name, one.report_file.string());
  }
  return text;
}

Json json_of(const std::vector<SuiteRun>& runs, const std::vector<RunOutcome>& outcomes) {
  Json list = Json::array();
  for (std::size_t k = 0; k < runs.size(); ++k) {
    list.push_back({{"run", runs[k].name},
                    {"result", word_for(outcomes[k].outcome)},
                    {"seconds", outcomes[k].seconds},
                    {"error", outcomes[k].error},
                    {"report", outcomes[k].report}});
  }
  return {{"runs", list}};
}

std::vector<verilator_tb::JUnitCase> tests_of(const std::vector<SuiteRun>& runs,
                                              const std::vector<RunOutcome>& outcomes) {
  std::vector<verilator_tb::JUnitCase> tests;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const RunOutcome& one = outcomes[k];
    verilator_tb::JUnitCase& test = tests.emplace_back(verilator_tb::JUnitCase{
        .name = runs[k].name, .seconds = one.seconds, .outcome = one.outcome});
    if (one.outcome == Outcome::passed) continue;
    test.message = word_for(one.outcome);
    test.details = one.report.is_object() ? one.report.dump(2) : one.error;
  }
  return tests;
}

/// How many runs ended in this way.
std::size_t count(const std::vector<RunOutcome>& outcomes, Outcome outcome) {
  return static_cast<std::size_t>(
      std::count_if(outcomes.begin(), outcomes.end(),
                    [&](const RunOutcome& one) { return one.outcome == outcome; }));
}

}  // namespace

void run_suite(const SuiteCommand& given) {
  SuiteCommand command = given;
  const Suite suite = value_or_exit(read_suite(command.suite));
  if (command.work.empty()) {
    std::string name = command.suite.stem().string();
    std::replace(name.begin(), name.end(), ' ', '_');  // Verilator builds in no path with blanks
    command.work = name + "_suite";
  }
  std::vector<fs::path> inputs = {command.suite};
  for (const SuiteRun& run : suite.runs) inputs.push_back(run.scene);
  value_or_exit(check_outputs({command.junit}, inputs));
  value_or_exit(check_writable({command.junit}));
  const std::vector<RunOutcome> outcomes = SuiteRunner(command, suite).run();
  print(command.json ? report::json_text(json_of(suite.runs, outcomes))
                     : table(suite.runs, outcomes));
  if (!command.junit.empty()) {
    value_or_exit(write_file(
        command.junit,
        verilator_tb::junit_text(command.suite.stem().string(), tests_of(suite.runs, outcomes))));
  }
  if (count(outcomes, Outcome::failed) > 0) throw Exit(ExitCode::refuted);
  if (count(outcomes, Outcome::broken) > 0) throw Exit(ExitCode::mistake);
  if (const std::size_t skipped = count(outcomes, Outcome::skipped); skipped > 0) {
    tell(fmt::format("{} of {} runs had no time; the same command goes on with them", skipped,
                     outcomes.size()));
    throw Exit(ExitCode::incomplete);
  }
}

}  // namespace mixcmp::cli
