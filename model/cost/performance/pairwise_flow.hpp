#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <mutex>
#include <vector>

#include "model/cost/performance/pairwise.hpp"
#include "model/scene/engine.hpp"

namespace mixcmp::performance {

/// The pairs of a set of items, and which of them an engine reports.
struct PairwiseData {
  ItemSet set;
  /// Bit k % 64 of element k / 64 is 1 if pair k is reported; pairs have the order of
  /// data::Comparisons. Empty: none is.
  std::vector<std::uint64_t> reported = {};

  std::uint64_t pairs() const;
  double reported_share() const;  ///< 0..1
};

/// What decides how fast words pass the lanes of a pairwise engine.
struct PairwiseEngine {
  int lanes = 1;
  int lanes_per_segment = 8;
  int streams = 1;  ///< of reports, no more than segments
  scene::ReportForm report_as = scene::ReportForm::pairs;
  int lane_latency_cycles = 0;
  double undecided = 0;                 ///< part of the pairs that lanes leave undecided
  double recomputations_per_cycle = 1;  ///< that references can start, above 0 and at most 1

  friend auto operator<=>(const PairwiseEngine&, const PairwiseEngine&) = default;
};

/// Counts the cycles of pairwise engines on one set of data, by a simulation of what can hold up a
/// word: the segments' queues of exceptions, the trees that merge them, the streams of reports, the
/// references, and the memory that either stores an item or reads a pair. So bursts of reports
/// count, which a mean rate of reports does not tell. Where lanes leave pairs undecided, these are
/// taken to lie among the reported ones, half of them reported; docs/theory.md compares the result
/// with simulated Verilog. A set of many words is sampled. Threads may share an object.
class PairwiseFlow {
public:
  explicit PairwiseFlow(PairwiseData data);

  const ItemSet& set() const { return data_.set; }
  double reported_share() const { return reported_share_; }
  double pairs() const { return static_cast<double>(data_.pairs()); }

  /// Cycles from the first item of the set to the last report.
  double cycles(const PairwiseEngine& engine) const;

private:
  PairwiseData data_;
  double reported_share_;
  mutable std::mutex mutex_;
  mutable std::map<PairwiseEngine, double> known_;
};

}  // namespace mixcmp::performance
