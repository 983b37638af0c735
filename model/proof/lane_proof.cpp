#include "model/proof/lane_proof.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "model/common/check.hpp"
#include "model/proof/absolute_proof.hpp"
#include "model/proof/rule_proof.hpp"

namespace mixcmp::model::proof {
namespace {

/// The first finding with this outcome that something depends on.
const Finding* first_with(const std::vector<Finding>& findings, Outcome outcome) {
  const auto found = std::find_if(findings.begin(), findings.end(), [&](const Finding& finding) {
    return !finding.optional && finding.outcome == outcome;
  });
  return found == findings.end() ? nullptr : &*found;
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
  if (machine_checked()) return "machine-checked";
  if (const Finding* finding = first_with(findings, Outcome::not_proven)) {
    return "refused: Gappa does not prove " + described(*finding);
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

LaneProof prove_lane(const Lane& lane, const Prove& prove, Effort effort) {
  if (std::holds_alternative<UlpDistanceDecision>(lane.decision)) {
    return prove_relative(lane, relative_claims(lane), prove, effort);
  }
  if (std::holds_alternative<AbsoluteBoundDecision>(lane.decision)) {
    return prove_absolute(lane, analysis_of(lane), prove);
  }
  LaneProof proof;
  proof.lane = lane.graph.arithmetic.format.name();
  proof.kind = "profiled";
  proof.findings = {{"the bound", Outcome::not_expressible, "it is measured, not derived"}};
  return proof;
}

}  // namespace mixcmp::model::proof
