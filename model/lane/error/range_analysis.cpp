#include "model/lane/error/range_analysis.hpp"

#include <algorithm>

#include "model/base/number/dyadic.hpp"
#include "model/base/number/exact.hpp"

namespace mixcmp::error {
namespace {

/// The largest number of `format` that is at most `value`. Subnormals are included, and exponents
/// are unlimited above.
mpq_class round_down(FloatFormat format, const mpq_class& value) {
  if (value == 0) return value;
  const long exponent = std::max<long>(floor_log2(abs(value)), format.min_exponent());
  const mpq_class unit = power_of_two(exponent - format.fraction_bits());
  return floor_of(value / unit) * unit;
}

mpq_class round_up(FloatFormat format, const mpq_class& value) {
  return -round_down(format, -value);
}

/// Square root rounded down, with more bits than any format; 0 for a negative value.
mpq_class root_down(const mpq_class& value) {
  if (value <= 0) return 0;
  constexpr long spare_bits = 2L * FloatFormat::max_precision;
  const long scale = spare_bits - floor_log2(value) / 2;
  mpz_class root = floor_of(value * power_of_two(2 * scale));
  mpz_sqrt(root.get_mpz_t(), root.get_mpz_t());
  return root * power_of_two(-scale);
}

mpq_class root_up(const mpq_class& value) {
  const mpq_class root = root_down(value);
  if (root * root == value || value <= 0) return root;
  return root + root * power_of_two(-FloatFormat::max_precision);
}

class RangeAnalyser {
public:
  RangeAnalyser(const TypedGraph& graph, const std::vector<std::optional<Range>>& ranges,
                Infinities infinities)
      : graph_(graph), ranges_(ranges), infinities_(infinities) {}

  std::vector<NodeRange> run() {
    for (const TypedNode& node : graph_.nodes) nodes_.push_back(analyse(node));
    return std::move(nodes_);
  }

private:
  const Range& operand(const TypedNode& node, std::size_t k) const {
    return nodes_[static_cast<std::size_t>(node.operands[k])].value;
  }

  NodeRange analyse(const TypedNode& node) {
    NodeRange result{.value = exact(node)};
    result.rangeless_inputs = rangeless(node);
    if (node.is_sign_of_sum()) return result;
    const auto mark = [&](Event event, bool may) {
      result.may_happen[static_cast<std::size_t>(event)] = may;
    };
    if (node.operation == Operation::divide) {
      mark(Event::division_by_zero, contains_zero(operand(node, 1)));
    }
    if (node.operation == Operation::square_root) {
      mark(Event::root_of_negative, operand(node, 0).low < 0);
    }
    if (node.operation != Operation::input && !only_moves_bits(node.operation)) {
      mark(Event::overflow, overflows(node, result.value));
      mark(Event::underflow, underflows(node, result.value));
    }
    if (is_choice(node.operation)) mark(Event::underflow, flushes_an_operand(node));
    const bool overflows_below = result.value.low < -largest_of(node.format);
    result.value = settled(node.format, result.value);
    if (infinities_ == Infinities::followed) {
      follow_infinities(node, result);
      result.may_be_negative_infinite =
          (overflows_below && !only_moves_bits(node.operation)) || passes_negative_infinity(node);
    }
    return result;
  }

  const NodeRange& below(const TypedNode& node, std::size_t k) const {
    return nodes_[static_cast<std::size_t>(node.operands[k])];
  }

  /// Whether -inf may result from an infinite operand, or from a division by a zero of either sign.
  bool passes_negative_infinity(const TypedNode& node) const {
    const auto infinite = [&](std::size_t k) { return below(node, k).may_be_infinite; };
    const auto negative = [&](std::size_t k) { return below(node, k).may_be_negative_infinite; };
    const auto below_zero = [&](std::size_t k) { return negative(k) || operand(node, k).low < 0; };
    switch (node.operation) {
      case Operation::input:
      case Operation::constant:
      case Operation::absolute:
      case Operation::square:
      case Operation::square_root: return false;
      case Operation::convert: return negative(0);
      case Operation::negate: return infinite(0);
      case Operation::add:
      case Operation::minimum:
      case Operation::maximum: return negative(0) || negative(1);
      case Operation::subtract: return negative(0) || infinite(1);
      case Operation::multiply:
        return (infinite(0) || infinite(1)) && (below_zero(0) || below_zero(1));
      case Operation::divide:
        return contains_zero(operand(node, 1)) || (infinite(0) && (below_zero(0) || below_zero(1)));
      case Operation::fused_sum:
        return std::any_of(node.terms.begin(), node.terms.end(),
                           [&](const FusedTerm& term) { return passes_negative_infinity(term); });
      case Operation::function:
      case Operation::look_up: break;
    }
    MIXCMP_CHECK(false);
  }

