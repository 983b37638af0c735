#include "model/lane/fixed/square_tables.hpp"

#include <algorithm>

namespace mixcmp::fixed {
namespace {

/// Bits 0 and 1 of a square need no memory.
constexpr int free_bits = 2;

/// The bits of squares that are stored: those that some result has, but no more than `most`.
int stored_bits(const FixedLane& lane, const std::vector<NodeId>& squares, int most) {
  int low = lane.nodes[squares.front()].dropped_bits, high = 0;
  for (const NodeId id : squares) {
    const FixedNode& node = lane.nodes[id];
    low = std::min(low, node.dropped_bits);
    high = std::max(high, node.dropped_bits + node.format.width);
  }
  return std::max(1, std::min(high, most) - std::max(low, free_bits));
}

bool has_sign(const FixedLane& lane, NodeId square) {
  return lane.nodes[lane.nodes[square].operands[0]].format.is_signed;
}

SquareTable table_for(const FixedLane& lane, std::vector<NodeId> squares, int block_bits) {
  std::sort(squares.begin(), squares.end());
  int bits = 0;
  bool is_signed = false;
  for (const NodeId id : squares) {
    bits = std::max(bits, magnitude_bits(lane, id));
    is_signed = is_signed || has_sign(lane, id);
  }
  SquareTable table{.squares = squares,
                    .address_bits = bits,
                    .word_bits = stored_bits(lane, squares, 2 * bits),
                    .has_signed_address = false};
  if (!is_signed) return table;
  SquareTable longer{.squares = std::move(squares),
                     .address_bits = bits + 1,
                     .word_bits = stored_bits(lane, table.squares, 2 * bits + 1),
                     .has_signed_address = true};
  return blocks_of(longer, block_bits) == blocks_of(table, block_bits) ? longer : table;
}

}  // namespace

int magnitude_bits(const FixedLane& lane, NodeId square) {
  return lane.nodes[lane.nodes[square].operands[0]].format.magnitude_bits();
}

int widest_squared_magnitude(const FixedLane& lane) {
  int widest = 0;
  for (NodeId id = 0; id < static_cast<NodeId>(lane.nodes.size()); ++id) {
    if (lane.nodes[id].operation == Operation::square) {
      widest = std::max(widest, magnitude_bits(lane, id));
    }
  }
  return widest;
}

std::int64_t blocks_of(const SquareTable& table, int block_bits) {
  const std::int64_t bits = std::int64_t{table.word_bits} << table.address_bits;
  return (bits + block_bits - 1) / block_bits;
}

std::vector<SquareTable> square_tables(const FixedLane& lane, int read_ports, int block_bits) {
  std::vector<NodeId> squares;
  for (NodeId id = 0; id < static_cast<NodeId>(lane.nodes.size()); ++id) {
    if (lane.nodes[id].operation == Operation::square) squares.push_back(id);
  }
  std::stable_sort(squares.begin(), squares.end(), [&](NodeId a, NodeId b) {
    return magnitude_bits(lane, a) > magnitude_bits(lane, b);
  });
  std::vector<SquareTable> tables;
  for (auto first = squares.begin(); first != squares.end();) {
    const auto last = first + std::min<std::ptrdiff_t>(read_ports, squares.end() - first);
    tables.push_back(table_for(lane, {first, last}, block_bits));
    first = last;
  }
  std::sort(tables.begin(), tables.end(), [](const SquareTable& a, const SquareTable& b) {
    return a.squares.front() < b.squares.front();
  });
  return tables;
}

const SquareTable* table_of(const std::vector<SquareTable>& tables, NodeId node) {
  for (const SquareTable& table : tables) {
    const auto& squares = table.squares;
    if (std::find(squares.begin(), squares.end(), node) != squares.end()) return &table;
  }
  return nullptr;
}

}  // namespace mixcmp::fixed
