#include "model/judge/proof/rule_proof.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>

#include "model/base/common/check.hpp"
#include "model/base/number/exact.hpp"
#include "model/judge/proof/cone.hpp"
#include "model/judge/proof/node_prover.hpp"
#include "model/judge/proof/rule.hpp"
#include "model/judge/proof/script.hpp"

namespace mixcmp::proof {
namespace {

std::vector<BoundSample> samples_of(const TypedGraph& graph) {
  std::vector<BoundSample> samples;
  for (int seed = 0; seed < BoundSample::sample_count; ++seed) {
    samples.emplace_back(graph, static_cast<std::uint64_t>(seed));
  }
  return samples;
}

/// Claims with the factors of mixed bounds, without their absolute parts.
std::vector<NodeClaim> factor_claims(const error::ErrorAnalysis& analysis) {
  std::vector<NodeClaim> claims;
  for (const error::NodeBound& bound : analysis.nodes) {
    NodeClaim claim{.relative = {},
                    .unrounded = bound.unrounded,
                    .nonnegative = bound.nonnegative,
                    .nonpositive = bound.nonpositive};
    if (bound.mixed) claim.relative = bound.mixed->factor;
    claims.push_back(std::move(claim));
  }
  return claims;
}

class RuleProof {
public:
  RuleProof(const error::Lane& lane, const error::ErrorAnalysis& analysis, const Prove& prove)
      : graph_(lane.graph),
        analysis_(analysis),
        claims_(factor_claims(analysis)),
        samples_(samples_of(lane.graph)),
        nodes_(lane, claims_, prove) {}

  std::vector<Finding> run() &&;

private:
  void prove_binade_rounding();
  void prove_factor(NodeId id, const NodeRules& rules);
  void prove_absolute_part(NodeId id, const NodeRules& rules);
  void check_lost_constant(NodeId id);
  void check_condition(const RuleCondition& condition);
  bool is_the_bound(NodeId id, const Rule& rule) const;
  const error::MixedBound& mixed(NodeId id) const { return *analysis_.nodes[id].mixed; }

