#include "model/proof/absolute_proof.hpp"

#include <fmt/core.h>

#include <array>

#include "model/common/check.hpp"
#include "model/proof/cone.hpp"
#include "model/proof/node_prover.hpp"
#include "model/proof/rule_proof.hpp"

namespace mixcmp::model::proof {
namespace {

void append(std::vector<Finding>& findings, std::vector<Finding> more) {
  for (Finding& finding : more) findings.push_back(std::move(finding));
}

/// A running bound may be a number too: what that leaves out is in guard and conditions.
bool is_constant(const AbsoluteBoundDecision& decision) {
  const std::vector<BoundNode>& nodes = decision.bound.nodes;
  return decision.guard_ulp == 0 && decision.conditions.empty() && nodes.size() == 1 &&
         nodes.front().operation == BoundOperation::constant;
}

/// The two sides of the difference that decides.
std::array<NodeId, 2> sides(const Lane& lane, const AbsoluteBoundDecision& decision) {
  const TypedNode& difference = lane.graph.nodes[decision.difference];
  MIXCMP_CHECK(difference.operation == Operation::subtract);
  return difference.operands;
}

Finding prove_from_ranges(const Lane& lane, const AbsoluteBoundDecision& decision,
                          const Prove& prove) {
  Finding finding{"f - g, the whole expression, from the ranges", Outcome::not_expressible, ""};
  const auto [f, g] = sides(lane, decision);
  const mpq_class& bound = decision.bound.nodes.front().constant;
  const RangeScript range = range_script(lane, f, g, bound);
  finding.detail = range.obstacle;
  if (!range.script) return finding;
  const ScriptResult result = prove(*range.script);
  finding.outcome = result.outcome;
  finding.detail = result.detail;
  if (!result.file.empty()) finding.files.push_back(result.file);
  return finding;
}

}  // namespace

LaneProof prove_absolute(const Lane& lane, const ErrorAnalysis& analysis, const Prove& prove) {
  const auto& decision = std::get<AbsoluteBoundDecision>(lane.decision);
  const bool constant = is_constant(decision);
  LaneProof proof;
  proof.lane = describe_arithmetic(lane.graph.arithmetic);
  proof.kind = constant ? "constant" : "running";
  proof.by_hand = {"that a non-exceptional result is the rounding with unbounded exponents",
                   "theorem 8 of docs/error_bounds.md: from the bound of f - g to its sign"};
  if (constant) {
    Finding whole = prove_from_ranges(lane, decision, prove);
    const bool settled = whole.outcome == Outcome::proven || whole.outcome == Outcome::unchecked;
    whole.optional = !settled;
    proof.findings.push_back(std::move(whole));
    if (settled) return proof;
    proof.by_hand.push_back("that intervals take the place of magnitudes in the bound (theorem 9)");
  } else {
    proof.by_hand.push_back("that bounds are rounded up in their few digits (theorem 9)");
  }
  proof.by_hand.push_back("theorem 7: that an error is the sum of terms whose size is proven");
  proof.by_hand.push_back("that rounding and its error scale with powers of two");
  append(proof.findings, prove_rules(lane, analysis, prove));
  if (constant) {
    proof.findings.push_back(check_constant_decision(lane, analysis));
  } else {
    append(proof.findings, check_running_decision(lane, analysis));
  }
  return proof;
}

}  // namespace mixcmp::model::proof
