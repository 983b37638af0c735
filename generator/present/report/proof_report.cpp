#include "generator/present/report/proof_report.hpp"

#include <fmt/core.h>

#include <nlohmann/json.hpp>

namespace mixcmp::report {

using proof::ByHand;
using proof::Finding;
using proof::LaneProof;

std::string to_text(const LaneProof& proof, const std::string& gappa) {
  std::string text = fmt::format("proof of the {} bound, {} ({})\n", proof.kind, proof.lane,
                                 gappa.empty() ? "no gappa" : "gappa " + gappa);
  for (const Finding& finding : proof.findings) {
    text += fmt::format("  {:<16} {}{}{}\n", to_string(finding.outcome), finding.what,
                        finding.detail.empty() ? "" : ": " + finding.detail,
                        finding.optional ? "; its operations one by one instead" : "");
  }
  for (const ByHand& step : proof.by_hand) {
    text += fmt::format("  {:<16} {}\n", "by hand", step.statement);
  }
  return text + "  " + proof.verdict() + "\n";
}

nlohmann::ordered_json to_json(const LaneProof& proof, const std::string& gappa) {
  nlohmann::ordered_json findings = nlohmann::ordered_json::array();
  for (const Finding& finding : proof.findings) {
    findings.push_back({{"what", finding.what},
                        {"outcome", to_string(finding.outcome)},
                        {"detail", finding.detail},
                        {"optional", finding.optional},
                        {"scripts", finding.files}});
  }
  nlohmann::ordered_json by_hand = nlohmann::ordered_json::array();
  for (const ByHand& step : proof.by_hand) {
    by_hand.push_back({{"theorem", step.theorem}, {"statement", step.statement}});
  }
  return {{"lane", proof.lane},
          {"bound", proof.kind},
          {"gappa", gappa.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(gappa)},
          {"machine_checked", proof.machine_checked()},
          {"refused", proof.refused()},
          {"verdict", proof.verdict()},
          {"findings", findings},
          {"by_hand", by_hand}};
}

}  // namespace mixcmp::report
