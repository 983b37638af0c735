#pragma once

#include <cstdint>
#include <functional>

namespace mixcmp::profile {

/// How a job is split; results must not depend on it.
struct WorkSplit {
  std::uint64_t size = 0;   ///< items 0 .. size - 1
  std::uint64_t block = 1;  ///< items per block
  unsigned threads = 0;     ///< 0: as many as the machine has
  std::function<void(double)> progress = {};
};

/// Takes the next block of items; false if none is left.
using BlockSource = std::function<bool(std::uint64_t& first, std::uint64_t& count)>;

/// Runs `work` once per thread. An exception in one thread stops the others and is rethrown.
void run_workers(const WorkSplit& split, const std::function<void(const BlockSource&)>& work);

}  // namespace mixcmp::profile
