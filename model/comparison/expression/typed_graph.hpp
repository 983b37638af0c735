#pragma once

#include <string>
#include <vector>

#include "model/base/number/float_format.hpp"
#include "model/base/number/lane_inputs.hpp"
#include "model/comparison/expression/graph.hpp"

namespace mixcmp::inline expression {

/// One term of a fused sum: the product of two nodes, or one node.
struct FusedTerm {
  NodeId a;
  NodeId b;  ///< a itself in a square; -1: the term is no product
  bool negated;

  bool is_product() const { return b >= 0; }
  bool is_square() const { return a == b; }
  friend bool operator==(const FusedTerm&, const FusedTerm&) = default;
};

/// The most terms of a fused sum: the limit of rtl_templates/fp/fp_fused_sum.v.
inline constexpr std::size_t max_fused_terms = 63;

/// The digits that each term of a fused sum keeps beyond the format's precision, counted from the
/// largest term's leading digits (docs/error_bounds.md). With these, the parts cut off all terms
/// add up to less than 1/32 of a unit in the last place of the largest one.
int fused_guard_digits(std::size_t terms);

/// The result of a fused sum.
enum class SumResult {
  rounded,
  sign,  ///< -1, 0 or 1, of the sum before any rounding, or a NaN: for a comparison with zero
};

/// One operation with the formats it works in. Both operands of an operation share a format; the
/// result may be narrower (an operator that takes reference-format inputs and rounds once).
struct TypedNode {
  Operation operation;
  std::array<NodeId, 2> operands = {-1, -1};
  FloatFormat operand_format;  ///< equals `format` for inputs and constants
  FloatFormat format;          ///< format of the result
  int input = -1;              ///< for Operation::input
  /// The most digits that an operand has, if the formats in which inputs arrive leave fewer than
  /// operand_format has; else 0.
  int arriving_digits = 0;
  /// For Operation::constant: `value`, rounded to nearest, ties to even. The golden model does not
  /// read this encoding; it rounds `value` itself.
  Bits constant = 0;
  mpq_class value;                            ///< for Operation::constant: exactly as written
  std::vector<FusedTerm> terms = {};          ///< for Operation::fused_sum: two or more
  SumResult sum_result = SumResult::rounded;  ///< valid for Operation::fused_sum

  /// The most digits that an operand has.
  int operand_digits() const {
    return arriving_digits > 0 ? arriving_digits : operand_format.precision();
  }
  bool is_sign_of_sum() const { return sum_result == SumResult::sign; }
  friend bool operator==(const TypedNode&, const TypedNode&) = default;
};

/// A comparison in which every node has a format. The golden model evaluates it and the generator
/// builds it. Parts that need the same operation share its node.
struct TypedGraph {
  std::vector<TypedNode> nodes;  ///< in topological order
  int input_count = 0;
  std::vector<std::string> input_names;  ///< names for messages, input_count of them
  FloatFormat input_format;              ///< the format of all inputs
  /// One per input: the format in which it arrives, all of whose numbers `input_format` holds.
  /// Empty: all arrive in `input_format`. Evaluations take operands in `input_format`; a datapath
  /// converts them from these formats first, which rounds nothing.
  std::vector<OperandFormat> arriving = {};
  Arithmetic arithmetic;     ///< rounding and subnormals of every operation; format of f and g
  std::vector<Sides> parts;  ///< at least one
  Combination combination = Combination::all;  ///< valid only if there are several parts

  /// The sides of a comparison that has one part.
  NodeId f() const;
  NodeId g() const;

  /// The format in which an input arrives; one in fixed point counts as one in `input_format`.
  FloatFormat arriving_format(int input) const {
    const OperandFormat format = operand_format(input);
    return format.floating() == nullptr ? input_format : *format.floating();
  }
  OperandFormat operand_format(int input) const {
    return arriving.empty() ? OperandFormat(input_format)
                            : arriving[static_cast<std::size_t>(input)];
  }

  friend bool operator==(const TypedGraph&, const TypedGraph&) = default;
};

/// The nodes that a node reads, each once.
std::vector<NodeId> operands_of(const TypedNode& node);

/// Which nodes are needed to compute `roots`, these included.
std::vector<bool> needed_nodes(const TypedGraph& graph, const std::vector<NodeId>& roots);

/// One part of a comparison as a graph of its own, with the nodes that it needs.
struct GraphPart {
  TypedGraph graph;
  std::vector<NodeId> ids;  ///< [node of the part]: that node in the whole graph
};
/// The part keeps the order of its nodes.
GraphPart part_of(const TypedGraph& graph, std::size_t part);

/// Appends a node unless the graph has an equal one. Returns the id of the new or the equal node.
NodeId add_node(TypedGraph& graph, TypedNode node);

/// The number of terms of the longest sum that `Sums::fused` would fuse; counting ends above
/// max_fused_terms.
std::size_t longest_fused_sum(const Graph& graph);

/// The graph in the reference format only, without any conversion. With Sums::fused, each sum that
/// the composed arithmetic rounds more than once becomes a fused sum of at most max_fused_terms
/// terms. If a part's sides are such sums, or products, the part compares the sign of their fused
/// difference with zero: f is that sign, g the constant 0.
TypedGraph reference_graph(const Graph& graph, Arithmetic reference);
/// The graph in the reference format with the two sides of every part, even if a fused difference
/// is compared.
TypedGraph sides_graph(const Graph& graph, Arithmetic reference);

/// The graph in a lane's reduced format, with the conversions that `inputs` asks for. f and g are
/// in the lane's format and are never inputs themselves. If a side is an input, a conversion
/// follows it, because an operation has to report an infinity or a NaN as exceptional. A division
/// by a constant is a multiplication by its reciprocal, if that is a normal number of the format.
/// Operands that arrive in a format that the lane's format holds are converted to the latter ahead
/// of any operation, whatever `inputs` asks for, since that rounds nothing.
TypedGraph lane_graph(const Graph& graph, FloatFormat reference, Arithmetic reduced,
                      LaneInputs inputs);

}  // namespace mixcmp::inline expression
