#include "model/fixed/graph_builder.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "model/common/check.hpp"
#include "model/expression/text.hpp"
#include "model/fixed/node_enclosure.hpp"
#include "model/fixed/root_error.hpp"
#include "model/number/dyadic.hpp"

namespace mixcmp::fixed {
namespace {

/// Results have at most 2 W + 16 bits: sums of some products of two operands stay exact, also where
/// their units differ by some places. What is wider loses its low bits.
constexpr int spare_bits = 16;

/// A root has at most W + 8 bits.
constexpr int spare_root_bits = 8;

/// The last bit of a factor is worth a 16th of its error or less: cutting off what is finer adds
/// no more than that to it.
constexpr int factor_guard_bits = 4;

int unit_exponent_of(Operation operation, const FixedFormat& a, const FixedFormat& b) {
  if (operation == Operation::square) return 2 * a.unit_exponent;
  if (operation == Operation::multiply) return a.unit_exponent + b.unit_exponent;
  return std::min(a.unit_exponent, b.unit_exponent);
}

/// The least k with magnitude < 2^k, but from a binade above the format's least normal number to
/// one above its largest.
int exponent_above(const mpq_class& magnitude, FloatFormat format) {
  const int least = format.min_exponent() + 1, most = format.max_exponent() + 1;
  if (magnitude == 0) return least;
  return static_cast<int>(std::clamp<long>(floor_log2(magnitude) + 1, least, most));
}

/// The root of the square of a rational number; none of others.
std::optional<mpq_class> exact_root(const mpq_class& value) {
  const bool is_square = value > 0 && mpz_perfect_square_p(value.get_num_mpz_t()) != 0 &&
                         mpz_perfect_square_p(value.get_den_mpz_t()) != 0;
  if (!is_square) return std::nullopt;
  return mpq_class(sqrt(value.get_num()), sqrt(value.get_den()));
}

/// The format that holds a range of multiples of the unit.
FixedFormat format_of(const Range& value, int unit_exponent) {
  const mpq_class per_unit = power_of_two(-unit_exponent);
  return FixedFormat::holding(floor_of(value.low * per_unit), ceiling_of(value.high * per_unit),
                              unit_exponent);
}

/// Drops `count` low bits of a result that has dropped none, if that is more than 0.
void drop_bits(FixedNode& node, int count) {
  if (count <= 0) return;
  node.dropped_bits = count;
  const mpq_class exact_unit = node.format.unit();
  const int unit_exponent = node.format.unit_exponent + count;
  const mpq_class unit = power_of_two(unit_exponent);
  node.error.low -= unit - exact_unit;
  node.value = {floor_of(node.value.low / unit) * unit, floor_of(node.value.high / unit) * unit};
  node.format = format_of(node.value, unit_exponent);
}

}  // namespace

FixedGraphBuilder::FixedGraphBuilder(const Graph& graph, FloatFormat input_format,
                                     const FixedOptions& options)
    : graph_(graph),
      input_format_(input_format),
      options_(options),
      known_(graph.nodes().size(), -1) {}

Result<NodeId> FixedGraphBuilder::node(NodeId id) {
  if (known_[id] >= 0) return known_[id];
  const Node& node = graph_.nodes()[id];
  for (int k = 0; k < arity(node.operation); ++k) {
    MIXCMP_TRY(operand, this->node(node.operands[k]));
    (void)operand;
  }
  MIXCMP_TRY(made, make(id));
  known_[id] = add(std::move(made));
  const auto limits = graph_.limits().find(id);
  if (limits == graph_.limits().end()) return known_[id];
  MIXCMP_TRY(checked, limited(id, limits->second));
  known_[id] = checked;
  return checked;
}

NodeId FixedGraphBuilder::difference(NodeId a, NodeId b) {
  return add(operation(Operation::subtract, a, b));
}

NodeId FixedGraphBuilder::magnitude(NodeId a) {
  return add(operation(Operation::absolute, a));
}

Error FixedGraphBuilder::refused(NodeId id, std::string_view why, const char* accepted) const {
  constexpr std::size_t most_characters = 60;
  return {.field = "reduced.format",
          .message = fmt::format("{}: {}", why, to_text(graph_, id, most_characters)),
          .received = options_.format.name(),
          .accepted = accepted};
}

Result<FixedNode> FixedGraphBuilder::make(NodeId id) {
  const Node& node = graph_.nodes()[id];
  switch (node.operation) {
    case Operation::input: return input(node);
    case Operation::constant: return constant(node.value);
    case Operation::square_root: return square_root(id);
    case Operation::divide: return quotient(id);
    case Operation::convert:
    case Operation::negate:
    case Operation::absolute:
    case Operation::add:
    case Operation::subtract:
    case Operation::multiply:
    case Operation::square:
    case Operation::minimum:
    case Operation::maximum: break;
  }
  const auto [a, b] = node.operands;
  const NodeId first = known_[a], second = b < 0 ? -1 : known_[b];
  if (node.operation == Operation::square) return operation(node.operation, factor(first));
  if (node.operation != Operation::multiply) return operation(node.operation, first, second);
  for (const auto& [constant, other] : {std::pair(a, b), {b, a}}) {
    const Node& coefficient = graph_.nodes()[constant];
    if (coefficient.operation != Operation::constant) continue;
    if (const auto square = multiple_of_square(coefficient.value, other)) return *square;
  }
  return product(first, second);
}

FixedNode FixedGraphBuilder::product(NodeId a, NodeId b) {
  const NodeId first = factor(a);
  const NodeId second = factor(b);
  return operation(Operation::multiply, first, second);
}

/// c^2 x^2 as (c x)^2, of which a norm bound can be made; none if the bound or the product is of
/// another kind.
std::optional<FixedNode> FixedGraphBuilder::multiple_of_square(const mpq_class& coefficient,
                                                               NodeId id) {
  const Node& square = graph_.nodes()[id];
  if (options_.bound == FixedBound::constant || square.operation != Operation::square ||
      graph_.limits().contains(id)) {
    return std::nullopt;
  }
  const std::optional<mpq_class> root = exact_root(coefficient);
  if (!root) return std::nullopt;
  const NodeId multiple = add(product(add(constant(*root)), known_[square.operands[0]]));
  return operation(Operation::square, factor(multiple));
}

/// Division by a constant is multiplication by its reciprocal.
Result<FixedNode> FixedGraphBuilder::quotient(NodeId id) {
  const auto [dividend, divisor] = graph_.nodes()[id].operands;
  const Node& constant_node = graph_.nodes()[divisor];
  if (constant_node.operation != Operation::constant || constant_node.value == 0) {
    return refused(id, "fixed point divides by constants alone",
                   "a floating-point format, or f and g without other quotients");
  }
  const mpq_class reciprocal = 1 / constant_node.value;
  if (const auto square = multiple_of_square(reciprocal, dividend)) return *square;
  return product(known_[dividend], add(constant(reciprocal)));
}

/// A lane checks limits on the number that it computes, errors included.
Result<NodeId> FixedGraphBuilder::limited(NodeId id, const Range& limits) {
  const NodeId unlimited = known_[id];
  const FixedNode& whole = nodes_[unlimited];
  const mpq_class unit = whole.format.unit();
  const mpq_class low = floor_of(limits.low / unit) * unit,
                  high = ceiling_of(limits.high / unit) * unit;
  const Range checked = {std::max(low, whole.value.low), std::min(high, whole.value.high)};
  if (checked == whole.value) return unlimited;
  if (checked.low > checked.high) {
    return refused(id, "the ranges allow no value that is within the limits",
                   "limits that meet what the ranges allow");
  }
  FixedNode node{.operation = Operation::convert, .operands = {unlimited, -1}, .constant = {}};
  node.value = checked;
  node.error = whole.error;
  node.format = format_of(node.value, whole.format.unit_exponent);
  return add(std::move(node));
}

/// A node as a factor: without the low bits that its error makes meaningless, since a multiplier's
/// area grows with the bits of both factors.
NodeId FixedGraphBuilder::factor(NodeId id) {
  const FixedNode& whole = nodes_[id];
  const mpq_class error = whole.error.high - whole.error.low;
  if (error == 0) return id;
  const int unit_exponent = static_cast<int>(floor_log2(error)) - factor_guard_bits;
  FixedNode node{.operation = Operation::convert, .operands = {id, -1}, .constant = {}};
  node.value = whole.value;
  node.error = whole.error;
  node.format = whole.format;
  const int most_dropped = whole.format.width - (whole.format.is_signed ? 2 : 1);
  drop_bits(node, std::min(unit_exponent - whole.format.unit_exponent, most_dropped));
  return node.dropped_bits == 0 ? id : add(std::move(node));
}

Result<FixedNode> FixedGraphBuilder::input(const Node& node) const {
  const std::optional<Range>& range = options_.ranges[static_cast<std::size_t>(node.input)];
  if (options_.format.is_block) return input_below(0, range && range->low >= 0, node.input);
  const std::string& name = graph_.inputs()[static_cast<std::size_t>(node.input)];
  if (!range) {
    return Error{.field = fmt::format("inputs.{}.range", name),
                 .message = "a fixed-point lane needs a range for each input",
                 .received = "none",
                 .accepted = "a range, such as [0, 100]"};
  }
  const int top = exponent_above(absolute(*range).high, input_format_);
  return input_below(top, range->low >= 0, node.input);
}

/// An operand below 2^top in magnitude.
FixedNode FixedGraphBuilder::input_below(int top, bool nonnegative, int index) const {
  const int bits = options_.format.bits;
  FixedNode input{.operation = Operation::input, .input = index, .constant = {}};
  input.format = {.width = bits, .unit_exponent = top - bits};
  const mpq_class unit = input.format.unit(), greatest = input.format.largest() * unit;
  input.value = {0, greatest};
  input.error = {-unit, 0};
  if (nonnegative) return input;
  input.value.low = -greatest - unit;
  input.format = {.width = bits + 1, .unit_exponent = top - bits, .is_signed = true};
  return input;
}

/// A constant is rounded to W digits; one that has no more of them stays exact.
FixedNode FixedGraphBuilder::constant(const mpq_class& value) const {
  FixedNode constant{.operation = Operation::constant, .constant = {}};
  int unit_exponent = 0;
  if (value != 0) {
    unit_exponent = static_cast<int>(floor_log2(abs(value))) + 1 - options_.format.bits;
    constant.constant = floor_of(scaled(value, -unit_exponent) + mpq_class(1, 2));
  }
  while (constant.constant != 0 && mpz_even_p(constant.constant.get_mpz_t()) != 0) {
    constant.constant /= 2;
    ++unit_exponent;
  }
  const mpq_class rounded = scaled(constant.constant, unit_exponent);
  constant.value = {rounded, rounded};
  constant.error = {rounded - value, rounded - value};
  constant.format = FixedFormat::holding(constant.constant, constant.constant, unit_exponent);
  return constant;
}

/// The unit is the power of two at or below half of the error that the radicand's error gives the
/// root, so that rounding adds little to it; but no coarser than the largest root.
Result<FixedNode> FixedGraphBuilder::square_root(NodeId id) const {
  const NodeId radicand = known_[graph_.nodes()[id].operands[0]];
  if (!is_nonnegative(nodes_, radicand)) {
    return refused(id, "the radicand of a root may be negative",
                   "a floating-point format, or a radicand such as a sum of squares");
  }
  FixedNode root{.operation = Operation::square_root, .operands = {radicand, -1}, .constant = {}};
  const Range& squares = nodes_[radicand].value;
  const Range exact = {root_of(squares.low, root_digits), root_above(squares.high, root_digits)};
  root.error = root_error(nodes_, radicand);
  const mpq_class effect = std::max<mpq_class>(-root.error.low, root.error.high);
  const int half_unit = nodes_[radicand].format.unit_exponent / 2 - 1;  // where all roots are zero
  const int largest = exact.high == 0
                          ? half_unit
                          : static_cast<int>(floor_log2(root_of(squares.high, root_digits)));
  const int finest = largest + 1 - options_.format.bits - spare_root_bits;
  const int wanted = effect == 0 ? finest : static_cast<int>(floor_log2(effect)) - 1;
  const int unit_exponent = std::clamp(wanted, finest, largest);
  const mpq_class unit = power_of_two(unit_exponent);
  root.error.low -= unit;
  root.value = {floor_of(exact.low / unit) * unit, floor_of(exact.high / unit) * unit};
  root.format = format_of(root.value, unit_exponent);
  return root;
}

FixedNode FixedGraphBuilder::operation(Operation operation, NodeId a, NodeId b) const {
  const FixedNode& first = nodes_[a];
  const FixedNode& second = nodes_[b < 0 ? a : b];
  FixedNode node{.operation = operation, .operands = {a, b}, .constant = {}};
  const bool cancels = operation == Operation::subtract && a == b;
  node.value = cancels ? Range{0, 0} : exact_value(operation, first.value, second.value);
  node.error = cancels ? Range{0, 0} : exact_error(operation, first, second);
  node.format = format_of(node.value, unit_exponent_of(operation, first.format, second.format));
  drop_bits(node, node.format.width - 2 * options_.format.bits - spare_bits);
  return node;
}

NodeId FixedGraphBuilder::add(FixedNode node) {
  const auto known = std::find(nodes_.begin(), nodes_.end(), node);
  const auto id = static_cast<NodeId>(known - nodes_.begin());
  if (known == nodes_.end()) nodes_.push_back(std::move(node));
  return id;
}

}  // namespace mixcmp::fixed
