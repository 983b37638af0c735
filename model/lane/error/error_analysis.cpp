#include "model/lane/error/error_analysis.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <utility>

#include "model/base/number/dyadic.hpp"
#include "model/base/number/exact.hpp"
#include "model/comparison/expression/text.hpp"
#include "model/lane/error/sign.hpp"

namespace mixcmp::error {
namespace {

/// The error of a divisor may be at most 1/32 of the divisor, so that dividing by the true divisor
/// costs the bound a factor of 32/31.
constexpr int divisor_margin = 32;

/// A bound for the exact result of an operation on the computed operands, before its own rounding.
struct BeforeRounding {
  std::optional<MixedBound> mixed;
  std::string reason;  ///< why there is no relative bound
};

BeforeRounding without_bound(std::string reason) {
  return {std::nullopt, std::move(reason)};
}

/// The reason of the first operand that has no bound at all, or else of the first that has no
/// relative bound; empty if both have one.
std::string first_reason(const NodeBound* a, const NodeBound* b) {
  for (const NodeBound* operand : {a, b}) {
    if (operand != nullptr && !operand->mixed) return operand->reason;
  }
  for (const NodeBound* operand : {a, b}) {
    if (operand != nullptr && !operand->reason.empty()) return operand->reason;
  }
  return "";
}

bool scales_exactly(const TypedNode& node) {
  return node.operation == Operation::constant && is_power_of_two(mpq_class(abs(node.value)));
}

mpq_class farthest(const RelativeBound& factor, const mpq_class& center) {
  return std::max<mpq_class>(factor.high - center, center - factor.low);
}

/// Splits `value` into a number of three or four binary digits, which a bound of few digits holds
/// without rounding it up, and an inflation >= 1. If the inflation would exceed 33/32, returns
/// {value, 1}.
std::pair<mpq_class, mpq_class> few_digits(const mpq_class& value) {
  constexpr long digits = 3;
  if (value == 0) return {value, 1};
  const long shift = static_cast<long>(mpz_sizeinbase(value.get_den_mpz_t(), 2)) -
                     static_cast<long>(mpz_sizeinbase(value.get_num_mpz_t(), 2)) + digits;
  mpq_class scaled = value, unit = 1;
  if (shift >= 0) {
    scaled *= mpz_class(1) << shift;
    unit /= mpz_class(1) << shift;
  } else {
    scaled /= mpz_class(1) << -shift;
    unit *= mpz_class(1) << -shift;
  }
  const mpq_class rounded = mpz_class(scaled.get_num() / scaled.get_den()) * unit;
  const mpq_class inflation = value / rounded;
  if (inflation > mpq_class(33, 32)) return {value, 1};
  return {rounded, inflation};
}

class ErrorAnalyser {
public:
  ErrorAnalyser(const TypedGraph& graph, const std::vector<bool>& input_nonnegative)
      : graph_(graph), signs_(analyse_signs(graph, input_nonnegative)) {}

  ErrorAnalysis run() &&;

private:
  const TypedNode& node(NodeId id) const { return graph_.nodes[id]; }
  const MixedBound& mixed(NodeId id) const { return *bounds_[id].mixed; }

  NodeBound bound_of(NodeId id);
  BeforeRounding exact(NodeId id);
  BeforeRounding exact_constant(NodeId id);
  BeforeRounding exact_sum(NodeId id);
  MixedBound exact_product(NodeId a, NodeId b);
  MixedBound exact_square(NodeId a);
  MixedBound exact_quotient(NodeId id, NodeId a, NodeId b);
  MixedBound exact_root(NodeId id, NodeId a);
  MixedBound exact_selection(NodeId a, NodeId b);
  BeforeRounding cancelling_sum(NodeId id, NodeId a, NodeId b);

  bool rounds_nothing(const TypedNode& node) const;
  bool rounds_once(NodeId id) const;
  bool is_plain(NodeId id) const;
  mpq_class center_of(NodeId a, NodeId b) const;
  AbsoluteError deviations(NodeId a, NodeId b, const mpq_class& center);
  mpq_class rounding_error(FloatFormat format) const;
  BoundId selection_error(NodeId id);
  BoundId magnitude(NodeId id);
  BoundId reciprocal(NodeId id);
  void check_exponents(NodeId id) const;
  AbsoluteError sum(const AbsoluteError& a, const AbsoluteError& b);
  NodeBound rounded(NodeId id, BeforeRounding exact) const;
  std::optional<RelativeBound> before_rounding(NodeId id, const NodeBound& bound) const;
  std::string text(NodeId id) const;

