#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "protocol.hpp"

namespace mixcmp::harness {

/// Records the results and violations since the last response.
class Recorder {
public:
  void result(const wire::Result& result) {
    results_.push_back(result);
    last_result_cycle_ = result.cycle_left;
  }

  void violation(const wire::Violation& violation) {
    if (full()) return;
    violations_.push_back(violation);
    ++violation_count_;
  }

  /// Tells whether max_violations were seen.
  bool full() const { return violation_count_ >= wire::max_violations; }

  std::uint64_t last_result_cycle() const { return last_result_cycle_; }
  std::vector<wire::Result> take_results() { return std::exchange(results_, {}); }
  std::vector<wire::Violation> take_violations() { return std::exchange(violations_, {}); }

private:
  std::vector<wire::Result> results_;
  std::vector<wire::Violation> violations_;
  std::uint64_t violation_count_ = 0;
  std::uint64_t last_result_cycle_ = 0;
};

}  // namespace mixcmp::harness
