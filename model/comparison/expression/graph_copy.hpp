#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "model/comparison/expression/graph.hpp"

namespace mixcmp::inline expression {

/// Copies nodes, and what is known of them, into a graph that has only those, with the same inputs.
class GraphCopy {
public:
  /// Returns the node that takes the place of a node's copy; none: the node is copied.
  using Replace = std::function<std::optional<NodeId>(NodeId id, GraphCopy& copies)>;

  explicit GraphCopy(const Graph& from, Replace replace = {});

  /// The copy of a node.
  NodeId copy(NodeId id);
  /// The sides of all parts.
  std::vector<Sides> copy(std::vector<Sides> parts);
  /// Whether some input has no copy yet.
  bool lacks_an_input() const;
  /// The graph of the copies.
  Graph& to() { return to_; }
  /// The copies as a graph that compares these parts, whose sides are copies. None if nodes whose
  /// limits (`within`) have no number in common have become one node.
  std::optional<Graph> compared(std::vector<Sides> parts) &&;

private:
  NodeId made(NodeId id);

  const Graph& from_;
  Replace replace_;
  Graph to_;
  std::vector<NodeId> copies_;
  bool limits_are_possible_ = true;
};

}  // namespace mixcmp::inline expression
