#include "generator/emit/described_modules.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "generator/rtl/lane_module.hpp"
#include "generator/rtl/reference_module.hpp"

namespace mixcmp::emit {
namespace {

using design::Design;

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
      design::Cases{[](const error::Lane& l) { return arithmetic_fact(l.graph.arithmetic); },
                    [&](const fixed::FixedLane&) {
                      return fmt::format("Format: {}, fixed point; operands are rounded down.",
                                         design::format_name(lane));
                    }},
      lane);
}

std::vector<std::string> decision_facts(const design::Lane& lane) {
  const std::string decision = "Decision: " + design::describe_criterion(lane) + ".";
  if (!design::is_certified(lane)) return {decision};
  const bool fixed = std::holds_alternative<fixed::FixedLane>(lane);
  return {decision, fixed ? "Operands out of range, infinities and NaNs are left undecided."
                          : "Infinities, NaNs, overflow and underflow are left undecided."};
}

/// When a datapath starts and ends.
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

Described describe_lane(const Design& design, const std::string& name,
                        const design::LaneGroup& group, const datapath::Schedule& schedule) {
  Described lane = {rtl::lane_module(name, design.inputs, group.lane, schedule),
                    {fmt::format("{}: decides {} in reduced precision, or says it cannot.", name,
                                 what_is_asked(design)),
                     fmt::format("Operands: {}, {}.", design.reference.input_format.name(),
                                 fmt::join(design.inputs, ", ")),
                     arithmetic_fact(group.lane)}};
  for (std::string& fact : decision_facts(group.lane)) lane.facts.push_back(std::move(fact));
  for (std::string& fact : timing_facts(schedule)) lane.facts.push_back(std::move(fact));
  return lane;
}

Described describe_reference(const Design& design, const std::string& name,
                             const datapath::Schedule& schedule) {
  Described reference = {
      rtl::reference_module(name, design.inputs, design.reference, schedule),
      {fmt::format("{}: {} in reference precision.", name, what_is_ordered(design)),
       arithmetic_fact(design.reference.arithmetic),
       "A NaN operand or result makes the verdict unordered."}};
  for (std::string& fact : timing_facts(schedule)) reference.facts.push_back(std::move(fact));
  return reference;
}

Described describe_lane_channel(const rtl::SystemShape& shape, const rtl::DatapathGroup& group) {
  const bool in_order = shape.order == scene::ResultOrder::in_order;
  return {
      rtl::lane_channel_module(shape, group),
      {group.channel + ": one lane between its AXI4-Streams.",
       in_order ? "Results leave in the order of acceptance."
                : "Results may overtake a recomputed one; the tag (tuser) tells which is which.",
       fmt::format("{} comparisons may be inside. Reset: aresetn, synchronous, active low.",
                   1 << shape.slot_bits)}};
}

Described describe_reference_channel(const rtl::SystemShape& shape,
                                     const rtl::DatapathGroup& group) {
  return {rtl::reference_channel_module(shape, group),
          {group.channel + ": one reference datapath behind the crossbar.",
           shape.refetches() ? "The operands are fetched again by tag on m_refetch and s_refetch."
                             : "The operands arrive with the request.",
           "Reset: aresetn, synchronous, active low."}};
}

