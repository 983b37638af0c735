#pragma once

#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "model/lane/fixed/encoded_range.hpp"
#include "model/lane/fixed/fixed_lane.hpp"

namespace mixcmp::fixed {

/// Turns the nodes of an expression into fixed-point nodes, operands first. Each gets a format, an
/// enclosure and an error.
class FixedGraphBuilder {
public:
  FixedGraphBuilder(const Graph& graph, FloatFormat input_format, const FixedOptions& options);

  /// With guard digits, makes the affine nodes and their common cuts. To be called before all
  /// others.
  Result<Done> cut_in_common();
  /// The fixed-point node of `id`, which is f or g of a part.
  Result<NodeId> side(const Sides& sides, NodeId id);
  /// The cut affine nodes from which products of a part are computed.
  std::vector<NodeId> nodes_in_products(const Sides& sides);
  /// a - b.
  NodeId difference(NodeId a, NodeId b);
  /// abs(a).
  NodeId magnitude(NodeId a);
  /// A node without its `count` low bits, but with at least one bit of magnitude; the node itself
  /// if `count` is 0 or less.
  NodeId without_low_bits(NodeId a, int count);
  /// A node limited to the reach of `bits` bits of magnitude; the node itself if it has no more
  /// bits, or if it is always beyond that reach.
  NodeId within_reach(NodeId a, int bits);
  /// The sum of squares `sum` with other elements: `others[element]` replaces each element.
  NodeId with_squared(NodeId sum, const std::map<NodeId, NodeId>& others);

  std::vector<FixedNode>& nodes() { return nodes_; }

private:
  /// The fixed-point node of an expression's node.
  Result<NodeId> node(NodeId id);
  /// The operand of a node of the expression as that node reads it: affine nodes read it before its
  /// common cut, other nodes after it.
  NodeId operand(NodeId reader, int k);
  NodeId read(NodeId id, bool by_affine);
  void align_norms();
  FixedNode conversion(Conversion conversion, NodeId id) const;
  FixedNode common_cut(NodeId id, int most) const;
  Error nothing_to_cut() const;
  /// The error that names a node of the expression and says why fixed point does not support it.
  Error refused(NodeId id, std::string_view why, const char* accepted) const;
  Result<FixedNode> make(NodeId id);  ///< the operands exist already
  Result<FixedNode> input(const Node& node) const;
  FixedNode input_below(int top, int bits, bool nonnegative, int index) const;
  std::optional<FixedNode> multiple_below(int top, const mpq_class& grid, bool nonnegative,
                                          int index) const;
  FixedNode arriving_input(const FixedFormat& arriving, int index) const;
  FixedNode constant(const mpq_class& value, int bits) const;
  Result<FixedNode> square_root(NodeId id);
  Result<FixedNode> quotient(NodeId id);
  std::optional<FixedNode> multiple_of_square(const mpq_class& coefficient, NodeId square);
  FixedNode product(NodeId a, NodeId b);
  Result<NodeId> limited(NodeId id, const Range& limits);
  NodeId factor(NodeId id);
  /// Encloses the real values of an expression's node, for inputs within their ranges.
  const Range& declared(NodeId id);
  std::optional<Range> enclosed(NodeId id);
  /// A function, and the node of the expression that is its argument.
  struct Applied {
    Function function;
    NodeId node;
  };
  Applied applied_at(NodeId id) const;
  /// The nodes of the expression from which a node is computed.
  std::vector<NodeId> read_by(NodeId id) const;
  Result<FixedNode> function(NodeId id);
  Result<FixedNode> quotient_by_variable(NodeId id);
  Result<FixedNode> applied(NodeId id, const Function& function, NodeId whole, const Range& real,
                            int further);
  std::optional<Range> encoded_numbers(const Function& function, const Range& declared) const;
  std::optional<FixedNode> of_encoding(const Applied& applied, int further);
  NodeId encoded_argument(const Function& function, int input, const EncodedRange& range);
  FixedNode value_of(const Function& function, const function::Piecewise& piecewise,
                     NodeId argument, const Range& values, const Range& moved);
  bool is_normalised_difference(NodeId id);
  FixedNode limited_to(NodeId id, const Range& values) const;
  /// A number that stands for `meant`.
  NodeId exact_constant(const mpz_class& number, int unit_exponent, const mpq_class& meant);
  Result<FixedNode> sign(NodeId id, NodeId argument);
  Result<FixedNode> remainder(NodeId id, const Function& function, NodeId argument);
  Result<NodeId> whole_quotient(NodeId id, const Function& function, NodeId argument,
                                const Range& count);
  Result<FixedNode> away_from_jumps(NodeId id, FixedNode result, const Function& function,
                                    const Range& error, const Range& off);
  Result<NodeId> argument_of(NodeId id, const Function& function, NodeId whole, const Range& real);
  NodeId coefficient(const Function& function, const function::Piecewise& piecewise, int power,
                     NodeId argument);
  struct Place {
    NodeId address;  ///< the node whose upper bits are the address
    NodeId t;        ///< -1 where the degree is 0
  };
  Place place_of(const Function& function, const function::Piecewise& piecewise, NodeId argument);
  Place place_after_start(const Function& function, const function::Piecewise& piecewise,
                          NodeId argument);
  FixedNode itself(FixedNode node) const;
  FixedNode word_of(const Function& function, NodeId address, const function::Words& words,
                    int unit_exponent) const;
  NodeId floating_code(const Function& function, NodeId argument);
  NodeId polynomial(const Function& function, const function::Piecewise& piecewise,
                    NodeId argument);
  /// An operation whose result loses the bits that are too many.
  FixedNode operation(Operation operation, NodeId a, NodeId b = -1) const;
  FixedNode exactly(Operation operation, NodeId a, NodeId b) const;
  NodeId add(FixedNode node);

  const Graph& graph_;
  FloatFormat input_format_;
  const FixedOptions& options_;
  std::vector<bool> affine_;                    ///< [node of the expression]
  std::vector<std::optional<Range>> declared_;  ///< [node of the expression]: known so far
  std::vector<NodeId> known_;                   ///< [node of the expression]: its node here, or -1
  std::vector<NodeId> cut_;  ///< [node of the expression]: the node after the cut, or -1
  std::vector<FixedNode> nodes_;
};

}  // namespace mixcmp::fixed
