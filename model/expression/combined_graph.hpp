#pragma once

#include <vector>

#include "model/expression/typed_graph.hpp"

namespace mixcmp::model {

/// The typed graphs of a comparison's parts, at least one, all over the same inputs, in the same
/// arithmetic.
struct CombinedGraph {
  Combination combination = Combination::all;
  std::vector<TypedGraph> parts;

  CombinedGraph(Combination combined, std::vector<TypedGraph> graphs);
  /// A comparison of one part is that part.
  CombinedGraph(TypedGraph only) : CombinedGraph(Combination::all, {std::move(only)}) {}

  const Arithmetic& arithmetic() const { return parts.front().arithmetic; }
  FloatFormat input_format() const { return parts.front().input_format; }
  int input_count() const { return parts.front().input_count; }
};

/// reference_graph and lane_graph of every part.
CombinedGraph reference_graphs(const Graph& graph, Arithmetic reference);
CombinedGraph lane_graphs(const Graph& graph, FloatFormat reference, Arithmetic reduced,
                          LaneInputs inputs);

/// All parts in one graph, in which equal operations are one node: what hardware builds. The nodes
/// of the first part keep their numbers, so that a single part is its own graph.
struct SharedGraph {
  TypedGraph graph;  ///< f and g are the first part's
  std::vector<Sides> sides;
  std::vector<std::vector<NodeId>> ids;  ///< [part][its node]: the node here
};
SharedGraph share(const CombinedGraph& graph);

}  // namespace mixcmp::model