  const TypedGraph& graph_;
  std::vector<Sign> signs_;
  std::set<int> used_;
  std::vector<NodeBound> bounds_;
  BoundGraphBuilder builder_;
  std::vector<BoundCondition> conditions_;
};

ErrorAnalysis ErrorAnalyser::run() && {
  for (NodeId id = 0; id < static_cast<NodeId>(graph_.nodes.size()); ++id) {
    NodeBound bound = bound_of(id);
    bound.before_rounding = before_rounding(id, bound);
    bounds_.push_back(std::move(bound));
  }
  const auto is_checked = [&](const SignProof& proof) {
    return proof && std::includes(used_.begin(), used_.end(), proof->begin(), proof->end());
  };
  for (size_t id = 0; id < bounds_.size(); ++id) {
    bounds_[id].nonnegative = is_checked(signs_[id].nonnegative);
    bounds_[id].nonpositive = is_checked(signs_[id].nonpositive);
  }
  return {
      std::move(bounds_), builder_.nodes(), std::move(conditions_), {used_.begin(), used_.end()}};
}

NodeBound ErrorAnalyser::bound_of(NodeId id) {
  const auto operand = [&](int k) {
    return k < arity(node(id).operation) ? &bounds_[node(id).operands[k]] : nullptr;
  };
  const NodeBound *a = operand(0), *b = operand(1);
  if ((a != nullptr && !a->mixed) || (b != nullptr && !b->mixed)) {
    return rounded(id, without_bound(first_reason(a, b)));
  }
  BeforeRounding result = exact(id);
  if (result.reason.empty()) result.reason = first_reason(a, b);
  return rounded(id, std::move(result));
}

BeforeRounding ErrorAnalyser::exact(NodeId id) {
  const auto [a, b] = node(id).operands;
  switch (node(id).operation) {
    case Operation::input: return {MixedBound{}, ""};
    case Operation::constant: return exact_constant(id);
    case Operation::convert:
    case Operation::negate:
    case Operation::absolute: return {mixed(a), ""};
    case Operation::minimum:
    case Operation::maximum: return {exact_selection(a, b), ""};
    case Operation::add:
    case Operation::subtract: return exact_sum(id);
    case Operation::multiply: return {exact_product(a, b), ""};
    case Operation::square: return {exact_square(a), ""};
    case Operation::divide: return {exact_quotient(id, a, b), ""};
    case Operation::square_root: return {exact_root(id, a), ""};
    case Operation::function:
    case Operation::look_up:
    case Operation::fused_sum: break;
  }
  MIXCMP_CHECK(false);
}

BeforeRounding ErrorAnalyser::exact_constant(NodeId id) {
  const mpq_class& value = node(id).value;
  const std::string name = fmt::format("the constant {}", to_text(value));
  const FloatFormat format = node(id).format;
  if (format.is_infinite(node(id).constant)) {
    return without_bound(fmt::format("{} overflows {}", name, format.name()));
  }
  if (value == 0) return {MixedBound{}, ""};
  if (format.is_zero(node(id).constant)) {
    return {MixedBound{.factor = {}, .absolute = {builder_.constant(abs(value))}},
            fmt::format("{} rounds to zero in {}", name, format.name())};
  }
  if (format.is_subnormal(node(id).constant) && graph_.arithmetic.subnormals == Subnormals::flush) {
    return without_bound(fmt::format("{} is subnormal in {}, and subnormals are flushed to zero",
                                     name, format.name()));
  }
  const mpq_class ratio = value / to_rational(format, node(id).constant);
  return {MixedBound{.factor = {ratio, ratio}, .absolute = {}}, ""};
}

BeforeRounding ErrorAnalyser::exact_sum(NodeId id) {
  const auto [a, b] = node(id).operands;
  const bool is_difference = node(id).operation == Operation::subtract;
  const AbsoluteError absolute = sum(mixed(a).absolute, mixed(b).absolute);
  if (is_exact(mixed(a).factor) && is_exact(mixed(b).factor)) {
    return {MixedBound{.factor = {}, .absolute = absolute}, ""};
  }
  const Sign sign = sum_sign(signs_[a], is_difference ? signs_[b].negated() : signs_[b]);
  const SignProof proof = either(sign.nonnegative, sign.nonpositive);
  if (!proof) return cancelling_sum(id, a, b);
  used_.insert(proof->begin(), proof->end());
  return {MixedBound{.factor = hull(mixed(a).factor, mixed(b).factor), .absolute = absolute}, ""};
}

/// Sum of operands that may cancel: a s + b t = (a + b) m + a (s - m) + b (t - m).
BeforeRounding ErrorAnalyser::cancelling_sum(NodeId id, NodeId a, NodeId b) {
  const mpq_class center = center_of(a, b);
  const AbsoluteError inherited = sum(mixed(a).absolute, mixed(b).absolute);
  const AbsoluteError absolute = sum(inherited, deviations(a, b, center));
  const bool is_difference = node(id).operation == Operation::subtract;
  return {MixedBound{.factor = {center, center}, .absolute = absolute},
          fmt::format("the {} {} takes inexact operands, and no rule here excludes that they "
                      "cancel: its error has no bound relative to its result",
                      is_difference ? "difference" : "sum", text(id))};
}

/// (a s + c)(b t + d) = ab st + (a s + c) d + b t c.
MixedBound ErrorAnalyser::exact_product(NodeId a, NodeId b) {
  const auto& [s, c] = mixed(a);
  const auto& [t, d] = mixed(b);
  MixedBound result{.factor = product(s, t), .absolute = {}};
  if (mixed(a).is_relative() && mixed(b).is_relative()) return result;
  const BoundId first = builder_.add(d.bound < 0 ? no_bound_node : magnitude(a), c.bound);
  const BoundId second = c.bound < 0 ? no_bound_node : magnitude(b);
  result.absolute = {
      builder_.add(builder_.multiply(first, d.bound), builder_.multiply(second, c.bound)),
      widened_up(std::max<mpq_class>(std::max<mpq_class>(s.high, c.inflation) * d.inflation,
                                     t.high * c.inflation))};
  return result;
}

/// (a s + c)^2 = a^2 s^2 + c (2 a s + c).
MixedBound ErrorAnalyser::exact_square(NodeId a) {
  const auto& [s, c] = mixed(a);
  MixedBound result{.factor = product(s, s), .absolute = {}};
  if (mixed(a).is_relative()) return result;
  const BoundId twice = builder_.scale(magnitude(a), 2);
  result.absolute = {builder_.multiply(builder_.add(twice, c.bound), c.bound),
                     widened_up(c.inflation * std::max<mpq_class>(s.high, c.inflation))};
  return result;
}

/// (a s + c) / (b t + d) = (a / b)(s / t) + (c - (a / b)(s / t) d) / (b t + d), |d| <= |b t| / 32.
MixedBound ErrorAnalyser::exact_quotient(NodeId id, NodeId a, NodeId b) {
  const auto& [s, c] = mixed(a);
  const auto& [t, d] = mixed(b);
  MixedBound result{.factor = quotient(s, t), .absolute = {}};
  if (mixed(a).is_relative() && mixed(b).is_relative()) return result;
  mpq_class inflation = c.inflation;
  BoundId numerator = c.bound;
  if (d.bound != no_bound_node) {
    conditions_.push_back({builder_.scale(d.bound, d.inflation * divisor_margin / t.low), b});
    numerator = builder_.add(numerator, builder_.multiply(magnitude(id), d.bound));
    const RelativeBound own =
        rounding_bound(node(id).format.precision(), graph_.arithmetic.rounding);
    inflation = std::max<mpq_class>(inflation, own.high * result.factor.high * d.inflation);
    inflation *= mpq_class(divisor_margin, divisor_margin - 1);
  }
  result.absolute = {builder_.multiply(numerator, reciprocal(b)), widened_up(inflation / t.low)};
  return result;
}

/// sqrt(a s + c) - sqrt(a s) = c / (sqrt(a s + c) + sqrt(a s)), at most c / sqrt(a s).
MixedBound ErrorAnalyser::exact_root(NodeId id, NodeId a) {
  const auto& [s, c] = mixed(a);
  MixedBound result{.factor = square_root(s), .absolute = {}};
  if (mixed(a).is_relative()) return result;
  if (!signs_[a].nonnegative) {
    conditions_.push_back({builder_.scale(c.bound, c.inflation / s.low), a});
  } else {
    used_.insert(signs_[a].nonnegative->begin(), signs_[a].nonnegative->end());
  }
  const RelativeBound own = rounding_bound(node(id).format.precision(), graph_.arithmetic.rounding);
  result.absolute = {builder_.multiply(c.bound, reciprocal(id)),
                     widened_up(c.inflation / (root_below(s.low) * own.low))};
  return result;
}

/// The error of a minimum or maximum is at most the larger error of its operands.
MixedBound ErrorAnalyser::exact_selection(NodeId a, NodeId b) {
  const auto& [s, c] = mixed(a);
  const auto& [t, d] = mixed(b);
  return {hull(s, t), {builder_.maximum(c.bound, d.bound), std::max(c.inflation, d.inflation)}};
}

bool ErrorAnalyser::rounds_nothing(const TypedNode& node) const {
  const int operand_digits = node.operand_digits();
  const int digits = node.format.precision();
  const auto scales_by = [&](int operand) {
    return operand_digits <= digits && scales_exactly(graph_.nodes[node.operands[operand]]);
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
    case Operation::square_root:
    case Operation::fused_sum: return false;
    case Operation::function:
    case Operation::look_up: break;
  }
  MIXCMP_CHECK(false);
}

/// Whether the node's own rounding is its only error: at most half an ulp of its binade, or one ulp
/// with rounding toward zero.
bool ErrorAnalyser::rounds_once(NodeId id) const {
  const NodeBound& bound = bounds_[id];
  return bound.relative && bound.unrounded && is_exact(*bound.unrounded);
}

/// Whether the node is an unchanged operand, a constant, or a choice among these.
bool ErrorAnalyser::is_plain(NodeId id) const {
  const TypedNode& plain = node(id);
  if (arity(plain.operation) == 0) return true;
  if (!only_moves_bits(plain.operation)) return false;
  return is_plain(plain.operands[0]) &&
         (arity(plain.operation) == 1 || is_plain(plain.operands[1]));
}

/// The factor m of cancelling_sum. Rounding toward zero errs to one side only: if both operands
/// have such errors, m is the middle of the range of their factors. Otherwise m = 1.
mpq_class ErrorAnalyser::center_of(NodeId a, NodeId b) const {
  const auto is_fixed = [&](NodeId id) { return is_exact(mixed(id).factor) || is_plain(id); };
  if (graph_.arithmetic.rounding == Rounding::nearest_even || is_fixed(a) || is_fixed(b)) return 1;
  const RelativeBound all = hull(mixed(a).factor, mixed(b).factor);
  return std::max<mpq_class>(1, (all.low + all.high) / 2);
}

/// Bounds |a (s - m)| + |b (t - m)| of cancelling_sum. If both terms need the magnitude of their
/// operand, the larger magnitude stands for both. Both have one format.
AbsoluteError ErrorAnalyser::deviations(NodeId a, NodeId b, const mpq_class& center) {
  BoundId constants = no_bound_node, binades = no_bound_node, larger = no_bound_node;
  mpq_class deviation = 0;
  for (const NodeId operand : {a, b}) {
    const RelativeBound& factor = mixed(operand).factor;
    if (is_exact(factor) && center == 1) continue;
    if (center == 1 && is_plain(operand)) {
      constants = builder_.add(constants, selection_error(operand));
    } else if (center == 1 && rounds_once(operand)) {
      binades = builder_.add(binades, builder_.of_value(BoundOperation::binade, operand));
    } else {
      larger = builder_.maximum(larger, magnitude(operand));
      deviation += farthest(factor, center);
    }
  }
  const auto [factor, inflation] = few_digits(widened_up(deviation));
  const BoundId rounding = builder_.scale(binades, rounding_error(node(a).format));
  return {builder_.add(builder_.add(constants, rounding), builder_.scale(larger, factor)),
          inflation};
}

/// The greatest error of one rounding to the format, in units of its result's binade.
mpq_class ErrorAnalyser::rounding_error(FloatFormat format) const {
  const int doubled = graph_.arithmetic.rounding == Rounding::nearest_even ? 0 : 1;
  return mpq_class(1, mpz_class(1) << (format.precision() - doubled));
}

/// The largest error of a plain node: the error of the encoded constants that it may select.
BoundId ErrorAnalyser::selection_error(NodeId id) {
  const TypedNode& selected = node(id);
  if (selected.operation == Operation::input) return no_bound_node;
  if (selected.operation == Operation::constant) {
    return builder_.constant(abs(selected.value - to_rational(selected.format, selected.constant)));
  }
  BoundId error = no_bound_node;
  for (int k = 0; k < arity(selected.operation); ++k) {
    error = builder_.maximum(error, selection_error(selected.operands[k]));
  }
  return error;
}

BoundId ErrorAnalyser::magnitude(NodeId id) {
  if (node(id).operation == Operation::constant) {
    return builder_.constant(abs(to_rational(node(id).format, node(id).constant)));
  }
  check_exponents(id);
  return builder_.of_value(BoundOperation::magnitude, id);
}

BoundId ErrorAnalyser::reciprocal(NodeId id) {
  check_exponents(id);
  return builder_.of_value(BoundOperation::reciprocal, id);
}

/// Checks that the node has the lane's exponent bits: bounds can only be built from such values.
void ErrorAnalyser::check_exponents(NodeId id) const {
  MIXCMP_CHECK(node(id).format.exponent_bits() == graph_.arithmetic.format.exponent_bits());
}

AbsoluteError ErrorAnalyser::sum(const AbsoluteError& a, const AbsoluteError& b) {
  return {builder_.add(a.bound, b.bound), std::max(a.inflation, b.inflation)};
}

/// Extends the bound of the exact result by the operation's own rounding.
NodeBound ErrorAnalyser::rounded(NodeId id, BeforeRounding exact) const {
  NodeBound bound{.reason = std::move(exact.reason)};
  if (!exact.mixed) return bound;
  MixedBound& mixed = *exact.mixed;
  if (!rounds_nothing(node(id))) {
    const RelativeBound own =
        rounding_bound(node(id).format.precision(), graph_.arithmetic.rounding);
    if (mixed.is_relative()) bound.unrounded = mixed.factor;
    mixed.factor = widened(product(mixed.factor, own));
  }
  if (is_useless(mixed.factor) || is_useless({1, mixed.absolute.inflation})) {
    return {.reason = "so many operations round that the error is out of bounds"};
  }
  if (mixed.is_relative()) {
    bound.relative = mixed.factor;
    bound.reason.clear();
  }
  bound.mixed = std::move(mixed);
  return bound;
}

/// NodeBound::before_rounding. A node that rounds nothing holds numbers of the format, and rounding
/// does not change these. Sign changes and selections commute with rounding.
std::optional<RelativeBound> ErrorAnalyser::before_rounding(NodeId id,
                                                            const NodeBound& bound) const {
  if (!bound.relative || !(node(id).format == graph_.arithmetic.format)) return std::nullopt;
  if (bound.unrounded) return bound.unrounded;
  const auto operand = [&](int k) { return bounds_[node(id).operands[k]].before_rounding; };
  switch (node(id).operation) {
    case Operation::negate:
    case Operation::absolute: return operand(0);
    case Operation::minimum:
    case Operation::maximum: return hull(*operand(0), *operand(1));
    case Operation::constant:
      // Constants are rounded to nearest, whatever the lane's rounding is.
      if (graph_.arithmetic.rounding == Rounding::nearest_even) return RelativeBound{};
      return bound.relative;
    case Operation::input:
    case Operation::convert:
    case Operation::add:
    case Operation::subtract:
    case Operation::multiply:
    case Operation::square:
    case Operation::divide:
    case Operation::square_root:
    case Operation::fused_sum: return bound.relative;
    case Operation::function:
    case Operation::look_up: break;
  }
  MIXCMP_CHECK(false);
}

std::string ErrorAnalyser::text(NodeId id) const {
  constexpr std::size_t readable_length = 60;
  return to_text(graph_.nodes, graph_.input_names, id, readable_length);
}

}  // namespace

ErrorAnalysis analyse_errors(const TypedGraph& graph, const std::vector<bool>& input_nonnegative) {
  MIXCMP_CHECK(static_cast<int>(input_nonnegative.size()) == graph.input_count);
  return ErrorAnalyser(graph, input_nonnegative).run();
}

}  // namespace mixcmp::error
