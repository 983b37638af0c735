#pragma once

#include <cstdint>
#include <vector>

#include "model/lane/fixed/fixed_lane.hpp"

namespace mixcmp::fixed {

/// The most bits of a magnitude whose squares are stored in a memory. For two squares, 2^14 words
/// of 26 bits fill 24 blocks of 18 Kb, more than 1 % of the largest device known here. One more bit
/// would double that.
inline constexpr int most_table_bits = 14;

/// Squares that are read from one memory, each at its own port.
struct SquareTable {
  std::vector<NodeId> squares;  ///< one or two, in the order of the lane's nodes
  int address_bits;             ///< those of the widest operand, or of its magnitude
  int word_bits;                ///< bits of a square that are stored and that some result has
  /// The memory has a word for each operand, not only for each magnitude: nothing removes signs.
  bool has_signed_address;

  friend bool operator==(const SquareTable&, const SquareTable&) = default;
};

/// The bits of the magnitude of a square's operand. The most negative integer of a signed format
/// has one more.
int magnitude_bits(const FixedLane& lane, NodeId square);

/// The bits of the widest magnitude that a lane squares; 0 if it squares none.
int widest_squared_magnitude(const FixedLane& lane);

/// Distributes the squares of a lane among memories with `read_ports` ports (1 or 2), in the order
/// of their first squares. If squares differ in width, the widest two share a memory, then the next
/// two. A memory's size follows its wider square, so this takes the least memory. Words for
/// negative operands are stored where that takes no more blocks of `block_bits` bits.
std::vector<SquareTable> square_tables(const FixedLane& lane, int read_ports, int block_bits);

/// The blocks of `block_bits` bits that a memory takes.
std::int64_t blocks_of(const SquareTable& table, int block_bits);

/// The table that a node reads; null if it reads none.
const SquareTable* table_of(const std::vector<SquareTable>& tables, NodeId node);

}  // namespace mixcmp::fixed
