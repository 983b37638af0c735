#include "model/judge/proof/constant_proof.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "model/base/common/check.hpp"
#include "model/base/number/bound_format.hpp"
#include "model/judge/proof/cone.hpp"
#include "model/judge/proof/node_prover.hpp"
#include "model/judge/proof/node_ranges.hpp"
#include "model/judge/proof/rule.hpp"
#include "model/judge/proof/script.hpp"

namespace mixcmp::proof {
namespace {

std::string quotient(const mpq_class& value) {
  const std::string numerator = value.get_num().get_str();
  return value.get_den() == 1 ? numerator
                              : fmt::format("({} / {})", numerator, value.get_den().get_str());
}

class ConstantProof {
public:
  ConstantProof(const error::Lane& lane, const error::ErrorAnalysis& analysis, const Prove& prove)
      : lane_(lane),
        graph_(lane.graph),
        analysis_(analysis),
        nodes_(lane, no_claims_, prove),
        ranges_(lane, nodes_) {}

  std::vector<Finding> run() &&;

private:
  void prove_bound();
  void prove_condition(const error::BoundCondition& condition);
  void prove_at_most(std::string what, error::BoundId bound, const mpq_class& factor,
                     const mpq_class& most);
  void prove_binade(NodeId id);
  void add_bound(Script& script, error::BoundId id, std::set<std::string>& known);
  void add_value(Script& script, NodeId id, std::set<std::string>& known);
  mpq_class greatest(error::BoundId id);
  mpq_class greatest_binade(NodeId id);
  static std::string name(error::BoundId id) { return fmt::format("b{}", id); }

