#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "generator/present/report/summary_report.hpp"
#include "model/comparison/expression/text.hpp"
#include "model/design/design.hpp"

namespace mixcmp::report {

using data::InputSource;
using data::Pairing;
using scene::DatapathSummary;
using scene::DataSummary;
using scene::EngineKind;
using scene::LaneGroupSpec;
using scene::LaneSavings;
using scene::OperandStore;
using scene::OperatorCount;
using scene::PlanNotes;
using scene::Possibility;
using scene::RangeQuestion;
using scene::ReducedSpec;
using scene::ReferenceGroupSpec;
using scene::Scene;
using scene::SideSummary;
using scene::Summary;
using scene::SystemSpec;

namespace {

constexpr std::size_t max_shown_operations = 3;

std::string shown(const Range& range) {
  return fmt::format("[{}, {}]", expression::to_text(range.low), expression::to_text(range.high));
}

std::string shown(const Arithmetic& arithmetic) {
  return fmt::format("{}, {}, {}{}", arithmetic.format.name(), to_string(arithmetic.rounding),
                     to_string(arithmetic.subnormals),
                     arithmetic.sums == Sums::fused ? ", sums fused" : "");
}

std::string formats_of(const OperatorCount& count) {
  if (count.operand_format == count.format) return count.format.name();
  return fmt::format("{} -> {}", count.operand_format.name(), count.format.name());
}

/// Collects sections of lines, each a name and a text.
class SectionList {
public:
  void section(std::string_view title) { sections_.push_back({std::string(title), {}}); }
  void line(std::string_view name, std::string_view text) {
    sections_.back().lines.emplace_back(name, text);
  }
  std::vector<SummaryLines> take() { return std::move(sections_); }

private:
  std::vector<SummaryLines> sections_;
};

std::string answer(const RangeQuestion& finding, bool with_operations) {
  std::string text(to_string(finding.answer));
  if (finding.answer == Possibility::ruled_out) return text;
  if (!finding.rangeless.empty()) {
    text += fmt::format(": no range for {}", fmt::join(finding.rangeless, ", "));
  }
  if (!with_operations) return text;
  const std::size_t count = std::min(max_shown_operations, finding.operations.size());
  const auto last = finding.operations.begin() + static_cast<long>(count);
  text += fmt::format("; in {}", fmt::join(finding.operations.begin(), last, "; "));
  if (count < finding.operations.size()) {
    text += fmt::format("; and {} more", finding.operations.size() - count);
  }
  return text;
}

void print_reduced(SectionList& page, const std::string& name, const ReducedSpec& reduced) {
  if (reduced.fixed_point) {
    page.line(name,
              fmt::format("{}, {}, multipliers {}", reduced.format_name(),
                          reduced.fixed_point->is_block ? "block floating point" : "fixed point",
                          to_string(reduced.multipliers)));
    return page.line("error bound", std::string(reduced.error_bound_word()));
  }
  page.line(name, fmt::format("{}, {}, {}, inputs {}, bound {}, multipliers {}",
                              reduced.format_name(), to_string(reduced.rounding),
                              to_string(reduced.subnormals), to_string(reduced.inputs),
                              reduced.bound_word(), to_string(reduced.multipliers)));
  if (!reduced.is_profiled) {
    page.line("error bound", fmt::format("{}, running ones of {} digits",
                                         reduced.error_bound_word(), reduced.bound_digits));
  }
}

std::string shown(const std::optional<int>& count) {
  return count ? fmt::format("{}", *count) : "auto";
}

/// "2", or "2, initiation interval 16" where a kind of them is folded.
std::string shown_references(const Scene& scene) {
  std::vector<std::string> intervals, targets;
  bool folded = false, own_target = false;
  for (const ReferenceGroupSpec& group : scene.reference_groups()) {
    intervals.push_back(shown(group.structure.initiation_interval));
    folded = folded || intervals.back() != "1";
    own_target = own_target || group.structure.target_mhz;
    targets.push_back(fmt::format("{}", group.structure.target_mhz
                                            ? double(*group.structure.target_mhz)
                                            : scene.system.target_mhz));
  }
  std::string text = shown(scene.reference_count());
  if (folded) text += fmt::format(", initiation interval {}", fmt::join(intervals, ", "));
  if (own_target) text += fmt::format(", placed for {} MHz", fmt::join(targets, ", "));
  return text;
}

std::string shown_lanes(const Scene& scene) {
  const std::string count = shown(scene.lane_count());
  const int group = scene.system.lanes_per_group;
  return group == 1 ? count : fmt::format("{}, in groups of {}", count, group);
}

void print_plan(SectionList& page, const PlanNotes& plan) {
  page.section(fmt::format("plan {}", plan.path.filename().string()));
  for (const auto& [key, value] : plan.values) page.line(key, value);
}

void print_parts(SectionList& page, const Scene& scene) {
  if (scene.parts.size() == 1) {
    page.line("f", scene.parts.front().f);
    page.line("g", scene.parts.front().g);
    return;
  }
  page.line("parts", fmt::format("{}, combined by \"{}\"", scene.parts.size(),
                                 to_string(scene.graph.combination())));
  for (std::size_t k = 0; k < scene.parts.size(); ++k) {
    page.line(fmt::format("f[{}]", k), scene.parts[k].f);
    page.line(fmt::format("g[{}]", k), scene.parts[k].g);
  }
}

void print_limits(SectionList& page, const Graph& graph) {
  constexpr std::size_t most_characters = 60;
  if (graph.limits().empty()) return;
  page.section("what lanes in fixed point leave undecided: values outside of");
  for (const auto& [node, limits] : graph.limits()) {
    page.line(expression::to_text(graph, node, most_characters), shown(limits));
  }
}

void print_understood(SectionList& page, const Scene& scene) {
  page.section(fmt::format("scene {}", scene.name));
  print_parts(page, scene);
  page.section("inputs");
  for (std::size_t k = 0; k < scene.ranges.size(); ++k) {
    std::string declared = scene.ranges[k] ? shown(*scene.ranges[k]) : "no range";
    const OperandFormat& format = scene.operand_formats[k];
    if (!(format == OperandFormat(scene.reference.format))) {
      declared = format.name() + ", " + declared;
    }
    if (scene.data_ranges[k]) declared += ", from the data";
    if (scene.grids[k])
      declared += fmt::format(", multiples of {}", expression::to_text(*scene.grids[k]));
    page.line(scene.graph.inputs()[k], declared);
  }
  print_limits(page, scene.graph);
  page.section("formats");
  page.line("reference", shown(scene.reference));
  if (const LaneFormat format = design::datapath_format(scene); format.fixed_point) {
    page.line("", "in hardware an exact lane in " + format.name());
  }
  const std::vector<LaneGroupSpec> groups = scene.lane_groups();
  const std::vector<std::string> labels = lane_group_labels(scene);
  for (std::size_t k = 0; k < groups.size(); ++k) {
    print_reduced(page, groups.size() == 1 ? "reduced" : labels[k], groups[k].reduced);
  }
  if (scene.second_tier) print_reduced(page, "second tier", *scene.second_tier);
  const SystemSpec& system = scene.system;
  page.section("system");
  page.line("device", fmt::format("{}, slack {}", system.device, system.slack));
  page.line("lanes", shown_lanes(scene));
  page.line("references", shown_references(scene));
  page.line("target_mhz", fmt::format("{}", system.target_mhz));
  page.line("order", to_string(system.order));
  page.line("operands", to_string(system.operands));
  if (system.operands == OperandStore::carried) {
    page.line("operand_memory", to_string(system.operand_memory));
    page.line("request_beats", shown(system.request_beats));
  }
  if (system.engine.kind == EngineKind::none) {
    page.line("input_registers", fmt::format("{}", system.input_registers));
  }
  page.line("tag_bits", fmt::format("{}", system.tag_bits));
  page.line("counter_bits", fmt::format("{}", system.counter_bits));
  page.line("counters", to_string(system.counters));
  if (system.engine.kind == EngineKind::none) return;
  if (system.engine.kind == EngineKind::arg_min) {
    return page.line("engine",
                     fmt::format("{}, a candidate more than lanes, row tags of {} bits",
                                 to_string(system.engine.kind), system.engine.row_tag_bits));
  }
  page.line(
      "engine",
      fmt::format("{}, {} items, reports {} as {} by {} stream{}, {} lanes in lock step",
                  to_string(system.engine.kind), system.engine.capacity,
                  fmt::join(reported_verdicts(system.engine), ", "),
                  to_string(system.engine.report_as), system.engine.report_streams,
                  system.engine.report_streams == 1 ? "" : "s", system.engine.lanes_per_group));
}

void print_data(SectionList& page, const DataSummary& data) {
  page.section("data");
  page.line("source", data.source);
  page.line("rows", fmt::format("{}", data.rows));
  if (has_second_table(data.pairing)) {
    const bool chooses = data.pairing == Pairing::arg_min;
    page.line("with", data.with);
    page.line(chooses ? "candidates" : "rows of it", fmt::format("{}", data.with_rows));
  }
  page.line("comparisons", fmt::format("{}", data.comparisons));
  page.line("out of range", data.out_of_range == 0
                                ? std::string("none")
                                : fmt::format("{} numbers, the first: {}", data.out_of_range,
                                              data.first_out_of_range));
  if (data.off_grid > 0) {
    page.line("off the grid",
              fmt::format("{} numbers, the first: {}", data.off_grid, data.first_off_grid));
  }
  page.section("columns of the data");
  for (const InputSource& input : data.inputs) page.line(input.input, "<- " + input.shown());
}

void print_savings(SectionList& page, const std::string& lane, const LaneSavings& savings) {
  const auto left_out = [&](const char* what, int count, int all, const char* units) {
    page.line(what, fmt::format("not built in {} of {} {}", count, all, units));
  };
  const auto& checked = savings.checked_inputs;
  page.section(lane == "lane" ? std::string("what a lane leaves out")
                              : fmt::format("what {} leave out", lane));
  page.line("operands checked",
            checked.empty() ? std::string("none") : fmt::format("{}", fmt::join(checked, ", ")));
  left_out("NaN, infinity", savings.without_special_operands, savings.operations, "operations");
  left_out("overflow", savings.without_overflow, savings.operations, "operations");
  left_out("underflow", savings.without_underflow, savings.operations, "operations");
  left_out("cancellation", savings.without_cancellation, savings.sums, "sums");
}

/// Prints whether the reference rounds, but only for a scene that declares a grid. Otherwise a
/// reader does not expect it to be exact.
void print_exactness(SectionList& page, const Summary& summary) {
  const auto& grids = summary.scene->grids;
  const bool any = std::any_of(grids.begin(), grids.end(), [](const auto& grid) { return !!grid; });
  if (!any) return;
  const bool broken =
      summary.data && (summary.data->off_grid > 0 || summary.data->out_of_range > 0);
  std::string text = "may round, first in " + summary.reference.first_rounding;
  if (summary.reference.exact) {
    text = broken ? "exact, but for data that break a range or a grid"
                  : "exact: its verdicts are the order of the real numbers";
  }
  page.line("reference", text);
}

/// Prints whether no fused sum has a larger error bound than the composed sum.
void print_fused_sums(SectionList& page, const Summary& summary) {
  if (summary.scene->reference.sums != Sums::fused) return;
  const std::string& loose = summary.reference.first_loose_sum;
  page.line("fused sums",
            loose.empty() ? std::string("no error bound is larger than with composed sums")
                          : fmt::format("below 2^{} a fused sum may err by more than a composed "
                                        "one; the first such sum is {}",
                                        summary.scene->reference.format.min_exponent(), loose));
}

}  // namespace

std::vector<SummaryLines> lines_of(const Summary& summary) {
  SectionList page;
  print_understood(page, *summary.scene);
  if (summary.scene->plan) print_plan(page, *summary.scene->plan);
  const char* const the_reference =
      summary.scene->has_fixed_operands() ? "the model of the " : "the ";
  for (const DatapathSummary& datapath : summary.datapaths) {
    const char* article = datapath.name == "lane"        ? "a "
                          : datapath.name == "reference" ? the_reference
                                                         : "";
    page.section(fmt::format("operators of {}{}", article, datapath.name));
    for (const OperatorCount& count : datapath.operators) {
      page.line(fmt::format("{} {}", count.count, to_string(count.operation)), formats_of(count));
    }
  }
  page.section("what the ranges rule out");
  for (const SideSummary& side : summary.sides) {
    page.line(side.name + " where finite", shown(side.value));
    page.line(side.negative.question, answer(side.negative, false));
    page.line(side.zero.question, answer(side.zero, false));
  }
  for (const DatapathSummary& datapath : summary.datapaths) {
    if (datapath.name == "reference" && summary.scene->has_fixed_operands()) continue;
    for (const RangeQuestion& event : datapath.events) {
      page.line(fmt::format("{} {}", datapath.name, event.question), answer(event, true));
    }
  }
  print_exactness(page, summary);
  print_fused_sums(page, summary);
  for (const DatapathSummary& datapath : summary.datapaths) {
    if (datapath.savings) print_savings(page, datapath.name, *datapath.savings);
  }
  if (summary.data) print_data(page, *summary.data);
  if (!summary.scene->notes.empty()) page.section("notes");
  for (const std::string& note : summary.scene->notes) page.line("-", note);
  return page.take();
}

std::string to_text(const Summary& summary) {
  std::string text;
  for (const SummaryLines& section : lines_of(summary)) {
    text += section.title + "\n";
    for (const auto& [name, line] : section.lines) text += fmt::format("  {:<18} {}\n", name, line);
  }
  return text;
}

}  // namespace mixcmp::report
