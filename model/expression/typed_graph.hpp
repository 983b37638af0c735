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
};

/// A graph whose every node has a format: what the golden model evaluates and the generator builds.
struct TypedGraph {
  std::vector<TypedNode> nodes;  ///< in topological order
  int input_count = 0;
  std::vector<std::string> input_names;  ///< names for messages, input_count of them
  FloatFormat input_format;              ///< the format of all inputs
  Arithmetic arithmetic;  ///< rounding and subnormals of every operation; format of f and g
  NodeId f = -1;
  NodeId g = -1;
};

/// The graph in the reference format alone: no conversion anywhere.
TypedGraph reference_graph(const Graph& graph, Arithmetic reference);

/// The graph in a lane's reduced format, with conversions where `inputs` asks for them. f and g are
/// in the lane's format and are never inputs themselves: a conversion follows the input, because an
/// operation is needed that reports an infinity or a NaN as exceptional.
TypedGraph lane_graph(const Graph& graph, FloatFormat reference, Arithmetic reduced,
                      LaneInputs inputs);

}  // namespace mixcmp::inline expression
