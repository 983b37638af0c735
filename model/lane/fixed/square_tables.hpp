#pragma once

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
  int address_bits;             ///< those of the widest magnitude
  int word_bits;                ///< bits of a square that are stored and that some result has

  friend bool operator==(const SquareTable&, const SquareTable&) = default;
};

/// The bits of the magnitude of a square's operand. The most negative integer of a signed format
/// has one more.
int magnitude_bits(const FixedLane& lane, NodeId square);

/// Distributes the squares of a lane among memories with `read_ports` ports (1 or 2), in the order
/// of their first squares. If squares differ in width, the widest two share a memory, then the next
/// two. A memory's size follows its wider square, so this takes the least memory.
std::vector<SquareTable> square_tables(const FixedLane& lane, int read_ports);

/// The table that a node reads; null if it reads none.
const SquareTable* table_of(const std::vector<SquareTable>& tables, NodeId node);

}  // namespace mixcmp::fixed
