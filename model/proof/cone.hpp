#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/proof/claims.hpp"

namespace mixcmp::model::proof {

/// A node's claim, to be proven from those of other nodes: every operation between them is an
/// expression of the script, with and without its roundings.
struct Cone {
  const TypedGraph* graph;
  const std::vector<NodeClaim>* claims;
  const std::vector<RangeCheck>* checks;
  NodeId root;
  std::vector<bool> is_leaf;  ///< one a node: taken as its claim says, not as its expression
};

/// Whether Gappa has no operation for this node: a minimum, a maximum, or the absolute value of an
/// inexact operand. Such a node is a leaf of every cone and is proven by lemmas of its own
/// (choice_scripts).
bool is_inexpressible(const TypedGraph& graph, const std::vector<NodeClaim>& claims, NodeId id);

/// The root's whole expression down to inputs, constants and what is not expressible.
Cone whole_cone(const TypedGraph& graph, const std::vector<NodeClaim>& claims,
                const std::vector<RangeCheck>& checks, NodeId root);
/// The root's operation alone.
Cone node_cone(const TypedGraph& graph, const std::vector<NodeClaim>& claims,
               const std::vector<RangeCheck>& checks, NodeId root);

/// Nodes of the cone: operands before users, the root last.
std::vector<NodeId> nodes_of(const Cone& cone);

/// Longest path from an input.
int depth_of(const TypedGraph& graph, NodeId id);

/// Whether a node's operation rounds its result. Conversions, products and squares of few digits do
/// not, which Gappa proves (exactness_script). Multiplying or dividing by a constant power of two
/// does not, either, which is proven by hand (theorem 1): Gappa counts the digits of a product as
/// those of both factors.
enum class OwnRounding { rounds, exact_by_digits, exact_by_hand, not_an_operation };
OwnRounding own_rounding(const TypedGraph& graph, const TypedNode& node);

/// One case: some nodes are zero, the others are not.
struct ConeCase {
  std::string zeros;  ///< "", or which expressions are zero, for a reader
  std::string script;
};

/// Relative errors do not reach through zero in Gappa: one script per combination of zeros that may
/// matter. None where there are more than 2^max_zero_nodes.
constexpr std::size_t max_zero_nodes = 6;
std::optional<std::vector<ConeCase>> cases_of(const Cone& cone);

}  // namespace mixcmp::model::proof
