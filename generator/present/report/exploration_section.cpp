#include <fmt/format.h>

#include "generator/present/report/chart_of_picture.hpp"
#include "generator/present/report/plan_report.hpp"
#include "generator/present/report/report_sections.hpp"
#include "generator/present/report/units.hpp"

namespace mixcmp::report {
namespace {

using optimise::Exploration;
using optimise::Optimisation;
using optimise::PublishedFigures;
using optimise::ResultsAtClocks;

using Published = std::optional<PublishedFigures>;

void add_level(page::Chart& chart, const std::string& title, double low, double high) {
  chart.bands.push_back({title, page::ChartBand::Across::y, low, high});
}

page::Element area_figure(const Optimisation& areas, const Published& published) {
  page::Chart chart = chart_of(figure7(areas));
  if (published) {
    const double level = published->reference_luts;
    add_level(chart, "the paper's reference, LUT-register pairs", level, level);
  }
  return page::figure(draw(chart), "Figure 7: the area of lanes, before placement.");
}

page::Element clock_figure(const Optimisation& plans, const Published& published) {
  page::Chart chart = chart_of(figure8(plans));
  if (published) {
    add_level(chart, "the paper's lanes", published->lane_mhz_low, published->lane_mhz_high);
  }
  return page::figure(draw(chart), "Figure 8: the clock of lanes; " + describe_clocks(plans) + ".");
}

page::Element throughput_figure(const ResultsAtClocks& column, const Published& published) {
  Picture picture = figure9(column.example);
  std::erase_if(picture.curves, [](const Curve& curve) { return curve.style.right_axis; });
  page::Chart chart = chart_of(picture);
  if (published) {
    add_level(chart, "the paper, scenario I", published->worst_per_s / giga,
              published->best_per_s / giga);
    add_level(chart, "the paper, references alone", published->baseline_per_s / giga,
              published->baseline_per_s / giga);
  }
  return page::figure(draw(chart),
                      fmt::format("Figure 9: the best plan at each precision; {}.", column.title));
}

page::Element ratio_figure(const ResultsAtClocks& column) {
  return page::figure(
      draw(chart_of(figure3(column.example))),
      fmt::format("Figure 3: throughput over the ratio of lanes to references; {}.", column.title));
}

void add_device(page::Section& section, const Exploration& exploration,
                const std::vector<SoftwareThroughput>& software, bool beside_paper) {
  const Published published =
      beside_paper ? optimise::published(exploration.device.name) : std::nullopt;
  section.content.push_back(page::heading(
      fmt::format("{} ({})", exploration.device.vendor_name, exploration.device.name)));
  // The first column has the paper's clocks, where the paper has this device.
  const ResultsAtClocks& first = exploration.columns.front();
  const ResultsAtClocks& last = exploration.columns.back();
  section.content.push_back(
      page::gallery({ratio_figure(first), area_figure(first.example, published),
                     clock_figure(last.example, published), throughput_figure(first, published)}));
  section.content.push_back(page::heading("Table III: references"));
  section.content.push_back(page::draw(table3(exploration, published)));
  section.content.push_back(page::heading("Table IV: systems"));
  section.content.push_back(page::draw(table4(exploration, published, software)));
  for (const std::string& note : exploration.notes) {
    section.content.push_back(page::note("Note: " + note));
  }
}

}  // namespace

page::Section exploration_section(const std::vector<Exploration>& explorations,
                                  const std::vector<SoftwareThroughput>& software,
                                  bool beside_paper) {
  page::Section section{
      "paper", beside_paper ? "Beside the paper" : "All devices and data sets", {}};
  section.content.push_back(page::paragraph(fmt::format(
      "Plans for {} data sets: scenario I plans for each, scenario II once for the worst of all.",
      explorations.empty() ? 0 : explorations.front().data_sets.size())));
  if (beside_paper) {
    section.content.push_back(page::paragraph(
        "The paper prints its curves without their numbers. What it does print in numbers is drawn "
        "beside ours as grey lines and bands. Its figures 4 and 5 are under \"Errors and "
        "recomputations\", its figure 6 under \"The system\"."));
  }
  for (const Exploration& each : explorations) add_device(section, each, software, beside_paper);
  return section;
}

}  // namespace mixcmp::report
