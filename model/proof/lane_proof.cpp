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

void add_once(std::vector<std::string>& list, std::string statement) {
  if (std::find(list.begin(), list.end(), statement) == list.end()) {
    list.push_back(std::move(statement));
  }
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

LaneProof prove_lane(const CombinedLane& lane, const Prove& prove, Effort effort) {
  if (lane.parts.size() == 1) return prove_lane(lane.parts.front(), prove, effort);
  LaneProof whole;
  for (std::size_t k = 0; k < lane.parts.size(); ++k) {
    LaneProof part = prove_lane(lane.parts[k], prove, effort);
    whole.lane = part.lane;
    if (whole.kind.find(part.kind) == std::string::npos) {
      whole.kind += (whole.kind.empty() ? "" : ", ") + part.kind;
    }
    for (Finding& finding : part.findings) {
      finding.what = fmt::format("part {}: {}", k, finding.what);
      whole.findings.push_back(std::move(finding));
    }
    for (std::string& statement : part.by_hand) add_once(whole.by_hand, std::move(statement));
  }
  whole.by_hand.emplace_back("theorem 11 of docs/error_bounds.md: from the parts to one verdict");
  return whole;
}

}  // namespace mixcmp::model::proof
