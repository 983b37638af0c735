#include "model/judge/proof/rule.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "model/base/common/check.hpp"
#include "model/base/number/exact.hpp"
#include "model/judge/proof/claims.hpp"
#include "model/judge/proof/cone.hpp"
#include "model/judge/proof/script.hpp"

namespace mixcmp::proof {
namespace {

/// A divisor's error is at most this fraction of it, as the lane's condition ensures.
const mpq_class divisor_share(1, 32);

using Weight = std::function<mpq_class(const BoundSample&)>;

class RuleWriter {
public:
  RuleWriter(const TypedGraph& graph, const error::ErrorAnalysis& analysis, NodeId id)
      : graph_(graph),
        analysis_(analysis),
        id_(id),
        node_(graph.nodes[id]),
        a_(node_.operands[0]),
        b_(node_.operands[1]) {}

  NodeRules run() &&;

private:
  const error::MixedBound& mixed(NodeId id) const { return *analysis_.nodes[id].mixed; }
  bool has_error(NodeId id) const { return !mixed(id).is_relative(); }
  bool is_signed_sum() const;
  Weight error(NodeId id) const;
  Weight magnitude(NodeId id) const;
  RuleVariable factor(const char* name, NodeId id) const;
  RuleVariable error_factor(const char* name, NodeId id) const;
  RuleVariable own_rounding_factor(const char* name) const;
  void add(Weight weight, std::string factor);

  void inherit();
  void select();
  void sum();
  void cancelling_sum();
  void add_deviations();
  void add_largest(const Weight& largest, const std::string& deviation);
  bool is_unrounded(NodeId id) const;
  mpq_class constant_error(NodeId id) const;
  void multiply();
  void square();
  void divide();
  void square_root();

