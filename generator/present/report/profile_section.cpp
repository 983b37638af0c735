#include <fmt/format.h>

#include "generator/present/report/chart_of_picture.hpp"
#include "generator/present/report/report_sections.hpp"

namespace mixcmp::report {
namespace {

using profile::RateProfile;
using profile::SchemeCounts;
using profile::SchemeKind;
using profile::SchemeProfile;

/// Section V of the paper: "undetectable when there are more than 31 mantissa bits".
constexpr int published_last_recomputation = 31;

/// The report with only the errors of those inputs whose rates were counted.
ProfileReport with_counted_inputs(const ProfileReport& report) {
  ProfileReport counted = report;
  std::erase_if(counted.errors, [&](const profile::ErrorProfile& errors) {
    for (const RateProfile& rates : report.rates) {
      if (rates.inputs == errors.inputs) return false;
    }
    return true;
  });
  return counted;
}

/// The wrong verdicts of each scheme, at all precisions together.
table::Table wrong_verdicts(const RateProfile& rates) {
  table::Table table =
      table::text_table({"scheme", "certified", "wrong verdicts of a lane", "at the worst L"});
  for (const SchemeProfile& scheme : rates.schemes) {
    if (!scheme.exists()) continue;
    std::uint64_t sum = 0, most = 0;
    int worst = 0;
    for (std::size_t k = 0; k < scheme.counts.size(); ++k) {
      const std::uint64_t wrong = scheme.kind == SchemeKind::lanes_alone
                                      ? scheme.counts[k].wrong
                                      : scheme.counts[k].wrong_by_lane;
      sum += wrong;
      if (wrong > most) worst = rates.first_precision + static_cast<int>(k);
      most = std::max(most, wrong);
    }
    table.rows.push_back({{scheme.name, scheme.kind == SchemeKind::certified ? "yes" : "no", sum,
                           most == 0 ? "-" : fmt::format("{} at L = {}", most, worst)}});
  }
  return table;
}

void add_rates(page::Section& section, const RateProfile& rates) {
  section.content.push_back(
      page::heading(fmt::format("Wrong verdicts, {}", describe(rates.inputs))));
  section.content.push_back(page::paragraph(fmt::format(
      "Held against exact arithmetic on all {} comparisons, at all precisions together; \"lanes "
      "alone\" compare f and g as rounded, without any bound. The reference by itself is wrong on "
      "{}.",
      rates.comparisons, rates.reference_wrong)));
  section.content.push_back(page::draw(wrong_verdicts(rates)));
  for (const SchemeProfile& scheme : rates.schemes) {
    if (scheme.reason.empty()) continue;
    section.content.push_back(page::note(fmt::format("{}: {}", scheme.name, scheme.reason)));
  }
  section.content.push_back(
      page::details(fmt::format("Undecided comparisons of {}, at every L", rates.comparisons),
                    page::draw(undecided_counts(rates))));
}

}  // namespace

page::Section profile_section(const IfThere<ProfileReport>& profile, bool beside_paper) {
  page::Section section{"profile", "Errors and recomputations", {}};
  if (const auto* missing = std::get_if<Missing>(&profile)) {
    section.content.push_back(page::missing(missing->why, missing->command));
    return section;
  }
  const ProfileReport report = with_counted_inputs(std::get<ProfileReport>(profile));
  section.content.push_back(
      page::paragraph(fmt::format("Counted on the scene's {} comparisons, with a reference in {}.",
                                  report.comparisons, report.reference.name())));
  page::Chart rates = chart_of(figure5(report));
  if (beside_paper) {
    rates.bands.push_back({.title = "the paper: none beyond",
                           .axis = page::ChartBand::Across::x,
                           .low = published_last_recomputation,
                           .high = published_last_recomputation});
  }
  section.content.push_back(page::gallery(
      {page::figure(draw(chart_of(figure4(report))),
                    "Largest relative error of f and g that was measured, and the bounds that are "
                    "proven for every input (dashed)."),
       page::figure(draw(rates),
                    "Share of comparisons that lanes of each kind leave to a reference.")}));
  for (const RateProfile& each : report.rates) add_rates(section, each);
  return section;
}

}  // namespace mixcmp::report
