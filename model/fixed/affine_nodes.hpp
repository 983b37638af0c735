#pragma once

#include <vector>

#include "model/expression/graph.hpp"

/// With guard digits, a lane first computes what is linear in its operands, with all their digits,
/// and cuts it before it enters what is not.
namespace mixcmp::fixed {

/// [node]: whether it is made of inputs and constants by sums, differences, signs, absolute values,
/// minima, maxima and multiplication by powers of two alone.
std::vector<bool> affine_nodes(const Graph& graph);

/// The affine nodes, but constants, that other operations or the sides of a part read: in their
/// order. Parts that are affine on both sides need no cut.
std::vector<NodeId> nodes_to_cut(const Graph& graph);

/// For each part whose sides are both sums of squares, those of `nodes_to_cut` that are squared.
std::vector<std::vector<NodeId>> nodes_in_norms(const Graph& graph);

}  // namespace mixcmp::fixed