  const TypedGraph& graph_;
  const error::ErrorAnalysis& analysis_;
  NodeId id_;
  const TypedNode& node_;
  NodeId a_;
  NodeId b_;
  Rule rule_;
  NodeRules result_;
};

Weight times(Weight a, Weight b) {
  return [a = std::move(a), b = std::move(b)](const BoundSample& sample) {
    return mpq_class(a(sample) * b(sample));
  };
}

Weight larger(Weight a, Weight b) {
  return [a = std::move(a), b = std::move(b)](const BoundSample& sample) {
    return std::max<mpq_class>(a(sample), b(sample));
  };
}

Weight scaled(Weight a, mpq_class factor) {
  return [a = std::move(a), factor = std::move(factor)](const BoundSample& sample) {
    return mpq_class(a(sample) * factor);
  };
}

/// A factor in [0, 1]; `unit` makes a factor in [-1, 1].
const RuleVariable any_share = {"o", 0, 1};
RuleVariable unit(const char* name) {
  return {name, -1, 1};
}

NodeRules RuleWriter::run() && {
  switch (node_.operation) {
    case Operation::input:
    case Operation::constant: return {};
    case Operation::convert:
    case Operation::negate:
    case Operation::absolute: inherit(); break;
    case Operation::minimum:
    case Operation::maximum: select(); return std::move(result_);
    case Operation::add:
    case Operation::subtract: is_signed_sum() ? sum() : cancelling_sum(); break;
    case Operation::multiply: multiply(); break;
    case Operation::square: square(); break;
    case Operation::divide: divide(); break;
    case Operation::square_root: square_root(); break;
    case Operation::function:
    case Operation::look_up:
    case Operation::fused_sum: MIXCMP_CHECK(!"lanes have no fused sums"); break;
  }
  if (!rule_.terms.empty()) result_.rules.push_back(std::move(rule_));
  return std::move(result_);
}

/// Whether the operands have one sign or exact factors. Either way the sum's factor is a mean of
/// both.
bool RuleWriter::is_signed_sum() const {
  const error::NodeBound &a = analysis_.nodes[a_], &b = analysis_.nodes[b_];
  const bool minus = node_.operation == Operation::subtract;
  if (error::is_exact(mixed(a_).factor) && error::is_exact(mixed(b_).factor)) return true;
  return (a.nonnegative && (minus ? b.nonpositive : b.nonnegative)) ||
         (a.nonpositive && (minus ? b.nonnegative : b.nonpositive));
}

Weight RuleWriter::error(NodeId id) const {
  return [this_analysis = &analysis_, bound = mixed(id).absolute.bound](const BoundSample& sample) {
    return sample.value(this_analysis->bounds, bound);
  };
}

Weight RuleWriter::magnitude(NodeId id) const {
  return [id](const BoundSample& sample) { return sample.magnitude(id); };
}

RuleVariable RuleWriter::factor(const char* name, NodeId id) const {
  const error::RelativeBound bound = provable(mixed(id).factor, depth_of(graph_, id));
  return {name, bound.low, bound.high};
}

RuleVariable RuleWriter::error_factor(const char* name, NodeId id) const {
  const mpq_class inflation = provable_inflation(graph_, analysis_, id);
  return {name, -inflation, inflation};
}

RuleVariable RuleWriter::own_rounding_factor(const char* name) const {
  if (own_rounding(graph_, node_) != OwnRounding::rounds) return {name, 1, 1};
  const error::RelativeBound own =
      rounding_interval(node_.format.precision(), graph_.arithmetic.rounding);
  return {name, own.low, own.high};
}

void RuleWriter::add(Weight weight, std::string factor) {
  rule_.terms.push_back({std::move(weight), std::move(factor)});
}

void RuleWriter::inherit() {
  if (!has_error(a_)) return;
  rule_.variables = {error_factor("p", a_)};
  add(error(a_), "p");
}

/// The error of a selection is at most the larger of its operands' errors.
void RuleWriter::select() {
  for (const NodeId operand : {a_, b_}) {
    if (!has_error(operand)) continue;
    Rule rule{.variables = {any_share, error_factor("p", operand)}};
    rule.terms.push_back({larger(error(a_), error(b_)), "o * p"});
    result_.rules.push_back(std::move(rule));
  }
}

void RuleWriter::sum() {
  for (const auto& [name, operand] : {std::pair("p", a_), std::pair("q", b_)}) {
    if (!has_error(operand)) continue;
    rule_.variables.push_back(error_factor(name, operand));
    add(error(operand), name);
  }
}

/// (a s + C p) + (b t + D q) = (a + b) m + C p + D q + a (s - m) + b (t - m).
void RuleWriter::cancelling_sum() {
  sum();
  const error::RelativeBound own =
      rounding_interval(node_.format.precision(), graph_.arithmetic.rounding);
  result_.center = mixed(id_).factor.low / own.low;
  rule_.identity = {"(a * s + c * p + (b * t + d * q)) - (a + b) * m",
                    "c * p + d * q + a * (s - m) + b * (t - m)"};
  add_deviations();
}

void RuleWriter::add_deviations() {
  const mpq_class& center = *result_.center;
  std::string deviation;
  Weight largest;
  for (const auto& [operand, part, factor_name, unit_name] :
       {std::tuple(a_, "v", "s", "al"), std::tuple(b_, "w", "t", "be")}) {
    const error::RelativeBound& operand_factor = mixed(operand).factor;
    const TypedNode& operand_node = graph_.nodes[operand];
    const bool plain = is_unrounded(operand);
    const error::NodeBound& bound = analysis_.nodes[operand];
    const bool rounded_once =
        bound.relative && bound.unrounded && error::is_exact(*bound.unrounded);
    if (error::is_exact(operand_factor) && center == 1) continue;
    if (center == 1 && (plain || rounded_once)) {
      const mpq_class size =
          plain ? constant_error(operand)
                : rounding_interval(operand_node.format.precision(), graph_.arithmetic.rounding)
                          .high -
                      1;
      if (size == 0) continue;
      rule_.variables.push_back(unit(part));
      add(
          [=, operand = operand](const BoundSample& sample) {
            return plain ? size : mpq_class(size * sample.binade(operand));
          },
          part);
      continue;
    }
    rule_.variables.push_back(factor(factor_name, operand));
    rule_.variables.push_back(unit(unit_name));
    deviation +=
        fmt::format("{}{} * ({} - m)", deviation.empty() ? "" : " + ", unit_name, factor_name);
    largest = largest ? larger(largest, magnitude(operand)) : magnitude(operand);
  }
  if (!largest) return;
  const error::RelativeBound exact_center = provable({center, center}, depth_of(graph_, a_));
  rule_.variables.push_back({"m", exact_center.low, exact_center.high});
  add_largest(largest, deviation);
}

/// Adds the term of the larger magnitude. The bound may choose the weight of this term, so the
/// weight is derived from the first sample.
void RuleWriter::add_largest(const Weight& largest, const std::string& deviation) {
  const BoundSample sample(graph_, 0);
  mpq_class rest = error(id_)(sample);
  for (const RuleTerm& term : rule_.terms) rest -= term.weight(sample);
  const mpq_class share = rest / largest(sample);
  if (share <= 0) return add(largest, deviation);
  add(scaled(largest, share), fmt::format("({}) / ({} / {})", deviation, share.get_num().get_str(),
                                          share.get_den().get_str()));
}

/// Whether nothing at or below the node rounds: an unchanged operand, a constant, or a node that
/// only moves the bits of these.
bool RuleWriter::is_unrounded(NodeId id) const {
  const TypedNode& node = graph_.nodes[id];
  if (arity(node.operation) > 0 && !only_moves_bits(node.operation)) return false;
  for (int k = 0; k < arity(node.operation); ++k) {
    if (!is_unrounded(node.operands[k])) return false;
  }
  return true;
}

/// The absolute error of a constant, or of a selection among constants and exact operands.
mpq_class RuleWriter::constant_error(NodeId id) const {
  const TypedNode& node = graph_.nodes[id];
  if (node.operation == Operation::constant) {
    return abs(node.value - to_rational(node.format, node.constant));
  }
  mpq_class error = 0;
  for (int k = 0; k < arity(node.operation); ++k) {
    error = std::max(error, constant_error(node.operands[k]));
  }
  return error;
}

void RuleWriter::multiply() {
  const bool first = has_error(a_), second = has_error(b_);
  rule_.variables = {factor("s", a_), factor("t", b_), error_factor("p", a_),
                     error_factor("q", b_)};
  if (second) add(times(magnitude(a_), error(b_)), "s * q");
  if (first && second) add(times(error(a_), error(b_)), "p * q");
  if (first) add(times(magnitude(b_), error(a_)), "t * p");
  rule_.identity = {"(a * s + c * p) * (b * t + d * q) - (a * b) * (s * t)",
                    "(a * d) * (s * q) + (c * d) * (p * q) + (b * c) * (t * p)"};
}

void RuleWriter::square() {
  if (!has_error(a_)) return;
  rule_.variables = {factor("s", a_), error_factor("p", a_)};
  add(scaled(times(magnitude(a_), error(a_)), 2), "s * p");
  add(times(error(a_), error(a_)), "p * p");
  rule_.identity = {"(a * s + c * p) * (a * s + c * p) - (a * a) * (s * s)",
                    "(2 * a * c) * (s * p) + (c * c) * (p * p)"};
}

/// Writes the rule of a quotient. z = D q / (b t), |z| <= 1/32; r is a / b over the computed
/// quotient; 1 / |b| is `o` times the bound's power of two.
void RuleWriter::divide() {
  const Weight reciprocal = [id = b_](const BoundSample& sample) { return sample.reciprocal(id); };
  const error::RelativeBound& divisor = mixed(b_).factor;
  rule_.variables = {factor("s", a_),       factor("t", b_),          error_factor("p", a_),
                     error_factor("q", b_), own_rounding_factor("r"), any_share};
  mpq_class share = 0;
  if (has_error(b_)) {
    const error::RelativeBound proven = provable(divisor, depth_of(graph_, b_));
    const mpq_class& claimed = mixed(b_).absolute.inflation;
    const mpq_class excess = provable_inflation(graph_, analysis_, b_) / claimed;
    share = rounded_up(divisor_share * excess * divisor.low / proven.low);
    const mpq_class limit = claimed / divisor_share / divisor.low;
    result_.conditions.push_back({b_, scaled(error(b_), limit)});
    add(times(times(magnitude(id_), error(b_)), reciprocal), "o * r * (s / t) * q / (t * (1 + z))");
  }
  rule_.variables.push_back({"z", -share, share});
  if (has_error(a_)) add(times(error(a_), reciprocal), "o * p / (t * (1 + z))");
  rule_.identity = {
      "(a * s + c * p) / (b * t * (1 + z)) - (a / b) * (s / t)",
      "c * p / (b * t * (1 + z)) - (a / b) * (s / t) * (z * b * t) / (b * t * (1 + z))"};
}

/// Writes the rule of a root. h = sqrt(a s), k = sqrt(a s + C p); r is sqrt(a) over the computed
/// root.
void RuleWriter::square_root() {
  if (!has_error(a_)) return;
  rule_.variables = {factor("s", a_), error_factor("p", a_), own_rounding_factor("r"), any_share};
  const Weight reciprocal = [id = id_](const BoundSample& sample) { return sample.reciprocal(id); };
  add(times(error(a_), reciprocal), "o * p / (r * sqrt(s))");
  rule_.identity = {"k - h", "(k * k - h * h) / (k + h)"};
  if (analysis_.nodes[a_].nonnegative) return;
  const mpq_class limit = mixed(a_).absolute.inflation / mixed(a_).factor.low;
  result_.conditions.push_back({a_, scaled(error(a_), limit)});
}

}  // namespace

NodeRules rules_of(const TypedGraph& graph, const error::ErrorAnalysis& analysis, NodeId id) {
  return RuleWriter(graph, analysis, id).run();
}

/// A factor enters by its distance from one, which is about an ulp. Relative to that distance the
/// widening of `provable` is about 2^P times as large, and so is the widening here.
mpq_class provable_inflation(const TypedGraph& graph, const error::ErrorAnalysis& analysis,
                             NodeId id) {
  const mpq_class& inflation = analysis.nodes[id].mixed->absolute.inflation;
  const long widening =
      2L * depth_of(graph, id) + graph.arithmetic.format.precision() + 4 - widening_bits;
  return rounded_up(inflation * (1 + power_of_two(widening)));
}

std::string rule_script(const Rule& rule, const mpq_class& inflation) {
  Script script;
  script.comment("An operation's absolute error is a sum of these factors, each times its weight.");
  for (const RuleVariable& variable : rule.variables) {
    script.assume_within(variable.name, dyadic(variable.low), dyadic(variable.high));
  }
  const std::string most = dyadic(inflation);
  for (const RuleTerm& term : rule.terms) {
    script.conclude(fmt::format("{} in [-{}, {}]", term.factor, most, most));
  }
  if (rule.identity) {
    script.comment("The hint does nothing but have Gappa check that both sides are equal.");
    script.hint(rule.identity->left, rule.identity->right);
  }
  return script.text();
}

}  // namespace mixcmp::proof
