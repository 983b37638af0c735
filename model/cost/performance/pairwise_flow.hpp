#pragma once

#include <compare>
#include <cstdint>
#include <memory>
#include <utility>

#include "model/base/common/memo.hpp"
#include "model/cost/performance/pairwise_walk.hpp"
#include "model/scene/engine.hpp"

namespace mixcmp::performance {

/// The numbers of a pairwise engine on which its speed depends.
struct PairwiseEngine {
  int lanes = 1;
  int lanes_per_segment = 8;
  int streams = 1;  ///< of reports, no more than segments
  scene::ReportForm report_as = scene::ReportForm::pairs;
  int lane_latency_cycles = 0;
  double undecided = 0;  ///< part of the pairs that lanes leave undecided
  /// Recomputations that references can start, at most 1. 0: there are none, and undecided pairs
  /// leave as reports.
  double recomputations_per_cycle = 1;
  int reference_latency_cycles = 0;

  friend auto operator<=>(const PairwiseEngine&, const PairwiseEngine&) = default;
};

/// Counts the cycles of pairwise engines on one set of data. A simulation of the engine has all
/// that may hold up a word: the segments' queues of exceptions, the trees that merge them, the
/// streams of reports, the references, and the memory that either stores an item or reads a pair. A
/// mean rate of reports would miss bursts.
///
/// Which pairs are undecided is not known. They are placed beside reported pairs, or evenly if
/// there are more of them; half are taken to be reported. Second tiers are not simulated. Of a
/// large set some words stand for all. docs/theory.md compares the cycles with those of simulated
/// Verilog. Threads may share an object.
class PairwiseFlow {
public:
  explicit PairwiseFlow(std::shared_ptr<const PairwiseData> data);

  double reported_share() const { return reported_share_; }
  double pairs() const { return static_cast<double>(data_->pairs()); }

  /// Cycles from the first item of the set to the closing beat of the last stream.
  double cycles(const PairwiseEngine& engine) const;

private:
  double count_cycles(const PairwiseEngine& engine) const;

  std::shared_ptr<const PairwiseData> data_;
  double reported_share_;
  mutable Memo<PairwiseEngine, double> cycles_;
  /// By the engine's lanes and its lanes of a segment.
  mutable Memo<std::pair<int, int>, PairwiseWalk> walks_;
};

}  // namespace mixcmp::performance
