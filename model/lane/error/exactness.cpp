#include "model/lane/error/exactness.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <utility>

#include "model/base/common/check.hpp"
#include "model/base/number/dyadic.hpp"
#include "model/base/number/exact.hpp"
#include "model/comparison/expression/text.hpp"
#include "model/lane/error/range_analysis.hpp"

namespace mixcmp::error {
namespace {

/// The known limits of a node's values, if nothing is rounded.
struct Multiples {
  mpq_class quantum;  ///< a power of two: every value is a multiple
  /// No value has more significant digits; `unlimited`: `most` and `quantum` limit them.
  int digits;
  mpq_class most;  ///< no magnitude is larger

  static constexpr int unlimited = std::numeric_limits<int>::max();

  /// The digits that a format needs to hold every value.
  int precision() const {
    const mpz_class units = ceiling_of(mpq_class(most / quantum));
    const int of_units =
        is_power_of_two(mpq_class(units)) ? digits_of(units) - 1 : digits_of(units);
    return std::max(1, std::min(digits, of_units));
  }
};
/// None: the node rounds, or one below it does.
using Known = std::optional<Multiples>;

/// The finite numbers of a format.
Range range_of(const OperandFormat& format) {
  if (const FixedFormat* fixed = format.fixed()) {
    return {fixed->smallest() * fixed->unit(), fixed->largest() * fixed->unit()};
  }
  const mpq_class most = to_rational(*format.floating(), format.floating()->largest_finite(false));
  return {-most, most};
}

/// The limits of a format's numbers, but for the largest magnitude.
Multiples numbers_of(const OperandFormat& format) {
  if (const FixedFormat* fixed = format.fixed()) return {fixed->unit(), Multiples::unlimited};
  return {to_rational(*format.floating(), Bits{1}), format.floating()->precision()};
}

/// The values of a constant; none if its binary digits never end.
Known constant(const mpq_class& value) {
  if (value == 0) return Multiples{1, 1};
  if (!is_power_of_two(mpq_class(value.get_den()))) return std::nullopt;
  const mpq_class magnitude = abs(value);
  const long last = lowest_digit(magnitude);
  return Multiples{power_of_two(last), static_cast<int>(floor_log2(magnitude) - last) + 1,
                   magnitude};
}

class ExactnessAnalyser {
public:
  ExactnessAnalyser(const TypedGraph& graph, std::vector<std::optional<Range>> ranges,
                    const std::vector<std::optional<mpq_class>>& grids)
      : graph_(graph), declared_(std::move(ranges)), grids_(grids) {
    std::vector<std::optional<Range>> possible = declared_;
    for (int input = 0; input < graph.input_count; ++input) {
      auto& range = possible[static_cast<std::size_t>(input)];
      if (!range) range = range_of(graph.operand_format(input));
    }
    ranges_ = analyse_ranges(graph, possible);
  }

  /// The values of each node if no operation rounds, for unlimited formats.
  std::vector<Known> in_any_format() {
    for (const TypedNode& node : graph_.nodes) add(multiples(node));
    return std::move(nodes_);
  }

  std::vector<bool> in_formats_of_nodes() {
    std::vector<bool> exact;
    for (const TypedNode& node : graph_.nodes) {
      add(multiples(node));
      Known& known = nodes_.back();
      if (known && !node.is_sign_of_sum() && !fits(nodes_.size() - 1, *known)) known.reset();
      exact.push_back(known.has_value());
    }
    return exact;
  }

private:
  void add(Known known) {
    const Range& value = ranges_[nodes_.size()].value;
    if (known) known->most = std::max<mpq_class>(abs(value.low), abs(value.high));
    nodes_.push_back(std::move(known));
  }

