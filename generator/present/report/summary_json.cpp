#include <nlohmann/json.hpp>

#include "generator/present/report/summary_report.hpp"
#include "model/comparison/expression/text.hpp"

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
using scene::ReferenceGroupSpec;
using scene::Scene;
using scene::SideSummary;
using scene::Summary;
using scene::SystemSpec;

namespace {

nlohmann::json json_of(const std::optional<Range>& range) {
  if (!range) return nullptr;
  return {expression::to_text(range->low), expression::to_text(range->high)};
}

nlohmann::json json_of(const RangeQuestion& finding) {
  return {{"answer", to_string(finding.answer)},
          {"operations", finding.operations},
          {"inputs_without_range", finding.rangeless}};
}

nlohmann::json json_of(const LaneSavings& savings) {
  return {{"checked_inputs", savings.checked_inputs},
          {"operations", savings.operations},
          {"without_special_operands", savings.without_special_operands},
          {"without_overflow", savings.without_overflow},
          {"without_underflow", savings.without_underflow},
          {"sums", savings.sums},
          {"without_cancellation", savings.without_cancellation}};
}

nlohmann::json json_of(const DatapathSummary& datapath) {
  nlohmann::json operators = nlohmann::json::array();
  for (const OperatorCount& count : datapath.operators) {
    operators.push_back({{"operation", to_string(count.operation)},
                         {"operand_format", count.operand_format.name()},
                         {"format", count.format.name()},
                         {"count", count.count}});
  }
  nlohmann::json events = nlohmann::json::object();
  for (const RangeQuestion& finding : datapath.events) events[finding.question] = json_of(finding);
  return {{"format", datapath.arithmetic.format.name()},
          {"rounding", to_string(datapath.arithmetic.rounding)},
          {"subnormals", to_string(datapath.arithmetic.subnormals)},
          {"sums", to_string(datapath.arithmetic.sums)},
          {"operators", operators},
          {"events", events},
          {"leaves_out", datapath.savings ? json_of(*datapath.savings) : nlohmann::json()}};
}

nlohmann::json json_of(const std::optional<int>& number) {
  if (!number) return "auto";
  return *number;
}

nlohmann::json json_of(const EngineSpec& engine) {
  if (engine.kind == EngineKind::none) return nullptr;
  if (engine.kind == EngineKind::arg_min) {
    return {{"kind", to_string(engine.kind)}, {"tag_bits", engine.row_tag_bits}};
  }
  return {{"kind", to_string(engine.kind)},          {"capacity", engine.capacity},
          {"report", reported_verdicts(engine)},     {"report_as", to_string(engine.report_as)},
          {"report_streams", engine.report_streams}, {"lanes_per_group", engine.lanes_per_group}};
}

nlohmann::json json_of_system(const Scene& scene) {
  const SystemSpec& system = scene.system;
  nlohmann::json intervals = nlohmann::json::array(), targets = nlohmann::json::array();
  for (const ReferenceGroupSpec& group : scene.reference_groups()) {
    intervals.push_back(json_of(group.structure.initiation_interval));
    targets.push_back(group.structure.target_mhz.value_or(system.target_mhz));
  }
  return {{"device", system.device},
          {"lanes", json_of(scene.lane_count())},
          {"lanes_per_group", system.lanes_per_group},
          {"input_registers", system.input_registers},
          {"references", json_of(scene.reference_count())},
          {"initiation_intervals", intervals},
          {"reference_targets_mhz", targets},
          {"slack", system.slack},
          {"target_mhz", system.target_mhz},
          {"order", to_string(system.order)},
          {"operands", to_string(system.operands)},
          {"operand_memory", to_string(system.operand_memory)},
          {"request_beats", json_of(system.request_beats)},
          {"tag_bits", system.tag_bits},
          {"counter_bits", system.counter_bits},
          {"counters", to_string(system.counters)},
          {"engine", json_of(system.engine)}};
}

nlohmann::json json_of(const InputSource& input) {
  const std::string& name = input.column.name;
  return {{"input", input.input},
          {"column", input.column.number},
          {"name", name.empty() ? nlohmann::json() : nlohmann::json(name)},
          {"source", input.source},
          {"item", input.item}};
}

nlohmann::json json_of(const DataSummary& data) {
  nlohmann::json inputs = nlohmann::json::array();
  for (const InputSource& input : data.inputs) inputs.push_back(json_of(input));
  return {{"source", data.source},
          {"rows", data.rows},
          {"pairs", to_string(data.pairing)},
          {"with", data.with},
          {"with_rows", data.with_rows},
          {"comparisons", data.comparisons},
          {"out_of_range", data.out_of_range},
          {"first_out_of_range", data.first_out_of_range},
          {"off_grid", data.off_grid},
          {"first_off_grid", data.first_off_grid},
          {"lost", data.lost.count},
          {"first_lost", data.lost.first},
          {"inputs", inputs}};
}

nlohmann::json json_of(const ReducedSpec& reduced) {
  return {{"format", reduced.format_name()},
          {"rounding", to_string(reduced.rounding)},
          {"subnormals", to_string(reduced.subnormals)},
          {"bound", reduced.bound_word()},
          {"error_bound", reduced.error_bound_word()},
          {"bound_digits", reduced.bound_digits},
          {"inputs", to_string(reduced.inputs)},
          {"multipliers", to_string(reduced.multipliers)}};
}

nlohmann::json json_of_groups(const Scene& scene) {
  nlohmann::json groups = nlohmann::json::array();
  for (const LaneGroupSpec& group : scene.lane_groups()) {
    groups.push_back(json_of(group.reduced));
    groups.back()["count"] = json_of(group.count);
  }
  return groups;
}

}  // namespace

nlohmann::json to_json(const Summary& summary) {
  const Scene& scene = *summary.scene;
  nlohmann::json json = {{"name", scene.name},
                         {"system", json_of_system(scene)},
                         {"lane_groups", json_of_groups(scene)},
                         {"notes", scene.notes}};
  if (scene.second_tier) json["second_tier"] = json_of(*scene.second_tier);
  for (std::size_t k = 0; k < scene.ranges.size(); ++k) {
    json["inputs"].push_back({{"name", scene.graph.inputs()[k]},
                              {"range", json_of(scene.ranges[k])},
                              {"format", scene.operand_formats[k].name()},
                              {"range_from_data", static_cast<bool>(scene.data_ranges[k])}});
  }
  constexpr std::size_t most_characters = 1000;
  for (const auto& [node, limits] : scene.graph.limits()) {
    json["limits"].push_back({{"value", expression::to_text(scene.graph, node, most_characters)},
                              {"range", json_of(limits)}});
  }
  if (scene.parts.size() > 1) json["combine"] = to_string(scene.graph.combination());
  for (const SideSummary& side : summary.sides) {
    json[side.name] = {{"text", side.text},
                       {"within", json_of(side.value)},
                       {"negative", json_of(side.negative)},
                       {"zero", json_of(side.zero)}};
  }
  for (const DatapathSummary& datapath : summary.datapaths) {
    json["datapaths"][datapath.name] = json_of(datapath);
  }
  json["reference_exact"] = summary.reference.exact;
  if (!summary.reference.exact) json["first_rounding"] = summary.reference.first_rounding;
  const std::string& loose = summary.reference.first_loose_sum;
  if (!loose.empty()) json["first_loose_sum"] = loose;
  if (scene.plan) {
    for (const auto& [key, value] : scene.plan->values) json["plan"][key] = value;
  }
  json["data"] = summary.data ? json_of(*summary.data) : nlohmann::json();
  return json;
}

}  // namespace mixcmp::report
