#include "generator/synthesis/characterise/job_runner.hpp"

#include <fmt/core.h>

#include <atomic>
#include <exception>
#include <filesystem>
#include <mutex>
#include <system_error>
#include <thread>

#include "generator/synthesis/characterise/signal_gate.hpp"
#include "model/base/common/folder_lock.hpp"
#include "model/base/common/output_file.hpp"
#include "model/base/common/scratch_folder.hpp"

namespace mixcmp::characterise {
namespace {

namespace fs = std::filesystem;
using Time = std::chrono::steady_clock;

constexpr std::chrono::milliseconds between_looks{100};

std::string replaced(std::string text, const std::string& old_part, const std::string& new_part) {
  for (std::size_t place = 0; (place = text.find(old_part, place)) != std::string::npos;
       place += new_part.size()) {
    text.replace(place, old_part.size(), new_part);
  }
  return text;
}

/// Copies a folder to `kept`, replacing one that an earlier run of the same job left there.
Result<Done> copy_in_place_of(const fs::path& folder, const fs::path& kept) {
  MIXCMP_TRY(staging, ScratchFolder::make_in(kept.parent_path(), "staging"));
  MIXCMP_DO(copy_folder(folder, staging.path()));
  return put_folder_in_place(staging.path(), kept);
}

class JobRunner {
public:
  JobRunner(const std::vector<PendingJob>& jobs, const devices::Device& device,
            const std::string& tools, const fs::path& store, const JobRunOptions& options)
      : jobs_(jobs),
        device_(device),
        tools_(tools),
        store_(fs::absolute(store)),
        work_(store_.string() + ".work"),
        options_(options) {}

  Result<JobRun> run() {
    MIXCMP_TRY(made, make_writable_folder(work_));
    std::vector<std::jthread> workers;
    try {
      while (workers.size() < options_.workers) {
        ++working_;
        workers.emplace_back([this] { work(); });
      }
    } catch (const std::system_error& refusal) {
      --working_;
      if (workers.empty()) return Error{.message = refusal.what(), .accepted = "fewer --jobs"};
    }
    while (working_ > 0) {
      if (const int signal = gate_.wait(between_looks); signal != 0) interrupt(signal);
      tell();
    }
    workers.clear();
    std::error_code kept;
    fs::remove(work_, kept);  // fails if something is kept in it
    return std::move(run_);
  }

private:
  void work() {
    while (const PendingJob* job = next()) do_one(*job);
    --working_;
  }

  const PendingJob* next() {
    const std::lock_guard lock(mutex_);
    return cancelled_ || next_ == jobs_.size() ? nullptr : &jobs_[next_++];
  }

  void interrupt(int signal) {
    const std::lock_guard lock(mutex_);
    run_.interrupted_by = signal;
    cancelled_ = true;
  }

  void do_one(const PendingJob& job) {
    const Result<ScratchFolder> folder = job_folder();
    if (!folder.ok()) return finish(job, folder.error(), {});
    const fs::path kept = work_ / ("failed." + job.hash);
    std::error_code ignored;
    fs::remove_all(kept, ignored);
    const Result<Done> done = guarded(job, folder->path());
    if (done.ok() || cancelled_) return finish(job, done, {});
    fs::rename(folder->path(), kept, ignored);
    Error error = done.error();
    error.file = replaced(error.file, folder->path().string(), kept.string());
    error.message = replaced(error.message, folder->path().string(), kept.string());
    finish(job, error, kept);
  }

  /// Makes a folder for one job. Tries again if another run, at its end, has removed the empty
  /// STORE.work between two steps of this one.
  Result<ScratchFolder> job_folder() const {
    while (true) {
      MIXCMP_TRY(made, make_writable_folder(work_));
      Result<ScratchFolder> folder = ScratchFolder::make_in(work_, "job");
      if (folder.ok() || fs::exists(work_)) return folder;
    }
  }

  /// Turns exceptions into errors, since none may leave a thread: unexpected JSON from a tool fails
  /// only that job.
  Result<Done> guarded(const PendingJob& job, const fs::path& folder) {
    try {
      return synthesise_into_store(job, folder);
    } catch (const std::exception& failure) {
      return Error{.file = folder.string(),
                   .message = fmt::format("a tool left what cannot be read: {}", failure.what())};
    }
  }

  Result<Done> synthesise_into_store(const PendingJob& job, const fs::path& folder) {
    MIXCMP_TRY(store, ResultStore::open(store_));
    MIXCMP_TRY(known, store.find(job.hash));
    if (known) return Done{};  // another process was faster
    SynthesisOptions synthesis = options_.synthesis;
    synthesis.each_tool.cancelled = &cancelled_;
    const auto result = synthesise(make(job), device_, synthesis, folder);
    if (!options_.keep.empty() && !cancelled_) {
      MIXCMP_DO(copy_in_place_of(folder, options_.keep));
    }
    if (!result.ok()) return result.error();
    // The signal that interrupts this run may also have ended a tool, and a tool's end may look
    // like an answer.
    if (cancelled_) return Error{.message = "interrupted"};
    return store.add(job.hash, *result, tools_);
  }

  /// Makes one job at a time, since the functions that make jobs share data.
  SynthesisJob make(const PendingJob& job) {
    const std::lock_guard lock(mutex_);
    return job.job();
  }

  void finish(const PendingJob& job, const Result<Done>& done, const fs::path& kept) {
    const std::lock_guard lock(mutex_);
    if (!done.ok() && cancelled_) return;
    ++run_.done;
    if (!done.ok()) run_.failed.push_back({job.label, done.error().to_string(), kept});
  }

  void tell() {
    const std::lock_guard lock(mutex_);
    const std::chrono::duration<double> elapsed = Time::now() - start_time_;
    if (options_.progress) options_.progress(run_.done, elapsed.count());
  }

  const std::vector<PendingJob>& jobs_;
  const devices::Device& device_;
  const std::string& tools_;
  const fs::path store_;
  const fs::path work_;
  const JobRunOptions& options_;
  const SignalGate gate_;  ///< made before the workers, which inherit the blocked signals
  const Time::time_point start_time_ = Time::now();
  std::atomic<unsigned> working_ = 0;
  std::atomic<bool> cancelled_ = false;
  std::mutex mutex_;  ///< guards the members below
  std::size_t next_ = 0;
  JobRun run_;
};

}  // namespace

Result<JobRun> run_jobs(const std::vector<PendingJob>& jobs, const devices::Device& device,
                        const std::string& tools, const fs::path& store,
                        const JobRunOptions& options) {
  return JobRunner(jobs, device, tools, store, options).run();
}

}  // namespace mixcmp::characterise