  Known multiples(const TypedNode& node) const {
    const auto operand = [&](int k) -> const Known& {
      return nodes_[static_cast<std::size_t>(node.operands[k])];
    };
    switch (node.operation) {
      case Operation::input: return input(node.input);
      case Operation::constant: return constant(node.value);
      case Operation::convert:
      case Operation::negate:
      case Operation::absolute: return operand(0);
      case Operation::add:
      case Operation::subtract: return either(operand(0), operand(1), Multiples::unlimited);
      case Operation::minimum:
      case Operation::maximum: return choice(operand(0), operand(1));
      case Operation::multiply: return product(operand(0), operand(1));
      case Operation::square: return product(operand(0), operand(0));
      case Operation::divide: return quotient(operand(0), graph_.nodes[node.operands[1]]);
      case Operation::square_root: return std::nullopt;
      case Operation::fused_sum: return sum(node);
      case Operation::function:
      case Operation::look_up: break;
    }
    MIXCMP_CHECK(false);
  }

  /// A fused sum cuts its terms below a place that the largest one's exponent sets. None if that
  /// may cut a digit.
  Known sum(const TypedNode& node) const {
    mpq_class quantum, largest = 0;
    for (const FusedTerm& term : node.terms) {
      Known known = nodes_[static_cast<std::size_t>(term.a)];
      mpq_class most_of_term = known ? known->most : mpq_class();
      if (term.is_product()) {
        const Known& factor = nodes_[static_cast<std::size_t>(term.b)];
        known = product(known, factor);
        if (known) most_of_term *= factor->most;
      }
      if (!known) return std::nullopt;
      quantum = &term == &node.terms.front() ? known->quantum : std::min(quantum, known->quantum);
      largest = std::max(largest, most_of_term);
    }
    if (largest == 0) return node.is_sign_of_sum() ? Multiples{1, 1} : Multiples{quantum, 1};
    const int kept = node.operand_format.precision() + fused_guard_digits(node.terms.size());
    long exponent = floor_log2(largest);
    // With subnormals, small terms are cut as if one of them were the smallest normal number.
    if (graph_.arithmetic.subnormals == Subnormals::gradual) {
      exponent = std::max<long>(exponent, node.operand_format.min_exponent());
    }
    if (scaled(quantum, kept) < power_of_two(exponent)) return std::nullopt;
    return node.is_sign_of_sum() ? Multiples{1, 1, 1}
                                 : Multiples{quantum, Multiples::unlimited, largest};
  }

  Multiples input(int input) const {
    Multiples numbers = numbers_of(graph_.operand_format(input));
    const auto k = static_cast<std::size_t>(input);
    if (declared_[k] && grids_[k]) numbers.quantum = std::max(numbers.quantum, *grids_[k]);
    return numbers;
  }

  static Known either(const Known& a, const Known& b, int digits) {
    if (!a || !b) return std::nullopt;
    return Multiples{std::min(a->quantum, b->quantum), digits};
  }

  static Known choice(const Known& a, const Known& b) {
    return either(a, b, a && b ? std::max(a->precision(), b->precision()) : 0);
  }

  static Known product(const Known& a, const Known& b) {
    if (!a || !b) return std::nullopt;
    return Multiples{a->quantum * b->quantum, a->precision() + b->precision()};
  }

  static Known quotient(const Known& a, const TypedNode& divisor) {
    const bool scales =
        divisor.operation == Operation::constant && is_power_of_two(abs(divisor.value));
    if (!a || !scales) return std::nullopt;
    return Multiples{mpq_class(a->quantum / abs(divisor.value)), a->digits};
  }

  /// Whether the format of the node holds such numbers.
  bool fits(std::size_t id, const Multiples& numbers) const {
    const FloatFormat format = graph_.nodes[id].format;
    if (ranges_[id].may(Event::overflow) || numbers.precision() > format.precision()) return false;
    const TypedNode& node = graph_.nodes[id];
    if (node.operation == Operation::constant && format.is_infinite(node.constant)) return false;
    const bool gradual = graph_.arithmetic.subnormals == Subnormals::gradual;
    return numbers.quantum >=
           to_rational(format, gradual ? Bits{1} : format.smallest_normal(false));
  }