  bool passes_negative_infinity(const FusedTerm& term) const {
    const auto& a = nodes_[static_cast<std::size_t>(term.a)];
    const auto& b = nodes_[static_cast<std::size_t>(term.is_product() ? term.b : term.a)];
    if (term.negated) return a.may_be_infinite || b.may_be_infinite;
    if (!term.is_product()) return a.may_be_negative_infinite;
    const auto below_zero = [](const NodeRange& x) {
      return x.may_be_negative_infinite || x.value.low < 0;
    };
    return !term.is_square() && (a.may_be_infinite || b.may_be_infinite) &&
           (below_zero(a) || below_zero(b));
  }

  /// Adds the node's results for infinite operands: a / inf is zero, and the smaller of x and inf
  /// is x.
  void follow_infinities(const TypedNode& node, NodeRange& result) const {
    bool infinite_operand = false;
    for (const NodeId operand : operands_of(node)) {
      infinite_operand |= nodes_[static_cast<std::size_t>(operand)].may_be_infinite;
    }
    result.may_be_infinite =
        infinite_operand || result.may(Event::overflow) || result.may(Event::division_by_zero);
    if (!infinite_operand) return;
    const auto include = [&result](const Range& range) {
      result.value = mixcmp::hull({result.value.low, result.value.high, range.low, range.high});
    };
    if (node.operation == Operation::minimum || node.operation == Operation::maximum) {
      include(operand(node, 0));
      include(operand(node, 1));
    }
    // inf / inf is no value.
    const bool different = node.operands[0] != node.operands[1];
    if (node.operation == Operation::divide && different && below(node, 1).may_be_infinite) {
      include({0, 0});
    }
    if (node.operation == Operation::square_root && below(node, 0).may_be_negative_infinite) {
      result.may_happen[static_cast<std::size_t>(Event::root_of_negative)] = true;
    }
  }

  std::vector<int> rangeless(const TypedNode& node) const {
    if (node.operation == Operation::input) {
      const bool declared = ranges_[static_cast<std::size_t>(node.input)].has_value();
      return declared ? std::vector<int>{} : std::vector<int>{node.input};
    }
    std::vector<int> inputs;
    for (const NodeId operand : operands_of(node)) {
      const auto& below = nodes_[static_cast<std::size_t>(operand)].rangeless_inputs;
      inputs.insert(inputs.end(), below.begin(), below.end());
    }
    std::sort(inputs.begin(), inputs.end());
    inputs.erase(std::unique(inputs.begin(), inputs.end()), inputs.end());
    return inputs;
  }

  /// Encloses the node's exact result for operands in their enclosures.
  Range exact(const TypedNode& node) const {
    switch (node.operation) {
      case Operation::input: return input(node);
      case Operation::constant: return {node.value, node.value};
      case Operation::convert: return operand(node, 0);
      case Operation::negate: return negated(operand(node, 0));
      case Operation::absolute: return absolute(operand(node, 0));
      case Operation::square: return square(operand(node, 0));
      case Operation::square_root:
        return {root_down(operand(node, 0).low), root_up(operand(node, 0).high)};
      case Operation::add:
      case Operation::subtract:
      case Operation::multiply:
      case Operation::divide:
      case Operation::minimum:
      case Operation::maximum: return exact(node, operand(node, 0), operand(node, 1));
      case Operation::fused_sum: return node.is_sign_of_sum() ? Range{-1, 1} : cut_sum(node);
      case Operation::function:
      case Operation::look_up: break;
    }
    MIXCMP_CHECK(false);
  }

  Range exact(const FusedTerm& term) const {
    const auto value = [&](NodeId id) { return nodes_[static_cast<std::size_t>(id)].value; };
    Range range = value(term.a);
    if (term.is_square()) range = square(range);
    if (term.is_product() && !term.is_square()) range = product(range, value(term.b));
    return term.negated ? negated(range) : range;
  }

  /// Encloses the sum that a fused sum rounds. Its terms are cut toward zero, each by less than a
  /// unit that the largest term or the smallest normal number sets.
  Range cut_sum(const TypedNode& node) const {
    Range whole{0, 0}, with_zeros{0, 0};
    mpq_class largest = power_of_two(node.format.min_exponent());
    for (const FusedTerm& term : node.terms) {
      const Range range = exact(term);
      whole = sum(whole, range);
      with_zeros = sum(with_zeros, mixcmp::hull({range.low, range.high, 0}));
      largest = std::max<mpq_class>(largest, absolute(range).high);
    }
    const int digits = node.format.precision() + fused_guard_digits(node.terms.size());
    const mpq_class lost = largest * power_of_two(-digits) * mpq_class(node.terms.size());
    return {std::max<mpq_class>(whole.low - lost, with_zeros.low),
            std::min<mpq_class>(whole.high + lost, with_zeros.high)};
  }

