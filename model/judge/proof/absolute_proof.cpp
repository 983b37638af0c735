#include "model/judge/proof/absolute_proof.hpp"

#include <fmt/core.h>

#include <array>

#include "model/base/common/check.hpp"
#include "model/judge/proof/constant_proof.hpp"
#include "model/judge/proof/node_prover.hpp"
#include "model/judge/proof/rule_proof.hpp"

namespace mixcmp::proof {
namespace {

void append(std::vector<Finding>& findings, std::vector<Finding> more) {
  for (Finding& finding : more) findings.push_back(std::move(finding));
}

/// The operands of the difference whose sign is the lane's decision.
std::array<NodeId, 2> sides(const error::Lane& lane,
                            const error::AbsoluteBoundCriterion& criterion) {
  const TypedNode& difference = lane.graph.nodes[criterion.difference];
  MIXCMP_CHECK(difference.operation == Operation::subtract);
  return difference.operands;
}

Finding prove_from_ranges(const error::Lane& lane, const error::AbsoluteBoundCriterion& criterion,
                          const Prove& prove) {
  Finding finding{"f - g, the whole expression, from the ranges", Outcome::not_expressible, ""};
  const auto [f, g] = sides(lane, criterion);
  const std::optional<mpq_class> bound = decided_beyond(lane);
  if (!bound) return {finding.what, Outcome::proven, "an infinite bound decides nothing"};
  const RangeScript range = range_script(lane, f, g, *bound);
  finding.detail = range.obstacle;
  if (!range.script) return finding;
  const ScriptResult result = prove(*range.script);
  finding.outcome = result.outcome;
  finding.detail = result.detail;
  if (!result.file.empty()) finding.files.push_back(result.file);
  return finding;
}

}  // namespace

LaneProof prove_absolute(const error::Lane& lane, const error::ErrorAnalysis& analysis,
                         const Prove& prove, Effort effort) {
  const auto& criterion = std::get<error::AbsoluteBoundCriterion>(lane.criterion());
  const bool constant = is_constant(criterion);
  LaneProof proof;
  proof.lane = describe_arithmetic(lane.graph.arithmetic);
  proof.kind = constant ? "constant" : "running";
  const ByHand decides = {"8", "theorem 8: from the bound of f - g to its sign"};
  proof.by_hand = {scaling_by_hand()};
  if (constant && effort == Effort::whole) {
    Finding whole = prove_from_ranges(lane, criterion, prove);
    const bool settled = whole.outcome == Outcome::proven || whole.outcome == Outcome::unchecked;
    whole.optional = !settled;
    proof.findings.push_back(std::move(whole));
    if (settled) {
      proof.by_hand.push_back(decides);
      return proof;
    }
  }
  proof.by_hand.push_back({"7",
                           "theorem 7: that an error is the sum of terms whose size is proven, and "
                           "the bound their sum wherever it is in random points"});
  proof.by_hand.push_back(decides);
  append(proof.findings, prove_rules(lane, analysis, prove));
  if (constant) {
    append(proof.findings, prove_constant(lane, analysis, prove));
  } else {
    proof.by_hand.push_back({"9", "theorem 9: that bounds are rounded up in their few digits"});
    append(proof.findings, check_running_decision(lane, analysis));
  }
  return proof;
}

}  // namespace mixcmp::proof
