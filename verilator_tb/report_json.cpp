#include <cstdint>
#include <nlohmann/json.hpp>

#include "verilator_tb/report.hpp"

namespace mixcmp::verilator_tb {
namespace {

using Json = nlohmann::ordered_json;

double ratio_of(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

Json to_json(const TruthCount& truth) {
  return {{"checked", truth.checked},
          {"wrong_by_lane", truth.wrong_by_lane},
          {"wrong_by_reference", truth.wrong_by_reference},
          {"reference_alone_checked", truth.reference_alone_checked},
          {"reference_alone_wrong", truth.reference_alone_wrong},
          {"not_checked",
           {{"total", truth.not_checked()},
            {"decided_by_lane", truth.decided_by_lane},
            {"undefined", truth.undefined},
            {"undetermined", truth.undetermined},
            {"undecided", truth.undecided}}}};
}

Json to_json(const data::InputSource& input) {
  const std::string& name = input.column.name;
  return {{"input", input.input},
          {"column", input.column.number},
          {"name", name.empty() ? Json() : Json(name)},
          {"source", input.source},
          {"item", input.item}};
}

Json to_json(const Mismatch& m) {
  Json operands = Json::array();
  for (const Mismatch::Operand& operand : m.operands) {
    operands.push_back({{"input", operand.input}, {"hex", operand.hex}, {"value", operand.value}});
  }
  return {
      {"index", m.index},  {"items", m.items}, {"operands", operands}, {"expected", m.expected},
      {"got", m.got},      {"lane", m.lane},   {"cycle", m.cycle},     {"simulation", m.simulation},
      {"repeat", m.repeat}};
}

Json to_json(const ProtocolViolation& violation) {
  return {{"fault", violation.fault},
          {"lane", violation.lane},
          {"cycle", violation.cycle},
          {"simulation", violation.simulation},
          {"details", violation.details}};
}

Json to_json(const LeastCounterexample& least) {
  Json json = {{"comparisons", least.comparisons}};
  if (least.mismatch) json["mismatch"] = to_json(*least.mismatch);
  if (least.violation) json["violation"] = to_json(*least.violation);
  json["waves"] = least.waves;
  return json;
}

Json to_json(const Latency& latency) {
  return {{"count", latency.count},
          {"minimum_cycles", latency.minimum_cycles},
          {"maximum_cycles", latency.maximum_cycles},
          {"total_cycles", latency.total_cycles},
          {"mean_cycles", latency.mean_cycles()}};
}

Json to_json(const GroupReport& group, bool with_truth) {
  Json json = {{"name", group.name},
               {"lanes", group.lanes},
               {"certified", group.certified},
               {"comparisons", group.comparisons},
               {"undecided", group.undecided},
               {"recomputations", group.recomputations},
               {"recomputation_rate", ratio_of(group.recomputations, group.comparisons)},
               {"decided_latency", to_json(group.latencies.decided)},
               {"recomputed_latency", to_json(group.latencies.recomputed)},
               {"undecided_latency", to_json(group.latencies.undecided)},
               {"mismatches", group.mismatches}};
  if (with_truth) json["wrong_by_lane"] = group.wrong_by_lane;
  return json;
}

void add_expectation(Json& engine, const std::optional<double>& cycles) {
  if (cycles) engine["expected_cycles"] = *cycles;
}

/// Adds the figures that only a system with an engine has.
void add_engines(Json& json, const VerifyReport& r) {
  if (r.engine) {
    json["engine"] = {{"top", r.engine->top},
                      {"items", r.engine->items},
                      {"item_bytes", r.engine->item_bytes},
                      {"pair_bytes", r.engine->pair_bytes},
                      {"reported", r.engine->reported},
                      {"cycles_per_pair", ratio_of(r.cycles, r.comparisons)},
                      {"stalled_cycles", r.engine->stalled_cycles},
                      {"item_bytes_per_pair", r.item_bytes_per_pair()},
                      {"sets", r.engine->sets}};
    add_expectation(json["engine"], r.engine->expected_cycles);
  }
  if (r.arg_min) {
    const ArgMinFigures& engine = *r.arg_min;
    json["arg_min"] = {{"top", engine.top},
                       {"candidates", engine.candidates},
                       {"rows", engine.rows},
                       {"rows_per_cycle", ratio_of(engine.rows, r.cycles)},
                       {"rows_unlike_reference", engine.rows_unlike_reference},
                       {"row_latency_cycles", engine.latency.mean_cycles()},
                       {"loading_cycles", engine.loading_cycles},
                       {"stalled_cycles", engine.stalled_cycles},
                       {"loads", engine.loads}};
    add_expectation(json["arg_min"], engine.expected_cycles);
  }
}

TruthCount truth_in(const Json& json) {
  const Json& rest = json.at("not_checked");
  return {.checked = json.at("checked"),
          .wrong_by_lane = json.at("wrong_by_lane"),
          .wrong_by_reference = json.at("wrong_by_reference"),
          .reference_alone_checked = json.at("reference_alone_checked"),
          .reference_alone_wrong = json.at("reference_alone_wrong"),
          .undefined = rest.at("undefined"),
          .undetermined = rest.at("undetermined"),
          .undecided = rest.at("undecided"),
          .decided_by_lane = rest.at("decided_by_lane")};
}

Latency latency_in(const Json& json) {
  return {.count = json.at("count"),
          .minimum_cycles = json.at("minimum_cycles"),
          .maximum_cycles = json.at("maximum_cycles"),
          .total_cycles = json.at("total_cycles")};
}

Latencies latencies_in(const Json& json) {
  return {.decided = latency_in(json.at("decided_latency")),
          .recomputed = latency_in(json.at("recomputed_latency")),
          .undecided = latency_in(json.at("undecided_latency"))};
}

GroupReport group_in(const Json& json) {
  return {.name = json.at("name"),
          .lanes = json.at("lanes"),
          .certified = json.at("certified"),
          .comparisons = json.at("comparisons"),
          .recomputations = json.at("recomputations"),
          .undecided = json.at("undecided"),
          .mismatches = json.at("mismatches"),
          .wrong_by_lane = json.value("wrong_by_lane", std::uint64_t{0}),
          .latencies = latencies_in(json)};
}

data::InputSource input_in(const Json& json) {
  const Json& name = json.at("name");
  return {.input = json.at("input"),
          .column = {.number = json.at("column"), .name = name.is_null() ? "" : name},
          .source = json.at("source"),
          .item = json.at("item")};
}

Mismatch mismatch_in(const Json& json) {
  Mismatch mismatch{.index = json.at("index"),
                    .items = json.at("items"),
                    .operands = {},
                    .expected = json.at("expected"),
                    .got = json.at("got"),
                    .lane = json.at("lane"),
                    .cycle = json.at("cycle"),
                    .simulation = json.at("simulation"),
                    .repeat = json.at("repeat")};
  for (const Json& operand : json.at("operands")) {
    mismatch.operands.push_back({operand.at("input"), operand.at("hex"), operand.at("value")});
  }
  return mismatch;
}

ProtocolViolation violation_in(const Json& json) {
  return {.fault = json.at("fault"),
          .lane = json.at("lane"),
          .cycle = json.at("cycle"),
          .details = json.at("details"),
          .simulation = json.at("simulation")};
}

/// Reads the lists of a report.
void read_lists(const Json& json, VerifyReport& report) {
  for (const Json& input : json.at("inputs")) report.inputs.push_back(input_in(input));
  for (const Json& group : json.value("lane_groups", Json::array())) {
    report.groups.push_back(group_in(group));
  }
  const Json counters = json.value("counters", Json::object());
  for (const auto& [name, counter] : counters.items()) {
    report.counters.push_back({name, counter.at("counted"), counter.at("observed")});
  }
  for (const Json& each : json.at("mismatches")) report.mismatches.push_back(mismatch_in(each));
  for (const Json& each : json.at("violations")) report.violations.push_back(violation_in(each));
}

}  // namespace

VerifyReport report_in(const Json& json) {
  VerifyReport report{.system = json.at("system"),
                      .simulator = json.at("simulator"),
                      .lanes = json.at("lanes"),
                      .lanes_per_group = json.value("lanes_per_group", 1),
                      .references = json.at("references"),
                      .certified = json.at("certified"),
                      .requested = json.at("requested"),
                      .comparisons = json.at("comparisons"),
                      .recomputations = json.at("recomputations"),
                      .undecided = json.at("undecided"),
                      .resets = json.at("resets"),
                      .cycles = json.at("cycles"),
                      .latencies = latencies_in(json),
                      .judged_by_emulator = json.at("judged_by_emulator"),
                      .emulator_errors = json.at("emulator_errors"),
                      .mismatch_count = json.at("mismatch_count"),
                      .violation_count = json.at("violation_count"),
                      .build_seconds = json.at("build_seconds"),
                      .run_seconds = json.at("run_seconds")};
  for (const Verdict verdict : all_verdicts) {
    report.verdicts[static_cast<std::size_t>(verdict)] =
        json.at("verdicts").at(std::string(to_string(verdict)));
  }
  if (json.contains("truth")) report.truth = truth_in(json.at("truth"));
  read_lists(json, report);
  return report;
}

Json to_json(const VerifyReport& r) {
  Json json = {{"passed", r.passed()},
               {"system", r.system},
               {"simulator", r.simulator},
               {"lanes", r.lanes},
               {"lanes_per_group", r.lanes_per_group},
               {"references", r.references},
               {"certified", r.certified},
               {"requested", r.requested},
               {"comparisons", r.comparisons}};
  json["inputs"] = Json::array();
  for (const data::InputSource& input : r.inputs) json["inputs"].push_back(to_json(input));
  for (const Verdict verdict : all_verdicts) {
    const std::string name(to_string(verdict));
    json["verdicts"][name] = r.verdicts[static_cast<std::size_t>(verdict)];
  }
  json["undecided"] = r.undecided;
  json["recomputations"] = r.recomputations;
  json["recomputation_rate"] = r.recomputation_rate();
  json["resets"] = r.resets;
  json["cycles"] = r.cycles;
  json["comparisons_per_cycle"] = r.comparisons_per_cycle();
  json["decided_latency"] = to_json(r.latencies.decided);
  json["recomputed_latency"] = to_json(r.latencies.recomputed);
  json["undecided_latency"] = to_json(r.latencies.undecided);
  for (const GroupReport& group : r.groups)
    json["lane_groups"].push_back(to_json(group, r.truth.has_value()));
  for (const CounterTotal& counter : r.counters) {
    json["counters"][counter.name] = {{"counted", counter.counted}, {"observed", counter.observed}};
  }
  json["judged_by_emulator"] = r.judged_by_emulator;
  json["emulator_errors"] = r.emulator_errors;
  json["mismatch_count"] = r.mismatch_count;
  json["mismatches"] = Json::array();
  for (const Mismatch& mismatch : r.mismatches) json["mismatches"].push_back(to_json(mismatch));
  json["violation_count"] = r.violation_count;
  json["violations"] = Json::array();
  for (const ProtocolViolation& violation : r.violations) {
    json["violations"].push_back(to_json(violation));
  }
  if (r.counterexample) json["counterexample"] = to_json(*r.counterexample);
  if (r.truth) json["truth"] = to_json(*r.truth);
  json["notes"] = notes_on(r);
  add_engines(json, r);
  json["build_seconds"] = r.build_seconds;
  json["run_seconds"] = r.run_seconds;
  return json;
}

}  // namespace mixcmp::verilator_tb
