#pragma once

#include <vector>

#include "model/lane/error/bound_graph.hpp"

namespace mixcmp::error {

/// Index of a bound node, or no_bound_node for a bound of zero, which needs no node.
using BoundId = int;
constexpr BoundId no_bound_node = -1;

/// Builds bound graphs. Equal nodes are merged, constants are folded and zeros are dropped.
class BoundGraphBuilder {
public:
  BoundId constant(const mpq_class& value);
  BoundId of_value(BoundOperation operation, NodeId value);
  BoundId add(BoundId a, BoundId b);
  BoundId multiply(BoundId a, BoundId b);
  BoundId maximum(BoundId a, BoundId b);
  BoundId scale(BoundId a, const mpq_class& factor) { return multiply(a, constant(factor)); }

  const std::vector<BoundNode>& nodes() const { return nodes_; }

private:
  const mpq_class* constant_of(BoundId id) const;
  BoundId intern(BoundNode node);

  std::vector<BoundNode> nodes_;
};

}  // namespace mixcmp::error
