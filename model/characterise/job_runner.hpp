#pragma once

#include <functional>
#include <string>
#include <vector>

#include "model/characterise/store.hpp"

namespace mixcmp::model {

/// A job whose result a store lacks.
struct PendingJob {
  std::string hash;
  std::string label;                  ///< for messages: "lane s12e8 exact relative"
  std::function<SynthesisJob()> job;  ///< made when it starts: sources of all at once are large
};

struct FailedJob {
  std::string label;
  std::string message;              ///< of the tool, with the end of its log
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
  std::filesystem::path keep = {};  ///< of a single job: where a copy of its folder goes
  /// Called now and then with what is finished (failed or not) and for how long it has run.
  std::function<void(int finished, double seconds)> progress = {};
};

/// Synthesises each job in a process of its own, `workers` at a time, and puts the results into the
/// store at `store`, which nobody in this process may have open. An interrupt (SIGINT, SIGTERM,
/// SIGHUP) ends those that run; what is in the store by then stays. Work is done in STORE.work;
/// failed jobs are kept there. To be called from the only thread of a process.
Result<JobRun> run_jobs(const std::vector<PendingJob>& jobs, const Device& device,
                        const std::string& tools, const std::filesystem::path& store,
                        const JobRunOptions& options);

}  // namespace mixcmp::model
