#include "model/comparison/expression/typed_graph.hpp"

#include <algorithm>
#include <bit>
#include <optional>
#include <utility>

#include "model/base/common/check.hpp"
#include "model/base/number/dyadic.hpp"
#include "model/base/number/exact.hpp"
#include "model/base/number/operand_format.hpp"

namespace mixcmp::inline expression {
namespace {

/// Which nodes are exact in the reference format (constants up to their encoding).
std::vector<bool> exact_nodes(const Graph& graph) {
  std::vector<bool> exact;
  for (const Node& node : graph.nodes()) {
    bool value = arity(node.operation) == 0 || only_moves_bits(node.operation);
    for (int k = 0; k < arity(node.operation); ++k) value = value && exact[node.operands[k]];
    exact.push_back(value);
  }
  return exact;
}

/// Whether a term's product is always exact, since one factor is a power of two.
bool is_scaling(const Graph& graph, const FusedTerm& term) {
  const auto scales = [&](NodeId id) {
    const Node& factor = graph.nodes()[id];
    return factor.operation == Operation::constant && factor.value != 0 &&
           is_power_of_two(abs(factor.value));
  };
  return term.is_product() && (scales(term.a) || scales(term.b));
}

/// Collects the terms of a sum, including those of the sums in it.
class TermCollector {
public:
  explicit TermCollector(const Graph& graph) : graph_(graph) {}

  std::vector<FusedTerm> collect(NodeId sum) {
    add(sum, false);
    return std::move(terms_);
  }

private:
  void add(NodeId id, bool negated) {
    if (terms_.size() > max_fused_terms) return;  // shared sums could double them many times
    const Node& node = graph_.nodes()[id];
    const auto [a, b] = node.operands;
    switch (node.operation) {
      case Operation::add:
      case Operation::subtract:
        add(a, negated);
        return add(b, negated != (node.operation == Operation::subtract));
      case Operation::negate: return add(a, !negated);
      case Operation::square: terms_.push_back({a, a, negated}); return;
      case Operation::multiply: terms_.push_back({a, b, negated}); return;
      case Operation::input:
      case Operation::constant:
      case Operation::convert:
      case Operation::absolute:
      case Operation::divide:
      case Operation::square_root:
      case Operation::minimum:
      case Operation::maximum:
      case Operation::function:
      case Operation::fused_sum: terms_.push_back({id, -1, negated}); return;
      case Operation::look_up: break;
    }
    MIXCMP_CHECK(false);
  }

  const Graph& graph_;
  std::vector<FusedTerm> terms_;
};

/// The terms for fusing a node, in nodes of `graph`. None if the node is no sum, or if composed
/// arithmetic also rounds it only once: a sum of two operands, or of multiples of them by powers of
/// two.
std::vector<FusedTerm> fused_terms(const Graph& graph, NodeId id) {
  const Operation operation = graph.nodes()[id].operation;
  if (operation != Operation::add && operation != Operation::subtract) return {};
  std::vector<FusedTerm> terms = TermCollector(graph).collect(id);
  const bool saves_a_rounding =
      terms.size() > 2 || std::any_of(terms.begin(), terms.end(), [&](const FusedTerm& term) {
        return term.is_product() && !is_scaling(graph, term);
      });
  return saves_a_rounding ? terms : std::vector<FusedTerm>();
}

/// Counts the operations and sides of comparisons that read a node.
std::ptrdiff_t readers_of(const Graph& graph, NodeId id) {
  std::ptrdiff_t readers = 0;
  for (const Node& node : graph.nodes()) {
    for (int k = 0; k < arity(node.operation); ++k) readers += node.operands[k] == id;
  }
  for (const Sides& part : graph.parts()) readers += (part.f == id) + (part.g == id);
  return readers;
}

void change_signs(std::vector<FusedTerm>& terms) {
  for (FusedTerm& term : terms) term.negated = !term.negated;
}

/// The terms that one side of a comparison adds to the difference: those of a fused sum, or a
/// product. A minus in front of either changes their signs. None if fusing would save no rounding
/// at the side, or if the side has other readers.
std::vector<FusedTerm> terms_of_side(const Graph& graph, NodeId side) {
  if (readers_of(graph, side) > 1) return {};
  if (graph.nodes()[side].operation == Operation::negate) {
    std::vector<FusedTerm> terms = terms_of_side(graph, graph.nodes()[side].operands[0]);
    change_signs(terms);
    return terms;
  }
  std::vector<FusedTerm> terms = fused_terms(graph, side);
  if (!terms.empty()) return terms;
  terms = TermCollector(graph).collect(side);
  const bool is_product =
      terms.size() == 1 && terms[0].is_product() && !is_scaling(graph, terms[0]);
  return is_product ? terms : std::vector<FusedTerm>();
}

/// The terms of f - g, if comparing that with zero saves a rounding and there are not too many.
std::vector<FusedTerm> terms_of_difference(const Graph& graph, const Sides& part) {
  std::vector<FusedTerm> terms = terms_of_side(graph, part.f);
  std::vector<FusedTerm> subtracted = terms_of_side(graph, part.g);
  if (terms.empty() && subtracted.empty()) return {};
  if (terms.empty()) terms.push_back({part.f, -1, false});
  if (subtracted.empty()) subtracted.push_back({part.g, -1, false});
  change_signs(subtracted);
  terms.insert(terms.end(), subtracted.begin(), subtracted.end());
  return terms.size() <= max_fused_terms ? terms : std::vector<FusedTerm>();
}

/// Emits the nodes that f and g need, operands first.
class TypedGraphBuilder {
public:
  TypedGraphBuilder(const Graph& graph, FloatFormat reference, Arithmetic arithmetic,
                    LaneInputs inputs);

