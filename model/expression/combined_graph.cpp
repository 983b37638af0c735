#include "model/expression/combined_graph.hpp"

#include <algorithm>

#include "model/common/check.hpp"

namespace mixcmp::inline expression {
namespace {

bool same(const TypedNode& a, const TypedNode& b) {
  return a.operation == b.operation && a.operands == b.operands && a.format == b.format &&
         a.operand_format == b.operand_format && a.input == b.input && a.constant == b.constant &&
         a.value == b.value;
}

/// Returns the number of an equal node if there is one, else appends the node.
NodeId intern(std::vector<TypedNode>& nodes, TypedNode node) {
  const auto known = std::find_if(nodes.begin(), nodes.end(),
                                  [&](const TypedNode& other) { return same(other, node); });
  if (known != nodes.end()) return static_cast<NodeId>(known - nodes.begin());
  nodes.push_back(std::move(node));
  return static_cast<NodeId>(nodes.size()) - 1;
}

std::vector<NodeId> add_part(std::vector<TypedNode>& nodes, const TypedGraph& part) {
  std::vector<NodeId> ids;
  for (TypedNode node : part.nodes) {
    for (int k = 0; k < arity(node.operation); ++k) node.operands[k] = ids[node.operands[k]];
    ids.push_back(intern(nodes, std::move(node)));
  }
  return ids;
}

std::vector<NodeId> unchanged_ids(const TypedGraph& part) {
  std::vector<NodeId> ids;
  for (std::size_t id = 0; id < part.nodes.size(); ++id) ids.push_back(static_cast<NodeId>(id));
  return ids;
}

}  // namespace

CombinedGraph::CombinedGraph(Combination combined, std::vector<TypedGraph> graphs)
    : combination(combined), parts(std::move(graphs)) {
  MIXCMP_CHECK(!parts.empty());
}

CombinedGraph reference_graphs(const Graph& graph, Arithmetic reference) {
  std::vector<TypedGraph> parts;
  for (std::size_t k = 0; k < graph.parts().size(); ++k) {
    parts.push_back(reference_graph(graph.part(k), reference));
  }
  return {graph.combination(), std::move(parts)};
}

CombinedGraph lane_graphs(const Graph& graph, FloatFormat reference, Arithmetic reduced,
                          LaneInputs inputs) {
  std::vector<TypedGraph> parts;
  for (std::size_t k = 0; k < graph.parts().size(); ++k) {
    parts.push_back(lane_graph(graph.part(k), reference, reduced, inputs));
  }
  return {graph.combination(), std::move(parts)};
}

SharedGraph share(const CombinedGraph& graph) {
  const TypedGraph& first = graph.parts.front();
  SharedGraph shared{first, {{first.f, first.g}}, {unchanged_ids(first)}};
  for (std::size_t k = 1; k < graph.parts.size(); ++k) {
    const TypedGraph& part = graph.parts[k];
    shared.ids.push_back(add_part(shared.graph.nodes, part));
    shared.sides.push_back({shared.ids[k][part.f], shared.ids[k][part.g]});
  }
  return shared;
}

}  // namespace mixcmp::inline expression
