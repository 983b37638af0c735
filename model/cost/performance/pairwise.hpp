#pragma once

#include <cstdint>

namespace mixcmp::performance {

/// Items that a pairwise engine compares with each other, or with those of a second table.
struct ItemSet {
  std::uint64_t items = 0;   ///< N
  std::uint64_t others = 0;  ///< M, of the second table; 0: the items meet each other
};

/// Cycles in which words enter the chain, one in each. Block b of p_L items meets the N - b p_L
/// items from its first one on. With `others` a block is loaded and then meets the M others.
std::uint64_t pairwise_word_cycles(std::uint64_t items, std::uint64_t others, int lanes);

}  // namespace mixcmp::performance