/// Counts and formats of lanes and references: one sentence if there is one kind of each, otherwise
/// a line for each group, too.
std::vector<std::string> count_facts(const Design& design, const rtl::SystemShape& shape) {
  const std::string reference = design.reference.arithmetic.format.name();
  if (design.lanes.size() == 1 && design.references.size() <= 1) {
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

Described describe_top(const Design& design, const rtl::SystemShape& shape) {
  const int tdata_bits = shape.tdata_bytes() * 8;
  std::vector<std::string> facts = count_facts(design, shape);
  const auto add = [&facts](std::string fact) { facts.push_back(std::move(fact)); };
  add("Every per-lane port is a vector of one field a lane, lane 0 in the lowest bits.");
  add(fmt::format("s_axis_tdata, {} bits a lane, operands {} bits each, the first lowest:",
                  tdata_bits, shape.input_width));
  add(fmt::format("  {}.", fmt::join(design.inputs, ", ")));
  add(fmt::format("s_axis_tuser, m_axis_tuser, {} bits a lane: the tag.", shape.tag_bits));
  add("m_axis_tdata, 8 bits a lane: {4'b0, undecided, recomputed, verdict[1:0]};");
  add("  verdict: 0 less, 1 equal, 2 greater, 3 unordered.");
  if (shape.refetches()) {
    add("m_refetch_tdata, s_refetch_tdata, a field a reference: a tag out, in the");
    add("  order of the tags the operands of each back in.");
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

std::vector<std::string> describe_arg_min(const rtl::EngineShape& engine,
                                          const rtl::SystemShape& shape) {
  int latency_cycles = 0;
  for (const rtl::DatapathGroup& lanes : shape.lane_groups) {
    latency_cycles +=
        lanes.count * (lanes.schedule.latency_cycles + shape.channel_latency_cycles() + 1);
  }
  std::vector<std::string> facts = {
      fmt::format("{}: which of {} candidates costs a row least,", engine.top, engine.capacity),
      fmt::format("  by a chain of the lanes of {}.", shape.top),
      fmt::format("s_candidate: a beat a candidate, tlast with the last; columns {} bits each, the "
                  "first lowest:",
                  engine.column_width),
      fmt::format("  {}.", fmt::join(engine.columns, ", ")),
      "  Fewer are as good as the last one repeated; more are left out, overrun says so until the",
      "  next load, which is taken when no row is inside; while it is offered no row comes in.",
      "s_axis: a beat a row, tag in tuser; columns likewise:",
      fmt::format("  {}.", fmt::join(engine.row_columns, ", ")),
      fmt::format(
          "m_axis: rows in their order; tdata: the candidate's number in [{}:0], from 0, the "
          "first of equals;",
          engine.index_bits() - 1),
      "  tuser and tlast: the row's.",
      fmt::format("Initiation interval 1, latency {} cycles where nothing is recomputed.",
                  latency_cycles)};
  if (shape.counter_bits > 0) {
    facts.emplace_back(
        "Counters since reset, they wrap: of each lane comparisons, recomputations, stalls;");
    facts.emplace_back("  rows that have left, stalled_cycles in which a row waited.");
  }
  facts.emplace_back("Reset: aresetn, synchronous, active low; forgets the candidates, too.");
  return facts;
}

Described describe_engine(const rtl::EngineShape& engine, const rtl::SystemShape& shape) {
  if (engine.spec.kind == scene::EngineKind::arg_min) {
    return {rtl::engine_module(engine, shape), describe_arg_min(engine, shape)};
  }
  const int field_bits = engine.index_field_bits();
  std::vector<std::string> facts = {
      fmt::format("{}: every pair i < j of up to {} items,", engine.top, engine.capacity),
      fmt::format("  through the lanes of {}.", shape.top),
      fmt::format("s_axis: a beat an item, tlast with the last; columns {} bits each, the first "
                  "lowest:",
                  engine.column_width),
      fmt::format("  {}.", fmt::join(engine.columns, ", ")),
      fmt::format("m_axis: a beat a pair that is {} or undecided;",
                  fmt::join(reported_verdicts(engine.spec), ", ")),
      fmt::format("  tdata: i in [{}:0], j in [{}:{}], from 0; tuser: {{4'b0, undecided, "
                  "recomputed, verdict[1:0]}};",
                  engine.index_bits() - 1, field_bits + engine.index_bits() - 1, field_bits),
      "  verdict: 0 less, 1 equal, 2 greater, 3 unordered.",
      "A set ends with a beat with tlast: tdata is the number of its reports, tuser",
      "  {1'b1, overrun, 6'b0}; overrun: more items came than fit, and the others were left out."};
  if (shape.counter_bits > 0) {
    facts.emplace_back(
        "Counters since reset, they wrap: of each lane comparisons, recomputations, "
        "stalls;");
    facts.emplace_back(
        "  reports, busy_cycles (from an item to the closing beat), stalled_cycles.");
  }
  facts.emplace_back("Reset: aresetn, synchronous, active low.");
  return {rtl::engine_module(engine, shape), std::move(facts)};
}

}  // namespace

std::vector<Described> describe_modules(const Design& design, const ScheduledSystem& scheduled) {
  const rtl::SystemShape& shape = scheduled.shape;
  std::vector<Described> modules;
  std::set<std::string> written;
  for (std::size_t k = 0; k < shape.lane_groups.size(); ++k) {
    const rtl::DatapathGroup& group = shape.lane_groups[k];
    if (!written.insert(group.datapath).second) continue;
    modules.push_back(describe_lane(design, group.datapath, design.lanes[k], group.schedule));
    modules.push_back(describe_lane_channel(shape, group));
  }
  for (const rtl::DatapathGroup& group : shape.reference_groups) {
    if (!written.insert(group.datapath).second) continue;
    modules.push_back(describe_reference(design, group.datapath, group.schedule));
    modules.push_back(describe_reference_channel(shape, group));
  }
  modules.push_back(describe_top(design, shape));
  if (scheduled.engine) modules.push_back(describe_engine(*scheduled.engine, shape));
  return modules;
}

}  // namespace mixcmp::emit
