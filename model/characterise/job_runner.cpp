#include "model/characterise/job_runner.hpp"

#include <fmt/core.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <map>

#include "model/characterise/process_tree.hpp"
#include "model/characterise/signal_gate.hpp"
#include "model/common/file.hpp"

namespace mixcmp::model {
namespace {

namespace fs = std::filesystem;
using Time = std::chrono::steady_clock;

constexpr const char* failure_file = "failure.txt";
constexpr std::chrono::milliseconds between_looks{500};

std::string replaced(std::string text, const std::string& old_part, const std::string& new_part) {
  for (std::size_t place = 0; (place = text.find(old_part, place)) != std::string::npos;
       place += new_part.size()) {
    text.replace(place, old_part.size(), new_part);
  }
  return text;
}

class JobRunner {
public:
  JobRunner(const std::vector<PendingJob>& jobs, const Device& device, const std::string& tools,
            const fs::path& store, const JobRunOptions& options)
      : jobs_(jobs),
        device_(device),
        tools_(tools),
        store_(fs::absolute(store)),
        work_(store_.string() + ".work"),
        options_(options) {}

  Result<JobRun> run() {
    std::error_code failed;
    fs::create_directories(work_, failed);
    if (failed) return Error{.file = work_.string(), .message = failed.message()};
    while (run_.interrupted_by == 0 && (next_ < jobs_.size() || !running_.empty())) {
      while (next_ < jobs_.size() && running_.size() < options_.workers) {
        MIXCMP_TRY(started, start(jobs_[next_++]));
      }
      const int signal = gate_.wait(between_looks);
      if (signal != SIGCHLD) run_.interrupted_by = signal;
      reap();
      tell();
    }
    end_all();
    fs::remove(work_, failed);  // unless something is kept in it
    return std::move(run_);
  }

  ~JobRunner() { end_all(); }
  JobRunner(const JobRunner&) = delete;
  JobRunner& operator=(const JobRunner&) = delete;

private:
  struct Running {
    const PendingJob* job;
    fs::path directory;
  };

  fs::path kept_directory(const PendingJob& job) const { return work_ / ("failed." + job.hash); }

  Result<Done> start(const PendingJob& job) {
    const fs::path directory = work_ / fmt::format("{}.{}", job.hash, getpid());
    std::error_code failed;
    fs::remove_all(directory, failed);  // of a process that had our number before
    fs::create_directories(directory, failed);
    if (failed) return Error{.file = directory.string(), .message = failed.message()};
    const pid_t child = fork();
    if (child < 0) {
      return Error{.message = fmt::format("no new process: {}", strerror(errno))};
    }
    if (child == 0) {
      setpgid(0, 0);  // an interrupt from the terminal reaches us alone
      gate_.restore();
      setenv("TMPDIR", directory.c_str(), 1);  // what tools leave behind goes with the folder
      _exit(work_in_child(job, directory));
    }
    running_[child] = {&job, directory};
    return Done{};
  }

  int work_in_child(const PendingJob& job, const fs::path& directory) const {
    const Result<Done> done = synthesise_into_store(job, directory);
    if (done.ok()) return 0;
    std::ofstream(directory / failure_file) << done.error().to_string();
    return 1;
  }

  Result<Done> synthesise_into_store(const PendingJob& job, const fs::path& directory) const {
    MIXCMP_TRY(store, ResultStore::open(store_));
    MIXCMP_TRY(known, store.find(job.hash));
    if (known) return Done{};  // another process was faster
    MIXCMP_TRY(result, synthesise(job.job(), device_, options_.synthesis, directory));
    return store.add(job.hash, result, tools_);
  }

  void reap() {
    int status = 0;
    for (pid_t child = 0; (child = waitpid(-1, &status, WNOHANG)) > 0;) {
      const auto found = running_.find(child);
      if (found == running_.end()) continue;
      finish(found->second, status);
      running_.erase(found);
    }
  }

  void finish(const Running& finished, int status) {
    ++run_.done;
    std::error_code ignored;
    const fs::path kept = kept_directory(*finished.job);
    fs::remove_all(kept, ignored);
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) {
      constexpr auto all = fs::copy_options::recursive | fs::copy_options::overwrite_existing;
      if (!options_.keep.empty()) fs::copy(finished.directory, options_.keep, all, ignored);
      fs::remove_all(finished.directory, ignored);
      return;
    }
    fs::rename(finished.directory, kept, ignored);
    const Result<std::string> told = read_file(kept / failure_file);
    const std::string message = told.ok()
                                    ? replaced(*told, finished.directory.string(), kept.string())
                                    : fmt::format("ended by signal {}", WTERMSIG(status));
    run_.failed.push_back({finished.job->label, message, kept});
  }

  void tell() const {
    const std::chrono::duration<double> elapsed = Time::now() - start_time_;
    if (options_.progress) options_.progress(run_.done, elapsed.count());
  }

  /// Of what has not finished nothing remains.
  void end_all() {
    for (const auto& [child, running] : running_) end_process_tree(child);
    for (const auto& [child, running] : running_) {
      waitpid(child, nullptr, 0);
      std::error_code ignored;
      // Another's file may appear while its process ends.
      for (int attempt = 0; attempt < 50 && fs::exists(running.directory, ignored); ++attempt) {
        fs::remove_all(running.directory, ignored);
      }
    }
    running_.clear();
  }

  const std::vector<PendingJob>& jobs_;
  const Device& device_;
  const std::string& tools_;
  const fs::path store_;
  const fs::path work_;
  const JobRunOptions& options_;
  const SignalGate gate_;
  const Time::time_point start_time_ = Time::now();
  std::size_t next_ = 0;
  std::map<pid_t, Running> running_;
  JobRun run_;
};

}  // namespace

Result<JobRun> run_jobs(const std::vector<PendingJob>& jobs, const Device& device,
                        const std::string& tools, const fs::path& store,
                        const JobRunOptions& options) {
  return JobRunner(jobs, device, tools, store, options).run();
}

}  // namespace mixcmp::model
