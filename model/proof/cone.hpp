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

/// Gappa has no word for it: minima, maxima, and absolutes of inexact operands. They are leaves of
/// every cone, and have lemmas of their own.
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

/// Whether a node rounds. Multiplying by, or dividing by, a constant power of two does not, by hand
/// (theorem 1): Gappa counts the digits of a product as those of both factors. Of conversions,
/// products and squares of few digits it is proven: exactness_script.
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
