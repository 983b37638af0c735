#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "model/fixed/fixed_lane.hpp"

namespace mixcmp::fixed {

/// Turns the nodes of an expression into fixed-point ones, operands first, with the format, the
/// enclosure and the error of each.
class FixedGraphBuilder {
public:
  FixedGraphBuilder(const Graph& graph, FloatFormat input_format, const FixedOptions& options);

  /// The fixed-point node of an expression's node.
  Result<NodeId> node(NodeId id);
  /// a - b.
  NodeId difference(NodeId a, NodeId b);
  /// abs(a).
  NodeId magnitude(NodeId a);

  std::vector<FixedNode>& nodes() { return nodes_; }

private:
  /// The error that names a node of the expression and says why fixed point does not have it.
  Error refused(NodeId id, std::string_view why, const char* accepted) const;
  Result<FixedNode> make(NodeId id);  ///< the operands are made already
  Result<FixedNode> input(const Node& node) const;
  FixedNode input_below(int top, bool nonnegative, int index) const;
  FixedNode constant(const mpq_class& value) const;
  Result<FixedNode> square_root(NodeId id) const;
  Result<FixedNode> quotient(NodeId id);
  std::optional<FixedNode> multiple_of_square(const mpq_class& coefficient, NodeId id);
  FixedNode product(NodeId a, NodeId b);
  Result<NodeId> limited(NodeId id, const Range& limits);
  NodeId factor(NodeId id);
  FixedNode operation(Operation operation, NodeId a, NodeId b = -1) const;
  NodeId add(FixedNode node);

  const Graph& graph_;
  FloatFormat input_format_;
  const FixedOptions& options_;
  std::vector<NodeId> known_;  ///< [node of the expression]: its node here, or -1
  std::vector<FixedNode> nodes_;
};

}  // namespace mixcmp::fixed
