#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "generator/faces/cli/characterise_options.hpp"
#include "generator/faces/cli/suite_run.hpp"

namespace mixcmp::cli {

/// The folder of a sweep: its plan, its results by their keys, and the files merged from them.
struct SweepFolder {
  std::filesystem::path path;

  std::filesystem::path plan() const { return path / "plan.json"; }
  std::filesystem::path results() const { return path / "results"; }
  std::filesystem::path report() const { return path / "report.json"; }
  /// The file of a run's report.
  std::filesystem::path report_of(const std::string& key) const {
    return results() / (key + ".json");
  }
};

/// A table that [[characterise]] asks for.
struct SweepTable {
  std::string name;  ///< scene and options as the sweep writes them
  CharacteriseCommand command;
  LoadedScene loaded;
  devices::Device device;
  components::CharacteriseOptions options;
  std::vector<components::PlannedJob> jobs;
};

/// A run of `verify` that [[run]] asks for, in one or several portions.
struct SweepRun {
  SuiteRun whole;
  std::vector<std::string> keys;  ///< one for each portion

  SuiteRun portion(std::size_t k) const;
};

/// All that a sweep's file asks for. The key of a job is a hash of everything that its result
/// depends on, the tools' versions or this program included.
struct Sweep {
  std::filesystem::path file;
  std::vector<SweepTable> tables;
  std::vector<SweepRun> runs;

  /// The descriptions of the jobs, by their keys.
  std::map<std::string, std::string> jobs() const;
};

/// Reads a sweep's file and lists its jobs, whose results go to `folder`. Ends the program on an
/// error, such as a run that is asked for twice.
Sweep read_sweep(const std::filesystem::path& file, const SweepFolder& folder, unsigned workers);

/// Checks each run as `verify` would before it simulates: a mistake should not wait until a shard
/// finds it. It loads all data.
Result<Done> check_runs(const Sweep& sweep);

/// Whether a run that did not pass counts as done: it has a result, but a shard repeats it.
enum class Failed { is_done, is_repeated };

/// The keys of those jobs whose results are not in the folder.
std::set<std::string> jobs_to_do(const Sweep& sweep, const SweepFolder& folder, Failed failed);

/// The report of a whole run, from those of its portions in their order. Times are left out: they
/// differ from machine to machine.
nlohmann::ordered_json merged_report(const std::vector<nlohmann::ordered_json>& portions);

}  // namespace mixcmp::cli