  Range exact(const TypedNode& node, const Range& a, const Range& b) const {
    const bool same = node.operands[0] == node.operands[1];
    switch (node.operation) {
      case Operation::add: return sum(a, b);
      case Operation::subtract: return same ? Range{0, 0} : difference(a, b);
      case Operation::multiply: return product(a, b);
      case Operation::divide: return same ? Range{1, 1} : quotient(node.format, a, b);
      case Operation::minimum: return minimum(a, b);
      case Operation::maximum: return maximum(a, b);
      case Operation::input:
      case Operation::constant:
      case Operation::convert:
      case Operation::negate:
      case Operation::absolute:
      case Operation::square:
      case Operation::square_root:
      case Operation::function:
      case Operation::look_up:
      case Operation::fused_sum: break;
    }
    MIXCMP_CHECK(false);
  }

  Range input(const TypedNode& node) const {
    const auto& range = ranges_[static_cast<std::size_t>(node.input)];
    if (range) return *range;
    const mpq_class largest = largest_of(graph_.arriving_format(node.input));
    return {-largest, largest};
  }

  /// The range of a / b. It reaches beyond the format's largest number if the range of b contains
  /// zero.
  static Range quotient(FloatFormat format, const Range& a, const Range& b) {
    if (!contains_zero(b)) return product(a, {1 / b.high, 1 / b.low});
    const mpq_class beyond = 2 * largest_of(format);
    if (b.low == 0 && b.high > 0 && a.low >= 0) {
      return {a.low / b.high, std::max<mpq_class>(beyond, a.high / b.high)};
    }
    return {-beyond, beyond};
  }

  static mpq_class largest_of(FloatFormat format) {
    return to_rational(format, format.largest_finite(false));
  }

  static bool overflows(const TypedNode& node, const Range& exact) {
    return absolute(exact).high > largest_of(node.format);
  }

  /// Whether a minimum or a maximum may treat a subnormal operand as zero.
  bool flushes_an_operand(const TypedNode& node) const {
    if (graph_.arithmetic.subnormals == Subnormals::gradual) return false;
    return std::any_of(node.operands.begin(), node.operands.end(), [&](NodeId id) {
      return is_given(id) && may_be_small(node.format, nodes_[static_cast<std::size_t>(id)].value);
    });
  }

  /// Whether the value is an input or a constant, up to its sign. Operations that flush have no
  /// subnormal results.
  bool is_given(NodeId id) const {
    const TypedNode& node = graph_.nodes[id];
    const bool changes_sign =
        node.operation == Operation::negate || node.operation == Operation::absolute;
    return arity(node.operation) == 0 || (changes_sign && is_given(node.operands[0]));
  }

  /// Whether a non-zero number of the range may lie below the smallest normal number.
  static bool may_be_small(FloatFormat format, const Range& range) {
    const mpq_class smallest = power_of_two(format.min_exponent());
    const bool only_zero = range.low == 0 && range.high == 0;
    return !only_zero && range.low < smallest && range.high > -smallest;
  }

  bool underflows(const TypedNode& node, const Range& exact) const {
    const bool sum = node.operation == Operation::add || node.operation == Operation::subtract;
    const bool gradual = graph_.arithmetic.subnormals == Subnormals::gradual;
    // Subnormal sums of numbers of the same format are exact.
    if (sum && gradual && node.operand_format == node.format) return false;
    return may_be_small(node.format, exact);
  }

  /// Encloses the finite results of rounding the values of `exact` into `format`.
  Range settled(FloatFormat format, const Range& exact) const {
    const mpq_class largest = largest_of(format);
    const auto clamped = [&](const mpq_class& value) {
      return std::max<mpq_class>(-largest, std::min(value, largest));
    };
    Range range{clamped(round_down(format, exact.low)), clamped(round_up(format, exact.high))};
    if (graph_.arithmetic.subnormals == Subnormals::gradual) return range;
    const mpq_class smallest = power_of_two(format.min_exponent());
    if (range.low > 0 && range.low < smallest) range.low = 0;
    if (range.high < 0 && range.high > -smallest) range.high = 0;
    return range;
  }

  const TypedGraph& graph_;
  const std::vector<std::optional<Range>>& ranges_;
  Infinities infinities_;
  std::vector<NodeRange> nodes_;
};

}  // namespace

std::string_view to_string(Event event) {
  switch (event) {
    case Event::overflow: return "overflow";
    case Event::underflow: return "underflow";
    case Event::division_by_zero: return "division by zero";
    case Event::root_of_negative: return "root of a negative number";
  }
  MIXCMP_CHECK(false);
}

std::vector<NodeRange> analyse_ranges(const TypedGraph& graph,
                                      const std::vector<std::optional<Range>>& ranges,
                                      Infinities infinities) {
  MIXCMP_CHECK(ranges.size() == static_cast<std::size_t>(graph.input_count));
  return RangeAnalyser(graph, ranges, infinities).run();
}

}  // namespace mixcmp::error
