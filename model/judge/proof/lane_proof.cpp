#include "model/judge/proof/lane_proof.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "model/base/common/check.hpp"
#include "model/judge/proof/absolute_proof.hpp"
#include "model/judge/proof/fixed_proof.hpp"
#include "model/judge/proof/hazard_proof.hpp"
#include "model/judge/proof/rule_proof.hpp"

namespace mixcmp::proof {
namespace {

/// The first finding with this outcome that something depends on.
const Finding* first_with(const std::vector<Finding>& findings, Outcome outcome) {
  const auto found = std::find_if(findings.begin(), findings.end(), [&](const Finding& finding) {
    return !finding.optional && finding.outcome == outcome;
  });
  return found == findings.end() ? nullptr : &*found;
}

void add_once(std::vector<ByHand>& list, ByHand step) {
  if (std::find(list.begin(), list.end(), step) == list.end()) list.push_back(std::move(step));
}

/// Appends the findings that are not listed yet; a node's range may come twice. Findings about
/// different long expressions may have the same text, because it is cut short, but they have
/// different scripts.
void add_new(std::vector<Finding>& findings, std::vector<Finding> more) {
  for (Finding& finding : more) {
    const bool known = std::any_of(findings.begin(), findings.end(), [&](const Finding& other) {
      return other.what == finding.what && other.outcome == finding.outcome &&
             other.files == finding.files;
    });
    if (!known) findings.push_back(std::move(finding));
  }
}

void add_hazards(LaneProof& proof, const error::Lane& lane, const Prove& prove) {
  add_new(proof.findings, prove_hazards(lane, prove));
  if (lane.checks.empty()) return;
  proof.by_hand.push_back(
      {"10", "theorem 10: that nothing is decided where an operand fails its check"});
}

std::string joined(const std::vector<ByHand>& steps) {
  std::string text;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const bool last = k + 1 == steps.size();
    text += (k == 0 ? "" : last ? " and " : ", ") + steps[k].theorem;
  }
  return text;
}

std::string described(const Finding& finding) {
  return finding.what + (finding.detail.empty() ? "" : " (" + finding.detail + ")");
}

}  // namespace

std::string_view to_string(Outcome outcome) {
  switch (outcome) {
    case Outcome::proven: return "proven";
    case Outcome::not_proven: return "not proven";
    case Outcome::out_of_time: return "out of time";
    case Outcome::not_expressible: return "not expressible";
    case Outcome::unchecked: return "unchecked";
  }
  MIXCMP_CHECK(false);
}

bool LaneProof::machine_checked() const {
  return std::all_of(findings.begin(), findings.end(), [](const Finding& finding) {
    return finding.optional || finding.outcome == Outcome::proven;
  });
}

bool LaneProof::refused() const {
  return first_with(findings, Outcome::not_proven) != nullptr;
}

std::string LaneProof::verdict() const {
  if (machine_checked()) {
    return by_hand.empty()
               ? "machine-checked"
               : fmt::format("machine-checked but for theorems {}, by hand", joined(by_hand));
  }
  if (const Finding* finding = first_with(findings, Outcome::not_proven)) {
    return "refused: no proof of " + described(*finding);
  }
  if (const Finding* finding = first_with(findings, Outcome::unchecked)) {
    return "not machine-checked: " + finding->detail;
  }
  for (const Outcome outcome : {Outcome::out_of_time, Outcome::not_expressible}) {
    if (const Finding* finding = first_with(findings, outcome)) {
      return fmt::format("not machine-checked: {}, {}", to_string(outcome), described(*finding));
    }
  }
  MIXCMP_CHECK(false);
}

ByHand scaling_by_hand() {
  return {
      "1 (exponents)",
      "theorem 1: that a non-exceptional result is the rounding with unbounded exponents, that "
      "rounding and its error scale with powers of two, and that products with these are exact"};
}

LaneProof prove_part(const error::Lane& lane, const Prove& prove, Effort effort) {
  LaneProof proof;
  if (lane.certified()) {
    proof = std::holds_alternative<error::UlpDistanceCriterion>(lane.criterion())
                ? prove_relative(lane, relative_claims(lane), prove, effort)
                : prove_absolute(lane, analysis_of(lane), prove, effort);
    add_hazards(proof, lane, prove);
    return proof;
  }
  proof.lane = lane.graph.arithmetic.format.name();
  proof.kind = "profiled";
  proof.findings = {
      {"the bound", Outcome::unchecked, "it is measured, not derived: there is nothing to prove"}};
  return proof;
}

LaneProof prove_lane(const error::Lane& lane, const Prove& prove, Effort effort) {
  if (lane.parts.size() == 1) return prove_part(lane, prove, effort);
  LaneProof whole;
  for (std::size_t k = 0; k < lane.parts.size(); ++k) {
    LaneProof part = prove_part(part_of(lane, k), prove, effort);
    whole.lane = part.lane;
    if (whole.kind.find(part.kind) == std::string::npos) {
      whole.kind += (whole.kind.empty() ? "" : ", ") + part.kind;
    }
    for (Finding& finding : part.findings) {
      finding.what = fmt::format("part {}: {}", k, finding.what);
      whole.findings.push_back(std::move(finding));
    }
    for (ByHand& step : part.by_hand) add_once(whole.by_hand, std::move(step));
  }
  whole.by_hand.push_back({"11", "theorem 11: from the parts' decisions to one verdict"});
  return whole;
}

LaneProof prove_lane(const fixed::FixedLane& lane, const Prove& prove, Effort) {
  return prove_fixed(lane, prove);
}

}  // namespace mixcmp::proof
