#include "generator/faces/cli/suite.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

#include "generator/faces/cli/exit.hpp"
#include "generator/faces/cli/options.hpp"
#include "generator/faces/cli/output.hpp"
#include "generator/faces/cli/suite_run.hpp"
#include "generator/present/report/json_text.hpp"
#include "verilator_tb/junit.hpp"

namespace mixcmp::cli {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

class SuiteRunner {
public:
  SuiteRunner(const SuiteCommand& command, Suite suite)
      : command_(command),
        suite_(std::move(suite)),
        minutes_(command.minutes > 0 ? command.minutes : suite_.minutes),
        program_(hash_of_program()) {}

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
    const auto hash = identity(one, program_);
    const fs::path kept =
        hash.ok() ? command_.work / "suite" / (key_of(*hash) + ".json") : fs::path();
    RunOutcome known = kept_outcome(kept);
    if (known.outcome == Outcome::passed) return known;
    const double left = minutes_ > 0 ? minutes_ * 60 - seconds_since(start_) : 1e9;
    return left <= 0 ? RunOutcome{} : verify_run(one, command_.work, kept, left);
  }

  const SuiteCommand& command_;
  Suite suite_;
  double minutes_;
  ContentHash program_;
  Clock::time_point start_ = Clock::now();
};

std::string number(const Json& report, const char* key) {
  return report.is_object() ? report[key].dump() : "";
}

std::string table(const std::vector<SuiteRun>& runs, const std::vector<RunOutcome>& outcomes) {
  std::string text = fmt::format("{:<8} {:>12} {:>12} {:>12} {:>9}  {}\n", "result", "comparisons",
                                 "recomputed", "cycles", "seconds", "run");
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const RunOutcome& one = outcomes[k];
    const Json report = report_of(one);
    text += fmt::format("{:<8} {:>12} {:>12} {:>12} {:>9.2f}  {}\n", word_for(one.outcome),
                        number(report, "comparisons"), number(report, "recomputations"),
                        number(report, "cycles"), one.seconds, runs[k].name);
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
                    {"report", report_of(outcomes[k])}});
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
    test.details = one.report.empty() ? one.error : report_of(one).dump(2);
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
  if (!command.junit.empty()) {
    value_or_exit(write_file(
        command.junit,
        verilator_tb::junit_text(command.suite.stem().string(), tests_of(suite.runs, outcomes))));
  }
  print(command.json ? report::json_text(json_of(suite.runs, outcomes))
                     : table(suite.runs, outcomes));
  if (count(outcomes, Outcome::failed) > 0) throw Exit(ExitCode::refuted);
  if (count(outcomes, Outcome::broken) > 0) throw Exit(ExitCode::mistake);
  if (const std::size_t skipped = count(outcomes, Outcome::skipped); skipped > 0) {
    tell(fmt::format("{} of {} runs had no time; the same command goes on with them", skipped,
                     outcomes.size()));
    throw Exit(ExitCode::incomplete);
  }
}

}  // namespace mixcmp::cli