  /// The node and all below it in the reference format.
  NodeId in_reference(NodeId id);
  /// The node in the lane's format.
  NodeId in_lane(NodeId id);

  /// Emits the values that a reference compares: the two sides in the reference format, or the sign
  /// of their fused difference and the constant 0.
  Sides compared_in_reference(const Sides& part);

  /// Makes the graph of all parts; `emit_part` emits the compared values of one part.
  template <class EmitPart>
  TypedGraph finish(EmitPart emit_part);

private:
  /// How an operation of the lane takes its operands.
  enum class Taken {
    from_reference,  ///< unchanged
    entering,        ///< rounded to `entering_`
    in_lane,
  };
  Taken operands_of(const Node& node) const;
  NodeId operand(Taken taken, NodeId id);
  FloatFormat format_of(Taken taken) const;
  /// The node and all below it in the format to which operands are rounded.
  NodeId entering(NodeId id);

  NodeId emit_constant(const mpq_class& value, FloatFormat format);
  NodeId emit_in_reference(NodeId id);
  NodeId emit_fused(std::vector<FusedTerm> terms, SumResult result);
  NodeId emit_entering(NodeId id);
  NodeId emit_in_lane(NodeId id);
  std::optional<mpq_class> reciprocal_of_divisor(const Node& node, FloatFormat format) const;
  NodeId emit_conversion(NodeId id, FloatFormat format);
  NodeId emit(TypedNode node);
  int digits_of(NodeId id) const;

