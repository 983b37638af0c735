#pragma once

#include <gmpxx.h>

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/number/operand_format.hpp"
#include "model/comparison/expression/combination.hpp"
#include "model/comparison/expression/function.hpp"
#include "model/comparison/expression/range.hpp"

namespace mixcmp::inline expression {

enum class Operation {
  input,
  constant,
  convert,  ///< to another format, in typed graphs; a cut or a limit in fixed point
  negate,
  absolute,
  add,
  subtract,
  multiply,
  square,
  divide,
  square_root,
  minimum,   ///< IEEE 754-2019 minimum: NaN wins, -0 < +0
  maximum,   ///< IEEE 754-2019 maximum
  function,  ///< of one argument: Node::function
  look_up,   ///< a word of a table, in fixed point: FixedNode::table
  /// A sum of products that is rounded once, in graphs of references. Its operands are
  /// TypedNode::terms.
  fused_sum,
};

/// Number of operands: 0 for input, constant and a fused sum (which has terms instead), 1 or 2
/// otherwise.
int arity(Operation operation);

/// Whether the result is one of two operands, unrounded: a minimum or a maximum.
bool is_choice(Operation operation);

/// Whether the result is one of the operands up to its sign: a choice, a negation, a magnitude.
bool only_moves_bits(Operation operation);
/// "add", "square_root", ...
std::string_view to_string(Operation operation);

/// Index of a node; operands always have smaller indices than their users.
using NodeId = int;

struct Node {
  Operation operation;
  std::array<NodeId, 2> operands = {-1, -1};  ///< the first arity(operation) are used
  int input = -1;                             ///< for Operation::input: index into Graph::inputs
  mpq_class value;                            ///< for Operation::constant: exactly as written
  std::optional<Function> function = {};      ///< for Operation::function
};

/// One part of a comparison: the sign of f - g.
struct Sides {
  NodeId f;
  NodeId g;

  friend bool operator==(const Sides&, const Sides&) = default;
};

/// The real-valued expressions f and g of one part or several. Operations have no number format;
/// an input may have one, whose numbers are then its only values. Equal subexpressions share one
/// node; x * x and x ^ 2 are a square.
class Graph {
public:
  NodeId input(const std::string& name);
  NodeId constant(const mpq_class& value);
  NodeId apply(Operation operation, NodeId first, NodeId second = -1);
  NodeId apply(const Function& function, NodeId argument);
  /// The first function that any node applies; none if no node does.
  std::optional<Function> first_function() const;

  /// Declares that a node's value matters only within `limits`: a lane may leave other comparisons
  /// undecided. Several limits of one node are intersected. If the intersection is empty, returns
  /// false and declares nothing.
  bool limit(NodeId id, const Range& limits);

  /// Declares that all values of an input, an index of inputs(), are numbers of `format`.
  void arrives_in(int input, OperandFormat format) { arriving_.insert_or_assign(input, format); }
  /// This comparison without the declarations of arrives_in.
  Graph with_any_operands() const;
  /// The format declared by arrives_in; none: the input has every format's numbers.
  std::optional<OperandFormat> arriving_format(int input) const;

  void compare(NodeId f, NodeId g);
  /// Compares the two sides of each part; there is at least one.
  void compare(std::vector<Sides> parts, Combination combination);

  const std::vector<Node>& nodes() const { return nodes_; }
  /// The names of the inputs in order of first appearance. Operands have this order everywhere.
  const std::vector<std::string>& inputs() const { return inputs_; }
  /// The limits of all nodes that have any.
  const std::map<NodeId, Range>& limits() const { return limits_; }
  const std::vector<Sides>& parts() const { return parts_; }
  /// Valid only if the comparison has several parts.
  Combination combination() const { return combination_; }
  /// The sides of a comparison that has one part.
  NodeId f() const;
  NodeId g() const;
  /// One part as a graph of its own, over the same nodes and inputs.
  Graph part(std::size_t index) const;

private:
  NodeId intern(Node node);

  std::vector<Node> nodes_;
  std::vector<std::string> inputs_;
  std::map<NodeId, Range> limits_;
  std::map<int, OperandFormat> arriving_;
  std::vector<Sides> parts_;
  Combination combination_ = Combination::all;
};

}  // namespace mixcmp::inline expression
