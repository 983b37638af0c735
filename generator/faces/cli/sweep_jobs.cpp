#include "generator/faces/cli/sweep_jobs.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "generator/faces/cli/characterise_table.hpp"
#include "generator/faces/cli/exit.hpp"
#include "generator/faces/cli/verify.hpp"
#include "generator/synthesis/characterise/result_folder.hpp"
#include "model/base/settings/section.hpp"
#include "verilator_tb/report.hpp"

namespace mixcmp::cli {
namespace {

namespace fs = std::filesystem;

Result<Done> check_sections(const settings::Settings& file) {
  for (const settings::Setting& entry : file.root.entries) {
    const bool known = entry.key == "suite" || entry.key == verify_group().name ||
                       entry.key == characterise_group().name;
    if (known) continue;
    return settings::mistake_at(entry, entry.key, "no such section of a sweep", entry.key,
                                "[[characterise]], [[run]] and [suite]");
  }
  return Done{};
}

SweepTable table_of(const SuiteRun& run, const SweepFolder& folder, unsigned workers) {
  CharacteriseCommand command = value_or_exit(characterise_command(run));
  command.store = folder.results();
  command.jobs = workers;
  LoadedScene loaded = value_or_exit(load(command.scene));
  const devices::Device device = value_or_exit(devices::find_device(loaded.scene.system.device));
  components::CharacteriseOptions options = prepared_options(command, loaded, device);
  const data::Comparisons* data = loaded.data ? &*loaded.data : nullptr;
  auto jobs = value_or_exit(components::list_jobs(loaded.scene, data, device, options));
  return {run.name, std::move(command), std::move(loaded),
          device,   std::move(options), std::move(jobs)};
}

std::string portion_option(std::size_t k, std::size_t count) {
  return fmt::format("--portion={}/{}", k + 1, count);
}

/// The key of a portion is made from the hash of the whole run, whose files are thus read once. The
/// hash comes last, since the first texts change all digits of a key.
SweepRun run_of(const SuiteRun& run, const ContentHash& program) {
  const Result<ContentHash> whole = identity(run, program);
  if (!whole.ok()) fail(mistake_in(run, whole.error()));
  SweepRun found{.whole = run, .keys = {}};
  if (run.portions == 1) found.keys = {key_of(*whole)};
  const auto count = static_cast<std::size_t>(run.portions);
  for (std::size_t k = found.keys.size(); k < count; ++k) {
    found.keys.push_back(key_of(ContentHash().add(portion_option(k, count)).add(whole->hex())));
  }
  return found;
}

}  // namespace

SuiteRun SweepRun::portion(std::size_t k) const {
  SuiteRun one = whole;
  if (keys.size() == 1) return one;
  one.options.push_back(portion_option(k, keys.size()));
  one.name += " " + one.options.back();
  return one;
}

std::map<std::string, std::string> Sweep::jobs() const {
  std::map<std::string, std::string> all;
  for (const SweepTable& table : tables) {
    for (const components::PlannedJob& job : table.jobs) {
      all.emplace(job.hash, fmt::format("{} on {}", job.label, table.device.name));
    }
  }
  for (const SweepRun& run : runs) {
    for (std::size_t k = 0; k < run.keys.size(); ++k) {
      all.emplace(run.keys[k], "verify " + run.portion(k).name);
    }
  }
  return all;
}

Sweep read_sweep(const fs::path& path, const SweepFolder& folder, unsigned workers) {
  std::error_code failed;
  const fs::path real = fs::canonical(path, failed);
  const settings::Settings file = value_or_exit(settings::read_settings(failed ? path : real, {}));
  value_or_exit(check_sections(file));
  Sweep sweep{.file = file.path, .tables = {}, .runs = {}};
  for (const SuiteRun& run : value_or_exit(read_groups(file, characterise_group()))) {
    sweep.tables.push_back(table_of(run, folder, workers));
  }
  const ContentHash program = hash_of_program();
  std::set<std::string> known;
  for (const SuiteRun& run : value_or_exit(read_groups(file, verify_group()))) {
    sweep.runs.push_back(run_of(run, program));
    if (known.insert(sweep.runs.back().keys.front()).second) continue;
    fail(mistake_in(run, {.message = "is asked for twice", .accepted = "each run once"}));
  }
  if (!sweep.jobs().empty()) return sweep;
  fail({.file = path.string(),
        .message = "a sweep without a job",
        .accepted = "one [[characterise]] or [[run]] at least"});
}

Result<Done> check_runs(const Sweep& sweep) {
  for (const SweepRun& run : sweep.runs) {
    const Result<Done> possible = check_verify(verify_words(run.portion(0)));
    if (!possible.ok()) return mistake_in(run.whole, possible.error());
  }
  return Done{};
}

std::set<std::string> jobs_to_do(const Sweep& sweep, const SweepFolder& folder, Failed failed) {
  const characterise::ResultFolder results(folder.results());
  std::set<std::string> to_do;
  for (const SweepTable& table : sweep.tables) {
    for (const components::PlannedJob& job : table.jobs) {
      if (!results.find(job.hash)) to_do.insert(job.hash);
    }
  }
  for (const SweepRun& run : sweep.runs) {
    for (const std::string& key : run.keys) {
      const Outcome outcome = kept_outcome(folder.report_of(key)).outcome;
      const bool is_done =
          outcome == Outcome::passed || (outcome == Outcome::failed && failed == Failed::is_done);
      if (!is_done) to_do.insert(key);
    }
  }
  return to_do;
}

nlohmann::ordered_json merged_report(const std::vector<nlohmann::ordered_json>& portions) {
  nlohmann::ordered_json merged = portions.front();
  if (portions.size() > 1) {
    std::vector<verilator_tb::VerifyReport> reports;
    for (const nlohmann::ordered_json& portion : portions) {
      reports.push_back(verilator_tb::report_in(portion));
    }
    merged = to_json(verilator_tb::join_portions(reports));
  }
  for (const char* time : {"build_seconds", "run_seconds"}) merged.erase(time);
  return merged;
}

}  // namespace mixcmp::cli
