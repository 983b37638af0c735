#include <fmt/format.h>

#include "generator/present/report/proof_report.hpp"
#include "generator/present/report/report_sections.hpp"

namespace mixcmp::report {
namespace {

std::size_t proven_by_machine(const proof::LaneProof& proof) {
  std::size_t count = 0;
  for (const proof::Finding& finding : proof.findings) {
    if (finding.outcome == proof::Outcome::proven) ++count;
  }
  return count;
}

void add_lanes(page::Section& section, const ProvenLanes& lanes) {
  section.content.push_back(page::heading("Lanes in " + lanes.name));
  table::Lines lines = {{"decision", lanes.decision}};
  if (!lanes.certified) {
    lines.push_back({"proof", "none: the bound is measured, and a verdict of a lane can be wrong"});
    return section.content.push_back(page::definitions(lines));
  }
  lines.push_back({"lane", lanes.proof.lane});
  lines.push_back({"bound", lanes.proof.kind});
  lines.push_back({"proof", lanes.proof.verdict()});
  lines.push_back({"checked by", lanes.gappa.empty() ? "nobody: Gappa is not installed"
                                                     : "Gappa " + lanes.gappa});
  section.content.push_back(page::definitions(lines));
  section.content.push_back(
      page::details(fmt::format("{} statements proven by machine, {} by hand",
                                proven_by_machine(lanes.proof), lanes.proof.by_hand.size()),
                    page::draw(findings_of(lanes.proof))));
}

}  // namespace

page::Section proof_section(const IfThere<std::vector<ProvenLanes>>& lanes) {
  page::Section section{"proof", "Error bound and proof", {}};
  if (const auto* missing = std::get_if<Missing>(&lanes)) {
    section.content.push_back(page::missing(missing->why, missing->command));
    return section;
  }
  section.content.push_back(
      page::paragraph("A certified lane decides a comparison only where its error bound leaves no "
                      "doubt of the sign of f - g. All others go to a reference or, in a system "
                      "without references, stay undecided. So a verdict of a certified lane is the "
                      "order of the real numbers f and g, and is never wrong."));
  for (const ProvenLanes& each : std::get<std::vector<ProvenLanes>>(lanes)) {
    add_lanes(section, each);
  }
  return section;
}

}  // namespace mixcmp::report
