#pragma once

#include <cstdint>
#include <functional>

#include "model/base/common/result.hpp"

namespace mixcmp::inline common {

/// How a job is split; results must not depend on it.
struct WorkSplit {
  std::uint64_t size = 0;   ///< items 0 .. size - 1
  std::uint64_t block = 1;  ///< items per block
  unsigned threads = 0;     ///< 0: as many as the machine has
  /// Called with the part that has been taken, which rises by at least one percent from call to
  /// call: from any of the threads, but from one at a time.
  std::function<void(double)> progress = {};
};

/// Takes the next block of items; false if none is left.
using BlockSource = std::function<bool(std::uint64_t& first, std::uint64_t& count)>;

/// Runs `work` once per thread. An exception in one thread stops the others and is rethrown.
void run_workers(const WorkSplit& split, const std::function<void(const BlockSource&)>& work);

/// Does `work` for each item, in threads that take the items in rising order. After an error no
/// further item is taken. Returns the error of the lowest item, as a loop in one thread would.
Result<Done> for_each_in_threads(const WorkSplit& split,
                                 const std::function<Result<Done>(std::uint64_t)>& work);

}  // namespace mixcmp::inline common
