#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "generator/synthesis/characterise/store.hpp"

namespace mixcmp::characterise {

/// A job whose result a store lacks.
struct PendingJob {
  std::string hash;
  std::string label;                  ///< for messages: "lane s12e8 exact relative"
  std::function<SynthesisJob()> job;  ///< called when the job starts, since sources are large
};

struct FailedJob {
  std::string label;
  std::string message;              ///< the tool's message, with the end of its log
  std::filesystem::path directory;  ///< where sources and logs are kept
};

struct JobRun {
  int done = 0;
  std::vector<FailedJob> failed;
  int interrupted_by = 0;  ///< the signal; 0: none
};

struct JobRunOptions {
  SynthesisOptions synthesis;
  unsigned workers = 1;
  std::filesystem::path keep = {};  ///< where to copy a single job's folder; empty: nowhere
  /// Called regularly with the number of finished jobs, failed ones included, and the seconds since
  /// the start.
  std::function<void(int finished, double seconds)> progress = {};
};

/// One piece of work in a folder of its own.
struct Work {
  std::string name;   ///< the folder is kept as failed.NAME if the work fails
  std::string label;  ///< for messages
  /// Must soon return once `cancelled` is true.
  std::function<Result<Done>(const std::filesystem::path& folder,
                             const std::atomic<bool>& cancelled)>
      run;
};

/// Does all work in folders under `place`, `workers` at a time. An interrupt (SIGINT, SIGTERM,
/// SIGHUP) ends what is running. Exceptions fail only the work that throws them.
Result<JobRun> run_work(const std::vector<Work>& all, const std::filesystem::path& place,
                        unsigned workers,
                        const std::function<void(int finished, double seconds)>& progress);

/// Synthesises the jobs, `workers` at a time, and puts the results into the store at `store`. An
/// interrupt (SIGINT, SIGTERM, SIGHUP) ends the running jobs; results already in the store stay.
/// Work is done in STORE.work, where failed jobs are kept.
Result<JobRun> run_jobs(const std::vector<PendingJob>& jobs, const devices::Device& device,
                        const std::string& tools, const std::filesystem::path& store,
                        const JobRunOptions& options);

}  // namespace mixcmp::characterise
