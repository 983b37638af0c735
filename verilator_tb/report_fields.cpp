#include <fmt/core.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "generator/present/table/table.hpp"
#include "verilator_tb/report.hpp"

/// Each field of a report once: its name in JSON, its line in the text, and the member that a
/// reader of JSON fills.
namespace mixcmp::verilator_tb {
namespace {

using data::InputSource;
using table::Field;
using table::Fields;
using table::Json;
using table::Lines;
using table::record;
using Report = VerifyReport;

constexpr int text_column = 25;
constexpr const char* rate_form = "{recomputations} ({recomputation_rate:.3e})";

double ratio_of(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

/// A line that is no pair of a name and a text.
template <class... Values>
Lines remark(int indent, fmt::format_string<Values...> form, Values&&... values) {
  return {{.name = fmt::format(form, std::forward<Values>(values)...), .indent = indent}};
}

/// The whole, for an object in JSON that is no member of it.
constexpr auto itself = [](auto& whole) -> auto& {
  return whole;
};

constexpr auto column_number = [](auto& input) -> auto& {
  return input.column.number;
};

Fields<InputSource> input_fields() {
  Field<InputSource> name({"name"}, [](const InputSource& input) {
    return input.column.name.empty() ? Json() : Json(input.column.name);
  });
  name.read = [](InputSource& input, const Json& json) {
    if (!json.is_null()) json.get_to(input.column.name);
  };
  const auto line = [](const InputSource& input) {
    return Lines{{input.input, "<- " + input.shown()}};
  };
  return {{{"input"}, &InputSource::input, line},
          {{"column"}, column_number},
          name,
          {{"source"}, &InputSource::source},
          {{"item"}, &InputSource::item}};
}

/// " of simulation 3"; nothing of the first, which is often the only one.
std::string of_simulation(std::uint64_t simulation) {
  return simulation == 0 ? "" : fmt::format(" of simulation {}", simulation);
}

Lines headline(const Mismatch& m) {
  return remark(2, "comparison {}{}: expected {}; got {}; lane {}, cycle {}{}", m.index,
                m.items.empty() ? "" : fmt::format(" ({})", m.items), m.expected, m.got, m.lane,
                m.cycle, of_simulation(m.simulation));
}

Fields<Mismatch> mismatch_fields() {
  using Operand = Mismatch::Operand;
  const auto operand_line = [](const Operand& operand) {
    return remark(4, "{} = 0x{} = {}", operand.input, operand.hex, operand.value);
  };
  const Fields<Operand> operand_fields = {{{"input"}, &Operand::input, operand_line},
                                          {{"hex"}, &Operand::hex},
                                          {{"value"}, &Operand::value}};
  return {{{"index"}, &Mismatch::index, headline},
          {{"items"}, &Mismatch::items},
          record<Mismatch>({"operands"}, &Mismatch::operands, operand_fields),
          {{"expected"}, &Mismatch::expected},
          {{"got"}, &Mismatch::got},
          {{"lane"}, &Mismatch::lane},
          {{"cycle"}, &Mismatch::cycle},
          {{"simulation"}, &Mismatch::simulation},
          {{"repeat"}, &Mismatch::repeat, [](const Mismatch& m) {
             return m.repeat.empty() ? Lines{} : remark(4, "repeat: {}", m.repeat);
           }}};
}

Fields<ProtocolViolation> violation_fields() {
  using Violation = ProtocolViolation;
  const auto line = [](const Violation& v) {
    return remark(2, "cycle {}{}, lane {}: {}{}", v.cycle, of_simulation(v.simulation), v.lane,
                  v.fault, v.details.empty() ? "" : " (" + v.details + ")");
  };
  return {{{"fault"}, &Violation::fault, line},
          {{"lane"}, &Violation::lane},
          {{"cycle"}, &Violation::cycle},
          {{"simulation"}, &Violation::simulation},
          {{"details"}, &Violation::details}};
}

Fields<LeastCounterexample> counterexample_fields() {
  using Least = LeastCounterexample;
  return {{{"comparisons", "least counterexample"}, &Least::comparisons},
          record<Least>({.name = "mismatch", .may_be_absent = true}, &Least::mismatch,
                        mismatch_fields()),
          record<Least>({.name = "violation", .may_be_absent = true}, &Least::violation,
                        violation_fields()),
          {{"waves"}, &Least::waves, [](const Least& least) {
             return least.waves.empty() ? Lines{} : remark(4, "waves: {}", least.waves);
           }}};
}

std::string with_mean(const Latency& latency) {
  if (latency.count == 0) return "";
  return fmt::format("{} .. {}, mean {:.1f} cycles", latency.minimum_cycles, latency.maximum_cycles,
                     latency.mean_cycles());
}

std::string range_or_none(const Latency& latency) {
  if (latency.count == 0) return "none";
  return fmt::format("{} .. {} cycles", latency.minimum_cycles, latency.maximum_cycles);
}

/// The latencies of a report or of lanes of one kind. `text_of`: one of them, in words.
template <class Source>
Fields<Source> latency_fields(bool has_references, std::string (*text_of)(const Latency&)) {
  static const Fields<Latency> fields = {{{"count"}, &Latency::count},
                                         {{"minimum_cycles"}, &Latency::minimum_cycles},
                                         {{"maximum_cycles"}, &Latency::maximum_cycles},
                                         {{"total_cycles"}, &Latency::total_cycles},
                                         {{"mean_cycles"}, &Latency::mean_cycles}};
  const auto latency = [&](const std::string& outcome, Latency Latencies::*member, bool is_shown) {
    const auto of = [member](auto& source) -> auto& {
      return source.latencies.*member;
    };
    Field<Source> field = record<Source>({outcome + "_latency"}, of, fields);
    field.lines = [=](const Source& source) {
      const std::string text = is_shown ? text_of(of(source)) : "";
      return text.empty() ? Lines{} : Lines{{"latency, " + outcome, text}};
    };
    return field;
  };
  return {latency("decided", &Latencies::decided, true),
          latency("recomputed", &Latencies::recomputed, has_references),
          latency("undecided", &Latencies::undecided, !has_references)};
}

Fields<GroupReport> group_fields(const Report& report) {
  using Group = GroupReport;
  const bool has_references = report.references > 0, has_truth = report.truth.has_value();
  Field<Group> wrong_by_lane(
      {.name = "wrong_by_lane", .title = "wrong by a lane", .may_be_absent = true},
      [=](const Group& group) { return has_truth ? Json(group.wrong_by_lane) : Json(); });
  wrong_by_lane.read = [](Group& group, const Json& json) { json.get_to(group.wrong_by_lane); };
  const auto title = [](const Group& group) {
    return remark(2, "{} {} {}, {}", group.lanes, group.lanes == 1 ? "lane" : "lanes", group.name,
                  group.certified ? "certified" : "not certified");
  };
  const Fields<Group> counts = {
      {{"name"}, &Group::name, title},
      {{"lanes"}, &Group::lanes},
      {{"certified"}, &Group::certified},
      {{"comparisons", "comparisons"}, &Group::comparisons},
      {{"undecided", has_references ? "" : "undecided"}, &Group::undecided},
      {{"recomputations", "recomputations"}, &Group::recomputations, rate_form},
      {{"recomputation_rate"},
       [](const Group& group) { return ratio_of(group.recomputations, group.comparisons); }}};
  const Fields<Group> faults = {{{"mismatches"}, &Group::mismatches},
                                wrong_by_lane,
                                table::line<Group>("mismatches", "{mismatches}")};
  return counts + latency_fields<Group>(has_references, range_or_none) + faults;
}

/// The lines of each kind of lanes, where there are several.
Lines group_lines(const Report& report) {
  if (report.groups.size() < 2) return {};
  Lines lines = lines_of(group_fields(report), report.groups);
  for (table::Line& line : lines) line.indent = line.text.empty() ? 2 : 4;
  return lines;
}

Field<Report> groups_field() {
  const auto objects = [](const Report& r) {
    return r.groups.empty() ? Json() : object_of(group_fields(r), r.groups);
  };
  Field<Report> field({.name = "lane_groups", .may_be_absent = true}, objects, group_lines);
  field.read = [](Report& r, const Json& json) { read_object(group_fields(r), json, r.groups); };
  return field;
}

Lines counter_lines(const Report& report) {
  Lines lines;
  for (const CounterTotal& each : report.counters) {
    const bool in_words = each.name == "comparisons" && report.lanes_per_group > 1;
    lines.push_back(
        {"counter " + each.name,
         fmt::format("{}{} (observed {}){}", each.counted,
                     in_words ? fmt::format(" words of {}", report.lanes_per_group) : "",
                     each.observed, report.resets > 0 ? " since the last reset" : "")});
  }
  return lines;
}

Field<Report> counters_field() {
  const auto object = [](const Report& report) {
    Json counters;
    for (const auto& [name, counted, observed] : report.counters) {
      counters[name] = {{"counted", counted}, {"observed", observed}};
    }
    return counters;
  };
  Field<Report> field({.name = "counters", .may_be_absent = true}, object, counter_lines);
  field.read = [](Report& report, const Json& counters) {
    for (const auto& [name, counter] : counters.items()) {
      report.counters.push_back({name, counter.at("counted"), counter.at("observed")});
    }
  };
  return field;
}

/// The reasons why comparisons were not checked; each title follows a count.
const Fields<TruthCount>& unchecked_fields() {
  static const Fields<TruthCount> fields = {
      {{"decided_by_lane", "decided by a lane"}, &TruthCount::decided_by_lane},
      {{"undefined", "where f or g has no value"}, &TruthCount::undefined},
      {{"undetermined", "whose truth is undetermined"}, &TruthCount::undetermined},
      {{"undecided", "undecided"}, &TruthCount::undecided}};
  return fields;
}

/// "3: 2 where f or g has no value, 1 whose truth is undetermined"
Lines not_checked(const TruthCount& truth) {
  std::string text;
  for (const table::Line& reason : lines_of(unchecked_fields(), truth)) {
    if (reason.text == "0") continue;
    text += fmt::format("{} {} {}", text.empty() ? ":" : ",", reason.text, reason.name);
  }
  return {{"not checked", std::to_string(truth.not_checked()) + text}};
}

/// A line where there is such a verdict.
Lines ordered_without_value(const TruthCount& truth) {
  if (truth.ordered_without_value == 0) return {};
  return {{"", fmt::format("{} of them by a reference that ordered f and g without a value",
                           truth.ordered_without_value)}};
}

Fields<TruthCount> truth_fields(bool has_references) {
  Field<TruthCount> without_value({"ordered_without_value"}, &TruthCount::ordered_without_value);
  without_value.lines = ordered_without_value;
  const Fields<TruthCount> total = {{{"total"}, &TruthCount::not_checked}};
  Field<TruthCount> unchecked =
      record<TruthCount>({"not_checked"}, itself, total + unchecked_fields());
  unchecked.lines = not_checked;
  return {
      {{"checked", "against the truth"},
       &TruthCount::checked,
       "{checked} checked, {wrong_by_lane} wrong by a lane, {wrong_by_reference} by a reference"},
      {{"wrong_by_lane"}, &TruthCount::wrong_by_lane},
      {{"wrong_by_reference"}, &TruthCount::wrong_by_reference},
      without_value,
      {{"reference_alone_checked"}, &TruthCount::reference_alone_checked},
      {{"reference_alone_wrong"}, &TruthCount::reference_alone_wrong},
      unchecked,
      table::line<TruthCount>(
          has_references ? "reference by itself" : "",
          "wrong on {reference_alone_wrong} of {reference_alone_checked} checked")};
}

/// A member of an engine that the report has.
template <class Engine, class Value>
auto of(std::optional<Engine> Report::*engine, Value Engine::*member) {
  return [=](const Report& report) { return (*(report.*engine)).*member; };
}

Fields<Report> pairwise_fields() {
  using Engine = PairwiseFigures;
  const auto engine = [](auto member) { return of(&Report::engine, member); };
  const auto expected = [](const Report& r) { return table::cell(r.engine->expected_cycles); };
  return {{{"top", "engine"}, engine(&Engine::top), "{top}, {sets} sets, one of all {items} items"},
          {{"items"}, engine(&Engine::items)},
          {{"item_bytes"}, engine(&Engine::item_bytes)},
          {{"pair_bytes"}, engine(&Engine::pair_bytes)},
          {{"reported", "reported pairs"}, engine(&Engine::reported)},
          {{"cycles_per_pair", "cycles per pair", 0, 2, "{:.5f}"},
           [](const Report& r) { return ratio_of(r.cycles, r.comparisons); }},
          {{"", "cycles by the model", 0, 2, "{:.0f}"}, expected},
          {{"stalled_cycles", "stalled cycles"},
           engine(&Engine::stalled_cycles),
           [](const Report& r) {
             return fmt::format("{} ({:.3f} %)", r.engine->stalled_cycles,
                                100 * ratio_of(r.engine->stalled_cycles, r.cycles));
           }},
          {{"item_bytes_per_pair", "bytes in per pair"},
           &Report::item_bytes_per_pair,
           "{item_bytes_per_pair:.4f} (streamed as pairs: {pair_bytes})"},
          {{"sets"}, engine(&Engine::sets)},
          {{.name = "expected_cycles", .may_be_absent = true}, expected}};
}

Fields<Report> arg_min_fields() {
  using Engine = ArgMinFigures;
  const auto engine = [](auto member) { return of(&Report::arg_min, member); };
  const auto expected = [](const Report& r) { return table::cell(r.arg_min->expected_cycles); };
  return {{{"top", "engine"},
           engine(&Engine::top),
           "{top}, {loads} loads, one of all {candidates} candidates"},
          {{"candidates"}, engine(&Engine::candidates)},
          {{"rows", "rows"}, engine(&Engine::rows), "{rows} ({rows_per_cycle:.3f} per cycle)"},
          {{"rows_per_cycle"}, [](const Report& r) { return ratio_of(r.arg_min->rows, r.cycles); }},
          {{"rows_unlike_reference", "unlike the reference", 0, 2, "{} rows"},
           engine(&Engine::rows_unlike_reference)},
          {{"row_latency_cycles", "latency of a row"},
           [](const Report& r) { return r.arg_min->latency.mean_cycles(); },
           [](const Report& r) { return with_mean(r.arg_min->latency); }},
          {{"", "cycles by the model", 0, 2, "{:.0f}"}, expected},
          {{"loading_cycles", "loading", 0, 2, "{} cycles"}, engine(&Engine::loading_cycles)},
          {{"stalled_cycles", "stalled cycles"}, engine(&Engine::stalled_cycles)},
          {{"loads"}, engine(&Engine::loads)},
          {{.name = "expected_cycles", .may_be_absent = true}, expected}};
}

Fields<Report> system_fields() {
  return {{{"passed"}, &Report::passed},
          {{"system"}, &Report::system},
          {{"simulator"}, &Report::simulator},
          {{"lanes"}, &Report::lanes},
          {{.name = "lanes_per_group", .may_be_absent = true}, &Report::lanes_per_group},
          {{"references"}, &Report::references},
          {{"certified"}, &Report::certified},
          {{"requested"}, &Report::requested}};
}

Fields<Report> outcome_fields(bool has_references) {
  Fields<Report> verdicts;
  for (const Verdict verdict : all_verdicts) {
    const auto k = static_cast<std::size_t>(verdict);
    const std::string name(to_string(verdict));
    const auto count = [k](auto& report) -> auto& {
      return report.verdicts[k];
    };
    verdicts.push_back({{name, name}, count});
  }
  return {record<Report>({"verdicts"}, itself, verdicts),
          {{"undecided", has_references ? "" : "undecided"}, &Report::undecided},
          {{"recomputations", "recomputations"}, &Report::recomputations, rate_form},
          {{"recomputation_rate"}, &Report::recomputation_rate}};
}

Fields<Report> cycle_fields(bool has_references) {
  const Fields<Report> cycles = {{{"cycles", "cycles"},
                                  &Report::cycles,
                                  "{cycles} ({comparisons_per_cycle:.3f} comparisons per cycle)"},
                                 {{"comparisons_per_cycle"}, &Report::comparisons_per_cycle}};
  return cycles + latency_fields<Report>(has_references, with_mean);
}

std::string judged_by(const Report& report) {
  if (report.judged_by_emulator == 0) return "the golden model (MPFR, GMP)";
  return fmt::format("the emulator; the golden model for {} of them",
                     report.comparisons - report.judged_by_emulator);
}

Fields<Report> finding_fields(const Report& report) {
  Field<Report> counterexample = record<Report>({.name = "counterexample", .may_be_absent = true},
                                                &Report::counterexample, counterexample_fields());
  counterexample.read = nullptr;
  return {{{"judged_by_emulator", "judged by"}, &Report::judged_by_emulator, judged_by},
          {{"emulator_errors", report.emulator_errors > 0 ? "emulator's errors" : ""},
           &Report::emulator_errors},
          {{"mismatch_count", "mismatches"}, &Report::mismatch_count},
          record<Report>({"mismatches"}, &Report::mismatches, mismatch_fields()),
          {{"violation_count", "protocol violations"}, &Report::violation_count},
          record<Report>({"violations"}, &Report::violations, violation_fields()),
          counterexample};
}

Lines note_lines(const Report& report) {
  Lines lines;
  for (const std::string& note : notes_on(report)) lines.push_back({"note", note});
  return lines;
}

/// The field that holds an engine's figures, if the report has some.
template <class Engine>
Field<Report> engine_field(std::string name, std::optional<Engine> Report::*engine,
                           const Fields<Report>& fields) {
  return {{.name = std::move(name), .may_be_absent = true},
          [=](const Report& r) { return r.*engine ? object_of(fields, r) : Json(); },
          [=](const Report& r) { return r.*engine ? lines_of(fields, r) : Lines{}; }};
}

/// All fields, in the order of JSON or of the text.
enum class Order { json, text };
Fields<Report> fields_of(const Report& report, Order order) {
  const bool has_references = report.references > 0;
  const Fields<Report> inputs = {record<Report>({"inputs"}, &Report::inputs, input_fields())};
  const Fields<Report> made = {
      {{"comparisons", "comparisons"}, &Report::comparisons, "{comparisons} of {requested}"}};
  const Fields<Report> outcomes = outcome_fields(has_references);
  const Fields<Report> cycles = cycle_fields(has_references);
  const Fields<Report> resets = {
      {{"resets", report.resets > 0 ? "resets in mid-stream" : ""}, &Report::resets}};
  const Fields<Report> groups = {groups_field()}, counters = {counters_field()};
  const Fields<Report> findings = finding_fields(report);
  const Fields<Report> truth = {record<Report>({.name = "truth", .may_be_absent = true},
                                               &Report::truth, truth_fields(has_references))};
  const Fields<Report> engines = {engine_field("engine", &Report::engine, pairwise_fields()),
                                  engine_field("arg_min", &Report::arg_min, arg_min_fields())};
  const Fields<Report> notes = {{{"notes"}, notes_on, note_lines}};
  const Fields<Report> seconds = {{{"build_seconds"}, &Report::build_seconds},
                                  {{"run_seconds"}, &Report::run_seconds}};
  if (order == Order::text) {
    return inputs + system_fields() + made + outcomes + cycles + resets + counters + truth +
           engines + groups + findings + notes;
  }
  return system_fields() + made + inputs + outcomes + resets + cycles + groups + counters +
         findings + truth + notes + engines + seconds;
}

}  // namespace

VerifyReport report_in(const Json& json) {
  VerifyReport report;
  read_object(fields_of(report, Order::json), json, report);
  return report;
}

Json to_json(const VerifyReport& report) {
  return object_of(fields_of(report, Order::json), report);
}

std::string to_text(const VerifyReport& report) {
  const std::string groups =
      report.lanes_per_group == 1 ? "" : fmt::format(" in groups of {}", report.lanes_per_group);
  return fmt::format("{}: {}, p_L = {}{}, p_H = {}, {}, {}\n",
                     report.passed() ? "passed" : "FAILED", report.system, report.lanes, groups,
                     report.references, report.certified ? "certified" : "not certified",
                     report.simulator) +
         to_text(lines_of(fields_of(report, Order::text), report), text_column);
}

}  // namespace mixcmp::verilator_tb
