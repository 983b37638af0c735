#pragma once

#include <cstdint>

namespace mixcmp::performance {

/// Items that a pairwise engine compares with each other, or with those of a second table.
struct ItemSet {
  std::uint64_t items = 0;   ///< N
  std::uint64_t others = 0;  ///< M, of the second table; 0: the items meet each other
};

/// The work of a pairwise engine for one set of items, and the engine's numbers.
struct PairwiseSet {
  std::uint64_t items = 0;   ///< N
  std::uint64_t others = 0;  ///< M, a second table's, met by the items; 0: they meet each other
  int lanes = 1;             ///< p_L
  int segments = 1;
  int lane_latency_cycles = 0;
  /// Reported and undecided pairs of the busiest report stream.
  std::uint64_t exceptions = 0;
  /// Cycles of the busiest second tier: one for each pair that its group leaves undecided, and one
  /// for each other word that it receives; 0 without a second tier.
  std::uint64_t second_tier_cycles = 0;
  std::uint64_t recomputations = 0;
  int references = 0;           ///< p_H; with 0 nothing is recomputed
  int initiation_interval = 1;  ///< of the references
};

/// Cycles in which words enter the chain, one in each. Block b of p_L items meets the N - b p_L
/// items from its first one on. With `others` a block is loaded and then meets the M others.
std::uint64_t pairwise_word_cycles(std::uint64_t items, std::uint64_t others, int lanes);

/// Approximate cycles from a set's first item to its closing beat. It is the way of a word through
/// all segments and the last one's lanes, plus the longest of several needs: words; exceptions (a
/// cycle each); a second tier; recomputations at the items' memory (a cycle each); recomputations
/// at the references (N / p_H cycles each).
double pairwise_cycles(const PairwiseSet& set);

}  // namespace mixcmp::performance
