#include "model/base/common/workers.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace mixcmp::inline common {
namespace {

class Job {
public:
  explicit Job(const WorkSplit& split) : split_(split) {}

  bool next(std::uint64_t& first, std::uint64_t& count) {
    first = next_.fetch_add(split_.block);
    if (failed_ || first >= split_.size) return false;
    count = std::min(split_.block, split_.size - first);
    report(first);
    return true;
  }

  void fail(std::exception_ptr failure) {
    const std::lock_guard lock(mutex_);
    if (!failed_) failure_ = std::move(failure);
    failed_ = true;
  }

  void finish() const {
    if (failure_) std::rethrow_exception(failure_);
  }

private:
  /// Reports progress in steps of at least one percent; reports out of order are dropped.
  void report(std::uint64_t first) {
    if (!split_.progress) return;
    const std::lock_guard lock(mutex_);
    const double share = static_cast<double>(first) / static_cast<double>(split_.size);
    if (share < told_ + 0.01) return;
    told_ = share;
    split_.progress(share);
  }

  const WorkSplit& split_;
  std::atomic<std::uint64_t> next_ = 0;
  std::atomic<bool> failed_ = false;
  std::mutex mutex_;
  std::exception_ptr failure_;
  double told_ = -1;  ///< of the last report; below 0: there was none
};

}  // namespace

void run_workers(const WorkSplit& split, const std::function<void(const BlockSource&)>& work) {
  Job job(split);
  const auto run = [&] {
    try {
      work([&](std::uint64_t& first, std::uint64_t& count) { return job.next(first, count); });
    } catch (...) {
      job.fail(std::current_exception());
    }
  };
  const unsigned wanted = split.threads != 0 ? split.threads : std::thread::hardware_concurrency();
  const std::uint64_t blocks = (split.size + split.block - 1) / split.block;
  const std::uint64_t count =
      std::clamp<std::uint64_t>(wanted, 1, std::max<std::uint64_t>(blocks, 1));
  std::vector<std::jthread> others;
  try {
    for (std::uint64_t k = 1; k < count; ++k) others.emplace_back(run);
  } catch (const std::system_error&) {
    // The system gives no more threads. The running ones take all blocks; results do not depend on
    // it.
  }
  run();
  others.clear();
  job.finish();
}

Result<Done> for_each_in_threads(const WorkSplit& split,
                                 const std::function<Result<Done>(std::uint64_t)>& work) {
  std::mutex mutex;
  std::optional<std::pair<std::uint64_t, Error>> lowest;  // with its item
  // Blocks are taken in rising order: those below an error's item have been taken before it.
  const auto is_needed = [&](std::uint64_t item) {
    const std::lock_guard lock(mutex);
    return !lowest || item < lowest->first;
  };
  run_workers(split, [&](const BlockSource& next) {
    std::uint64_t first = 0, count = 0;
    while (next(first, count)) {
      for (std::uint64_t item = first; item < first + count; ++item) {
        if (!is_needed(item)) return;
        const Result<Done> done = work(item);
        if (done.ok()) continue;
        const std::lock_guard lock(mutex);
        if (!lowest || item < lowest->first) lowest.emplace(item, done.error());
        return;
      }
    }
  });
  return lowest ? Result<Done>(lowest->second) : Done{};
}

}  // namespace mixcmp::inline common
