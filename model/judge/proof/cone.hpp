#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/judge/proof/claims.hpp"

namespace mixcmp::proof {

/// A subgraph for proving its root's claim from the claims of its leaves. Every operation between
/// them becomes an expression of the script, with and without its rounding.
struct Cone {
  const TypedGraph* graph;
  const std::vector<NodeClaim>* claims;
  const std::vector<error::RangeCheck>* checks;
  NodeId root;
  std::vector<bool> is_leaf;  ///< per node: its claim stands for its expression
};

/// Whether Gappa has no operation for this node: a minimum, a maximum, or the absolute value of an
/// inexact operand. This node is then a leaf of every cone, and lemmas of its own prove it
/// (choice_scripts).
bool is_inexpressible(const TypedGraph& graph, const std::vector<NodeClaim>& claims, NodeId id);

/// The cone of the root's whole expression, down to inputs, constants and inexpressible nodes.
Cone whole_cone(const TypedGraph& graph, const std::vector<NodeClaim>& claims,
                const std::vector<error::RangeCheck>& checks, NodeId root);
/// The cone of only the root's operation.
Cone node_cone(const TypedGraph& graph, const std::vector<NodeClaim>& claims,
               const std::vector<error::RangeCheck>& checks, NodeId root);

/// Nodes of the cone: operands before users, the root last.
std::vector<NodeId> nodes_of(const Cone& cone);

/// The number of operations on the longest path from an input or constant.
int depth_of(const TypedGraph& graph, NodeId id);

/// The most digits of an operand of the node, by the formats in which inputs arrive. The lane's own
/// count, TypedNode::operand_digits, is not believed here.
int digits_of_operands(const TypedGraph& graph, const TypedNode& node);

/// Whether a node's operation rounds its result. Conversions, products and squares of few digits
/// round nothing, and Gappa proves that (exactness_script). A multiplication or division by a
/// constant power of two rounds nothing, and that is proven by hand (docs/error_bounds.md, theorem
/// 1): Gappa counts the digits of a product as those of both factors.
enum class OwnRounding { rounds, exact_by_digits, exact_by_hand, never_rounds };
OwnRounding own_rounding(const TypedGraph& graph, const TypedNode& node);

/// The script for one combination of nodes that are zero.
struct ConeCase {
  std::string zeros;  ///< the expressions that are zero, for a reader; may be empty
  std::string script;
};

/// Gappa's relative errors say nothing about zero, so each combination of zeros that may matter has
/// a script of its own. There are no scripts if there may be more than 2^max_zero_nodes
/// combinations.
constexpr std::size_t max_zero_nodes = 6;
std::optional<std::vector<ConeCase>> cases_of(const Cone& cone);

}  // namespace mixcmp::proof
