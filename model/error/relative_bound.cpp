#include "model/error/relative_bound.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <utility>

#include "model/expression/text.hpp"
#include "model/golden/arithmetic.hpp"

namespace mixcmp::model {
namespace {

/// The inputs whose ranges prove a sign; none where nothing proves it.
using SignProof = std::optional<std::set<int>>;

SignProof both(const SignProof& a, const SignProof& b) {
  if (!a || !b) return std::nullopt;
  std::set<int> inputs = *a;
  inputs.insert(b->begin(), b->end());
  return inputs;
}

/// The proof that asks for less.
SignProof either(const SignProof& a, const SignProof& b) {
  if (!a || !b) return a ? a : b;
  return a->size() <= b->size() ? a : b;
}

struct Sign {
  SignProof nonnegative;
  SignProof nonpositive;

  Sign negated() const { return {nonpositive, nonnegative}; }
};

/// That of a sum is known if both operands lie on the same side of zero.
Sign sum_sign(const Sign& a, const Sign& b) {
  return {both(a.nonnegative, b.nonnegative), both(a.nonpositive, b.nonpositive)};
}

Sign product_sign(const Sign& a, const Sign& b) {
  return {either(both(a.nonnegative, b.nonnegative), both(a.nonpositive, b.nonpositive)),
          either(both(a.nonnegative, b.nonpositive), both(a.nonpositive, b.nonnegative))};
}

const std::set<int> nothing = {};

Sign constant_sign(const mpq_class& value) {
  return {value >= 0 ? SignProof(nothing) : std::nullopt,
          value <= 0 ? SignProof(nothing) : std::nullopt};
}

/// Of one rounding, where it is not exceptional: theorem 1 of docs/error_bounds.md.
RelativeBound rounding_bound(int precision, Rounding rounding) {
  const mpq_class u(1, mpz_class(1) << precision);
  switch (rounding) {
    case Rounding::nearest_even: return {1 - u, 1 + u};
    case Rounding::toward_zero: return {1, 1 + 2 * u};
  }
  MIXCMP_CHECK(false);
}

RelativeBound product(const RelativeBound& a, const RelativeBound& b) {
  return {a.low * b.low, a.high * b.high};
}

RelativeBound quotient(const RelativeBound& a, const RelativeBound& b) {
  return {a.low / b.high, a.high / b.low};
}

RelativeBound hull(const RelativeBound& a, const RelativeBound& b) {
  return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

bool is_exact(const RelativeBound& bound) {
  return bound.low == 1 && bound.high == 1;
}

/// A rational just below the root (with `up`: just above), off by less than 2^-256 of it.
mpq_class root(const mpq_class& value, int up) {
  const unsigned long shift = 256 + mpz_sizeinbase(value.get_den_mpz_t(), 2);
  const mpz_class scaled = (value.get_num() << (2 * shift)) / value.get_den();
  mpq_class result(sqrt(scaled) + up, mpz_class(1) << shift);
  result.canonicalize();
  return result;
}

RelativeBound square_root(const RelativeBound& a) {
  if (is_exact(a)) return a;
  return {root(a.low, 0), root(a.high, 1)};
}

long bit_length(const mpz_class& value) {
  return static_cast<long>(mpz_sizeinbase(value.get_mpz_t(), 2));
}

/// `value` to some 512 digits, rounded down (with `up`: up): powers of powers need not be exact.
mpq_class shortened(const mpq_class& value, int up) {
  constexpr long short_enough = 1024, kept = 512;
  const mpz_class &num = value.get_num(), &den = value.get_den();
  if (bit_length(num) <= short_enough && bit_length(den) <= short_enough) return value;
  const long shift = kept + bit_length(den) - bit_length(num);
  const mpz_class dividend = shift > 0 ? num << shift : num;
  const mpz_class divisor = shift < 0 ? den << -shift : den;
  mpz_class digits = dividend / divisor + up;
  mpq_class result(digits);
  if (shift > 0) mpq_div_2exp(result.get_mpq_t(), result.get_mpq_t(), shift);
  if (shift < 0) mpq_mul_2exp(result.get_mpq_t(), result.get_mpq_t(), -shift);
  return result;
}

RelativeBound widened(const RelativeBound& bound) {
  return {shortened(bound.low, 0), shortened(bound.high, 1)};
}

/// Allows more than the ratio of any two numbers of any format.
bool is_useless(const RelativeBound& bound) {
  constexpr long most_doublings = 2L << FloatFormat::max_exponent_bits;
  const auto doublings = [](const mpq_class& value) {
    return std::abs(bit_length(value.get_num()) - bit_length(value.get_den()));
  };
  return std::max(doublings(bound.low), doublings(bound.high)) > most_doublings;
}

NodeBound without_rounding(RelativeBound bound) {
  return {.relative = std::move(bound)};
}
NodeBound no_bound(std::string reason) {
  return {.reason = std::move(reason)};
}

bool is_power_of_two(const TypedNode& node) {
  if (node.operation != Operation::constant || node.value == 0) return false;
  const mpz_class product = abs(node.value.get_num()) * node.value.get_den();
  return mpz_popcount(product.get_mpz_t()) == 1;
}

class Analysis {
public:
  Analysis(const TypedGraph& graph, const std::vector<bool>& input_nonnegative)
      : graph_(graph), input_nonnegative_(input_nonnegative) {}

  RelativeAnalysis run() &&;

private:
  Sign sign_of(const TypedNode& node) const;
  NodeBound bound_of(NodeId id);
  NodeBound constant_bound(const TypedNode& node) const;
  NodeBound sum_bound(NodeId id, const RelativeBound& a, const RelativeBound& b);
  bool rounds_nothing(const TypedNode& node) const;
  /// `bound` of the exact result, then the operation's own rounding.
  NodeBound rounded(const TypedNode& node, const RelativeBound& bound) const;
  std::string text(NodeId id) const;

  const TypedGraph& graph_;
  const std::vector<bool>& input_nonnegative_;
  std::vector<Sign> signs_;
  std::set<int> used_;
  std::vector<NodeBound> bounds_;
};

RelativeAnalysis Analysis::run() && {
  for (NodeId id = 0; id < static_cast<NodeId>(graph_.nodes.size()); ++id) {
    signs_.push_back(sign_of(graph_.nodes[id]));
    bounds_.push_back(bound_of(id));
  }
  const auto is_checked = [&](const SignProof& proof) {
    return proof && std::includes(used_.begin(), used_.end(), proof->begin(), proof->end());
  };
  for (size_t id = 0; id < bounds_.size(); ++id) {
    bounds_[id].nonnegative = is_checked(signs_[id].nonnegative);
    bounds_[id].nonpositive = is_checked(signs_[id].nonpositive);
  }
  return {std::move(bounds_), {used_.begin(), used_.end()}};
}

Sign Analysis::sign_of(const TypedNode& node) const {
  const Sign unknown;
  const Sign& a = node.operands[0] < 0 ? unknown : signs_[node.operands[0]];
  const Sign& b = node.operands[1] < 0 ? unknown : signs_[node.operands[1]];
  switch (node.operation) {
    case Operation::input:
      if (!input_nonnegative_[node.input]) return unknown;
      return {std::set<int>{node.input}, std::nullopt};
    case Operation::constant: return constant_sign(node.value);
    case Operation::convert: return a;
    case Operation::negate: return a.negated();
    case Operation::add: return sum_sign(a, b);
    case Operation::subtract: return sum_sign(a, b.negated());
    case Operation::multiply:
    case Operation::divide: return product_sign(a, b);
    case Operation::absolute:
    case Operation::square:
    case Operation::square_root: return {nothing, std::nullopt};
    case Operation::minimum:
      return {both(a.nonnegative, b.nonnegative), either(a.nonpositive, b.nonpositive)};
    case Operation::maximum:
      return {either(a.nonnegative, b.nonnegative), both(a.nonpositive, b.nonpositive)};
  }
  MIXCMP_CHECK(false);
}

NodeBound Analysis::bound_of(NodeId id) {
  const TypedNode& node = graph_.nodes[id];
  for (int k = 0; k < arity(node.operation); ++k) {
    const NodeBound& operand = bounds_[node.operands[k]];
    if (!operand.relative) return no_bound(operand.reason);
  }
  const RelativeBound exact;
  const RelativeBound& a = node.operands[0] < 0 ? exact : *bounds_[node.operands[0]].relative;
  const RelativeBound& b = node.operands[1] < 0 ? exact : *bounds_[node.operands[1]].relative;
  switch (node.operation) {
    case Operation::input: return without_rounding(exact);
    case Operation::constant: return constant_bound(node);
    case Operation::negate:
    case Operation::absolute: return without_rounding(a);
    case Operation::minimum:
    case Operation::maximum: return without_rounding(hull(a, b));
    case Operation::convert: return rounded(node, a);
    case Operation::add:
    case Operation::subtract: return sum_bound(id, a, b);
    case Operation::multiply: return rounded(node, product(a, b));
    case Operation::square: return rounded(node, product(a, a));
    case Operation::divide: return rounded(node, quotient(a, b));
    case Operation::square_root: return rounded(node, square_root(a));
  }
  MIXCMP_CHECK(false);
}

NodeBound Analysis::constant_bound(const TypedNode& node) const {
  const std::string name = fmt::format("the constant {}", to_text(node.value));
  const std::string format = node.format.name();
  if (node.format.is_infinite(node.constant)) {
    return no_bound(fmt::format("{} overflows {}", name, format));
  }
  if (node.value == 0) return without_rounding({});
  if (node.format.is_zero(node.constant)) {
    return no_bound(fmt::format("{} rounds to zero in {}", name, format));
  }
  if (node.format.is_subnormal(node.constant) &&
      graph_.arithmetic.subnormals == Subnormals::flush) {
    return no_bound(
        fmt::format("{} is subnormal in {}, and subnormals are flushed to zero", name, format));
  }
  const mpq_class ratio = node.value / golden::to_rational(node.format, node.constant);
  return without_rounding({ratio, ratio});
}

NodeBound Analysis::sum_bound(NodeId id, const RelativeBound& a, const RelativeBound& b) {
  const TypedNode& node = graph_.nodes[id];
  if (is_exact(a) && is_exact(b)) return rounded(node, {});
  const bool is_difference = node.operation == Operation::subtract;
  const Sign& first = signs_[node.operands[0]];
  const Sign& second = signs_[node.operands[1]];
  const Sign sign = sum_sign(first, is_difference ? second.negated() : second);
  const SignProof proof = either(sign.nonnegative, sign.nonpositive);
  if (!proof) {
    return no_bound(
        fmt::format("the {} {} takes inexact operands that may cancel, so that its "
                    "error has no bound relative to its result",
                    is_difference ? "difference" : "sum", text(id)));
  }
  used_.insert(proof->begin(), proof->end());
  return rounded(node, hull(a, b));
}

bool Analysis::rounds_nothing(const TypedNode& node) const {
  const int operand_digits = node.operand_format.precision();
  const int digits = node.format.precision();
  const auto scales_by = [&](int operand) {
    return operand_digits <= digits && is_power_of_two(graph_.nodes[node.operands[operand]]);
  };
  switch (node.operation) {
    case Operation::convert: return operand_digits <= digits;
    case Operation::multiply: return 2 * operand_digits <= digits || scales_by(0) || scales_by(1);
    case Operation::square: return 2 * operand_digits <= digits;
    case Operation::divide: return scales_by(1);
    case Operation::input:
    case Operation::constant:
    case Operation::negate:
    case Operation::absolute:
    case Operation::minimum:
    case Operation::maximum: return true;
    case Operation::add:
    case Operation::subtract:
    case Operation::square_root: return false;
  }
  MIXCMP_CHECK(false);
}

NodeBound Analysis::rounded(const TypedNode& node, const RelativeBound& bound) const {
  if (rounds_nothing(node)) return without_rounding(bound);
  const RelativeBound own = rounding_bound(node.format.precision(), graph_.arithmetic.rounding);
  const RelativeBound all = widened(product(bound, own));
  if (is_useless(all)) return no_bound("so many operations round that the error is out of bounds");
  return {.relative = all, .unrounded = bound};
}

std::string Analysis::text(NodeId id) const {
  constexpr std::size_t readable_length = 60;
  return to_text(graph_.nodes, graph_.input_names, id, readable_length);
}

/// The first node that has no bound although its operands have.
NodeId first_failure(const TypedGraph& graph, const RelativeAnalysis& analysis) {
  const auto failed = [](const NodeBound& bound) { return !bound.relative; };
  const auto first = std::find_if(analysis.nodes.begin(), analysis.nodes.end(), failed);
  MIXCMP_CHECK(first != analysis.nodes.end() && graph.nodes.size() == analysis.nodes.size());
  return static_cast<NodeId>(first - analysis.nodes.begin());
}

/// With inputs = "exact" this operand would not be rounded.
bool would_be_exact(const TypedGraph& graph, NodeId id) {
  const TypedNode& node = graph.nodes[id];
  switch (node.operation) {
    case Operation::input: return true;
    case Operation::constant:
      return golden::to_rational(graph.input_format,
                                 golden::from_rational(graph.input_format, node.value)) ==
             node.value;
    case Operation::convert:
    case Operation::negate:
    case Operation::absolute: return would_be_exact(graph, node.operands[0]);
    case Operation::minimum:
    case Operation::maximum:
      return would_be_exact(graph, node.operands[0]) && would_be_exact(graph, node.operands[1]);
    case Operation::add:
    case Operation::subtract:
    case Operation::multiply:
    case Operation::square:
    case Operation::divide:
    case Operation::square_root: return false;
  }
  MIXCMP_CHECK(false);
}

std::string what_helps(const TypedGraph& graph, NodeId failure) {
  const TypedNode& node = graph.nodes[failure];
  if (node.operation == Operation::constant) return "a reduced.format with more exponent bits";
  std::string help;
  if (would_be_exact(graph, node.operands[0]) && would_be_exact(graph, node.operands[1])) {
    help += "reduced.inputs = \"exact\", ";
  }
  const std::vector<bool> all_nonnegative(graph.input_count, true);
  if (analyse_relative(graph, all_nonnegative).nodes[failure].relative) {
    help += "ranges that exclude negative inputs, ";
  }
  return help + "reduced.bound = \"profiled\", or another formulation of f and g";
}

Bits smallest_guard(const NodeBound& f, const NodeBound& g, int precision) {
  const Bits guard = guard_ulp(*f.relative, *g.relative, precision);
  if (!f.unrounded || !g.unrounded) return guard;
  return std::min(guard, guard_ulp_before_rounding(*f.unrounded, *g.unrounded, precision));
}

/// Beyond the distances of every format.
constexpr Bits unreachable = ~Bits{0};

/// Beyond the distance of any two finite encodings, and as wide as one: the lane's hardware holds
/// it.
Bits never(FloatFormat format) {
  return low_mask(format.width());
}

Bits to_bits(const mpz_class& value) {
  const mpz_class high = value >> 64;
  return Bits{high.get_ui()} << 64 | mpz_class(value - (high << 64)).get_ui();
}

/// How far apart the true values of f and g may lie where the others are equal.
mpq_class worst_ratio(const RelativeBound& f, const RelativeBound& g) {
  return std::max<mpq_class>(g.high / f.low, f.high / g.low);
}

/// The smallest number of steps whose every stretch of encodings multiplies by more than `ratio`
/// (theorem 2).
Bits steps_beyond(const mpq_class& ratio, int precision) {
  constexpr int most_doublings = 1 << FloatFormat::max_exponent_bits;
  int doublings = 0;
  mpq_class rest = ratio;  // ratio = rest * 2^doublings, 1 <= rest < 2
  for (; rest >= 2; rest /= 2) {
    if (++doublings == most_doublings) return unreachable;
  }
  const mpq_class steps = (1 - 1 / rest) * (mpz_class(1) << precision);
  const mpz_class whole = steps.get_num() / steps.get_den();
  return (Bits(doublings) << (precision - 1)) + to_bits(whole) + 1;
}

}  // namespace

RelativeAnalysis analyse_relative(const TypedGraph& graph,
                                  const std::vector<bool>& input_nonnegative) {
  MIXCMP_CHECK(static_cast<int>(input_nonnegative.size()) == graph.input_count);
  return Analysis(graph, input_nonnegative).run();
}

Result<Lane> relative_lane(TypedGraph graph, const std::vector<bool>& input_nonnegative) {
  RelativeAnalysis analysis = analyse_relative(graph, input_nonnegative);
  const NodeBound& f = analysis.nodes[graph.f];
  const NodeBound& g = analysis.nodes[graph.g];
  if (!f.relative || !g.relative) {
    const NodeId failure = first_failure(graph, analysis);
    return Error{.field = "reduced.bound",
                 .message = "no bound can be proven: " + analysis.nodes[failure].reason,
                 .received = "\"certified\"",
                 .accepted = what_helps(graph, failure)};
  }
  const FloatFormat format = graph.arithmetic.format;
  UlpDistanceDecision decision{
      .guard_ulp = std::min(smallest_guard(f, g, format.precision()), never(format)),
      .nonnegative = f.nonnegative && g.nonnegative};
  std::vector<RangeCheck> checks;
  for (const int input : analysis.nonnegative_inputs) {
    checks.push_back(sign_check(input, RequiredSign::nonnegative));
  }
  return Lane{std::move(graph), std::move(decision), std::move(checks)};
}

Bits guard_ulp(const RelativeBound& f, const RelativeBound& g, int precision) {
  const mpq_class ratio = worst_ratio(f, g);
  return ratio == 1 ? 0 : steps_beyond(ratio, precision);
}

Bits guard_ulp_before_rounding(const RelativeBound& f, const RelativeBound& g, int precision) {
  const mpq_class ratio = worst_ratio(f, g);
  if (ratio == 1) return 1;
  const Bits steps = steps_beyond(ratio, precision);
  return steps == unreachable ? unreachable : steps + 1;
}

}  // namespace mixcmp::model
