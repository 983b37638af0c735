#pragma once

#include <cstdint>

namespace mixcmp::performance {

/// What a pairwise engine has to do with one set of items, and with what.
struct PairwiseSet {
  std::uint64_t items = 0;   ///< N
  std::uint64_t others = 0;  ///< M, a second table's, which the items meet; 0: they meet each other
  int lanes = 1;             ///< p_L
  int segments = 1;
  int lane_latency_cycles = 0;
  /// Reported and undecided pairs of the report stream that has most of them.
  std::uint64_t exceptions = 0;
  /// Of the second tier that has most to do: a cycle for each pair that its group leaves undecided,
  /// and one for each other word of which it is told; 0 without a second tier.
  std::uint64_t second_tier_cycles = 0;
  std::uint64_t recomputations = 0;
  int references = 0;           ///< p_H; with 0 nothing is recomputed
  int initiation_interval = 1;  ///< of the references
};

/// Cycles in which words enter the chain, one in each. Block b of p_L items meets the N - b p_L
/// items from its first one on; or it is loaded, and meets the M `others`.
std::uint64_t pairwise_word_cycles(std::uint64_t items, std::uint64_t others, int lanes);

/// Cycles from a set's first item to its closing beat, about: the longest of what words, exceptions
/// (a cycle each), a second tier and recomputations need (a cycle each of the items' memory, N /
/// p_H each of the references), and the way of a word through all segments and the last one's
/// lanes.
double pairwise_cycles(const PairwiseSet& set);

}  // namespace mixcmp::performance
