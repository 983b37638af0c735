#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "generator/faces/cli/characterise_table.hpp"
#include "generator/faces/cli/exit.hpp"
#include "generator/faces/cli/output.hpp"
#include "generator/faces/cli/sweep_jobs.hpp"
#include "generator/faces/cli/verbs.hpp"
#include "generator/hardware/emit/version.hpp"
#include "generator/present/report/json_text.hpp"
#include "model/base/common/file.hpp"
#include "model/base/common/folder_lock.hpp"
#include "model/base/common/output_file.hpp"

namespace mixcmp::cli {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct SweepCommand {
  std::string step;
  fs::path path;                  ///< the sweep's file to `plan`, its folder to `run` and `merge`
  fs::path output;                ///< empty: NAME_sweep
  fs::path work;                  ///< of simulations; empty: in the sweep's folder
  std::optional<Fraction> shard;  ///< none: all jobs
  unsigned jobs = 0;              ///< 0: one per processor
  bool json = false;
};

/// The outcome of one shard.
struct ShardOutcome {
  std::size_t jobs = 0;
  std::size_t done_before = 0;
  std::size_t run = 0;
  std::size_t failed = 0;   ///< jobs that a tool, or the machine, did not do
  std::size_t refuted = 0;  ///< runs in which hardware and model differ
  int interrupted_by = 0;
};

Json plan_json(const Sweep& sweep, const SweepFolder& folder) {
  const fs::path from = fs::canonical(folder.path);
  Json jobs = Json::array();
  for (const auto& [key, what] : sweep.jobs()) jobs.push_back({{"key", key}, {"what", what}});
  return {{"sweep", sweep.file.lexically_relative(from).generic_string()},
          {"generator", emit::version},
          {"jobs", std::move(jobs)}};
}

Error no_plan(const SweepFolder& folder, const std::string& received) {
  return {.file = folder.plan().string(),
          .message = "no plan of a sweep",
          .received = received,
          .accepted = "the folder that mixcmp sweep plan has made"};
}

Json read_plan(const SweepFolder& folder) {
  const auto text = read_file(folder.plan());
  if (!text.ok()) fail(no_plan(folder, text.error().received));
  Json plan = Json::parse(*text, nullptr, false);
  const bool is_plan = plan.is_object() && plan.contains("sweep") && plan["sweep"].is_string() &&
                       plan.contains("jobs") && plan["jobs"].is_array();
  if (!is_plan) fail(no_plan(folder, "another text"));
  return plan;
}

/// The sweep of a planned folder. Its jobs must be those of the plan, or shards would not make one
/// whole.
Sweep planned_sweep(const SweepFolder& folder, unsigned jobs) {
  const Json plan = read_plan(folder);
  Sweep sweep = read_sweep(folder.path / plan["sweep"].get<std::string>(), folder, jobs);
  const Json now = plan_json(sweep, folder);
  if (now["jobs"] == plan["jobs"]) return sweep;
  fail({.file = folder.plan().string(),
        .message = "the jobs are others than when they were planned",
        .received = "another program, tool, scene or file of data",
        .accepted = "what was there then, or a new plan: mixcmp sweep plan; results that still "
                    "count are kept"});
}

/// Refuses an option of another step, which would do nothing.
void check_options(const SweepCommand& command) {
  struct Given {
    const char* option;
    const char* step;
    bool given;
  };
  const std::array options = {Given{"--output", "plan", !command.output.empty()},
                              Given{"--shard", "run", command.shard.has_value()},
                              Given{"--work", "run", !command.work.empty()},
                              Given{"--jobs", "run", command.jobs > 0}};
  for (const Given& each : options) {
    if (!each.given || each.step == command.step) continue;
    fail({.field = each.option,
          .message = fmt::format("is only of sweep {}", each.step),
          .received = "sweep " + command.step,
          .accepted = fmt::format("sweep {} ... {}", each.step, each.option)});
  }
}

std::string number_of_jobs(std::size_t count) {
  return fmt::format("{} {}", count, count == 1 ? "job" : "jobs");
}

void plan(const SweepCommand& command) {
  SweepFolder folder{command.output};
  if (folder.path.empty()) folder.path = command.path.stem().string() + "_sweep";
  const Sweep sweep = read_sweep(command.path, folder, command.jobs);
  value_or_exit(check_runs(sweep));
  value_or_exit(make_writable_folder(folder.results()));
  const Json planned = plan_json(sweep, folder);
  value_or_exit(write_file(folder.plan(), report::json_text(planned)));
  if (command.json) return print(report::json_text(planned));
  std::string text;
  for (const auto& [key, what] : sweep.jobs()) text += fmt::format("{:<32}  {}\n", key, what);
  print(fmt::format("{}{}, {} of them to do: mixcmp sweep run {} [--shard K/N]\n", text,
                    number_of_jobs(planned["jobs"].size()),
                    jobs_to_do(sweep, folder, Failed::is_done).size(),
                    quoted(folder.path.string())));
}

/// The shard's keys: every n-th of all, which are as random as hashes are.
std::set<std::string> keys_of(const Sweep& sweep, const Fraction& shard) {
  std::set<std::string> keys;
  std::uint64_t number = 0;
  for (const auto& [key, what] : sweep.jobs()) {
    if (number++ % shard.count == shard.number - 1) keys.insert(key);
  }
  return keys;
}

void measure(const SweepTable& table, const std::set<std::string>& keys, ShardOutcome& outcome) {
  const bool any = std::any_of(table.jobs.begin(), table.jobs.end(),
                               [&](const auto& job) { return keys.contains(job.hash); });
  if (!any || outcome.interrupted_by != 0) return;
  const data::Comparisons* data = table.loaded.data ? &*table.loaded.data : nullptr;
  const characterise::JobRun run = value_or_exit(
      components::run_some(table.loaded.scene, data, table.device, table.options, keys));
  show_progress("");
  for (const characterise::FailedJob& job : run.failed) {
    tell(fmt::format("{}: {}\n  kept in {}", job.label, job.message, job.directory.string()));
  }
  outcome.run += static_cast<std::size_t>(run.done);
  outcome.failed += run.failed.size();
  outcome.interrupted_by = run.interrupted_by;
}

void verify(const SweepRun& run, const SweepFolder& folder, const fs::path& work,
            const std::set<std::string>& keys, ShardOutcome& outcome) {
  constexpr double no_limit = 1e9;
  for (std::size_t k = 0; k < run.keys.size() && outcome.interrupted_by == 0; ++k) {
    if (!keys.contains(run.keys[k])) continue;
    const SuiteRun portion = run.portion(k);
    show_progress("verify " + portion.name);
    const RunOutcome done = verify_run(portion, work, folder.report_of(run.keys[k]), no_limit);
    show_progress("");
    ++outcome.run;
    if (done.outcome == Outcome::failed) ++outcome.refuted;
    if (done.outcome != Outcome::broken) continue;
    ++outcome.failed;
    tell(fmt::format("verify {}: {}", portion.name, done.error));
  }
}

void end_unless_done(const ShardOutcome& outcome) {
  if (outcome.interrupted_by != 0) throw Exit::interrupted(outcome.interrupted_by);
  if (outcome.refuted > 0) throw Exit(ExitCode::refuted);
  if (outcome.failed > 0) throw Exit(ExitCode::mistake);
}

void run_shard(const SweepCommand& command) {
  const SweepFolder folder{command.path};
  const Sweep sweep = planned_sweep(folder, command.jobs);
  const fs::path work = command.work.empty() ? folder.path / "work" : command.work;
  const Fraction shard = command.shard.value_or(Fraction{});
  std::set<std::string> keys = keys_of(sweep, shard);
  ShardOutcome outcome{.jobs = keys.size()};
  const std::set<std::string> to_do = jobs_to_do(sweep, folder, Failed::is_repeated);
  outcome.done_before = std::erase_if(keys, [&](const auto& key) { return !to_do.contains(key); });
  for (const SweepTable& table : sweep.tables) measure(table, keys, outcome);
  for (const SweepRun& run : sweep.runs) verify(run, folder, work, keys, outcome);
  if (command.json) {
    print(report::json_text({{"shard", shard.number},
                             {"shards", shard.count},
                             {"jobs", outcome.jobs},
                             {"done_before", outcome.done_before},
                             {"run", outcome.run},
                             {"failed", outcome.failed},
                             {"refuted", outcome.refuted}}));
  } else {
    print(fmt::format("shard {}/{}: {}, {} done before, {} run, {} failed, {} refuted\n",
                      shard.number, shard.count, number_of_jobs(outcome.jobs), outcome.done_before,
                      outcome.run, outcome.failed, outcome.refuted));
  }
  end_unless_done(outcome);
}

/// Ends the program if results are missing.
void end_if_missing(const Sweep& sweep, const SweepFolder& folder, bool json) {
  const std::set<std::string> missing = jobs_to_do(sweep, folder, Failed::is_done);
  if (missing.empty()) return;
  if (json) print(report::json_text({{"missing", missing}}));
  const auto jobs = sweep.jobs();
  constexpr std::size_t most_told = 20;
  std::vector<std::string> parts;
  for (const std::string& key : missing) {
    if (parts.size() == most_told) break;
    parts.push_back(fmt::format("{} {}", key, jobs.at(key)));
  }
  if (missing.size() > most_told) {
    parts.push_back(fmt::format("and {} more", missing.size() - most_told));
  }
  end_if_incomplete(parts);
}

Json merged_table(const SweepTable& table) {
  const components::CharacteriseReport report = measure_table(table.command, table.loaded);
  end_if_unfinished(report);
  const fs::path path = table_of(table.command, table.loaded.scene, table.device);
  return {{"table", path.filename().string()},
          {"device", table.device.name},
          {"rows", report.table.rows.size()}};
}

Json merged_run(const SweepRun& run, const SweepFolder& folder) {
  std::vector<Json> reports;
  for (const std::string& key : run.keys) {
    reports.push_back(report_of(kept_outcome(folder.report_of(key))));
  }
  Json report = merged_report(reports);
  const Outcome outcome = report["passed"] == true ? Outcome::passed : Outcome::failed;
  return {{"run", run.whole.name}, {"result", word_for(outcome)}, {"report", std::move(report)}};
}

std::string text_of(const Json& merged) {
  std::string text;
  for (const Json& table : merged["tables"]) {
    text +=
        fmt::format("{} rows in {}\n", table["rows"].get<int>(), table["table"].get<std::string>());
  }
  for (const Json& run : merged["runs"]) {
    text += fmt::format("{:<8} {:>12} comparisons  {}\n", run["result"].get<std::string>(),
                        run["report"]["comparisons"].get<std::uint64_t>(),
                        run["run"].get<std::string>());
  }
  return text;
}

void merge(const SweepCommand& command) {
  const SweepFolder folder{command.path};
  const Sweep sweep = planned_sweep(folder, command.jobs);
  end_if_missing(sweep, folder, command.json);
  Json merged = {{"tables", Json::array()}, {"runs", Json::array()}};
  for (const SweepTable& table : sweep.tables) merged["tables"].push_back(merged_table(table));
  bool all_passed = true;
  for (const SweepRun& run : sweep.runs) {
    merged["runs"].push_back(merged_run(run, folder));
    all_passed = all_passed && merged["runs"].back()["result"] == word_for(Outcome::passed);
  }
  value_or_exit(write_file(folder.report(), report::json_text(merged)));
  print(command.json ? report::json_text(merged)
                     : text_of(merged) + folder.report().string() + "\n");
  if (!all_passed) throw Exit(ExitCode::refuted);
}

void run(const SweepCommand& command) {
  check_options(command);
  if (command.step == "plan") return plan(command);
  if (command.step == "run") return run_shard(command);
  merge(command);
}

}  // namespace

void add_sweep(CLI::App& app) {
  const Verb verb(app, "sweep",
                  "split tables and regressions over machines: plan, run a shard, merge");
  auto command = std::make_shared<SweepCommand>();
  verb.option("STEP", command->step, "plan FILE, run FOLDER, or merge FOLDER (docs/sweep.md)")
      .required()
      .one_of({"plan", "run", "merge"});
  verb.option("PATH", command->path, "the sweep's file, or the folder of its plan").required();
  verb.option("-o,--output", command->output, "of plan: the folder (default: NAME_sweep)");
  verb.text_option(
          "--shard",
          [&shard = command->shard](const std::string& text) { shard = fraction_of(text).value(); },
          "of run: 2/8 is the second of eight shards (default: all jobs)")
      .check(a_fraction());
  verb.option("--work", command->work,
              "of run: folder for builds of simulations (default: work in the sweep's folder)");
  verb.option("--jobs", command->jobs, "of run: at a time (default: one a processor)")
      .check(within(settings::limits::threads));
  verb.flag("--json", command->json, "print the result as JSON");
  verb.when_chosen([command] { run(*command); });
}

}  // namespace mixcmp::cli
