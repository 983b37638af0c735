#pragma once

#include <cstddef>

namespace mixcmp::emulator {

/// The size of a block is a multiple of this: as many comparisons as four of the widest vectors
/// hold.
inline constexpr std::size_t block_granularity = 32;
inline constexpr std::size_t max_block_size = 128;

/// Some comparisons: every node of a graph is a column of doubles, every instruction one loop over
/// columns.
struct Block {
  const double* const* columns;  ///< `size` numbers each
  double* const* results;        ///< the same columns, for instructions to write
  std::size_t size;              ///< a multiple of block_granularity
};

}  // namespace mixcmp::emulator
