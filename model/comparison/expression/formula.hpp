#pragma once

#include <compare>
#include <optional>
#include <vector>

#include "model/comparison/expression/graph.hpp"
#include "model/comparison/expression/range.hpp"

namespace mixcmp::inline expression {

/// An expression of one variable.
struct Formula {
  /// In topological order: the variable is the only Operation::input, the last node the value.
  std::vector<Node> nodes;
  std::optional<Range> arguments = {};  ///< where there is a value; none: everywhere

  NodeId value() const { return static_cast<NodeId>(nodes.size()) - 1; }
  friend bool operator==(const Formula& a, const Formula& b) { return (a <=> b) == 0; }
  friend std::strong_ordering operator<=>(const Formula& a, const Formula& b);
};

}  // namespace mixcmp::inline expression