  const TypedGraph& graph_;
  const error::ErrorAnalysis& analysis_;
  std::vector<NodeClaim> claims_;
  std::vector<BoundSample> samples_;
  NodeProver nodes_;
};

std::vector<Finding> RuleProof::run() && {
  nodes_.prove_arithmetic();
  prove_binade_rounding();
  for (NodeId id = 0; id < static_cast<NodeId>(graph_.nodes.size()); ++id) {
    if (!analysis_.nodes[id].mixed) continue;
    if (graph_.nodes[id].operation == Operation::constant && !mixed(id).is_relative()) {
      check_lost_constant(id);
      continue;
    }
    const NodeRules rules = rules_of(graph_, analysis_, id);
    prove_factor(id, rules);
    if (!mixed(id).is_relative()) prove_absolute_part(id, rules);
    for (const RuleCondition& condition : rules.conditions) check_condition(condition);
  }
  return std::move(nodes_).take();
}

/// Proves theorem 1's error relative to the binade, which a sum uses for an operand that rounds
/// once.
void RuleProof::prove_binade_rounding() {
  const int precision = graph_.arithmetic.format.precision();
  std::vector<ConeCase> cases;
  for (const std::string& script : binade_scripts(precision, graph_.arithmetic.rounding)) {
    cases.push_back({"", script});
  }
  nodes_.add(nodes_.run_scripts("the same rounding's error as a part of the binade", cases));
}

void RuleProof::prove_factor(NodeId id, const NodeRules& rules) {
  if (!rules.center) return nodes_.prove_node(id);
  const error::RelativeBound own =
      rounding_interval(graph_.arithmetic.format.precision(), graph_.arithmetic.rounding);
  const error::RelativeBound& factor = mixed(id).factor;
  const bool holds = factor.low <= *rules.center * own.low &&
                     *rules.center * own.high <= factor.high && *rules.center > 0;
  nodes_.add({fmt::format("{} {}, factor", to_string(graph_.nodes[id].operation), nodes_.text(id)),
              holds ? Outcome::proven : Outcome::not_proven, "by exact arithmetic"});
}

void RuleProof::prove_absolute_part(NodeId id, const NodeRules& rules) {
  const mpq_class inflation = provable_inflation(graph_, analysis_, id);
  std::vector<ConeCase> cases;
  for (const Rule& rule : rules.rules) cases.push_back({"", rule_script(rule, inflation)});
  Finding finding = nodes_.run_scripts(
      fmt::format("{} {}, absolute error", to_string(graph_.nodes[id].operation), nodes_.text(id)),
      cases);
  const bool same =
      !rules.rules.empty() && std::all_of(rules.rules.begin(), rules.rules.end(),
                                          [&](const Rule& rule) { return is_the_bound(id, rule); });
  if (!same) {
    finding.outcome = Outcome::not_proven;
    finding.detail = "the bound is not the sum that theorem 7 asks for";
  }
  nodes_.add(std::move(finding));
}

bool RuleProof::is_the_bound(NodeId id, const Rule& rule) const {
  return std::all_of(samples_.begin(), samples_.end(), [&](const BoundSample& sample) {
    mpq_class sum = 0;
    for (const RuleTerm& term : rule.terms) sum += term.weight(sample);
    return sum == sample.value(analysis_.bounds, mixed(id).absolute.bound);
  });
}

/// Checks a constant that its format rounds to zero; its bound is a number.
void RuleProof::check_lost_constant(NodeId id) {
  const TypedNode& node = graph_.nodes[id];
  const mpq_class computed = to_rational(node.format, node.constant);
  const error::MixedBound& bound = mixed(id);
  const mpq_class error = samples_.front().value(analysis_.bounds, bound.absolute.bound);
  const auto within = [&](const mpq_class& factor) {
    return abs(node.value - computed * factor) <= bound.absolute.inflation * error;
  };
  nodes_.add({"constant " + nodes_.text(id),
              within(bound.factor.low) && within(bound.factor.high) ? Outcome::proven
                                                                    : Outcome::not_proven,
              "by exact arithmetic"});
}

void RuleProof::check_condition(const RuleCondition& condition) {
  const auto asks = [&](const error::BoundCondition& known) {
    return known.value == condition.value &&
           std::all_of(samples_.begin(), samples_.end(), [&](const BoundSample& sample) {
             return sample.value(analysis_.bounds, known.bound) >= condition.bound(sample);
           });
  };
  const auto& known = analysis_.conditions;
  const bool found = std::any_of(known.begin(), known.end(), asks);
  nodes_.add({"a condition on " + nodes_.text(condition.value),
              found ? Outcome::proven : Outcome::not_proven, "by exact arithmetic"});
}

/// Whether a node of the lane's bound graph equals the analysis' bound in every sample.
bool stands_for(const error::Lane& lane, int lane_bound, const error::ErrorAnalysis& analysis,
                error::BoundId bound) {
  const auto& nodes = std::get<error::AbsoluteBoundCriterion>(lane.criterion()).bound.nodes;
  const std::vector<BoundSample> samples = samples_of(lane.graph);
  return std::all_of(samples.begin(), samples.end(), [&](const BoundSample& sample) {
    return sample.value(nodes, lane_bound) == sample.value(analysis.bounds, bound);
  });
}

/// Whether the guard covers the inflation. A guard of 0 suffices for an inflation as small as the
/// proof's own widening, since numbers of P digits are further apart.
bool guards(Bits guard, const mpq_class& inflation, int precision) {
  if (inflation <= 1 + power_of_two(-precision - 2)) return true;
  return guard >= error::steps_beyond(inflation, precision);
}

}  // namespace

error::ErrorAnalysis analysis_of(const error::Lane& lane) {
  std::vector<bool> nonnegative;
  for (int input = 0; input < lane.graph.input_count; ++input) {
    nonnegative.push_back(is_checked_nonnegative(lane.checks, input));
  }
  return error::analyse_errors(lane.graph, nonnegative);
}

std::vector<Finding> prove_rules(const error::Lane& lane, const error::ErrorAnalysis& analysis,
                                 const Prove& prove) {
  return RuleProof(lane, analysis, prove).run();
}

std::vector<Finding> check_running_decision(const error::Lane& lane,
                                            const error::ErrorAnalysis& analysis) {
  const auto& criterion = std::get<error::AbsoluteBoundCriterion>(lane.criterion());
  const Arithmetic& arithmetic = lane.graph.arithmetic;
  const int precision = arithmetic.format.precision();
  const auto finding = [](std::string what, bool holds) {
    return Finding{std::move(what), holds ? Outcome::proven : Outcome::not_proven,
                   "by exact arithmetic"};
  };
  const error::MixedBound& bound = *analysis.nodes[criterion.difference].mixed;
  const auto last = static_cast<int>(criterion.bound.nodes.size()) - 1;
  const mpq_class low = bound.factor.low / rounding_interval(precision, arithmetic.rounding).low;
  const mpq_class inflation =
      provable_inflation(lane.graph, analysis, criterion.difference) / std::min<mpq_class>(1, low);
  const bool conditions = std::all_of(
      analysis.conditions.begin(), analysis.conditions.end(),
      [&](const error::BoundCondition& needed) {
        return std::any_of(criterion.conditions.begin(), criterion.conditions.end(),
                           [&](const error::BoundCondition& held) {
                             return held.value == needed.value &&
                                    stands_for(lane, held.bound, analysis, needed.bound);
                           });
      });
  return {finding("the lane computes the bound of f - g",
                  stands_for(lane, last, analysis, bound.absolute.bound)),
          finding("its guard covers the factors left out",
                  guards(criterion.guard_ulp, inflation, precision) ||
                      criterion.guard_ulp == low_mask(arithmetic.format.width())),
          finding("it asks for every condition", conditions)};
}

}  // namespace mixcmp::proof
