#pragma once

#include <cstddef>

namespace mixcmp::emulator {

/// The size of a block is a multiple of this: the comparisons in four of the widest vectors.
inline constexpr std::size_t block_granularity = 32;
inline constexpr std::size_t max_block_size = 128;

/// Some comparisons: every node of a graph is a column of doubles, every instruction one loop over
/// columns.
struct Block {
  const double* const* columns;  ///< `size` numbers each
  double* const* results;        ///< the same columns, where instructions write
  std::size_t size;              ///< a multiple of block_granularity
};

}  // namespace mixcmp::emulator
