#pragma once

#include <vector>

#include "model/expression/typed_graph.hpp"

namespace mixcmp::inline expression {

/// The typed graphs of a comparison's parts, at least one, all over the same inputs, in the same
/// arithmetic.
struct CombinedGraph {
  Combination combination = Combination::all;
  std::vector<TypedGraph> parts;

  CombinedGraph(Combination combined, std::vector<TypedGraph> graphs);
  /// Makes the graph of a comparison of one part.
  CombinedGraph(TypedGraph only) : CombinedGraph(Combination::all, {std::move(only)}) {}

  const Arithmetic& arithmetic() const { return parts.front().arithmetic; }
  FloatFormat input_format() const { return parts.front().input_format; }
  int input_count() const { return parts.front().input_count; }
};

/// Call reference_graph or lane_graph for every part.
CombinedGraph reference_graphs(const Graph& graph, Arithmetic reference);
CombinedGraph lane_graphs(const Graph& graph, FloatFormat reference, Arithmetic reduced,
                          LaneInputs inputs);

/// All parts in one graph, in which equal operations share one node, as hardware builds them. The
/// nodes of the first part keep their numbers, so that the graph of a single part does not change.
struct SharedGraph {
  TypedGraph graph;  ///< its f and g are those of the first part
  std::vector<Sides> sides;
  std::vector<std::vector<NodeId>> ids;  ///< [part][node of that part]: the node in `graph`
};
SharedGraph share(const CombinedGraph& graph);

}  // namespace mixcmp::inline expression
