#pragma once

#include <cstdint>
#include <functional>

namespace mixcmp::model {

/// How a job is split; results must not depend on it.
struct WorkSplit {
  std::uint64_t size = 0;   ///< items 0 .. size - 1
  std::uint64_t block = 1;  ///< treated together
  unsigned threads = 0;     ///< 0: as many as the machine has
  std::function<void(double)> progress = {};
};

/// Takes blocks until none is left: next(first, count) is false at the end.
using BlockSource = std::function<bool(std::uint64_t& first, std::uint64_t& count)>;

/// Runs `work` once a thread. What it throws ends all and is thrown again.
void run_workers(const WorkSplit& split, const std::function<void(const BlockSource&)>& work);

}  // namespace mixcmp::model
