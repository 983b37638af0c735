#include "model/lane/fixed/graph_builder.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "model/base/common/check.hpp"
#include "model/base/number/dyadic.hpp"
#include "model/comparison/expression/text.hpp"
#include "model/lane/fixed/affine_nodes.hpp"
#include "model/lane/fixed/node_enclosure.hpp"
#include "model/lane/fixed/root_error.hpp"

namespace mixcmp::fixed {
namespace {

/// Results have at most 2 W + 16 bits, or 16 bits more than an operand with its guard digits. With
/// these, sums of a few products of two operands stay exact, even if their units differ by some
/// places. A wider result loses its low bits.
constexpr int spare_bits = 16;

/// A root has at most W + 8 bits.
constexpr int spare_root_bits = 8;

/// The last bit of a factor is worth at most a 16th of its error, so cutting off finer bits adds no
/// more than that to the error.
constexpr int factor_guard_bits = 4;

/// The least k with magnitude < 2^k, limited to a range: from a binade above the format's smallest
/// normal number to one above its largest.
int exponent_above(const mpq_class& magnitude, FloatFormat format) {
  const int least = format.min_exponent() + 1, most = format.max_exponent() + 1;
  if (magnitude == 0) return least;
  return static_cast<int>(std::clamp<long>(floor_log2(magnitude) + 1, least, most));
}

/// The square root of a rational number; none if that is irrational.
std::optional<mpq_class> exact_root(const mpq_class& value) {
  const bool is_square = value > 0 && mpz_perfect_square_p(value.get_num_mpz_t()) != 0 &&
                         mpz_perfect_square_p(value.get_den_mpz_t()) != 0;
  if (!is_square) return std::nullopt;
  return mpq_class(sqrt(value.get_num()), sqrt(value.get_den()));
}

}  // namespace

FixedGraphBuilder::FixedGraphBuilder(const Graph& graph, FloatFormat input_format,
                                     const FixedOptions& options)
    : graph_(graph),
      input_format_(input_format),
      options_(options),
      affine_(affine_nodes(graph)),
      declared_(graph.nodes().size()),
      known_(graph.nodes().size(), -1),
      cut_(graph.nodes().size(), -1) {}

Result<Done> FixedGraphBuilder::cut_in_common() {
  if (options_.format.guard_digits == 0) return Done{};
  const std::vector<NodeId> read = nodes_to_cut(graph_);
  if (read.empty()) return nothing_to_cut();
  for (const NodeId id : read) {
    MIXCMP_TRY(whole, node(id));
    cut_[id] = factor(whole);
  }
  align_norms();
  int most = 0;
  for (const NodeId id : read) {
    most = std::max(most, nodes_[cut_[id]].format.magnitude_bits() - options_.format.bits);
  }
  if (most == 0) return Done{};
  for (const NodeId id : read) cut_[id] = add(common_cut(cut_[id], most));
  return Done{};
}

/// Gives the elements of each norm the coarsest of their units. Finer digits of one element would
/// only take digits from the others, since the common cut drops the same number of all.
void FixedGraphBuilder::align_norms() {
  for (const std::vector<NodeId>& squared : nodes_in_norms(graph_)) {
    const auto unit_exponent = [&](NodeId id) { return nodes_[cut_[id]].format.unit_exponent; };
    std::vector<int> units;
    for (const NodeId id : squared) {
      if (cut_[id] >= 0) units.push_back(unit_exponent(id));
    }
    for (const NodeId id : squared) {
      if (cut_[id] < 0) continue;
      const int coarsest = *std::max_element(units.begin(), units.end());
      cut_[id] = without_low_bits(cut_[id], coarsest - unit_exponent(id));
    }
  }
}

/// A conversion that does not change its operand yet.
FixedNode FixedGraphBuilder::conversion(Conversion conversion, NodeId id) const {
  FixedNode node{.operation = Operation::convert, .operands = {id, -1}, .constant = {}};
  node.conversion = conversion;
  node.format = nodes_[id].format;
  node.value = nodes_[id].value;
  node.error = nodes_[id].error;
  return node;
}

FixedNode FixedGraphBuilder::common_cut(NodeId id, int most) const {
  const FixedNode& whole = nodes_[id];
  FixedNode node = conversion(Conversion::common_cut, id);
  node.most_dropped = most;
  node.value = cut_value(whole, options_.format.bits, most);
  node.error = cut_error(whole, most);
  node.format = format_of(node.value, whole.format.unit_exponent);
  return node;
}

Error FixedGraphBuilder::nothing_to_cut() const {
  return {.field = "reduced.format",
          .message =
              "guard digits serve what is multiplied, squared or rooted: f and g have "
              "nothing of the kind",
          .received = options_.format.name(),
          .accepted = "f and g such as (a-b)^2 and c^2; or a format without guard digits"};
}

Result<NodeId> FixedGraphBuilder::side(const Sides& sides, NodeId id) {
  MIXCMP_TRY(whole, node(id));
  (void)whole;
  return read(id, affine_[sides.f] && affine_[sides.g]);
}

std::vector<NodeId> FixedGraphBuilder::nodes_in_products(const Sides& sides) {
  std::vector<NodeId> read_here;
  for (const NodeId id : fixed::nodes_in_products(graph_, sides))
    read_here.push_back(read(id, false));
  return read_here;
}

NodeId FixedGraphBuilder::operand(NodeId reader, int k) {
  return read(graph_.nodes()[reader].operands[k], affine_[reader]);
}

/// A constant used with uncut operands has as many digits as they have.
NodeId FixedGraphBuilder::read(NodeId id, bool by_affine) {
  const Node& node = graph_.nodes()[id];
  const FixedPoint& format = options_.format;
  if (node.operation == Operation::constant) {
    return add(constant(node.value, by_affine ? format.operand_bits() : format.bits));
  }
  return by_affine || cut_[id] < 0 ? known_[id] : cut_[id];
}

Result<NodeId> FixedGraphBuilder::node(NodeId id) {
  if (known_[id] >= 0) return known_[id];
  for (const NodeId operand : read_by(id)) {
    MIXCMP_TRY(made, node(operand));
    (void)made;
  }
  MIXCMP_TRY(made, make(id));
  known_[id] = add(std::move(made));
  const auto limits = graph_.limits().find(id);
  if (limits == graph_.limits().end() || options_.is_reference) return known_[id];
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

NodeId FixedGraphBuilder::within_reach(NodeId a, int bits) {
  const FixedNode& whole = nodes_[a];
  const mpq_class unit = whole.format.unit(), beyond = power_of_two(bits) * unit;
  const bool is_always_far = whole.value.low >= beyond || whole.value.high < -beyond;
  if (bits >= whole.format.magnitude_bits() || is_always_far) return a;
  FixedNode node = conversion(Conversion::reach, a);
  node.value = {std::max<mpq_class>(whole.value.low, -beyond),
                std::min<mpq_class>(whole.value.high, beyond - unit)};
  node.format = format_of(node.value, whole.format.unit_exponent);
  return add(std::move(node));
}

NodeId FixedGraphBuilder::with_squared(NodeId sum, const std::map<NodeId, NodeId>& others) {
  const FixedNode node = nodes_[sum];
  if (node.operation == Operation::square) {
    return add(operation(Operation::square, others.at(node.operands[0])));
  }
  const NodeId first = with_squared(node.operands[0], others);
  return add(operation(Operation::add, first, with_squared(node.operands[1], others)));
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
    case Operation::constant: return constant(node.value, options_.format.bits);
    case Operation::square_root: return square_root(id);
    case Operation::divide: return quotient(id);
    case Operation::function: return function(id);
    case Operation::convert:
    case Operation::negate:
    case Operation::absolute:
    case Operation::add:
    case Operation::subtract:
    case Operation::multiply:
    case Operation::square:
    case Operation::minimum:
    case Operation::maximum:
    case Operation::look_up:
    case Operation::fused_sum: break;
  }
  const NodeId first = operand(id, 0);
  if (node.operation == Operation::square) return operation(node.operation, factor(first));
  const NodeId second = arity(node.operation) < 2 ? -1 : operand(id, 1);
  if (node.operation != Operation::multiply) return operation(node.operation, first, second);
  const auto [a, b] = node.operands;
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

/// c^2 x^2 as (c x)^2, for which there may be a norm bound; none if the bound or the product is of
/// another kind.
std::optional<FixedNode> FixedGraphBuilder::multiple_of_square(const mpq_class& coefficient,
                                                               NodeId square) {
  if (options_.bound == BoundKind::constant ||
      graph_.nodes()[square].operation != Operation::square || graph_.limits().contains(square)) {
    return std::nullopt;
  }
  const std::optional<mpq_class> root = exact_root(coefficient);
  if (!root) return std::nullopt;
  const NodeId scale = add(constant(*root, options_.format.bits));
  const NodeId multiple = add(product(scale, operand(square, 0)));
  return operation(Operation::square, factor(multiple));
}

/// The dividend times the reciprocal of the divisor.
Result<FixedNode> FixedGraphBuilder::quotient(NodeId id) {
  const auto [dividend, divisor] = graph_.nodes()[id].operands;
  if (!divides_by_constant(graph_, id)) {
    if (!options_.format.is_plain()) {
      return refused(id, "lanes with guard digits or blocks divide only by constants",
                     "a lane such as q13, a floating-point format");
    }
    return quotient_by_variable(id);
  }
  const mpq_class reciprocal = 1 / graph_.nodes()[divisor].value;
  if (const auto square = multiple_of_square(reciprocal, dividend)) return *square;
  return product(operand(id, 0), add(constant(reciprocal, options_.format.bits)));
}

/// A lane checks limits on the computed number, errors included.
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
  FixedNode node = conversion(Conversion::limit, unlimited);
  node.value = checked;
  node.format = format_of(node.value, whole.format.unit_exponent);
  return add(std::move(node));
}

/// A node as a factor, without the low bits that its error makes meaningless: a multiplier's area
/// grows with the bits of both factors.
NodeId FixedGraphBuilder::factor(NodeId id) {
  const FixedNode& whole = nodes_[id];
  const mpq_class error = whole.error.high - whole.error.low;
  if (error == 0) return id;
  const int unit_exponent = static_cast<int>(floor_log2(error)) - factor_guard_bits;
  return without_low_bits(id, unit_exponent - whole.format.unit_exponent);
}

NodeId FixedGraphBuilder::without_low_bits(NodeId id, int count) {
  FixedNode node = conversion(Conversion::cut, id);
  drop_bits(node, std::min(count, node.format.magnitude_bits() - 1));
  return node.dropped_bits == 0 ? id : add(std::move(node));
}

Result<FixedNode> FixedGraphBuilder::input(const Node& node) const {
  const auto number = static_cast<std::size_t>(node.input);
  if (!options_.operand_formats.empty()) {
    const FixedFormat* arriving = options_.operand_formats[number].fixed();
    if (arriving != nullptr) return arriving_input(*arriving, node.input);
  }
  const std::optional<Range>& range = options_.ranges[number];
  const int bits = options_.format.operand_bits();
  if (options_.format.is_block) return input_below(0, bits, range && range->low >= 0, node.input);
  const std::string& name = graph_.inputs()[number];
  if (!range) {
    return Error{.field = fmt::format("inputs.{}.range", name),
                 .message = "a fixed-point lane needs a range for each input",
                 .received = "none",
                 .accepted = "a range, such as [0, 100]"};
  }
  const int top = exponent_above(absolute(*range).high, input_format_);
  if (const mpq_class* const grid = options_.relied_grid(number)) {
    const std::optional<FixedNode> exact = multiple_below(top, *grid, range->low >= 0, node.input);
    if (exact) return *exact;
  }
  return input_below(top, bits, range->low >= 0, node.input);
}

/// An operand that is a multiple of a promised grid, with a magnitude below 2^top; none if it has
/// more bits than the lane's format. If 2^top is not above the grid, only 0 is such an operand. An
/// integer has a bit all the same, so the lane then takes the grid as well.
std::optional<FixedNode> FixedGraphBuilder::multiple_below(int top, const mpq_class& grid,
                                                           bool nonnegative, int index) const {
  const int unit = static_cast<int>(std::min<long>(floor_log2(grid), input_format_.max_exponent()));
  const int bits = std::max(1, top - unit);
  if (bits > options_.format.operand_bits()) return std::nullopt;
  FixedNode exact = input_below(unit + bits, bits, nonnegative, index);
  exact.is_promised = true;
  exact.error = {0, 0};
  return exact;
}

/// An operand whose magnitude is below 2^top, in a unit of 2^(top - bits).
FixedNode FixedGraphBuilder::input_below(int top, int bits, bool nonnegative, int index) const {
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

/// An operand in fixed point, without the low bits beyond those that the lane's format has.
FixedNode FixedGraphBuilder::arriving_input(const FixedFormat& arriving, int index) const {
  FixedNode input{.operation = Operation::input, .input = index, .constant = {}};
  const mpq_class unit = arriving.unit();
  input.format = arriving;
  input.value = {arriving.smallest() * unit, arriving.largest() * unit};
  drop_bits(input, arriving.magnitude_bits() - options_.format.operand_bits());
  return input;
}

/// A constant is rounded to `bits` digits; with no more digits than that it stays exact.
FixedNode FixedGraphBuilder::constant(const mpq_class& value, int bits) const {
  FixedNode constant{.operation = Operation::constant, .constant = {}};
  int unit_exponent = 0;
  if (value != 0) {
    unit_exponent = static_cast<int>(floor_log2(abs(value))) + 1 - bits;
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

/// The unit is the power of two at or below half of the root's error that results from the
/// radicand's error, so rounding adds little to it. It is no coarser than the largest root.
Result<FixedNode> FixedGraphBuilder::square_root(NodeId id) {
  const NodeId radicand = operand(id, 0);
  if (!is_nonnegative(nodes_, radicand)) {
    return refused(id, "the radicand of a root may be negative",
                   "within(x, low, high), max(x, 0), or a radicand such as a sum of squares");
  }
  FixedNode root{.operation = Operation::square_root, .operands = {radicand, -1}, .constant = {}};
  const Range& squares = nodes_[radicand].value;
  const Range exact = {root_of(squares.low, root_digits), root_above(squares.high, root_digits)};
  root.error = root_error(nodes_, radicand);
  const mpq_class effect = std::max<mpq_class>(-root.error.low, root.error.high);
  const int half_unit = nodes_[radicand].format.unit_exponent / 2 - 1;  // if all roots are zero
  const int largest = exact.high == 0
                          ? half_unit
                          : static_cast<int>(floor_log2(root_of(squares.high, root_digits)));
  const int finest = largest + 1 - options_.format.bits - spare_root_bits;
  const int wanted = effect == 0 ? finest : static_cast<int>(floor_log2(effect)) - 1;
  const int unit_exponent = std::clamp(wanted, finest, largest);
  const mpq_class unit = power_of_two(unit_exponent);
  root.error.low -= unit;
  root.value = rounded_down(exact, unit);
  root.format = format_of(root.value, unit_exponent);
  return root;
}

FixedNode FixedGraphBuilder::operation(Operation operation, NodeId a, NodeId b) const {
  FixedNode node = exactly(operation, a, b);
  const int exact_bits = std::max(2 * options_.format.bits, options_.format.operand_bits());
  drop_bits(node, node.format.width - exact_bits - spare_bits);
  return node;
}

FixedNode FixedGraphBuilder::exactly(Operation operation, NodeId a, NodeId b) const {
  return exact_node(nodes_, operation, a, b);
}

NodeId FixedGraphBuilder::add(FixedNode node) {
  const auto known = std::find(nodes_.begin(), nodes_.end(), node);
  const auto id = static_cast<NodeId>(known - nodes_.begin());
  if (known == nodes_.end()) nodes_.push_back(std::move(node));
  return id;
}

}  // namespace mixcmp::fixed