  const error::Lane& lane_;
  const TypedGraph& graph_;
  const error::ErrorAnalysis& analysis_;
  const std::vector<NodeClaim> no_claims_;
  NodeProver nodes_;
  NodeRanges ranges_;
  std::set<NodeId> proven_binades_;
};

std::vector<Finding> ConstantProof::run() && {
  prove_bound();
  for (const error::BoundCondition& condition : analysis_.conditions) prove_condition(condition);
  return std::move(nodes_).take();
}

/// Proves that A / l of theorem 8 is at most `decided_beyond`.
void ConstantProof::prove_bound() {
  const NodeId difference = std::get<error::AbsoluteBoundCriterion>(lane_.criterion()).difference;
  const error::MixedBound& bound = *analysis_.nodes[difference].mixed;
  const std::optional<mpq_class> most = decided_beyond(lane_);
  const std::string what = "the constant, from that bound and the ranges";
  if (!most || bound.absolute.bound == error::no_bound_node) {
    nodes_.add({what, Outcome::proven, "by exact arithmetic"});
    return;
  }
  const error::RelativeBound own =
      rounding_interval(graph_.arithmetic.format.precision(), graph_.arithmetic.rounding);
  const mpq_class low = std::min<mpq_class>(1, bound.factor.low / own.low);
  const mpq_class factor = rounded_up(provable_inflation(graph_, analysis_, difference) / low);
  prove_at_most(what, bound.absolute.bound, factor, *most);
}

void ConstantProof::prove_condition(const error::BoundCondition& condition) {
  const mpq_class least = least_magnitude(ranges_.prove_range(condition.value));
  prove_at_most(fmt::format("{} is never closer to zero than its condition asks",
                            nodes_.text(condition.value)),
                condition.bound, 1, least);
}

void ConstantProof::prove_at_most(std::string what, error::BoundId bound, const mpq_class& factor,
                                  const mpq_class& most) {
  Script script;
  script.comment(
      "c: computed values in their ranges; e: powers of two at or below them; m: maxima.");
  std::set<std::string> known;
  add_bound(script, bound, known);
  script.conclude(fmt::format("{} * {} in [0, {}]", dyadic(factor), name(bound), dyadic(most)));
  nodes_.add(nodes_.run_scripts(std::move(what), {{"", script.text()}}));
}

/// Defines a bound, its operands first. A maximum becomes a variable with an upper limit. The
/// script also concludes that neither operand exceeds this limit. The operands do not depend on the
/// variable, so the limit holds for the true maximum.
void ConstantProof::add_bound(Script& script, error::BoundId id, std::set<std::string>& known) {
  if (!known.insert(name(id)).second) return;
  const error::BoundNode& node = analysis_.bounds[id];
  for (int k = 0; k < arity(node.operation); ++k) add_bound(script, node.operands[k], known);
  const std::string a = name(node.operands[0]), b = name(node.operands[1]);
  switch (node.operation) {
    case error::BoundOperation::constant: return script.define(name(id), quotient(node.constant));
    case error::BoundOperation::magnitude:
      add_value(script, node.value, known);
      return script.define(name(id), fmt::format("|c{}|", node.value));
    case error::BoundOperation::reciprocal:
      add_value(script, node.value, known);
      return script.define(name(id), fmt::format("1 / |c{}|", node.value));
    case error::BoundOperation::binade:
      prove_binade(node.value);
      script.define(name(id), fmt::format("e{}", node.value));
      return script.assume_within(fmt::format("e{}", node.value), "0",
                                  dyadic(greatest_binade(node.value)));
    case error::BoundOperation::add: return script.define(name(id), fmt::format("{} + {}", a, b));
    case error::BoundOperation::multiply:
      return script.define(name(id), fmt::format("{} * {}", a, b));
    case error::BoundOperation::maximum: {
      const std::string most = dyadic(greatest(id));
      for (const std::string& operand : {a, b}) {
        script.conclude(fmt::format("{} in [0, {}]", operand, most));
      }
      script.define(name(id), fmt::format("m{}", id));
      return script.assume_within(fmt::format("m{}", id), "0", most);
    }
  }
  MIXCMP_CHECK(false);
}

void ConstantProof::add_value(Script& script, NodeId id, std::set<std::string>& known) {
  const std::string name = fmt::format("c{}", id);
  if (!known.insert(name).second) return;
  const Range& range = ranges_.prove_range(id);
  script.assume_within(name, dyadic(range.low), dyadic(range.high));
}

/// A binade in the bound stands for the error of its node's rounding. Proves that this error is at
/// most the relative error of one rounding times the greatest binade of the node's range.
void ConstantProof::prove_binade(NodeId id) {
  if (!proven_binades_.insert(id).second) return;
  const Range& range = ranges_.prove_range(id);
  const mpq_class most = greatest_binade(id);
  if (most == 0) return;  // only zero rounds to zero
  const int precision = graph_.nodes[id].format.precision();
  const Rounding rounding = graph_.arithmetic.rounding;
  const std::string error = dyadic((rounding_interval(precision, rounding).high - 1) * most);
  Script script;
  script.comment("The error of a rounding whose result lies in this range.");
  script.define_operator("rnd", rounding_operator(precision, rounding));
  script.define("c", "rnd(y)");
  script.assume_within("c", dyadic(range.low), dyadic(range.high));
  script.conclude(fmt::format("c - y in [-{0}, {0}]", error));
  nodes_.add(
      nodes_.run_scripts(fmt::format("the error of rounding {} in its range", nodes_.text(id)),
                         {{"", script.text()}}));
}

mpq_class ConstantProof::greatest_binade(NodeId id) {
  const mpq_class most = greatest_magnitude(ranges_.prove_range(id));
  return most == 0 ? most : binade(most);
}

/// An upper limit of the bound, raised a little so that Gappa can prove it. The reciprocal of a
/// value that may be zero has no limit. The result is then 0, and Gappa cannot prove that.
mpq_class ConstantProof::greatest(error::BoundId id) {
  const error::BoundNode& node = analysis_.bounds[id];
  const auto operand = [&](int k) { return greatest(node.operands[k]); };
  const auto widened = [](const mpq_class& value) {
    return rounded_up(value * (1 + power_of_two(-widening_bits)));
  };
  switch (node.operation) {
    case error::BoundOperation::constant: return widened(node.constant);
    case error::BoundOperation::magnitude:
      return greatest_magnitude(ranges_.prove_range(node.value));
    case error::BoundOperation::binade: return greatest_binade(node.value);
    case error::BoundOperation::reciprocal: {
      const mpq_class least = least_magnitude(ranges_.prove_range(node.value));
      return least == 0 ? mpq_class(0) : widened(1 / least);
    }
    case error::BoundOperation::add: return widened(operand(0) + operand(1));
    case error::BoundOperation::multiply: return widened(operand(0) * operand(1));
    case error::BoundOperation::maximum: return std::max<mpq_class>(operand(0), operand(1));
  }
  MIXCMP_CHECK(false);
}

}  // namespace

bool is_constant(const error::AbsoluteBoundCriterion& criterion) {
  const std::vector<error::BoundNode>& nodes = criterion.bound.nodes;
  return criterion.guard_ulp == 0 && criterion.conditions.empty() && nodes.size() == 1 &&
         nodes.front().operation == error::BoundOperation::constant;
}

/// Numbers of P digits are more than one part in 2^P apart. A difference f - g that exceeds the
/// constant by less than half a step is still rounded to the constant.
std::optional<mpq_class> decided_beyond(const error::Lane& lane) {
  const auto& criterion = std::get<error::AbsoluteBoundCriterion>(lane.criterion());
  MIXCMP_CHECK(is_constant(criterion));
  const BoundFormat format = criterion.bound.format;
  const Bits encoded = encode_bound(format, criterion.bound.nodes.front().constant);
  if (encoded == format.infinity()) return std::nullopt;
  const int precision = lane.graph.arithmetic.format.precision();
  return mpq_class(bound_value(format, encoded) * (1 + power_of_two(-precision - 2)));
}

std::vector<Finding> prove_constant(const error::Lane& lane, const error::ErrorAnalysis& analysis,
                                    const Prove& prove) {
  return ConstantProof(lane, analysis, prove).run();
}

}  // namespace mixcmp::proof
