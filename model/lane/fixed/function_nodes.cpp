#include <algorithm>

#include "model/base/number/dyadic.hpp"
#include "model/lane/fixed/function_error.hpp"
#include "model/lane/fixed/graph_builder.hpp"
#include "model/lane/fixed/node_enclosure.hpp"
#include "model/lane/fixed/root_error.hpp"
#include "model/lane/function/taylor.hpp"

/// Functions as piecewise polynomials. Proof: docs/fixed_point.md, theorem 10.
namespace mixcmp::fixed {
namespace {

using function::Interval;

/// A limit costs a comparator. It is worth that if errors become so many times smaller.
constexpr int worth_a_limit = 2;

/// How near to an end without a value an argument is looked at, from so far on the other side. An
/// error e moves the logarithm and the quotient of like numbers by some e / d at distance d. Nearer
/// arguments, a share of d / span, are left undecided: this d makes both equal.
mpq_class balanced_distance(const Range& error, const mpq_class& span) {
  return root_of(absolute(error).high * span, root_digits);
}

/// The map of a node that is affine in one of its operands, which is no constant; none otherwise.
struct AffineStep {
  NodeId operand;
  AffineMap map;
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

bool is_smooth(const Function& function) {
  const auto smooth = std::find(all_functions.begin(), all_functions.end(), function.kind());
  return smooth != all_functions.end();
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
    case Operation::input:
      if (options_.ranges.empty()) return std::nullopt;
      return options_.ranges[static_cast<std::size_t>(node.input)];
    case Operation::constant: return Range{node.value, node.value};
    case Operation::square_root: {
      const Range& radicand = declared(node.operands[0]);
      if (radicand.low < 0) return std::nullopt;
      return Range{root_of(radicand.low, root_digits), root_above(radicand.high, root_digits)};
    }
    case Operation::divide: {
      if (is_normalised_difference(id)) return Range{-1, 1};
      const Range& divisor = declared(node.operands[1]);
      if (divisor.low <= 0 && divisor.high >= 0) return std::nullopt;
      const Range factor = {1 / divisor.high, 1 / divisor.low};
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

/// The argument of a function, limited if its format has numbers beyond what the scene declares at
/// which the function has no value or is steep.
Result<NodeId> FixedGraphBuilder::argument_of(NodeId id, const Function& function, NodeId whole,
                                              const Range& real) {
  const FixedNode& argument = nodes_[whole];
  const mpq_class unit = argument.format.unit();
  mpz_class least = floor_of((real.low + argument.error.low) / unit);
  mpz_class greatest = ceiling_of((real.high + argument.error.high) / unit);
  const Domain accepted = domain(function);
  // A lane leaves what may have no value undecided; a reference trusts the ranges.
  const Range reached = options_.is_reference ? real : stood_for(argument.value, argument.error);
  if (const auto& low = accepted.low; low && (low->is_open || reached.low < low->at)) {
    mpq_class end = low->at + argument.error.high;
    const mpz_class first = low->is_open ? floor_of(end / unit) + 1 : ceiling_of(end / unit);
    least = std::max(least, first);
    if (low->is_open && real.low <= low->at && !options_.is_reference) {
      end = low->at + balanced_distance(argument.error, real.high - low->at);
      least = std::max(least, floor_of(end / unit));
    }
  }
  if (const auto& high = accepted.high; high && (high->is_open || reached.high > high->at)) {
    mpq_class end = high->at + argument.error.low;
    const mpz_class last = high->is_open ? ceiling_of(end / unit) - 1 : floor_of(end / unit);
    greatest = std::min(greatest, last);
    if (high->is_open && real.high >= high->at && !options_.is_reference) {
      end = high->at - balanced_distance(argument.error, high->at - real.low);
      greatest = std::min(greatest, ceiling_of(end / unit));
    }
  }
  Range limits = {std::max<mpq_class>(argument.value.low, least * unit),
                  std::min<mpq_class>(argument.value.high, greatest * unit)};
  const auto limited =
      limits.low > limits.high ? std::nullopt : moved_by(function, limits, argument.error);
  if (!limited) {
    return refused(id, "the argument's range holds numbers at which the function has no bound",
                   options_.is_reference
                       ? "a narrower range of the inputs (references do not read limits)"
                       : "a narrower range of the inputs, or within(x, low, high) around the "
                         "argument");
  }
  const auto unlimited = moved_by(function, argument.value, argument.error);
  const bool has_all_values = accepted.contains(reached.low) && accepted.contains(reached.high);
  if (has_all_values && unlimited &&
      absolute(*unlimited).high <= worth_a_limit * absolute(*limited).high) {
    return whole;
  }
  FixedNode node = conversion(Conversion::limit, whole);
  node.value = limits;
  node.format = format_of(node.value, argument.format.unit_exponent);
  return add(std::move(node));
}

/// The node of the coefficient of t^power. A constant does not read the argument, whose operands
/// and limits are checked only if something does: a polynomial of degree 0 is a look-up.
NodeId FixedGraphBuilder::coefficient(const Function& function,
                                      const function::Piecewise& piecewise, int power,
                                      NodeId argument) {
  const function::CoefficientTable& table = piecewise.coefficients[static_cast<std::size_t>(power)];
  const mpq_class unit = table.format.unit();
  const bool is_read = piecewise.degree() > 0 || is_constant(nodes_, argument);
  if (is_read && are_equal(table.words)) {
    FixedNode constant{.operation = Operation::constant, .constant = table.words[0]};
    constant.format = table.format;
    constant.function = function;
    constant.value = {table.words[0] * unit, table.words[0] * unit};
    return add(std::move(constant));
  }
  FixedNode word =
      word_of(function, argument, with_address(table.words), table.format.unit_exponent);
  word.format = table.format;
  word.power = power;
  return add(std::move(word));
}

/// A word of a table, whose address is the upper bits of a node.
FixedNode FixedGraphBuilder::word_of(const Function& function, NodeId address,
                                     const function::Words& words, int unit_exponent) const {
  FixedNode word{.operation = Operation::look_up, .operands = {address, -1}, .constant = {}};
  mpz_class least = words[0], greatest = words[0];
  for (std::size_t k = 1; k < words.size(); ++k) {
    least = std::min(least, words[k]);
    greatest = std::max(greatest, words[k]);
  }
  word.value = {scaled(mpq_class(least), unit_exponent),
                scaled(mpq_class(greatest), unit_exponent)};
  word.format = format_of(word.value, unit_exponent);
  word.words = words;
  word.function = function;
  return word;
}

NodeId FixedGraphBuilder::floating_code(const Function& function, NodeId argument) {
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
  node.function = function;
  return add(std::move(node));
}

/// Makes the node whose upper bits are the address of the argument's piece, and t.
FixedGraphBuilder::Place FixedGraphBuilder::place_of(const Function& function,
                                                     const function::Piecewise& piecewise,
                                                     NodeId argument) {
  if (!piecewise.starts.empty()) return place_after_start(function, piecewise, argument);
  if (piecewise.is_floating) argument = floating_code(function, argument);
  if (piecewise.degree() == 0) return {argument, -1};
  FixedNode place = conversion(Conversion::place, argument);
  place.format = {.width = piecewise.piece_bits,
                  .unit_exponent = nodes_[argument].format.unit_exponent};
  place.value = {0, place.format.largest() * place.format.unit()};
  place.error = {0, 0};
  place.function = function;
  return {argument, add(std::move(place))};
}

/// The address is the sum of one for each start but the first that the argument reaches; t is the
/// argument less the start of its piece.
FixedGraphBuilder::Place FixedGraphBuilder::place_after_start(const Function& function,
                                                              const function::Piecewise& piecewise,
                                                              NodeId argument) {
  const int unit_exponent = nodes_[argument].format.unit_exponent;
  const std::vector<mpz_class>& starts = piecewise.starts;
  std::vector<NodeId> reached;
  for (std::size_t k = 1; k < starts.size(); ++k) {
    const NodeId start =
        exact_constant(starts[k], unit_exponent, scaled(mpq_class(starts[k]), unit_exponent));
    FixedNode beyond = itself(exactly(Operation::subtract, argument, start));
    beyond.function = function;
    const function::Words one_or_none(std::vector<mpz_class>{1, 0});
    reached.push_back(add(word_of(Function::sign, add(std::move(beyond)), one_or_none, 0)));
  }
  while (reached.size() > 1) {
    std::vector<NodeId> sums;
    for (std::size_t k = 0; k + 1 < reached.size(); k += 2) {
      FixedNode sum = exactly(Operation::add, reached[k], reached[k + 1]);
      sum.function = function;
      sums.push_back(add(std::move(sum)));
    }
    if (reached.size() % 2 != 0) sums.push_back(reached.back());
    reached = std::move(sums);
  }
  if (reached.empty()) reached.push_back(argument);  // one piece, whose words have no address
  NodeId start = -1;
  if (starts.size() == 1) {
    start = exact_constant(starts[0], unit_exponent, scaled(mpq_class(starts[0]), unit_exponent));
  } else {
    std::vector<mpz_class> all = starts;
    all.resize(std::size_t{1} << piecewise.address_bits(), starts.back());
    FixedNode word = word_of(function, reached.front(), function::Words(all), unit_exponent);
    word.power = -1;
    start = add(std::move(word));
  }
  FixedNode t = itself(exactly(Operation::subtract, argument, start));
  t.format = {.width = piecewise.piece_bits, .unit_exponent = unit_exponent};
  t.value = {0, t.format.largest() * t.format.unit()};
  t.function = function;
  return {reached.front(), add(std::move(t))};
}

/// A node that stands for the computed number, not for a real one.
FixedNode FixedGraphBuilder::itself(FixedNode node) const {
  node.error = {0, 0};
  return node;
}

/// Whether one multiplier of Xilinx' DSP48 takes these factors, of which t has no sign.
bool fits_block(const FixedNode& factor, const FixedNode& t) {
  const int bits = factor.format.magnitude_bits(), t_bits = t.format.width;
  return std::min(bits, t_bits) <= 17 && std::max(bits, t_bits) <= 24;
}

/// The polynomial's value before its last cut. The computed numbers inside stand for themselves, so
/// that they have no error. A coefficient has no bits below the cut of its product, so the cut of
/// their sum gives the same number, and the adder of a multiplier block can make that sum.
NodeId FixedGraphBuilder::polynomial(const Function& function, const function::Piecewise& piecewise,
                                     NodeId argument) {
  const auto [address, t] = place_of(function, piecewise, argument);
  NodeId sum = coefficient(function, piecewise, piecewise.degree(), address);
  for (int k = piecewise.degree() - 1; k >= 0; --k) {
    const NodeId constant = coefficient(function, piecewise, k, address);
    FixedNode product = exactly(Operation::multiply, sum, t);
    const int dropped = nodes_[constant].format.unit_exponent - product.format.unit_exponent;
    const bool is_added_in_block =
        options_.products == function::ProductKind::embedded && fits_block(nodes_[sum], nodes_[t]);
    if (!is_added_in_block) drop_bits(product, dropped);
    const NodeId multiple = add(itself(std::move(product)));
    FixedNode next = exactly(Operation::add, constant, multiple);
    if (is_added_in_block) drop_bits(next, dropped);
    sum = add(itself(std::move(next)));
  }
  return sum;
}

/// Affine operations between a smooth function and a node are no nodes of the lane: tables hold the
/// values of both. A limit is checked where the expression has it.
FixedGraphBuilder::Applied FixedGraphBuilder::applied_at(NodeId id) const {
  const Node& node = graph_.nodes()[id];
  Applied applied{*node.function, node.operands[0]};
  if (!options_.format.is_plain() || !is_smooth(applied.function)) return applied;
  while (!graph_.limits().contains(applied.node)) {
    const auto step = affine_step(graph_, graph_.nodes()[applied.node]);
    if (!step) break;
    applied = {applied.function.of(step->map), step->operand};
  }
  return applied;
}

std::vector<NodeId> FixedGraphBuilder::read_by(NodeId id) const {
  const Node& node = graph_.nodes()[id];
  if (node.operation == Operation::function) return {applied_at(id).node};
  return {node.operands.begin(), node.operands.begin() + arity(node.operation)};
}

Result<FixedNode> FixedGraphBuilder::function(NodeId id) {
  const Applied found = applied_at(id);
  if (auto value = of_encoding(found, 0)) return *std::move(value);
  return applied(id, found.function, factor(read(found.node, affine_[id])), declared(found.node),
                 0);
}

/// Whether a quotient is (u - v) / (u + v) of numbers that are not negative: it is from -1 to 1.
bool FixedGraphBuilder::is_normalised_difference(NodeId id) {
  const auto [dividend, divisor] = graph_.nodes()[id].operands;
  const Node &first = graph_.nodes()[dividend], &second = graph_.nodes()[divisor];
  if (first.operation != Operation::subtract || second.operation != Operation::add) return false;
  const auto [u, v] = first.operands;
  return std::minmax(u, v) == std::minmax(second.operands[0], second.operands[1]) &&
         declared(u).low >= 0 && declared(v).low >= 0;
}

/// A quotient by a variable: the dividend times a power of the divisor.
Result<FixedNode> FixedGraphBuilder::quotient_by_variable(NodeId id) {
  const auto [dividend, divisor] = graph_.nodes()[id].operands;
  Range real = declared(divisor);
  if (real.low < 0 && real.high > 0) {
    return refused(id, "the divisor may be below 0 and above it",
                   "ranges, or within(x, low, high), that leave the divisor one sign");
  }
  NodeId argument = factor(operand(id, 1));
  const bool is_negative = real.low < 0;
  if (is_negative) {
    argument = add(operation(Operation::negate, argument));
    real = {-real.high, -real.low};
  }
  // The reciprocal has so many digits more as the quotient is smaller than by its factors' ranges.
  const NodeId first = operand(id, 0);
  const std::optional<Range> values = enclosed(id);
  const mpq_class unit = nodes_[argument].format.unit();
  const mpq_class least = std::max(real.low, unit);
  const mpq_class most = absolute(nodes_[first].value).high / least;
  const mpq_class largest = values ? absolute(*values).high : most;
  const int further =
      most > largest && largest > 0 ? static_cast<int>(floor_log2(most) - floor_log2(largest)) : 0;
  const Function reciprocal = Function::power_of(-1);
  std::optional<FixedNode> inverse = of_encoding({reciprocal, divisor}, further);
  if (!inverse) {
    MIXCMP_TRY(made, applied(id, reciprocal, argument, real, further));
    inverse = std::move(made);
  }
  NodeId quotient = add(product(first, add(*std::move(inverse))));
  if (is_negative) quotient = add(operation(Operation::negate, quotient));
  return further > 0 ? limited_to(quotient, *values) : nodes_[quotient];
}

/// A node limited to what it computes for real values of a range: no comparison is beyond.
FixedNode FixedGraphBuilder::limited_to(NodeId id, const Range& values) const {
  const FixedNode& whole = nodes_[id];
  const mpq_class unit = whole.format.unit();
  FixedNode node = conversion(Conversion::limit, id);
  narrow(node.value, {floor_of((values.low + whole.error.low) / unit) * unit,
                      ceiling_of((values.high + whole.error.high) / unit) * unit});
  node.format = format_of(node.value, whole.format.unit_exponent);
  return node;
}

/// A function of a node whose real values are in a range. `id` is the node of the expression that
/// errors name; the value has `further` digits more than others.
Result<FixedNode> FixedGraphBuilder::applied(NodeId id, const Function& function, NodeId whole,
                                             const Range& real, int further) {
  if (function.kind() == Function::sign) return sign(id, whole);
  if (function.kind() == Function::remainder) return remainder(id, function, whole);
  MIXCMP_TRY(argument, argument_of(id, function, whole, real));
  const FixedNode computed = nodes_[argument];
  const mpq_class unit = computed.format.unit();
  const Range moved = *moved_by(function, computed.value, computed.error);
  const Range values = function::value_on(function, computed.value).range();
  const int unit_exponent =
      unit_exponent_for(values, absolute(moved).high, options_.format.bits + further);
  const auto piecewise = function::approximate(
      function, {computed.format}, floor_of(computed.value.low / unit),
      ceiling_of(computed.value.high / unit), unit_exponent, options_.products);
  if (!piecewise) {
    return refused(id, "the function needs more pieces than a table has words",
                   "a narrower range of the inputs, or fewer bits");
  }
  return value_of(function, *piecewise, argument, values, moved);
}

/// The value of a polynomial; `moved` is what the argument's error does to it.
FixedNode FixedGraphBuilder::value_of(const Function& function,
                                      const function::Piecewise& piecewise, NodeId argument,
                                      const Range& values, const Range& moved) {
  const NodeId last = polynomial(function, piecewise, argument);
  FixedNode result = nodes_[last];
  if (piecewise.degree() > 0) {
    const int unit_exponent = piecewise.result.unit_exponent;
    result = conversion(Conversion::function_value, last);
    result.dropped_bits = unit_exponent - result.format.unit_exponent;
    result.function = function;
    const mpq_class result_unit = power_of_two(unit_exponent);
    result.value =
        rounded_down(sum(values, {piecewise.error.low, piecewise.error.high}), result_unit);
    narrow(result.value, rounded_down(nodes_[last].value, result_unit));
    result.format = format_of(result.value, unit_exponent);
  }
  result.error = sum(piecewise.error, moved);
  return result;
}

}  // namespace mixcmp::fixed
