#include "model/lane/fixed/square_tables.hpp"

#include <algorithm>

namespace mixcmp::fixed {
namespace {

/// Bits 0 and 1 of a square need no memory.
constexpr int free_bits = 2;

SquareTable table_for(const FixedLane& lane, std::vector<NodeId> squares) {
  std::sort(squares.begin(), squares.end());
  SquareTable table{.squares = std::move(squares), .address_bits = 0, .word_bits = 0};
  int low = lane.nodes[table.squares.front()].dropped_bits, high = 0;
  for (const NodeId id : table.squares) {
    const FixedNode& node = lane.nodes[id];
    table.address_bits = std::max(table.address_bits, magnitude_bits(lane, id));
    low = std::min(low, node.dropped_bits);
    high = std::max(high, node.dropped_bits + node.format.width);
  }
  const int kept = std::min(high, 2 * table.address_bits) - std::max(low, free_bits);
  table.word_bits = std::max(1, kept);
  return table;
}

}  // namespace

int magnitude_bits(const FixedLane& lane, NodeId square) {
  return lane.nodes[lane.nodes[square].operands[0]].format.magnitude_bits();
}

std::vector<SquareTable> square_tables(const FixedLane& lane, int read_ports) {
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
    tables.push_back(table_for(lane, {first, last}));
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
