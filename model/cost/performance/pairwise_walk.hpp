#pragma once

#include <cstdint>
#include <vector>

#include "model/cost/performance/pairwise.hpp"

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

/// The words of a set, or of a sample of it, in the order in which they enter an engine's chain,
/// and the reported pairs that each of them forms in each segment.
struct PairwiseWalk {
  struct Word {
    std::uint64_t needs = 0;  ///< items that have to be loaded before it is read
    int stays = -1;           ///< the segment in which it stays; -1: in none
  };

  int segments = 1;
  std::vector<Word> words;
  /// By segment and word: a simulation reads each segment's words one after the other.
  std::vector<std::uint8_t> counts;
  std::uint64_t pairs = 0;
  std::uint64_t reported = 0;
  std::uint64_t all_words = 0;  ///< of the set

  int count(std::uint64_t word, int segment) const {
    return counts[static_cast<std::uint64_t>(segment) * words.size() + word];
  }
  std::uint64_t passes() const;  ///< how often a word passes a segment
  bool is_sample() const { return words.size() < all_words; }
  double part() const;  ///< of the set's words, 0..1
};

/// Walks a set block by block, as pair_walker.v does. A large set is sampled: 2^18 to 2^19 words
/// divided by segments, in windows of 64 consecutive ones.
PairwiseWalk walk_pairs(const PairwiseData& data, int lanes, int lanes_per_segment);

}  // namespace mixcmp::performance
