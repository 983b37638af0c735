#pragma once

#include <optional>
#include <vector>

#include "model/comparison/expression/graph.hpp"

namespace mixcmp::fixed {

struct SumOfSquares {
  std::vector<NodeId> elements;  ///< the numbers that are squared
  std::vector<NodeId> results;   ///< the squares and the additions, the whole sum last
};

/// A node of an expression or of a lane as a sum of squares, which may be a single square; none if
/// the node is neither.
template <class Node>
std::optional<SumOfSquares> sum_of_squares(const std::vector<Node>& nodes, NodeId sum) {
  const auto& [first, second] = nodes[sum].operands;
  if (nodes[sum].operation == Operation::square) return SumOfSquares{{first}, {sum}};
  if (nodes[sum].operation != Operation::add) return std::nullopt;
  std::optional<SumOfSquares> whole = sum_of_squares(nodes, first);
  const std::optional<SumOfSquares> other = sum_of_squares(nodes, second);
  if (!whole || !other) return std::nullopt;
  whole->elements.insert(whole->elements.end(), other->elements.begin(), other->elements.end());
  whole->results.insert(whole->results.end(), other->results.begin(), other->results.end());
  whole->results.push_back(sum);
  return whole;
}

}  // namespace mixcmp::fixed
