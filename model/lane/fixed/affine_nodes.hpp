#pragma once

#include <vector>

#include "model/comparison/expression/graph.hpp"

/// A lane with guard digits computes affine nodes with all digits of its operands. Other operations
/// read affine nodes after the cut.
namespace mixcmp::fixed {

/// [node]: whether it consists only of inputs and constants, combined by sums, differences, signs,
/// absolute values, minima, maxima and multiplication by powers of two.
std::vector<bool> affine_nodes(const Graph& graph);

/// The affine nodes that have to be cut, in their order: those that another operation reads, or
/// that are a side of a part whose other side is not affine. Constants are left out.
std::vector<NodeId> nodes_to_cut(const Graph& graph);

/// The affine nodes from which products, squares and quotients of a part are computed, in their
/// order and without constants. They limit the errors of these.
std::vector<NodeId> nodes_in_products(const Graph& graph, const Sides& part);

/// For each part whose sides are both sums of squares, the affine nodes that are squared there.
std::vector<std::vector<NodeId>> nodes_in_norms(const Graph& graph);

}  // namespace mixcmp::fixed
