#include "generator/present/report/proof_report.hpp"

#include <fmt/core.h>

namespace mixcmp::report {

using proof::ByHand;
using proof::Finding;
using proof::LaneProof;

table::Table findings_of(const LaneProof& proof) {
  table::Table table = table::text_table({"outcome", "statement"});
  for (const Finding& finding : proof.findings) {
    table.rows.push_back(
        {{to_string(finding.outcome),
          fmt::format("{}{}{}", finding.what, finding.detail.empty() ? "" : ": " + finding.detail,
                      finding.optional ? "; its operations one by one instead" : "")}});
  }
  for (const ByHand& step : proof.by_hand) {
    table.rows.push_back({{"by hand", step.statement}});
  }
  return table;
}

std::string to_text(const LaneProof& proof, const std::string& gappa) {
  std::string text = fmt::format("proof of the {} bound, {} ({})\n", proof.kind, proof.lane,
                                 gappa.empty() ? "no gappa" : "gappa " + gappa);
  const table::Table findings = findings_of(proof);
  for (const table::Row& row : findings.rows) {
    const std::vector<std::string> cells = shown_cells(findings, row);
    text += fmt::format("  {:<16} {}\n", cells[0], cells[1]);
  }
  return text + "  " + proof.verdict() + "\n";
}

table::Json to_json(const LaneProof& proof, const std::string& gappa) {
  table::Table findings = table::named_table({"what", "outcome", "detail", "optional", "scripts"});
  for (const Finding& finding : proof.findings) {
    findings.rows.push_back({{finding.what, to_string(finding.outcome), finding.detail,
                              finding.optional, finding.files}});
  }
  table::Table by_hand = table::named_table({"theorem", "statement"});
  for (const ByHand& step : proof.by_hand) by_hand.rows.push_back({{step.theorem, step.statement}});
  return {{"lane", proof.lane},
          {"bound", proof.kind},
          {"gappa", gappa.empty() ? table::Json() : table::Json(gappa)},
          {"machine_checked", proof.machine_checked()},
          {"refused", proof.refused()},
          {"verdict", proof.verdict()},
          {"findings", to_json(findings)},
          {"by_hand", to_json(by_hand)}};
}

}  // namespace mixcmp::report
