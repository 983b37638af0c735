#include "model/judge/proof/node_ranges.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

#include "model/base/common/check.hpp"
#include "model/base/number/exact.hpp"
#include "model/comparison/expression/text.hpp"
#include "model/judge/proof/script.hpp"
#include "model/lane/error/hazards.hpp"
#include "model/lane/error/range_analysis.hpp"

namespace mixcmp::proof {
namespace {

/// The value of a finite magnitude, from its encoded fields.
mpq_class value_of(FloatFormat format, Bits magnitude) {
  const Bits field = magnitude >> format.fraction_bits();
  const Bits hidden = field == 0 ? 0 : Bits{1} << format.fraction_bits();
  const Bits significand = hidden | (magnitude & low_mask(format.fraction_bits()));
  const mpz_class upper(static_cast<unsigned long>(significand >> 64));
  const mpz_class lower(static_cast<unsigned long>(significand & low_mask(64)));
  const long exponent = std::max<long>(static_cast<long>(field), 1) - format.bias();
  return ((upper << 64) + lower) * power_of_two(exponent - format.fraction_bits());
}

Range any_finite(FloatFormat format) {
  const mpq_class largest = largest_number(format);
  return {-largest, largest};
}

bool holds_zero(const Range& range) {
  return range.low <= 0 && range.high >= 0;
}

void assume_in(Script& script, const std::string& name, const Range& range) {
  script.assume_within(name, dyadic(range.low), dyadic(range.high));
}

}  // namespace

std::optional<Range> enforced_range(const error::RangeCheck& check, FloatFormat format) {
  const int rest = format.width() - 1 - check.leading_bits;
  const Bits greatest = ((check.greatest + 1) << rest) - 1;
  const Bits first_special = low_mask(format.exponent_bits()) << format.fraction_bits();
  if (check.leading_bits == 0 || greatest >= first_special) return std::nullopt;
  const mpq_class low = value_of(format, check.least << rest), high = value_of(format, greatest);
  switch (check.sign) {
    case error::RequiredSign::any: return Range{-high, high};
    case error::RequiredSign::nonnegative: return Range{low, high};
    case error::RequiredSign::nonpositive: return Range{-high, -low};
  }
  MIXCMP_CHECK(false);
}

std::vector<std::optional<Range>> enforced_ranges(const error::Lane& lane) {
  std::vector<std::optional<Range>> ranges(static_cast<std::size_t>(lane.graph.input_count));
  for (const error::RangeCheck& check : lane.checks) {
    ranges[static_cast<std::size_t>(check.input)] = enforced_range(check, lane.graph.input_format);
  }
  return ranges;
}

std::string result_text(const TypedNode& node, const std::string& a, const std::string& b) {
  switch (node.operation) {
    case Operation::convert: return a;
    case Operation::negate: return fmt::format("-{}", a);
    case Operation::absolute: return fmt::format("|{}|", a);
    case Operation::add: return fmt::format("{} + {}", a, b);
    case Operation::subtract: return fmt::format("{} - {}", a, b);
    case Operation::multiply: return fmt::format("{} * {}", a, b);
    case Operation::square: return fmt::format("{0} * {0}", a);
    case Operation::divide: return fmt::format("{} / {}", a, b);
    case Operation::square_root: return fmt::format("sqrt({})", a);
    case Operation::input:
    case Operation::constant:
    case Operation::minimum:
    case Operation::maximum:
    case Operation::function:
    case Operation::look_up:
    case Operation::fused_sum: break;
  }
  MIXCMP_CHECK(false);
}

bool flags_overflow(const error::Lane& lane, NodeId id) {
  return lane.hazards.empty() || lane.hazards[static_cast<std::size_t>(id)].overflow;
}

mpq_class smallest_number(FloatFormat format) {
  return power_of_two(format.min_exponent() - format.fraction_bits());
}

mpq_class largest_number(FloatFormat format) {
  // Without infinities, the significand of all ones at the largest exponent is that of the NaN.
  const int places_below_two = format.fraction_bits() - (format.has_infinities() ? 0 : 1);
  return (2 - power_of_two(-places_below_two)) * power_of_two(format.max_exponent());
}

mpq_class binade(const mpq_class& value) {
  const mpq_class power = power_of_two(binade_of(value));
  return power > value ? mpq_class(power / 2) : power;
}

mpq_class least_magnitude(const Range& range) {
  if (holds_zero(range)) return 0;
  return std::min<mpq_class>(abs(range.low), abs(range.high));
}

mpq_class greatest_magnitude(const Range& range) {
  return std::max<mpq_class>(abs(range.low), abs(range.high));
}

NodeRanges::NodeRanges(const error::Lane& lane, NodeProver& nodes)
    : lane_(lane), graph_(lane.graph), nodes_(nodes), done_(lane.graph.nodes.size(), false) {
  const auto proposed = error::analyse_ranges(graph_, error::checked_ranges(graph_, lane.checks));
  for (const error::NodeRange& node : proposed) ranges_.push_back(node.value);
}

const Range& NodeRanges::prove_range(NodeId id) {
  if (done_[id]) return ranges_[id];
  done_[id] = true;
  const int operands = arity(graph_.nodes[id].operation);
  if (operands == 0) return ranges_[id] = given(id);
  for (int k = 0; k < operands; ++k) prove_range(graph_.nodes[id].operands[k]);
  prove_operation(id);
  return ranges_[id];
}

/// The range of an input or a constant. An operand that is not checked counts as finite, since the
/// comparison is exceptional otherwise.
Range NodeRanges::given(NodeId id) const {
  const TypedNode& node = graph_.nodes[id];
  if (node.operation == Operation::input) {
    const auto checked = enforced_ranges(lane_)[static_cast<std::size_t>(node.input)];
    return checked.value_or(any_finite(graph_.arriving_format(node.input)));
  }
  if (node.format.is_infinite(node.constant)) return any_finite(node.format);
  const mpq_class value = to_rational(node.format, node.constant);
  return {value, value};
}

/// Whether a node is only known to be finite or flagged: a quotient whose divisor may lie on either
/// side of zero. There is nothing to prove about it.
bool NodeRanges::is_any_finite_quotient(NodeId id) const {
  const TypedNode& node = graph_.nodes[id];
  if (node.operation != Operation::divide || !flags_overflow(lane_, id)) return false;
  const Range all = any_finite(node.format);
  return ranges_[id].low <= all.low && ranges_[id].high >= all.high;
}

void NodeRanges::prove_operation(NodeId id) {
  if (is_any_finite_quotient(id)) return;
  std::vector<ConeCase> cases;
  if (is_choice(graph_.nodes[id].operation)) {
    for (std::string& text : selection_scripts(id)) cases.push_back({"", std::move(text)});
  } else {
    cases.push_back({"", script(id)});
  }
  nodes_.add(nodes_.run_scripts(
      fmt::format("range of {}: [{}, {}]", nodes_.text(id), rounded_text(ranges_[id].low, 5),
                  rounded_text(ranges_[id].high, 5)),
      cases));
}

std::string NodeRanges::script(NodeId id) const {
  const TypedNode& node = graph_.nodes[id];
  const bool two = arity(node.operation) == 2;
  Range a = ranges_[node.operands[0]];
  const bool same = two && node.operands[0] == node.operands[1];
  const bool flagged = flags_overflow(lane_, id);
  Script script;
  script.comment("What an operation computes, from the ranges of its operands.");
  script.define_operator("rnd",
                         rounding_operator(node.format.precision(), graph_.arithmetic.rounding));
  if (node.operation == Operation::square_root) {  // a negative operand is exceptional
    a = {std::max<mpq_class>(a.low, 0), std::max<mpq_class>(a.high, 0)};
  }
  if (same && node.operation == Operation::divide && flagged) {
    script.assume_within("|a|", dyadic(smallest_number(graph_.nodes[node.operands[0]].format)),
                         dyadic(greatest_magnitude(a)));
  } else {
    assume_in(script, "a", a);
  }
  if (two && !same) {
    Range b = ranges_[node.operands[1]];
    if (node.operation == Operation::divide && flagged && holds_zero(b)) {
      const mpq_class least = smallest_number(graph_.nodes[node.operands[1]].format);
      if (b.low == 0) b.low = least;
      if (b.high == 0) b.high = -least;
    }
    assume_in(script, "b", b);
  }
  const std::string exact = result_text(node, "a", same ? "a" : "b");
  script.define("c", error::has_unit(node.operation) ? fmt::format("rnd({})", exact) : exact);
  const Range all = any_finite(node.format);
  const bool clamped = ranges_[id].low <= all.low || ranges_[id].high >= all.high;
  if (clamped && flagged) assume_in(script, "c", all);
  script.conclude(fmt::format("c in [{}, {}]", dyadic(ranges_[id].low), dyadic(ranges_[id].high)));
  return script.text();
}

/// One script for each operand; in it, a is the operand that is selected. All numbers are divided
/// by a power of two, which changes no choice: from 2^1024 on Gappa 1.4 narrows no interval.
std::vector<std::string> NodeRanges::selection_scripts(NodeId id) const {
  const TypedNode& node = graph_.nodes[id];
  const bool minimum = node.operation == Operation::minimum;
  std::vector<std::string> scripts;
  for (const auto& [first, second] : {std::pair(0, 1), std::pair(1, 0)}) {
    const Range &a = ranges_[node.operands[first]], &b = ranges_[node.operands[second]];
    const mpq_class most = greatest_magnitude(a) + greatest_magnitude(b);
    const mpq_class unit = most == 0 ? mpq_class(1) : binade(most);
    const auto scaled = [&](const Range& range) {
      return Range{range.low / unit, range.high / unit};
    };
    Script script;
    script.comment("Of a and b, divided by a power of two, a is selected.");
    assume_in(script, "a", scaled(a));
    assume_in(script, "b", scaled(b));
    assume_in(script, "(a - b)", scaled(minimum ? Range{-most, 0} : Range{0, most}));
    const Range result = scaled(ranges_[id]);
    script.conclude(fmt::format("a in [{}, {}]", dyadic(result.low), dyadic(result.high)));
    script.hint("a", "b + (a - b)");
    scripts.push_back(script.text());
  }
  return scripts;
}

}  // namespace mixcmp::proof
