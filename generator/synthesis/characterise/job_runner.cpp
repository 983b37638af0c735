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

class WorkRunner {
public:
  using Progress = std::function<void(int finished, double seconds)>;

  WorkRunner(const std::vector<Work>& all, const fs::path& place, const Progress& progress)
      : all_(all), place_(place), progress_(progress) {}

  Result<JobRun> run(unsigned count) {
    MIXCMP_TRY(made, make_writable_folder(place_));
    std::vector<std::jthread> workers;
    try {
      while (workers.size() < count) {
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
    fs::remove(place_, kept);  // fails if something is kept in it
    return std::move(run_);
  }

private:
  void work() {
    while (const Work* work = next()) do_one(*work);
    --working_;
  }

  const Work* next() {
    const std::lock_guard lock(mutex_);
    return cancelled_ || next_ == all_.size() ? nullptr : &all_[next_++];
  }

  void interrupt(int signal) {
    const std::lock_guard lock(mutex_);
    run_.interrupted_by = signal;
    cancelled_ = true;
  }

  void do_one(const Work& work) {
    const Result<ScratchFolder> folder = work_folder();
    if (!folder.ok()) return finish(work, folder.error(), {});
    const fs::path kept = place_ / ("failed." + work.name);
    std::error_code ignored;
    fs::remove_all(kept, ignored);
    const Result<Done> done = guarded(work, folder->path());
    if (done.ok() || cancelled_) return finish(work, done, {});
    fs::rename(folder->path(), kept, ignored);
    Error error = done.error();
    error.file = replaced(error.file, folder->path().string(), kept.string());
    error.message = replaced(error.message, folder->path().string(), kept.string());
    finish(work, error, kept);
  }

  /// Makes a folder for one piece of work. Tries again if another run, at its end, has removed the
  /// empty place between two steps of this one.
  Result<ScratchFolder> work_folder() const {
    while (true) {
      MIXCMP_TRY(made, make_writable_folder(place_));
      Result<ScratchFolder> folder = ScratchFolder::make_in(place_, "job");
      if (folder.ok() || fs::exists(place_)) return folder;
    }
  }

  /// Turns exceptions into errors, since none may leave a thread: unexpected JSON from a tool fails
  /// only that work.
  Result<Done> guarded(const Work& work, const fs::path& folder) {
    try {
      return work.run(folder, cancelled_);
    } catch (const std::exception& failure) {
      return Error{.file = folder.string(),
                   .message = fmt::format("a tool left what cannot be read: {}", failure.what())};
    }
  }

  void finish(const Work& work, const Result<Done>& done, const fs::path& kept) {
    const std::lock_guard lock(mutex_);
    if (!done.ok() && cancelled_) return;
    ++run_.done;
    if (!done.ok()) run_.failed.push_back({work.label, done.error().to_string(), kept});
  }

  void tell() {
    const std::lock_guard lock(mutex_);
    const std::chrono::duration<double> elapsed = Time::now() - start_time_;
    if (progress_) progress_(run_.done, elapsed.count());
  }

  const std::vector<Work>& all_;
  const fs::path& place_;
  const Progress& progress_;
  const SignalGate gate_;  ///< made before the workers, which inherit the blocked signals
  const Time::time_point start_time_ = Time::now();
  std::atomic<unsigned> working_ = 0;
  std::atomic<bool> cancelled_ = false;
  std::mutex mutex_;  ///< guards the members below
  std::size_t next_ = 0;
  JobRun run_;
};

/// The inputs that all jobs of a run share.
struct JobContext {
  const devices::Device& device;
  const std::string& tools;
  const fs::path store;
  const JobRunOptions& options;
  std::mutex making = {};  ///< the functions that make jobs share data: one makes a job at a time

  SynthesisJob make(const PendingJob& job) {
    const std::lock_guard lock(making);
    return job.job();
  }
};

Result<Done> synthesise_into_store(const PendingJob& job, JobContext& context,
                                   const fs::path& folder, const std::atomic<bool>& cancelled) {
  MIXCMP_TRY(store, ResultStore::open(context.store));
  MIXCMP_TRY(known, store.find(job.hash));
  if (known) return Done{};  // another process was faster
  SynthesisOptions synthesis = context.options.synthesis;
  synthesis.each_tool.cancelled = &cancelled;
  const auto result = synthesise(context.make(job), context.device, synthesis, folder);
  if (!context.options.keep.empty() && !cancelled) {
    MIXCMP_DO(copy_in_place_of(folder, context.options.keep));
  }
  if (!result.ok()) return result.error();
  // The signal that interrupts this run may also have ended a tool, and a tool's end may look like
  // an answer.
  if (cancelled) return Error{.message = "interrupted"};
  return store.add(job.hash, *result, context.tools);
}

}  // namespace

Result<JobRun> run_work(const std::vector<Work>& all, const fs::path& place, unsigned workers,
                        const std::function<void(int finished, double seconds)>& progress) {
  return WorkRunner(all, place, progress).run(workers);
}

Result<JobRun> run_jobs(const std::vector<PendingJob>& jobs, const devices::Device& device,
                        const std::string& tools, const fs::path& store,
                        const JobRunOptions& options) {
  JobContext context{device, tools, fs::absolute(store), options};
  std::vector<Work> all;
  for (const PendingJob& job : jobs) {
    all.push_back({job.hash, job.label, [&](const fs::path& folder, const auto& cancelled) {
                     return synthesise_into_store(job, context, folder, cancelled);
                   }});
  }
  return run_work(all, context.store.string() + ".work", options.workers, options.progress);
}

}  // namespace mixcmp::characterise
