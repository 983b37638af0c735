#include <algorithm>

#include "model/base/number/dyadic.hpp"
#include "model/lane/fixed/graph_builder.hpp"
#include "model/lane/fixed/node_enclosure.hpp"
#include "model/lane/fixed/root_error.hpp"
#include "model/lane/function/taylor.hpp"

/// Functions as piecewise polynomials. Proof: docs/fixed_point.md, theorem 10.
namespace mixcmp::fixed {
namespace {

/// A function's value has at most W + 8 bits.
constexpr int spare_function_bits = 8;

/// A limit costs a comparator. It is worth that if errors become so many times smaller.
constexpr int worth_a_limit = 2;

/// The real numbers that the computed ones of a range may stand for.
Range stood_for(const Range& computed, const Range& error) {
  return difference(computed, error);
}

/// By how much the value of function(inner(x)) changes if x does by an error: the slopes between
/// the computed x and the real one, times the error. None if some slope has no bound.
std::optional<Range> moved_by(Function function, const function::AffineMap& inner,
                              const Range& computed, const Range& error) {
  const Range real = stood_for(computed, error);
  const Range both = {std::min(computed.low, real.low), std::max(computed.high, real.high)};
  const function::Interval slope =
      function::taylor(function, function::Interval(inner.of(both)), 2, inner.factor).back();
  if (!slope.is_bounded()) return std::nullopt;
  return product(slope.range(), error);
}

/// The map of a node that is affine in one of its operands, which is no constant; none otherwise.
struct AffineStep {
  NodeId operand;
  function::AffineMap map;
};

std::optional<AffineStep> affine_step(const Graph& graph, const Node& node) {
  const auto constant = [&](int k) -> const mpq_class* {
    const Node& operand = graph.nodes()[node.operands[k]];
    return operand.operation == Operation::constant ? &operand.value : nullptr;
  };
  if (node.operation == Operation::negate && constant(0) == nullptr) {
    return AffineStep{node.operands[0], {.factor = -1}};
  }
  if (arity(node.operation) != 2 || (constant(0) == nullptr) == (constant(1) == nullptr)) {
    return std::nullopt;
  }
  const int read = constant(0) == nullptr ? 0 : 1;
  const mpq_class& c = *constant(1 - read);
  const NodeId operand = node.operands[read];
  switch (node.operation) {
    case Operation::add: return AffineStep{operand, {.offset = c}};
    case Operation::subtract:
      if (read == 1) return AffineStep{operand, {.factor = -1, .offset = c}};
      return AffineStep{operand, {.offset = -c}};
    case Operation::multiply:
      if (c == 0) return std::nullopt;
      return AffineStep{operand, {.factor = c}};
    case Operation::divide:
      if (read == 1 || c == 0) return std::nullopt;
      return AffineStep{operand, {.factor = 1 / c}};
    default: return std::nullopt;
  }
}

/// The unit of a function's values. As for a root, it is the power of two at or below half of the
/// error that results from the argument's error.
int unit_exponent_for(const Range& values, const mpq_class& effect, int bits) {
  const mpq_class greatest = absolute(values).high;
  const int largest = greatest == 0 ? 0 : static_cast<int>(floor_log2(greatest));
  const int digits = largest + 1 - bits;
  if (effect == 0) return digits;
  return std::clamp(static_cast<int>(floor_log2(effect)) - 1, digits - spare_function_bits,
                    largest);
}

bool are_equal(const function::Words& words) {
  for (std::size_t k = 1; k < words.size(); ++k) {
    if (words[k] != words[0]) return false;
  }
  return true;
}

/// Whether a node has the same number in every comparison.
bool is_constant(const std::vector<FixedNode>& nodes, NodeId id) {
  std::vector<bool> constant;
  for (NodeId each = 0; each <= id; ++each) {
    const FixedNode& node = nodes[each];
    bool is_so = node.operation != Operation::input;
    for (int k = 0; k < arity(node.operation); ++k) is_so = is_so && constant[node.operands[k]];
    constant.push_back(is_so);
  }
  return constant.back();
}

/// A table with an address.
function::Words with_address(const function::Words& words) {
  return words.size() > 1 ? words : function::Words(std::vector<mpz_class>{words[0], words[0]});
}

}  // namespace

const Range& FixedGraphBuilder::declared(NodeId id) {
  std::optional<Range>& range = declared_[id];
  if (range) return *range;
  const FixedNode& computed = nodes_[known_[id]];
  range = stood_for(computed.value, computed.error);
  if (const auto found = enclosed(id)) narrow(*range, *found);
  return *range;
}

/// The real values of a node by those of its operands; none if the computed numbers tell as much.
std::optional<Range> FixedGraphBuilder::enclosed(NodeId id) {
  const Node& node = graph_.nodes()[id];
  switch (node.operation) {
    case Operation::input: return options_.ranges[static_cast<std::size_t>(node.input)];
    case Operation::constant: return Range{node.value, node.value};
    case Operation::square_root: {
      const Range& radicand = declared(node.operands[0]);
      if (radicand.low < 0) return std::nullopt;
      return Range{root_of(radicand.low, root_digits), root_above(radicand.high, root_digits)};
    }
    case Operation::divide: {
      const mpq_class reciprocal = 1 / graph_.nodes()[node.operands[1]].value;
      const Range factor = {reciprocal, reciprocal};
      return exact_value(Operation::multiply, declared(node.operands[0]), factor);
    }
    case Operation::negate:
    case Operation::absolute:
    case Operation::square: return exact_value(node.operation, declared(node.operands[0]), {});
    case Operation::add:
    case Operation::subtract:
    case Operation::multiply:
    case Operation::minimum:
    case Operation::maximum: {
      const Range first = declared(node.operands[0]);
      return exact_value(node.operation, first, declared(node.operands[1]));
    }
    case Operation::convert:
    case Operation::function:
    case Operation::look_up:
    case Operation::fused_sum: return std::nullopt;
  }
  MIXCMP_CHECK(false);
}

/// Affine operations between a function and a node are no nodes of the lane: tables hold the values
/// of both. A limit is checked where the expression has it.
FixedGraphBuilder::Applied FixedGraphBuilder::applied(NodeId id) const {
  const Node& node = graph_.nodes()[id];
  Applied applied{*node.function, {}, node.operands[0]};
  const bool is_cut = options_.format.is_block || options_.format.guard_digits > 0;
  while (!is_cut && !graph_.limits().contains(applied.node)) {
    const auto step = affine_step(graph_, graph_.nodes()[applied.node]);
    if (!step) break;
    applied.inner = step->map.then(applied.inner);
    applied.node = step->operand;
  }
  return applied;
}

std::vector<NodeId> FixedGraphBuilder::read_by(NodeId id) const {
  const Node& node = graph_.nodes()[id];
  if (node.operation == Operation::function) return {applied(id).node};
  return {node.operands.begin(), node.operands.begin() + arity(node.operation)};
}

/// The argument of a function, limited if its format has numbers beyond what the scene declares at
/// which the function has no value or is steep.
Result<NodeId> FixedGraphBuilder::argument_of(NodeId id, const Applied& applied) {
  const auto& [function, inner, read] = applied;
  const NodeId whole = factor(this->read(read, affine_[id]));
  const FixedNode& argument = nodes_[whole];
  const Range &value = argument.value, &error = argument.error;
  const mpq_class unit = argument.format.unit();
  const Range& real = declared(read);
  mpz_class least = floor_of((real.low + error.low) / unit),
            greatest = ceiling_of((real.high + error.high) / unit);
  if (const auto end = open_end(function)) {
    const mpq_class at = (*end - inner.offset) / inner.factor;
    if (inner.factor > 0) {
      least = std::max<mpz_class>(least, floor_of((at + error.high) / unit) + 1);
    } else {
      greatest = std::min<mpz_class>(greatest, ceiling_of((at + error.low) / unit) - 1);
    }
  }
  Range limits = {std::max<mpq_class>(value.low, least * unit),
                  std::min<mpq_class>(value.high, greatest * unit)};
  const auto limited =
      limits.low > limits.high ? std::nullopt : moved_by(function, inner, limits, error);
  if (!limited) {
    return refused(id, "the argument's range holds numbers at which the function has no bound",
                   options_.is_reference
                       ? "a narrower range of the inputs (references do not read limits)"
                       : "a narrower range of the inputs, or within(x, low, high) around the "
                         "argument");
  }
  const auto unlimited = moved_by(function, inner, value, error);
  if (unlimited && absolute(*unlimited).high <= worth_a_limit * absolute(*limited).high) {
    return whole;
  }
  FixedNode node = conversion(Conversion::limit, whole);
  node.value = limits;
  node.format = format_of(node.value, argument.format.unit_exponent);
  return add(std::move(node));
}

/// The node of the coefficient of t^power. A constant does not read the argument, whose operands
/// and limits are checked only if something does: a polynomial of degree 0 is a look-up.
NodeId FixedGraphBuilder::coefficient(const Applied& applied, const function::Piecewise& piecewise,
                                      int power, NodeId argument) {
  const function::CoefficientTable& table = piecewise.coefficients[static_cast<std::size_t>(power)];
  const mpq_class unit = table.format.unit();
  const bool is_read = piecewise.degree() > 0 || is_constant(nodes_, argument);
  if (is_read && are_equal(table.words)) {
    FixedNode constant{.operation = Operation::constant, .constant = table.words[0]};
    constant.format = table.format;
    constant.function = applied.function;
    constant.inner = applied.inner;
    constant.value = {table.words[0] * unit, table.words[0] * unit};
    return add(std::move(constant));
  }
  FixedNode word{.operation = Operation::look_up, .operands = {argument, -1}, .constant = {}};
  word.format = table.format;
  mpz_class least = table.words[0], greatest = table.words[0];
  for (std::size_t k = 1; k < table.words.size(); ++k) {
    least = std::min(least, table.words[k]);
    greatest = std::max(greatest, table.words[k]);
  }
  word.value = {least * unit, greatest * unit};
  word.words = with_address(table.words);
  word.function = applied.function;
  word.inner = applied.inner;
  word.power = power;
  return add(std::move(word));
}

NodeId FixedGraphBuilder::floating_code(const Applied& applied, NodeId argument) {
  const FixedNode& number = nodes_[argument];
  const function::FloatingCode code{number.format.width};
  const auto at = [&](const mpq_class& end) {
    return scaled(mpq_class(code.of(floor_of(end / number.format.unit()))),
                  code.format().unit_exponent);
  };
  FixedNode node = conversion(Conversion::floating, argument);
  node.format = code.format();
  node.value = {at(number.value.low), at(number.value.high)};
  node.error = {0, 0};
  node.function = applied.function;
  node.inner = applied.inner;
  return add(std::move(node));
}

/// The polynomial's value before its last cut. The computed numbers inside stand for themselves, so
/// that they have no error.
NodeId FixedGraphBuilder::polynomial(const Applied& applied, const function::Piecewise& piecewise,
                                     NodeId argument) {
  if (piecewise.is_floating) argument = floating_code(applied, argument);
  NodeId sum = coefficient(applied, piecewise, piecewise.degree(), argument);
  if (piecewise.degree() == 0) return sum;
  FixedNode place = conversion(Conversion::place, argument);
  place.format = {.width = piecewise.piece_bits,
                  .unit_exponent = nodes_[argument].format.unit_exponent};
  place.value = {0, place.format.largest() * place.format.unit()};
  place.error = {0, 0};
  place.function = applied.function;
  place.inner = applied.inner;
  const NodeId t = add(std::move(place));
  for (int k = piecewise.degree() - 1; k >= 0; --k) {
    const NodeId constant = coefficient(applied, piecewise, k, argument);
    FixedNode product = exactly(Operation::multiply, sum, t);
    drop_bits(product, piecewise.coefficients[static_cast<std::size_t>(k)].format.unit_exponent -
                           product.format.unit_exponent);
    product.error = {0, 0};
    const NodeId multiple = add(std::move(product));
    sum = add(exactly(Operation::add, constant, multiple));
  }
  return sum;
}

Result<FixedNode> FixedGraphBuilder::function(NodeId id) {
  const Applied applied = this->applied(id);
  MIXCMP_TRY(argument, argument_of(id, applied));
  const FixedNode computed = nodes_[argument];
  const mpq_class unit = computed.format.unit();
  const Range moved = *moved_by(applied.function, applied.inner, computed.value, computed.error);
  const function::Interval arguments(applied.inner.of(computed.value));
  const Range values = function::value(applied.function, arguments).range();
  const int unit_exponent = unit_exponent_for(values, absolute(moved).high, options_.format.bits);
  const auto piecewise = function::approximate(
      applied.function, computed.format, floor_of(computed.value.low / unit),
      ceiling_of(computed.value.high / unit), unit_exponent, applied.inner, options_.products);
  if (!piecewise) {
    return refused(id, "the function needs more pieces than a table has words",
                   "a narrower range of the inputs, or fewer bits");
  }
  const NodeId last = polynomial(applied, *piecewise, argument);
  FixedNode result = nodes_[last];
  if (piecewise->degree() > 0) {
    result = conversion(Conversion::function_value, last);
    result.dropped_bits = unit_exponent - result.format.unit_exponent;
    result.function = applied.function;
    result.inner = applied.inner;
    const mpq_class result_unit = power_of_two(unit_exponent);
    result.value =
        rounded_down(sum(values, {piecewise->error.low, piecewise->error.high}), result_unit);
    narrow(result.value, rounded_down(nodes_[last].value, result_unit));
    result.format = format_of(result.value, unit_exponent);
  }
  result.error = sum(piecewise->error, moved);
  return result;
}

}  // namespace mixcmp::fixed
