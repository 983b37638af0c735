#pragma once

#include <string>
#include <vector>

#include "model/expression/graph.hpp"
#include "model/number/float_format.hpp"
#include "model/number/lane_inputs.hpp"

namespace mixcmp::inline expression {

/// One operation with the formats it works in. Both operands of an operation share a format; the
/// result may be narrower (an operator that takes reference-format inputs and rounds once).
struct TypedNode {
  Operation operation;
  std::array<NodeId, 2> operands = {-1, -1};
  FloatFormat operand_format;  ///< equals `format` for inputs and constants
  FloatFormat format;          ///< format of the result
  int input = -1;              ///< for Operation::input
  /// For Operation::constant: `value`, rounded to nearest, ties to even. The golden model does not
  /// read this encoding; it rounds `value` itself.
  Bits constant = 0;
  mpq_class value;  ///< for Operation::constant: exactly as written

  friend bool operator==(const TypedNode&, const TypedNode&) = default;
};

/// A comparison whose every node has a format: what the golden model evaluates and the generator
/// builds. Parts that need the same operation share its node.
struct TypedGraph {
  std::vector<TypedNode> nodes;  ///< in topological order
  int input_count = 0;
  std::vector<std::string> input_names;  ///< names for messages, input_count of them
  FloatFormat input_format;              ///< the format of all inputs
  Arithmetic arithmetic;     ///< rounding and subnormals of every operation; format of f and g
  std::vector<Sides> parts;  ///< at least one
  Combination combination = Combination::all;  ///< meaningful only where there are several parts

  /// The sides of a comparison that has one part.
  NodeId f() const;
  NodeId g() const;

  friend bool operator==(const TypedGraph&, const TypedGraph&) = default;
};

/// Which nodes are needed to compute `roots`, these included.
std::vector<bool> needed_nodes(const TypedGraph& graph, const std::vector<NodeId>& roots);

/// One part of a comparison alone, with the nodes that it needs.
struct GraphPart {
  TypedGraph graph;
  std::vector<NodeId> ids;  ///< [node of the part]: that node in the whole graph
};
/// The part keeps the order of its nodes.
GraphPart part_of(const TypedGraph& graph, std::size_t part);

/// Appends a node, unless the graph has an equal one. Returns the number of either.
NodeId add_node(TypedGraph& graph, TypedNode node);

/// The graph in the reference format alone: no conversion anywhere.
TypedGraph reference_graph(const Graph& graph, Arithmetic reference);

/// The graph in a lane's reduced format, with conversions where `inputs` asks for them. f and g are
/// in the lane's format and are never inputs themselves: a conversion follows the input, because an
/// operation is needed that reports an infinity or a NaN as exceptional.
TypedGraph lane_graph(const Graph& graph, FloatFormat reference, Arithmetic reduced,
                      LaneInputs inputs);

}  // namespace mixcmp::inline expression
