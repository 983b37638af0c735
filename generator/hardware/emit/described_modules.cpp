#include "generator/hardware/emit/described_modules.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "generator/hardware/emit/comparison_facts.hpp"
#include "generator/hardware/rtl/arg_min_module.hpp"
#include "generator/hardware/rtl/channel_modules.hpp"
#include "generator/hardware/rtl/lane_module.hpp"
#include "generator/hardware/rtl/reference_module.hpp"
#include "generator/hardware/rtl/system_modules.hpp"
#include "model/base/common/cases.hpp"

namespace mixcmp::emit {
namespace {

using design::Design;

constexpr const char* recomputed_by_either =
    "  recomputed: the second tier or a reference answered; the bit does not tell which.";

std::string arithmetic_fact(const Arithmetic& arithmetic) {
  return fmt::format("Format: {}, rounding {}, subnormals {}{}.", arithmetic.format.name(),
                     to_string(arithmetic.rounding), to_string(arithmetic.subnormals),
                     arithmetic.sums == Sums::fused ? ", sums fused" : "");
}

/// The question that a comparison answers, in words: "the sign of f - g".
std::string what_is_asked(const Design& design) {
  const std::size_t parts = design.reference.parts.size();
  if (parts == 1) return "the sign of f - g";
  return fmt::format("the signs of f - g of {} of {} parts",
                     to_string(design.reference.combination), parts);
}

std::string what_is_ordered(const Design& design) {
  const std::size_t parts = design.reference.parts.size();
  if (parts == 1) return "the ordering of f and g as computed";
  return fmt::format("the orderings of f and g of {} of {} parts as computed",
                     to_string(design.reference.combination), parts);
}

std::string arithmetic_fact(const design::Lane& lane) {
  return std::visit(
      Cases{[](const error::Lane& l) { return arithmetic_fact(l.graph.arithmetic); },
            [&](const fixed::FixedLane& made) {
              return fmt::format(
                  "Format: {}, fixed point; {}.", design::format_name(lane),
                  fixed::rounds_nothing(made) ? "nothing is rounded" : "operands are rounded down");
            }},
      lane);
}

std::vector<std::string> decision_facts(const design::Lane& lane) {
  const std::string decision = "Decision: " + design::describe_criterion(lane) + ".";
  if (!design::is_certified(lane)) return {decision};
  const auto* fixed = std::get_if<fixed::FixedLane>(&lane);
  if (fixed != nullptr && fixed::is_exact(*fixed)) return {decision};
  if (fixed == nullptr) {
    return {decision, "Infinities, NaNs, overflow and underflow are left undecided."};
  }
  const char* const off_grid = fixed::relies_on_grids(*fixed) ? "off their grid, " : "";
  return {decision, fmt::format("Operands out of range, {}infinities and NaNs are left undecided.",
                                off_grid)};
}

/// The facts about the cycles in which a datapath starts and ends.
std::vector<std::string> timing_facts(const datapath::Schedule& schedule) {
  std::vector<std::string> facts = {
      fmt::format("Latency {} cycles, initiation interval {}, no reset.", schedule.latency_cycles,
                  schedule.initiation_interval)};
  if (schedule.initiation_interval > 1) {
    facts.push_back(fmt::format("A comparison starts in phase 0; its operands stay until phase {}.",
                                schedule.last_operand_phase));
  }
  return facts;
}

std::string lane_fact(const Design& design, const std::string& module, const design::Lane& lane) {
  const auto* fixed = std::get_if<fixed::FixedLane>(&lane);
  const bool always = fixed != nullptr && fixed::is_exact(*fixed);
  return fmt::format("{}: decides {} {}.", module, what_is_asked(design),
                     always ? "exactly" : "in reduced precision, or says it cannot");
}

/// The operands of a lane, with their format if it is one: "s53e11, a, b".
std::string operands_text(const Design& design) {
  const std::vector<OperandFormat> formats = design.formats_of_inputs();
  const bool alike = std::all_of(formats.begin(), formats.end(), [&](const OperandFormat& format) {
    return format == formats.front();
  });
  std::vector<std::string> texts;
  if (alike) texts.push_back(formats.front().name());
  for (std::size_t k = 0; k < formats.size(); ++k) {
    texts.push_back(alike ? design.inputs[k] : design.inputs[k] + " " + formats[k].name());
  }
  return fmt::format("{}", fmt::join(texts, ", "));
}

Described describe_lane(const Design& design, const std::string& name,
                        const design::LaneGroup& group, const datapath::Schedule& schedule) {
  Described lane = {
      rtl::lane_module(name, design.inputs, group.lane, schedule),
      {lane_fact(design, name, group.lane), fmt::format("Operands: {}.", operands_text(design)),
       arithmetic_fact(group.lane)}};
  for (std::string& fact : decision_facts(group.lane)) lane.facts.push_back(std::move(fact));
  for (std::string& fact : timing_facts(schedule)) lane.facts.push_back(std::move(fact));
  return lane;
}

std::vector<std::string> reference_facts(const Design& design, const std::string& name) {
  if (design.requested_reference() != nullptr) {
    return {fmt::format("{}: {} in fixed point.", name, what_is_ordered(design)),
            fmt::format("Operands: {}.", operands_text(design)),
            arithmetic_fact(design::Lane(*design.fixed_reference)),
            "Operands that do not fit, infinities and NaNs make the verdict unordered."};
  }
  if (design.fixed_reference) {
    const design::Lane lane = *design.fixed_reference;
    return {lane_fact(design, name, lane), fmt::format("Operands: {}.", operands_text(design)),
            arithmetic_fact(lane)};
  }
  return {fmt::format("{}: {} in reference precision.", name, what_is_ordered(design)),
          arithmetic_fact(design.reference.arithmetic),
          "A NaN operand or result makes the verdict unordered."};
}

Described describe_reference(const Design& design, const std::string& name,
                             const datapath::Schedule& schedule) {
  Described reference = {
      rtl::reference_module(name, design.inputs, design.reference_datapath(), schedule),
      reference_facts(design, name)};
  for (std::string& fact : timing_facts(schedule)) reference.facts.push_back(std::move(fact));
  return reference;
}

Described describe_lane_channel(const rtl::SystemShape& shape, const rtl::DatapathGroup& group) {
  const bool in_order = shape.order == scene::ResultOrder::in_order;
  return {
      rtl::lane_channel_module(shape, group),
      {shape.lanes_per_group == 1
           ? group.channel + ": one lane between its AXI4-Streams."
           : fmt::format("{}: {} lanes in lock step, lane 0 in the lowest bits.", group.channel,
                         shape.lanes_per_group),
       in_order ? "Results leave in the order of acceptance."
                : "Results may overtake a recomputed one; the tag (tuser) tells which is which.",
       fmt::format("{} {} may be inside. Reset: aresetn, synchronous, active low.",
                   1 << shape.slot_bits,
                   shape.lanes_per_group == 1 ? "comparisons" : "words of comparisons")}};
}

Described describe_reference_channel(const rtl::SystemShape& shape,
                                     const rtl::DatapathGroup& group) {
  return {rtl::reference_channel_module(shape, group),
          {group.channel + ": one reference datapath behind the crossbar.",
           shape.refetches() ? "The operands are fetched again by tag on m_refetch and s_refetch."
                             : "The operands arrive with the request.",
           "Reset: aresetn, synchronous, active low."}};
}

Described describe_second_tier_channel(const rtl::SystemShape& shape) {
  const std::string& name = shape.second_tier->channel;
  return {rtl::second_tier_channel_module(shape),
          {name + ": one lane of the second tier, between a crossbar and the next.",
           shape.refetches() ? "The operands are fetched again by tag on m_refetch and s_refetch."
                             : "The operands arrive with the request.",
           "Answers leave in the order of requests: one of a reference holds up those behind it.",
           fmt::format("{} comparisons may be inside. Reset: aresetn, synchronous, active low.",
                       1 << shape.second_tier_slot_bits)}};
}

/// Counts and formats of lanes and references: one sentence if there is one kind of each, otherwise
/// also a line for each group.
std::vector<std::string> count_facts(const Design& design, const rtl::SystemShape& shape) {
  const std::string reference = design::format_name(design.reference_datapath());
  if (design.lanes.size() == 1 && design.references.size() <= 1 && !design.second_tier) {
    return {fmt::format("{}: p_L = {} in {}, p_H = {} in {}.", shape.top, shape.lanes,
                        design::format_name(design.lanes.front().lane), shape.references,
                        reference)};
  }
  std::vector<std::string> facts = {fmt::format("{}: p_L = {}, p_H = {} in {}.", shape.top,
                                                shape.lanes, shape.references, reference)};
  const auto add_groups = [&facts](const char* what,
                                   const std::vector<rtl::DatapathGroup>& groups) {
    for (const rtl::DatapathGroup& group : groups) {
      const std::string which = group.count == 1 ? fmt::format("{} {}", what, group.first)
                                                 : fmt::format("{}s {} to {}", what, group.first,
                                                               group.first + group.count - 1);
      facts.push_back(
          fmt::format("{}: {}, {} cycles.", which, group.channel, group.schedule.latency_cycles));
    }
  };
  add_groups("Lane", shape.lane_groups);
  if (shape.second_tier) add_groups("Second-tier lane", {*shape.second_tier});
  add_groups("Reference", shape.reference_groups);
  return facts;
}

int shortest_latency_cycles(const rtl::SystemShape& shape) {
  const auto shortest =
      std::min_element(shape.lane_groups.begin(), shape.lane_groups.end(),
                       [](const rtl::DatapathGroup& a, const rtl::DatapathGroup& b) {
                         return a.schedule.latency_cycles < b.schedule.latency_cycles;
                       });
  return shortest->schedule.latency_cycles + shape.channel_latency_cycles();
}

void add_all(std::vector<std::string>& facts, std::vector<std::string> more) {
  for (std::string& fact : more) facts.push_back(std::move(fact));
}

/// The fields of a lane's s_axis_tdata: operands or, in an engine, words of its items.
std::vector<std::string> operand_facts(const Design& design, const ScheduledSystem& scheduled) {
  const rtl::SystemShape& shape = scheduled.shape;
  const int tdata_bits = shape.lane_tdata_bytes() * 8;
  if (const rtl::ItemWords* words = scheduled.words()) {
    return {fmt::format("s_axis_tdata, {} bits a lane, words of the engine around it, the first "
                        "lowest:",
                        tdata_bits),
            fmt::format("  the row's, {} bits, and two candidates', {} bits each.",
                        words->rows.bits(), words->items.bits())};
  }
  std::vector<std::string> facts = {
      fmt::format("s_axis_tdata, {} bits a lane, operands {}, the first lowest:", tdata_bits,
                  widths_text(shape.input_formats))};
  add_all(facts, layout_facts(design.inputs, shape.input_formats));
  return facts;
}

Described describe_top(const Design& design, const ScheduledSystem& scheduled) {
  const rtl::SystemShape& shape = scheduled.shape;
  std::vector<std::string> facts = count_facts(design, shape);
  const auto add = [&facts](std::string fact) { facts.push_back(std::move(fact)); };
  const bool grouped = shape.lanes_per_group > 1;
  const char* const sender = grouped ? "group" : "lane";
  add_all(facts, formula_facts(design, "The verdict is "));
  add("Streams s_axis, m_axis: AXI4-Stream.");
  if (grouped) {
    add(fmt::format(
        "Groups of {} lanes in lock step take words of one comparison a lane. Operands and",
        shape.lanes_per_group));
    add("  results are one field a lane, handshakes, tags and counters one a group, 0 lowest.");
  } else {
    add("Every per-lane port is a vector of one field a lane, lane 0 in the lowest bits.");
  }
  add_all(facts, operand_facts(design, scheduled));
  add(fmt::format("s_axis_tuser, m_axis_tuser, {} bits a {}: the tag.", shape.tag_bits, sender));
  add("m_axis_tdata, 8 bits a lane: {4'b0, undecided, recomputed, verdict[1:0]};");
  add("  verdict: 0 less, 1 equal, 2 greater, 3 unordered.");
  if (shape.second_tier) add(recomputed_by_either);
  if (shape.refetches()) {
    add("m_refetch, also AXI4-Stream: tags whose operands are wanted, a field a reference;");
    add("  s_refetch: these operands, in the same order.");
    if (shape.second_tier) {
      add("  Behind the references' fields come those of the second tier's lanes.");
    }
    if (grouped) add("  The tag of lane k of a group is the word's + k.");
  }
  if (shape.counter_bits > 0) {
    add("comparisons, recomputations, stalls: counts since reset, they wrap.");
  }
  add(
      fmt::format("Initiation interval 1 a lane, latency {} cycles and up. Reset: aresetn, "
                  "synchronous, active low.",
                  shortest_latency_cycles(shape)));
  return {rtl::top_module(shape), std::move(facts)};
}

std::vector<std::string> describe_arg_min(const Design& design, const rtl::ArgMinShape& arg_min,
                                          const rtl::SystemShape& shape) {
  constexpr int queue_cycles = 2;  // cycles of the queue behind the conversion of rows
  const rtl::EngineShape& engine = arg_min.engine;
  int latency_cycles = arg_min.words.latency_cycles() + queue_cycles;
  for (const rtl::DatapathGroup& lanes : shape.lane_groups) {
    latency_cycles +=
        lanes.count * (lanes.schedule.latency_cycles + shape.channel_latency_cycles() + 1);
  }
  std::vector<std::string> facts = {
      fmt::format("{}: which of {} candidates costs a row least,", engine.top, engine.capacity),
      fmt::format("  by a chain of the lanes of {}.", shape.top)};
  add_all(facts, formula_facts(design,
                               "Candidate j replaces i, the best before it, where the "
                               "verdict is greater. It is "));
  add_all(facts, {"Streams s_candidate, s_axis, m_axis: AXI4-Stream.",
                  fmt::format("s_candidate: a beat a candidate, tlast with the last; columns {}, "
                              "the first lowest:",
                              widths_text(engine.column_formats))});
  add_all(facts, layout_facts(engine.columns, engine.column_formats));
  add_all(
      facts,
      {"  Fewer are as good as the last one repeated; more are left out, overrun says so until "
       "the",
       "  next load, which is taken when no row is inside; while it is offered no row comes in.",
       "s_axis: a beat a row, tag in tuser; columns likewise:"});
  add_all(facts, layout_facts(engine.row_columns, engine.row_column_formats));
  add_all(facts,
          {fmt::format("m_axis: rows in their order; tdata: the candidate's number in [{}:0], from "
                       "0, the first of equals;",
                       engine.index_bits() - 1),
           "  tuser and tlast: the row's.",
           fmt::format("Initiation interval 1, latency {} cycles where nothing is recomputed.",
                       latency_cycles)});
  if (shape.counter_bits > 0) {
    facts.emplace_back(
        "Counters since reset, they wrap: of each lane comparisons, recomputations, stalls;");
    facts.emplace_back("  rows that have left, stalled_cycles in which a row waited.");
  }
  facts.emplace_back("Reset: aresetn, synchronous, active low; it also forgets the candidates.");
  return facts;
}

/// The fact about a report stream: "a beat a pair that is less or undecided". With a reference
/// every pair is decided.
std::string report_fact(const rtl::PairwiseShape& shape, int references) {
  const scene::EngineSpec& spec = shape.engine.spec;
  const std::string reported = fmt::format("{}", fmt::join(reported_verdicts(spec), " or "));
  const char* const undecided = references == 0 ? " or undecided" : "";
  switch (spec.report_as) {
    case scene::ReportForm::pairs:
      return fmt::format("m_axis: a beat a pair that is {}{};", reported, undecided);
    case scene::ReportForm::bitmap:
      return fmt::format(
          "m_axis: a beat for an item j and {} items i in a row, of which some are {};",
          shape.lanes_per_segment(), reported);
    case scene::ReportForm::count:
      return fmt::format("m_axis: a beat a set, with the number of pairs that are {}{}.", reported,
                         undecided);
  }
  MIXCMP_CHECK(false);
}

std::vector<std::string> report_fields(const rtl::PairwiseShape& shape, int references,
                                       bool has_second_tier) {
  const rtl::EngineShape& engine = shape.engine;
  const int field_bits = engine.index_field_bits();
  std::vector<std::string> facts;
  if (engine.spec.report_as != scene::ReportForm::count) {
    facts.push_back(fmt::format(
        "  tdata: i in [{}:0], j in [{}:{}], from 0; tuser: {{4'b0, undecided, recomputed, "
        "verdict[1:0]}};",
        engine.index_bits() - 1, field_bits + engine.index_bits() - 1, field_bits));
  }
  if (engine.spec.report_as == scene::ReportForm::bitmap) {
    facts.push_back(
        fmt::format("  flags in [{}:{}]: bit k is about i + k and j; {} pairs leave one by one;",
                    2 * field_bits + shape.lanes_per_segment() - 1, 2 * field_bits,
                    references == 0 ? "undecided" : "recomputed"));
  }
  if (engine.spec.report_as != scene::ReportForm::count) {
    facts.emplace_back("  verdict: 0 less, 1 equal, 2 greater, 3 unordered.");
    if (has_second_tier) facts.emplace_back(recomputed_by_either);
  }
  return facts;
}

Described describe_pairwise(const Design& design, const rtl::PairwiseShape& shape,
                            const rtl::SystemShape& system) {
  const rtl::EngineShape& engine = shape.engine;
  std::vector<std::string> facts = {
      fmt::format("{}: every pair i < j of up to {} items,", engine.top, engine.capacity),
      fmt::format("  past p_L = {} lanes in {} segments, undecided pairs by p_H = {} references.",
                  system.lanes, shape.segment_count(), system.references)};
  add_all(facts, formula_facts(design, "The verdict of a pair is "));
  add_all(facts, {"Streams s_axis, m_axis: AXI4-Stream.",
                  fmt::format("s_axis: a beat an item, tlast with the last; columns {}, the first "
                              "lowest:",
                              widths_text(engine.column_formats))});
  add_all(facts, layout_facts(engine.columns, engine.column_formats));
  add_all(facts, {"  A set that begins with items with tuser compares each of these with each of "
                  "the others, and no other pairs.",
                  report_fact(shape, system.references)});
  add_all(facts, report_fields(shape, system.references, system.second_tier.has_value()));
  if (shape.streams() > 1) {
    facts.push_back(
        fmt::format("  {} streams side by side; each ends every set.", shape.streams()));
  }
  facts.push_back(fmt::format("A set ends with a beat with tlast: tdata is {}, tuser",
                              engine.spec.report_as == scene::ReportForm::count
                                  ? "that number"
                                  : "the number of its reports"));
  facts.emplace_back(
      "  {1'b1, overrun, 6'b0}; overrun: more items came than fit, and the others were left out.");
  if (system.counter_bits > 0) {
    facts.emplace_back(
        "Counters since reset, they wrap: reports, recomputations, busy_cycles (from an item to "
        "the");
    facts.emplace_back("  closing beat), stalled_cycles.");
  }
  facts.emplace_back("Reset: aresetn, synchronous, active low.");
  return {rtl::pairwise_module(shape, system), std::move(facts)};
}

/// The conversion that computes the words of an item or a row.
Described describe_conversion(const rtl::ItemWords& words, data::Item item, const char* what,
                              const rtl::EngineShape& engine) {
  const rtl::Word& word = words.of(item);
  std::vector<std::string> facts = {
      fmt::format("{}: what the lanes know of {}, computed when it is loaded.", word.module, what),
      fmt::format("Columns: {}, {}.", widths_text(engine.formats_of(item)),
                  fmt::join(engine.columns_of(item), ", ")),
      "word, the first field lowest:"};
  for (const rtl::Word::Field& field : word.fields) {
    facts.push_back(
        fmt::format("  {} in [{}:{}]", field.name, field.low + field.width - 1, field.low));
  }
  for (std::string& fact : timing_facts(word.schedule)) facts.push_back(std::move(fact));
  return {rtl::item_word_module(words, item, engine), std::move(facts)};
}

/// A lane that reads words; `made` is the lane as designed, which reads operands.
Described describe_word_lane(const Design& design, const design::Lane& made,
                             const rtl::WordLane& lane, const rtl::DatapathGroup& lanes) {
  std::vector<std::string> ports;
  for (const rtl::LanePort& port : lane.ports) ports.push_back(port.name);
  const bool of_row =
      std::any_of(lane.ports.begin(), lane.ports.end(),
                  [](const rtl::LanePort& port) { return port.item == data::Item::row; });
  const char* const whose = of_row ? "the row and of candidates i and j" : "items i and j";
  Described described = {
      rtl::word_lane_module(lanes.datapath, lane, lanes.schedule),
      {lane_fact(design, lanes.datapath, made),
       fmt::format("Operands: of the words of {}, {}.", whose, fmt::join(ports, ", ")),
       arithmetic_fact(made)}};
  for (std::string& fact : decision_facts(made)) {
    described.facts.push_back(std::move(fact));
  }
  for (std::string& fact : timing_facts(lanes.schedule)) {
    described.facts.push_back(std::move(fact));
  }
  return described;
}

Described describe_segment(const rtl::PairwiseShape& shape, const rtl::SystemShape& system,
                           const rtl::SegmentGroup& segments) {
  Described segment = {rtl::segment_module(system, shape.engine, shape.words, segments),
                       {fmt::format("{}: {} lanes in lock step, a link of the engine's chain.",
                                    segments.module, segments.lanes)}};
  if (system.second_tier) {
    segment.facts.push_back(fmt::format("A pair that they leave undecided goes to {}, one a cycle.",
                                        system.second_tier->datapath));
  }
  segment.facts.emplace_back("Reset: aresetn, synchronous, active low.");
  return segment;
}

/// Adds each module once, however many groups have it.
class ModuleList {
public:
  template <class Describe>
  void add(const std::string& name, Describe describe) {
    if (written_.insert(name).second) modules_.push_back(describe());
  }
  std::vector<Described> take() { return std::move(modules_); }

private:
  std::set<std::string> written_;
  std::vector<Described> modules_;
};

void add_references(const Design& design, const rtl::SystemShape& shape, ModuleList& modules) {
  for (const rtl::DatapathGroup& group : shape.reference_groups) {
    modules.add(group.datapath,
                [&] { return describe_reference(design, group.datapath, group.schedule); });
    modules.add(group.channel, [&] { return describe_reference_channel(shape, group); });
  }
}

void add_conversion(const rtl::ItemWords& words, data::Item item, const char* what,
                    const rtl::EngineShape& engine, ModuleList& modules) {
  const rtl::Word& word = words.of(item);
  if (!word.converts()) return;
  modules.add(word.module, [&] { return describe_conversion(words, item, what, engine); });
}

/// The lanes of group k, which read words.
void add_word_lane(const Design& design, const rtl::ItemWords& words, std::size_t k,
                   const rtl::SystemShape& system, ModuleList& modules) {
  const rtl::DatapathGroup& group = system.lane_groups[k];
  modules.add(group.datapath, [&] {
    return describe_word_lane(design, design.lanes[k].lane, words.lanes[k], group);
  });
}

std::vector<Described> describe_pairwise_modules(const Design& design,
                                                 const rtl::PairwiseShape& shape,
                                                 const rtl::SystemShape& system) {
  ModuleList modules;
  add_conversion(shape.words, data::Item::first, "an item", shape.engine, modules);
  for (std::size_t k = 0; k < system.lane_groups.size(); ++k) {
    add_word_lane(design, shape.words, k, system, modules);
  }
  if (system.second_tier) {
    modules.add(system.second_tier->datapath, [&] {
      return describe_word_lane(design, design.second_tier->lane, *shape.words.second_tier,
                                *system.second_tier);
    });
  }
  for (const rtl::SegmentGroup& segments : shape.segments) {
    modules.add(segments.module, [&] { return describe_segment(shape, system, segments); });
  }
  add_references(design, rtl::reference_shape(system), modules);
  modules.add(shape.engine.top, [&] { return describe_pairwise(design, shape, system); });
  return modules.take();
}

std::vector<Described> describe_system_modules(const Design& design,
                                               const ScheduledSystem& scheduled) {
  const rtl::SystemShape& shape = scheduled.shape;
  const rtl::ItemWords* const words = scheduled.words();
  ModuleList modules;
  if (words != nullptr) {
    add_conversion(*words, data::Item::first, "a candidate", *scheduled.engine, modules);
    add_conversion(*words, data::Item::row, "a row", *scheduled.engine, modules);
  }
  for (std::size_t k = 0; k < shape.lane_groups.size(); ++k) {
    const rtl::DatapathGroup& group = shape.lane_groups[k];
    if (words != nullptr) {
      add_word_lane(design, *words, k, shape, modules);
    } else {
      modules.add(group.datapath, [&] {
        return describe_lane(design, group.datapath, design.lanes[k], group.schedule);
      });
    }
    modules.add(group.channel, [&] { return describe_lane_channel(shape, group); });
  }
  if (shape.second_tier) {
    const rtl::DatapathGroup& tier = *shape.second_tier;
    modules.add(tier.datapath, [&] {
      return describe_lane(design, tier.datapath, *design.second_tier, tier.schedule);
    });
    modules.add(tier.channel, [&] { return describe_second_tier_channel(shape); });
  }
  add_references(design, shape.second_tier ? rtl::second_tier_shape(shape) : shape, modules);
  modules.add(shape.top, [&] { return describe_top(design, scheduled); });
  if (scheduled.arg_min) {
    modules.add(scheduled.engine->top, [&] {
      return Described{rtl::arg_min_module(*scheduled.arg_min, shape),
                       describe_arg_min(design, *scheduled.arg_min, shape)};
    });
  }
  return modules.take();
}

/// Moves the counters of the outermost module to an AXI4-Lite port, and states their addresses.
void add_counter_port(Described& top, const ScheduledSystem& scheduled) {
  const std::vector<rtl::Counters> counters = scheduled.counters();
  top.module = rtl::with_counter_port(std::move(top.module), counters, scheduled.shape);
  top.facts.push_back(fmt::format(
      "s_axi: the counters on an AXI4-Lite port that refuses writes; {} bits each, at byte:",
      scheduled.shape.read_counter_bits));
  for (const auto& [kind, offset] : rtl::counter_offsets(counters)) {
    const std::string step =
        kind.count == 1 ? "" : fmt::format(" + {} k, k < {}", rtl::counter_stride, kind.count);
    top.facts.push_back(fmt::format("  {}: 0x{:x}{}", kind.name, offset, step));
  }
}

}  // namespace

std::vector<Described> describe_modules(const Design& design, const ScheduledSystem& scheduled) {
  std::vector<Described> modules =
      scheduled.pairwise ? describe_pairwise_modules(design, *scheduled.pairwise, scheduled.shape)
                         : describe_system_modules(design, scheduled);
  if (scheduled.shape.has_counter_port()) add_counter_port(modules.back(), scheduled);
  return modules;
}

}  // namespace mixcmp::emit