  const TypedGraph& graph_;
  std::vector<std::optional<Range>> declared_;
  const std::vector<std::optional<mpq_class>>& grids_;
  std::vector<NodeRange> ranges_;
  std::vector<Known> nodes_;
};

Error not_exact(std::string message, std::string received, std::string accepted) {
  return {.field = "reference.format",
          .message = std::move(message),
          .received = std::move(received),
          .accepted = std::move(accepted)};
}

constexpr std::size_t most_characters = 60;

/// Why an operation rounds in every format.
Error rounds_always(const TypedGraph& graph, NodeId id) {
  const TypedNode& node = graph.nodes[static_cast<std::size_t>(id)];
  const std::string text = to_text(graph.nodes, graph.input_names, id, most_characters);
  switch (node.operation) {
    case Operation::square_root:
      return not_exact("square roots are rounded", text, "the squares of both sides");
    case Operation::divide:
      return not_exact("quotients are rounded", text, "both sides times the divisor");
    case Operation::constant:
      return not_exact("a constant is no multiple of a power of two", text,
                       "constants such as 0.25");
    case Operation::input:
    case Operation::convert:
    case Operation::negate:
    case Operation::absolute:
    case Operation::add:
    case Operation::subtract:
    case Operation::multiply:
    case Operation::square:
    case Operation::minimum:
    case Operation::maximum:
    case Operation::function:
    case Operation::look_up:
    case Operation::fused_sum: break;
  }
  MIXCMP_CHECK(!"an operation that rounds although none below it does");
}

/// The exponent bits with which units of 2^last and numbers up to 2^first are normal numbers.
int exponent_bits_of(long first, long last) {
  const long farthest = std::max(std::abs(first), std::abs(last) + 1);
  int bits = FloatFormat::min_exponent_bits;
  while ((1L << (bits - 1)) - 1 < farthest) ++bits;
  return bits;
}

}  // namespace

std::vector<bool> exact_nodes(const TypedGraph& graph,
                              const std::vector<std::optional<Range>>& ranges,
                              const std::vector<std::optional<mpq_class>>& grids) {
  MIXCMP_CHECK(ranges.size() == grids.size());
  return ExactnessAnalyser(graph, ranges, grids).in_formats_of_nodes();
}

Result<FloatFormat> exact_format(const Graph& graph, const std::vector<OperandFormat>& formats,
                                 const std::vector<std::optional<Range>>& ranges,
                                 const std::vector<std::optional<mpq_class>>& grids) {
  const FloatFormat widest =
      FloatFormat::make(FloatFormat::max_precision, FloatFormat::max_exponent_bits).value();
  TypedGraph typed = sides_graph(graph, {.format = widest});
  typed.arriving = formats;
  const FloatFormat of_operands = format_holding(formats);
  int least_precision = of_operands.precision(), least_exponent_bits = of_operands.exponent_bits();
  const std::vector<Known> nodes = ExactnessAnalyser(typed, ranges, grids).in_any_format();
  const auto text = [&](std::size_t id) {
    return to_text(typed.nodes, typed.input_names, static_cast<NodeId>(id), most_characters);
  };
  for (std::size_t id = 0; id < nodes.size(); ++id) {
    if (!nodes[id]) return rounds_always(typed, static_cast<NodeId>(id));
    const int precision = nodes[id]->precision();
    if (precision > FloatFormat::max_precision) {
      return not_exact(fmt::format("it needs {} digits", precision), text(id),
                       fmt::format("at most {}; a range and a grid for the inputs lower it",
                                   FloatFormat::max_precision));
    }
    least_precision = std::max(least_precision, precision);
    const long first = nodes[id]->most == 0 ? 0 : floor_log2(nodes[id]->most) + 1;
    const int exponent_bits = exponent_bits_of(first, floor_log2(nodes[id]->quantum));
    if (exponent_bits > FloatFormat::max_exponent_bits) {
      return not_exact(fmt::format("it needs {} exponent bits", exponent_bits), text(id),
                       fmt::format("at most {}", FloatFormat::max_exponent_bits));
    }
    least_exponent_bits = std::max(least_exponent_bits, exponent_bits);
  }
  return FloatFormat::make(least_precision, least_exponent_bits);
}

}  // namespace mixcmp::error