  const Graph& graph_;
  FloatFormat reference_;
  LaneInputs inputs_;
  FloatFormat entering_;  ///< the format of inputs for the lane's first operators
  std::vector<bool> exact_;
  std::vector<bool> fits_lane_;
  std::vector<NodeId> reference_ids_;
  std::vector<NodeId> entering_ids_;
  std::vector<NodeId> lane_ids_;
  TypedGraph typed_;
};

FloatFormat entering_format(FloatFormat reference, FloatFormat lane, LaneInputs inputs) {
  const int digits = inputs.digits(lane.precision(), reference.precision());
  return FloatFormat::make(digits, lane.exponent_bits()).value();
}

/// One per input. Empty if all arrive in the reference's format. A format that the reference's does
/// not hold says nothing: the graph is then one of a program that rounds its operands first.
std::vector<OperandFormat> arriving_formats(const Graph& graph, FloatFormat reference) {
  const OperandFormat unknown(reference);
  std::vector<OperandFormat> formats;
  for (int input = 0; input < static_cast<int>(graph.inputs().size()); ++input) {
    const OperandFormat format = graph.arriving_format(input).value_or(unknown);
    formats.push_back(format.is_held_by(reference) ? format : unknown);
  }
  const bool any = std::any_of(formats.begin(), formats.end(),
                               [&](const OperandFormat& format) { return !(format == unknown); });
  return any ? formats : std::vector<OperandFormat>();
}

/// Whether a constant is a normal number of the format, or zero.
bool is_normal_number(FloatFormat format, const mpq_class& value) {
  const Bits bits = from_rational(format, value);
  return !format.is_infinite(bits) && !format.is_subnormal(bits) &&
         to_rational(format, bits) == value;
}

/// Which nodes are operands, up to their sign or a choice among several, that a conversion to the
/// lane's format leaves as they are.
std::vector<bool> fitting_nodes(const Graph& graph, const TypedGraph& typed) {
  const FloatFormat lane = typed.arithmetic.format;
  std::vector<bool> fits;
  for (const Node& node : graph.nodes()) {
    bool value = only_moves_bits(node.operation);
    for (int k = 0; k < arity(node.operation); ++k) value = value && fits[node.operands[k]];
    if (node.operation == Operation::constant) value = is_normal_number(lane, node.value);
    if (node.operation == Operation::input) {
      value = !typed.arriving.empty() && typed.arriving[node.input].is_held_by(lane);
    }
    fits.push_back(value);
  }
  return fits;
}

TypedGraphBuilder::TypedGraphBuilder(const Graph& graph, FloatFormat reference,
                                     Arithmetic arithmetic, LaneInputs inputs)
    : graph_(graph),
      reference_(reference),
      inputs_(inputs),
      entering_(entering_format(reference, arithmetic.format, inputs)),
      exact_(exact_nodes(graph)),
      reference_ids_(graph.nodes().size(), -1),
      entering_ids_(graph.nodes().size(), -1),
      lane_ids_(graph.nodes().size(), -1),
      typed_{.input_count = static_cast<int>(graph.inputs().size()),
             .input_names = graph.inputs(),
             .input_format = reference,
             .arriving = arriving_formats(graph, reference),
             .arithmetic = arithmetic,
             .combination = graph.combination()} {
  fits_lane_ = fitting_nodes(graph, typed_);
}

NodeId TypedGraphBuilder::in_reference(NodeId id) {
  NodeId& known = reference_ids_[id];
  if (known < 0) known = emit_in_reference(id);
  return known;
}

NodeId TypedGraphBuilder::entering(NodeId id) {
  NodeId& known = entering_ids_[id];
  if (known < 0) known = emit_entering(id);
  return known;
}

NodeId TypedGraphBuilder::in_lane(NodeId id) {
  NodeId& known = lane_ids_[id];
  if (known < 0) known = emit_in_lane(id);
  return known;
}

TypedGraphBuilder::Taken TypedGraphBuilder::operands_of(const Node& node) const {
  if (inputs_ == LaneInputs::rounded) return Taken::in_lane;
  bool all_fit = true;
  for (int k = 0; k < arity(node.operation); ++k) {
    if (!exact_[node.operands[k]]) return Taken::in_lane;
    all_fit = all_fit && fits_lane_[node.operands[k]];
  }
  if (all_fit) return Taken::in_lane;
  if (entering_.precision() == reference_.precision()) return Taken::from_reference;
  // A choice among operands that the lane takes in its own format is made in that format.
  return only_moves_bits(node.operation) ? Taken::in_lane : Taken::entering;
}

NodeId TypedGraphBuilder::operand(Taken taken, NodeId id) {
  switch (taken) {
    case Taken::from_reference: return in_reference(id);
    case Taken::entering: return entering(id);
    case Taken::in_lane: return in_lane(id);
  }
  MIXCMP_CHECK(false);
}

FloatFormat TypedGraphBuilder::format_of(Taken taken) const {
  switch (taken) {
    case Taken::from_reference: return reference_;
    case Taken::entering: return entering_;
    case Taken::in_lane: return typed_.arithmetic.format;
  }
  MIXCMP_CHECK(false);
}

NodeId TypedGraphBuilder::emit_constant(const mpq_class& value, FloatFormat format) {
  return emit({.operation = Operation::constant,
               .operand_format = format,
               .format = format,
               .constant = from_rational(format, value),
               .value = value});
}

/// The terms refer to nodes of the graph without formats.
NodeId TypedGraphBuilder::emit_fused(std::vector<FusedTerm> terms, SumResult result) {
  MIXCMP_CHECK(terms.size() <= max_fused_terms);
  for (FusedTerm& term : terms) {
    term.a = in_reference(term.a);
    if (term.is_product()) term.b = in_reference(term.b);
  }
  return emit({.operation = Operation::fused_sum,
               .operand_format = reference_,
               .format = reference_,
               .value = {},
               .terms = std::move(terms),
               .sum_result = result});
}

Sides TypedGraphBuilder::compared_in_reference(const Sides& part) {
  if (typed_.arithmetic.sums == Sums::fused) {
    std::vector<FusedTerm> terms = terms_of_difference(graph_, part);
    if (!terms.empty()) {
      const NodeId sign = emit_fused(std::move(terms), SumResult::sign);
      return {sign, emit_constant(0, reference_)};
    }
  }
  const NodeId f = in_reference(part.f);
  return {f, in_reference(part.g)};
}

NodeId TypedGraphBuilder::emit_in_reference(NodeId id) {
  const Node& node = graph_.nodes()[id];
  if (typed_.arithmetic.sums == Sums::fused) {
    std::vector<FusedTerm> terms = fused_terms(graph_, id);
    if (!terms.empty()) return emit_fused(std::move(terms), SumResult::rounded);
  }
  if (node.operation == Operation::constant) return emit_constant(node.value, reference_);
  TypedNode typed{.operation = node.operation,
                  .operand_format = reference_,
                  .format = reference_,
                  .input = node.input,
                  .value = {}};
  for (int k = 0; k < arity(node.operation); ++k) {
    typed.operands[k] = in_reference(node.operands[k]);
  }
  return emit(std::move(typed));
}

NodeId TypedGraphBuilder::emit_conversion(NodeId id, FloatFormat format) {
  return emit({.operation = Operation::convert,
               .operands = {in_reference(id), -1},
               .operand_format = reference_,
               .format = format,
               .value = {}});
}

NodeId TypedGraphBuilder::emit_entering(NodeId id) {
  const Node& node = graph_.nodes()[id];
  if (node.operation == Operation::constant) return emit_constant(node.value, entering_);
  if (node.operation == Operation::input) return emit_conversion(id, entering_);
  TypedNode typed{
      .operation = node.operation, .operand_format = entering_, .format = entering_, .value = {}};
  for (int k = 0; k < arity(node.operation); ++k) typed.operands[k] = entering(node.operands[k]);
  return emit(std::move(typed));
}

NodeId TypedGraphBuilder::emit_in_lane(NodeId id) {
  const Node& node = graph_.nodes()[id];
  const FloatFormat format = typed_.arithmetic.format;
  if (node.operation == Operation::constant) return emit_constant(node.value, format);
  const Taken taken = operands_of(node);
  const bool is_unrounded = taken == Taken::from_reference && only_moves_bits(node.operation);
  if (node.operation == Operation::input || is_unrounded) return emit_conversion(id, format);
  TypedNode typed{.operation = node.operation,
                  .operand_format = format_of(taken),
                  .format = format,
                  .value = {}};
  if (const auto reciprocal = reciprocal_of_divisor(node, typed.operand_format)) {
    typed.operation = Operation::multiply;
    typed.operands[0] = operand(taken, node.operands[0]);
    typed.operands[1] = emit_constant(*reciprocal, typed.operand_format);
    return emit(std::move(typed));
  }
  for (int k = 0; k < arity(node.operation); ++k) {
    typed.operands[k] = operand(taken, node.operands[k]);
  }
  return emit(std::move(typed));
}

/// The reciprocal of a constant divisor: a lane multiplies by it, since a divider takes several
/// times as much as a multiplier, and the reciprocal's rounding is an error as that of any
/// constant. None for other operations, or if the format rounds it to no normal number.
std::optional<mpq_class> TypedGraphBuilder::reciprocal_of_divisor(const Node& node,
                                                                  FloatFormat format) const {
  if (node.operation != Operation::divide) return std::nullopt;
  const Node& divisor = graph_.nodes()[node.operands[1]];
  if (divisor.operation != Operation::constant || divisor.value == 0) return std::nullopt;
  mpq_class reciprocal = 1 / divisor.value;
  const int exponent = format.biased_exponent(from_rational(format, reciprocal));
  if (exponent == 0 || exponent == format.max_biased_exponent()) return std::nullopt;
  return reciprocal;
}

/// The most digits of a node's value.
int TypedGraphBuilder::digits_of(NodeId id) const {
  const TypedNode& node = typed_.nodes[id];
  const int own = node.format.precision();
  if (typed_.arriving.empty()) return own;
  if (node.operation == Operation::input) return typed_.arriving_format(node.input).precision();
  const bool only_moves = node.operation == Operation::convert || only_moves_bits(node.operation);
  return only_moves ? std::min(own, node.operand_digits()) : own;
}

NodeId TypedGraphBuilder::emit(TypedNode node) {
  int digits = 0;
  for (int k = 0; k < arity(node.operation); ++k) {
    digits = std::max(digits, digits_of(node.operands[k]));
  }
  if (digits < node.operand_format.precision()) node.arriving_digits = digits;
  typed_.nodes.push_back(std::move(node));
  return static_cast<NodeId>(typed_.nodes.size()) - 1;
}

template <class EmitPart>
TypedGraph TypedGraphBuilder::finish(EmitPart emit_part) {
  for (const Sides& part : graph_.parts()) typed_.parts.push_back(emit_part(part));
  return std::move(typed_);
}

}  // namespace

NodeId TypedGraph::f() const {
  MIXCMP_CHECK(parts.size() == 1);
  return parts.front().f;
}

NodeId TypedGraph::g() const {
  MIXCMP_CHECK(parts.size() == 1);
  return parts.front().g;
}

int fused_guard_digits(std::size_t terms) {
  constexpr int share_digits = 5;
  return static_cast<int>(std::bit_width(terms - 1)) + share_digits;
}

std::vector<NodeId> operands_of(const TypedNode& node) {
  std::vector<NodeId> operands;
  const auto read = [&](NodeId id) {
    if (std::find(operands.begin(), operands.end(), id) == operands.end()) operands.push_back(id);
  };
  for (int k = 0; k < arity(node.operation); ++k) read(node.operands[k]);
  for (const FusedTerm& term : node.terms) {
    read(term.a);
    if (term.is_product()) read(term.b);
  }
  return operands;
}

std::vector<bool> needed_nodes(const TypedGraph& graph, const std::vector<NodeId>& roots) {
  std::vector<bool> needed(graph.nodes.size(), false);
  for (const NodeId root : roots) needed[root] = true;
  for (std::size_t id = graph.nodes.size(); id-- > 0;) {
    if (!needed[id]) continue;
    for (const NodeId operand : operands_of(graph.nodes[id])) needed[operand] = true;
  }
  return needed;
}

GraphPart part_of(const TypedGraph& graph, std::size_t part) {
  const Sides& sides = graph.parts[part];
  const std::vector<bool> needed = needed_nodes(graph, {sides.f, sides.g});
  GraphPart alone{graph, {}};
  alone.graph.nodes.clear();
  std::vector<NodeId> renumbered(graph.nodes.size(), -1);
  for (std::size_t id = 0; id < graph.nodes.size(); ++id) {
    if (!needed[id]) continue;
    TypedNode node = graph.nodes[id];
    for (int k = 0; k < arity(node.operation); ++k) {
      node.operands[k] = renumbered[node.operands[k]];
    }
    for (FusedTerm& term : node.terms) {
      term.a = renumbered[term.a];
      if (term.is_product()) term.b = renumbered[term.b];
    }
    renumbered[id] = static_cast<NodeId>(alone.graph.nodes.size());
    alone.graph.nodes.push_back(std::move(node));
    alone.ids.push_back(static_cast<NodeId>(id));
  }
  alone.graph.parts = {{renumbered[sides.f], renumbered[sides.g]}};
  return alone;
}

NodeId add_node(TypedGraph& graph, TypedNode node) {
  const auto known = std::find(graph.nodes.begin(), graph.nodes.end(), node);
  const auto id = static_cast<NodeId>(known - graph.nodes.begin());
  if (known == graph.nodes.end()) graph.nodes.push_back(std::move(node));
  return id;
}

std::size_t longest_fused_sum(const Graph& graph) {
  std::size_t longest = 0;
  for (NodeId id = 0; id < static_cast<NodeId>(graph.nodes().size()); ++id) {
    longest = std::max(longest, fused_terms(graph, id).size());
  }
  return longest;
}

TypedGraph reference_graph(const Graph& graph, Arithmetic reference) {
  TypedGraphBuilder builder(graph, reference.format, reference, LaneInputs::exact);
  return builder.finish([&](const Sides& part) { return builder.compared_in_reference(part); });
}

TypedGraph sides_graph(const Graph& graph, Arithmetic reference) {
  TypedGraphBuilder builder(graph, reference.format, reference, LaneInputs::exact);
  return builder.finish([&](const Sides& part) {
    const NodeId f = builder.in_reference(part.f);
    return Sides{f, builder.in_reference(part.g)};
  });
}

TypedGraph lane_graph(const Graph& graph, FloatFormat reference, Arithmetic reduced,
                      LaneInputs inputs) {
  TypedGraphBuilder builder(graph, reference, reduced, inputs);
  return builder.finish([&](const Sides& part) {
    const NodeId f = builder.in_lane(part.f);
    return Sides{f, builder.in_lane(part.g)};
  });
}

}  // namespace mixcmp::inline expression
