#include "generator/present/report/summary_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <numeric>

#include "model/comparison/expression/text.hpp"
#include "model/design/design.hpp"

namespace mixcmp::report {

using data::InputSource;
using scene::DatapathSummary;
using scene::DataSummary;
using scene::EngineKind;
using scene::EngineSpec;
using scene::LaneGroupSpec;
using scene::LaneSavings;
using scene::OperatorCount;
using scene::RangeQuestion;
using scene::ReducedSpec;
using scene::Scene;
using scene::SideSummary;
using scene::Summary;
using scene::SystemSpec;
using table::Fields;
using table::Json;
using table::Lines;
using table::within;

namespace {

constexpr int text_column = 21;
constexpr std::size_t max_shown_operations = 3;

std::string shown(const Range& range) {
  return fmt::format("[{}, {}]", expression::to_text(range.low), expression::to_text(range.high));
}

std::string shown(const Arithmetic& arithmetic) {
  return fmt::format("{}, {}, {}{}", arithmetic.format.name(), to_string(arithmetic.rounding),
                     to_string(arithmetic.subnormals),
                     arithmetic.sums == Sums::fused ? ", sums fused" : "");
}

std::string shown(const std::optional<int>& count) {
  return count ? fmt::format("{}", *count) : "auto";
}

Json json_of(const std::optional<Range>& range) {
  if (!range) return nullptr;
  return {expression::to_text(range->low), expression::to_text(range->high)};
}

Json json_of(const std::optional<int>& number) {
  return number ? Json(*number) : Json("auto");
}

std::string answer(const RangeQuestion& finding, bool with_operations) {
  std::string text(to_string(finding.answer));
  if (finding.answer == scene::Possibility::ruled_out) return text;
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

Json json_of(const RangeQuestion& finding) {
  return {{"answer", to_string(finding.answer)},
          {"operations", finding.operations},
          {"inputs_without_range", finding.rangeless}};
}

/// The format of a lane. `title`: of its line.
Fields<ReducedSpec> reduced_fields(const ReducedSpec& lane, const std::string& title) {
  std::string words = "{format}, {rounding}, {subnormals}, inputs {inputs}, bound {bound}";
  std::string bound = "{error_bound}, running ones of {bound_digits} digits";
  if (lane.fixed_point) {
    words = lane.fixed_point->is_block ? "{format}, block floating point" : "{format}, fixed point";
    bound = "{error_bound}";
  }
  const bool has_bound = lane.fixed_point || !lane.is_profiled;
  words += ", multipliers {multipliers}";
  return {{{"format", title}, &ReducedSpec::format_name, words},
          {{"rounding"}, &ReducedSpec::rounding},
          {{"subnormals"}, &ReducedSpec::subnormals},
          {{"bound"}, &ReducedSpec::bound_word},
          {{"error_bound", has_bound ? "error bound" : ""}, &ReducedSpec::error_bound_word, bound},
          {{"bound_digits"}, &ReducedSpec::bound_digits},
          {{"inputs"}, [](const ReducedSpec& r) { return to_string(r.inputs); }},
          {{"multipliers"}, &ReducedSpec::multipliers}};
}

Json json_of(const ReducedSpec& reduced) {
  return object_of(reduced_fields(reduced, ""), reduced);
}

Json json_of_groups(const Scene& scene) {
  Json groups = Json::array();
  for (const LaneGroupSpec& group : scene.lane_groups()) {
    groups.push_back(json_of(group.reduced));
    groups.back()["count"] = json_of(group.count);
  }
  return groups;
}

/// "2", or "2, initiation interval 16" where a kind of them is folded.
std::string shown_references(const Scene& scene) {
  std::vector<std::string> intervals, targets;
  bool folded = false, own_target = false;
  for (const scene::ReferenceGroupSpec& group : scene.reference_groups()) {
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

Json json_of(const EngineSpec& engine) {
  if (engine.kind == EngineKind::none) return nullptr;
  if (engine.kind == EngineKind::arg_min) {
    return {{"kind", to_string(engine.kind)}, {"tag_bits", engine.row_tag_bits}};
  }
  return {{"kind", to_string(engine.kind)},          {"capacity", engine.capacity},
          {"report", reported_verdicts(engine)},     {"report_as", to_string(engine.report_as)},
          {"report_streams", engine.report_streams}, {"lanes_per_group", engine.lanes_per_group}};
}

std::string shown(const EngineSpec& engine) {
  Json words = json_of(engine);
  if (engine.kind == EngineKind::arg_min) {
    return table::in_words("{kind}, a candidate more than lanes, row tags of {tag_bits} bits", {},
                           words);
  }
  words["verdicts"] = fmt::format("{}", fmt::join(reported_verdicts(engine), ", "));
  words["streams"] = engine.report_streams == 1 ? "stream" : "streams";
  return table::in_words(
      "{kind}, {capacity} items, reports {verdicts} as {report_as} by "
      "{report_streams} {streams}, {lanes_per_group} lanes in lock step",
      {}, words);
}

Fields<Scene> device_fields() {
  return within<Scene>(
      Fields<SystemSpec>{{{"device", "device"}, &SystemSpec::device, "{device}, slack {slack}"},
                         {{"slack"}, &SystemSpec::slack},
                         {{"lanes_per_group"}, &SystemSpec::lanes_per_group}},
      &Scene::system);
}

Fields<Scene> count_fields(const Scene& scene) {
  Json intervals = Json::array(), targets = Json::array();
  for (const scene::ReferenceGroupSpec& group : scene.reference_groups()) {
    intervals.push_back(json_of(group.structure.initiation_interval));
    targets.push_back(group.structure.target_mhz.value_or(scene.system.target_mhz));
  }
  const char* const lanes =
      scene.system.lanes_per_group == 1 ? "{lanes}" : "{lanes}, in groups of {lanes_per_group}";
  const Fields<Scene> counts = {
      {{"lanes", "lanes"}, [](const Scene& each) { return json_of(each.lane_count()); }, lanes},
      {{"references", "references"},
       [](const Scene& each) { return json_of(each.reference_count()); },
       shown_references}};
  return counts + table::constant<Scene>({"initiation_intervals"}, intervals) +
         table::constant<Scene>({"reference_targets_mhz"}, targets);
}

Fields<Scene> stream_fields(const SystemSpec& system) {
  const bool carried = system.operands == scene::OperandStore::carried;
  const bool has_engine = system.engine.kind != EngineKind::none;
  return within<Scene>(
      Fields<SystemSpec>{
          {{"target_mhz", "target_mhz"}, &SystemSpec::target_mhz},
          {{"order", "order"}, &SystemSpec::order},
          {{"operands", "operands"}, &SystemSpec::operands},
          {{"operand_memory", carried ? "operand_memory" : ""}, &SystemSpec::operand_memory},
          {{"request_beats", carried ? "request_beats" : ""},
           [](const SystemSpec& each) { return json_of(each.request_beats); }},
          {{"input_registers", has_engine ? "" : "input_registers"}, &SystemSpec::input_registers},
          {{"tag_bits", "tag_bits"}, &SystemSpec::tag_bits},
          {{"counter_bits", "counter_bits"}, &SystemSpec::counter_bits},
          {{"counters", "counters"}, &SystemSpec::counters},
          {{"engine", "engine"},
           [](const SystemSpec& each) { return json_of(each.engine); },
           [=](const SystemSpec& each) { return has_engine ? shown(each.engine) : ""; }}},
      &Scene::system);
}

Fields<Scene> system_fields(const Scene& scene) {
  return device_fields() + count_fields(scene) + stream_fields(scene.system);
}

/// The format of an input that has not the reference's.
std::string own_format(const Scene& scene, const OperandFormat& format) {
  const FloatFormat* const floating = format.floating();
  if (floating == nullptr) return format.name();
  const std::string_view standard = floating->standard_name();
  return fmt::format("{}{}, widened to {}", format.name(),
                     standard.empty() ? "" : fmt::format(" ({})", standard),
                     scene.reference.format.name());
}

std::string declaration(const Scene& scene, std::size_t input) {
  std::string text = scene.ranges[input] ? shown(*scene.ranges[input]) : "no range";
  const OperandFormat& format = scene.operand_formats[input];
  const bool is_own = !(format == OperandFormat(scene.reference.format));
  if (is_own) text = own_format(scene, format) + ", " + text;
  if (scene.data_ranges[input]) text += ", from the data";
  if (const auto& grid = scene.grids[input]) {
    text += fmt::format(", multiples of {}", expression::to_text(*grid));
  }
  return text;
}

/// An input, by its number.
Fields<std::size_t> input_fields(const Scene& scene) {
  return {{{"name"},
           [&](std::size_t k) { return scene.graph.inputs()[k]; },
           [&](std::size_t k) {
             return Lines{{scene.graph.inputs()[k], declaration(scene, k)}};
           }},
          {{"range"}, [&](std::size_t k) { return json_of(scene.ranges[k]); }},
          {{"format"}, [&](std::size_t k) { return scene.operand_formats[k].name(); }},
          {{"range_from_data"},
           [&](std::size_t k) { return static_cast<bool>(scene.data_ranges[k]); }}};
}

std::vector<std::size_t> inputs_of(const Scene& scene) {
  std::vector<std::size_t> inputs(scene.ranges.size());
  std::iota(inputs.begin(), inputs.end(), 0);
  return inputs;
}

std::string formats_of(const OperatorCount& count) {
  if (count.operand_format == count.format) return count.format.name();
  return fmt::format("{} -> {}", count.operand_format.name(), count.format.name());
}

Fields<OperatorCount> operator_fields() {
  return {{{"operation"},
           &OperatorCount::operation,
           [](const OperatorCount& count) {
             return Lines{{fmt::format("{} {}", count.count, to_string(count.operation)),
                           formats_of(count)}};
           }},
          {{"operand_format"}, [](const OperatorCount& c) { return c.operand_format.name(); }},
          {{"format"}, [](const OperatorCount& count) { return count.format.name(); }},
          {{"count"}, &OperatorCount::count}};
}

std::string checked_inputs(const LaneSavings& savings) {
  if (savings.checked_inputs.empty()) return "none";
  return fmt::format("{}", fmt::join(savings.checked_inputs, ", "));
}

Fields<LaneSavings> savings_fields() {
  return {{{"checked_inputs", "operands checked"}, &LaneSavings::checked_inputs, checked_inputs},
          {{"operations"}, &LaneSavings::operations},
          {{"without_special_operands", "NaN, infinity"},
           &LaneSavings::without_special_operands,
           "not built in {without_special_operands} of {operations} operations"},
          {{"without_overflow", "overflow"},
           &LaneSavings::without_overflow,
           "not built in {without_overflow} of {operations} operations"},
          {{"without_underflow", "underflow"},
           &LaneSavings::without_underflow,
           "not built in {without_underflow} of {operations} operations"},
          {{"sums"}, &LaneSavings::sums},
          {{"without_cancellation", "cancellation"},
           &LaneSavings::without_cancellation,
           "not built in {without_cancellation} of {sums} sums"}};
}

Json json_of(const DatapathSummary& datapath) {
  Json events = Json::object();
  for (const RangeQuestion& event : datapath.events) events[event.question] = json_of(event);
  return {{"format", datapath.arithmetic.format.name()},
          {"rounding", to_string(datapath.arithmetic.rounding)},
          {"subnormals", to_string(datapath.arithmetic.subnormals)},
          {"sums", to_string(datapath.arithmetic.sums)},
          {"operators", object_of(operator_fields(), datapath.operators)},
          {"events", events},
          {"leaves_out", object_of(savings_fields(), datapath.savings)}};
}

Fields<SideSummary> side_fields(const SideSummary& side) {
  return {{{"text"}, &SideSummary::text},
          {{"within", side.name + " where finite"},
           [](const SideSummary& s) { return json_of(s.value); },
           [](const SideSummary& s) { return shown(s.value); }},
          {{"negative", side.negative.question},
           [](const SideSummary& s) { return json_of(s.negative); },
           [](const SideSummary& s) { return answer(s.negative, false); }},
          {{"zero", side.zero.question},
           [](const SideSummary& s) { return json_of(s.zero); },
           [](const SideSummary& s) { return answer(s.zero, false); }}};
}

Fields<InputSource> source_fields() {
  return {{{"input"},
           &InputSource::input,
           [](const InputSource& input) {
             return Lines{{input.input, "<- " + input.shown()}};
           }},
          {{"column"}, [](const InputSource& input) { return input.column.number; }},
          {{"name"},
           [](const InputSource& input) {
             return input.column.name.empty() ? Json() : Json(input.column.name);
           }},
          {{"source"}, &InputSource::source},
          {{"item"}, &InputSource::item}};
}

/// Its columns have a section of their own in the text.
Fields<DataSummary> data_fields(const DataSummary& data) {
  const bool has_second = has_second_table(data.pairing);
  const char* const rows = data.pairing == data::Pairing::arg_min ? "candidates" : "rows of it";
  const char* const out_of_range =
      data.out_of_range == 0 ? "none" : "{out_of_range} numbers, the first: {first_out_of_range}";
  return {{{"source", "source"}, &DataSummary::source},
          {{"rows", "rows"}, &DataSummary::rows},
          {{"pairs"}, &DataSummary::pairing},
          {{"with", has_second ? "with" : ""}, &DataSummary::with},
          {{"with_rows", has_second ? rows : ""}, &DataSummary::with_rows},
          {{"comparisons", "comparisons"}, &DataSummary::comparisons},
          {{"out_of_range", "out of range"}, &DataSummary::out_of_range, out_of_range},
          {{"first_out_of_range"}, &DataSummary::first_out_of_range},
          {{"off_grid", data.off_grid > 0 ? "off the grid" : ""},
           &DataSummary::off_grid,
           "{off_grid} numbers, the first: {first_off_grid}"},
          {{"first_off_grid"}, &DataSummary::first_off_grid},
          {{"not_kept", data.lost.count > 0 ? "not kept" : ""},
           [](const DataSummary& each) { return each.lost.count; },
           "{not_kept} numbers, the first: {first_not_kept}"},
          {{"first_not_kept"}, [](const DataSummary& each) { return each.lost.first; }},
          {{"inputs"},
           [](const DataSummary& each) { return object_of(source_fields(), each.inputs); }}};
}

/// Says whether the reference rounds.
std::string exactness(const Summary& summary) {
  if (!summary.reference.exact) {
    return "may round, first in " + summary.reference.first_rounding;
  }
  const bool broken =
      summary.data && (summary.data->off_grid > 0 || summary.data->out_of_range > 0);
  return broken ? "exact, but for data that break a range or a grid"
                : "exact: every verdict is the order of the real numbers";
}

/// Says whether no fused sum has a larger error bound than the composed sum.
std::string fused_sums(const Summary& summary) {
  const std::string& loose = summary.reference.first_loose_sum;
  if (loose.empty()) return "no error bound is larger than with composed sums";
  return fmt::format(
      "below 2^{} a fused sum may err by more than a composed one; the first such sum is {}",
      summary.scene->reference.format.min_exponent(), loose);
}

/// Adds the lines of one thing to a section.
void add(SummaryLines& section, Lines lines) {
  std::move(lines.begin(), lines.end(), std::back_inserter(section.lines));
}

SummaryLines comparison_section(const Scene& scene) {
  SummaryLines section{"scene " + scene.name, {}};
  const bool several = scene.parts.size() > 1;
  if (several) {
    add(section, {{"parts", fmt::format("{}, combined by \"{}\"", scene.parts.size(),
                                        to_string(scene.graph.combination()))}});
  }
  for (std::size_t k = 0; k < scene.parts.size(); ++k) {
    const std::string index = several ? fmt::format("[{}]", k) : "";
    add(section, {{"f" + index, scene.parts[k].f}, {"g" + index, scene.parts[k].g}});
  }
  return section;
}

SummaryLines limits_section(const Graph& graph) {
  constexpr std::size_t most_characters = 60;
  SummaryLines section{"what lanes in fixed point leave undecided: values outside of", {}};
  for (const auto& [node, limits] : graph.limits()) {
    add(section, {{expression::to_text(graph, node, most_characters), shown(limits)}});
  }
  return section;
}

/// How far f - g, as a reference in fixed point computes it, is from the real difference.
std::string accuracy(const fixed::FixedLane& reference) {
  mpq_class most = 0;
  for (const fixed::FixedPart& part : reference.parts) {
    const Range& error = reference.nodes[static_cast<std::size_t>(part.difference)].error;
    most = std::max<mpq_class>(most, std::max<mpq_class>(abs(error.low), abs(error.high)));
  }
  if (most == 0) return reference.format.name();
  return fmt::format("{}, where f - g errs by less than 2^{}", reference.format.name(),
                     floor_log2(most) + 1);
}

/// The arithmetic of references.
Lines reference_lines(const Scene& scene) {
  if (!scene.has_fixed_references()) return {{"reference", shown(scene.reference)}};
  const auto datapath = design::reference_datapath(scene);
  if (scene.reference_fixed_point) {
    return {{"reference", datapath.ok() ? accuracy(std::get<fixed::FixedLane>(*datapath))
                                        : scene.reference_fixed_point->name()}};
  }
  Lines lines = {{"reference", shown(scene.reference)}};
  if (datapath.ok()) {
    lines.push_back({"", "in hardware an exact lane in " + design::format_name(*datapath)});
  }
  return lines;
}

SummaryLines formats_section(const Scene& scene) {
  SummaryLines section{"formats", reference_lines(scene)};
  const auto add_lane = [&](const ReducedSpec& lane, const std::string& title) {
    add(section, lines_of(reduced_fields(lane, title), lane));
  };
  const std::vector<LaneGroupSpec> groups = scene.lane_groups();
  const std::vector<std::string> labels = lane_group_labels(scene);
  for (std::size_t k = 0; k < groups.size(); ++k) {
    add_lane(groups[k].reduced, groups.size() == 1 ? "reduced" : labels[k]);
  }
  if (scene.second_tier) add_lane(*scene.second_tier, "second tier");
  return section;
}

SummaryLines operators_section(const Scene& scene, const DatapathSummary& datapath) {
  std::string article;
  if (datapath.name == "lane") article = "a ";
  if (datapath.name == "reference") {
    article = scene.has_fixed_references() ? "the model of the " : "the ";
  }
  return {"operators of " + article + datapath.name,
          lines_of(operator_fields(), datapath.operators)};
}

SummaryLines ranges_section(const Summary& summary) {
  SummaryLines section{"what the ranges rule out", {}};
  for (const SideSummary& side : summary.sides) add(section, lines_of(side_fields(side), side));
  for (const DatapathSummary& datapath : summary.datapaths) {
    if (datapath.name == "reference" && summary.scene->has_fixed_references()) continue;
    for (const RangeQuestion& event : datapath.events) {
      add(section, {{fmt::format("{} {}", datapath.name, event.question), answer(event, true)}});
    }
  }
  const auto& grids = summary.scene->grids;
  const bool any_grid =
      std::any_of(grids.begin(), grids.end(), [](const auto& grid) { return grid.has_value(); });
  // Without a grid or fused sums a reader does not expect the reference to be exact.
  const bool is_fused = summary.scene->reference.sums == Sums::fused;
  const bool may_round = !summary.scene->reference_fixed_point && (any_grid || is_fused);
  if (may_round || summary.reference.exact) {
    add(section, {{"reference", exactness(summary)}});
  }
  if (is_fused) {
    add(section, {{"fused sums", fused_sums(summary)}});
  }
  return section;
}

}  // namespace

std::vector<SummaryLines> lines_of(const Summary& summary) {
  const Scene& scene = *summary.scene;
  std::vector<SummaryLines> all = {comparison_section(scene),
                                   {"inputs", lines_of(input_fields(scene), inputs_of(scene))}};
  if (!scene.graph.limits().empty()) all.push_back(limits_section(scene.graph));
  all.push_back(formats_section(scene));
  all.push_back({"system", lines_of(system_fields(scene), scene)});
  if (scene.plan) {
    SummaryLines& plan =
        all.emplace_back(SummaryLines{"plan " + scene.plan->path.filename().string(), {}});
    for (const auto& [key, value] : scene.plan->values) add(plan, {{key, value}});
  }
  for (const DatapathSummary& datapath : summary.datapaths) {
    all.push_back(operators_section(scene, datapath));
  }
  all.push_back(ranges_section(summary));
  for (const DatapathSummary& datapath : summary.datapaths) {
    if (!datapath.savings) continue;
    all.push_back({datapath.name == "lane" ? "what a lane leaves out"
                                           : "what " + datapath.name + " leave out",
                   lines_of(savings_fields(), datapath.savings)});
  }
  if (const auto& data = summary.data) {
    all.push_back({"data", lines_of(data_fields(*data), *data)});
    all.push_back({"columns of the data", lines_of(source_fields(), data->inputs)});
  }
  if (scene.notes.empty()) return all;
  SummaryLines& notes = all.emplace_back(SummaryLines{"notes", {}});
  for (const std::string& note : scene.notes) add(notes, {{"-", note}});
  return all;
}

std::string to_text(const Summary& summary) {
  std::string text;
  for (const SummaryLines& section : lines_of(summary)) {
    text += section.title + "\n" + to_text(section.lines, text_column);
  }
  return text;
}

nlohmann::json to_json(const Summary& summary) {
  const Scene& scene = *summary.scene;
  Json json = {{"name", scene.name},
               {"system", object_of(system_fields(scene), scene)},
               {"lane_groups", json_of_groups(scene)},
               {"notes", scene.notes}};
  if (scene.second_tier) json["second_tier"] = json_of(*scene.second_tier);
  json["inputs"] = object_of(input_fields(scene), inputs_of(scene));
  constexpr std::size_t most_characters = 1000;
  for (const auto& [node, limits] : scene.graph.limits()) {
    json["limits"].push_back({{"value", expression::to_text(scene.graph, node, most_characters)},
                              {"range", json_of(limits)}});
  }
  if (scene.parts.size() > 1) json["combine"] = to_string(scene.graph.combination());
  for (const SideSummary& side : summary.sides) {
    json[side.name] = object_of(side_fields(side), side);
  }
  for (const DatapathSummary& datapath : summary.datapaths) {
    json["datapaths"][datapath.name] = json_of(datapath);
  }
  json["reference_exact"] = summary.reference.exact;
  if (!summary.reference.first_rounding.empty())
    json["first_rounding"] = summary.reference.first_rounding;
  const std::string& loose = summary.reference.first_loose_sum;
  if (!loose.empty()) json["first_loose_sum"] = loose;
  if (scene.plan) {
    for (const auto& [key, value] : scene.plan->values) json["plan"][key] = value;
  }
  json["data"] = summary.data ? object_of(data_fields(*summary.data), *summary.data) : Json();
  return json;
}

}  // namespace mixcmp::report
