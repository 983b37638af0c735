#include "generator/rtl/datapath_module.hpp"

#include <fmt/core.h>

#include "generator/rtl/bound_unit_builder.hpp"
#include "generator/rtl/datapath_builder.hpp"
#include "generator/rtl/range_checks.hpp"
#include "model/common/check.hpp"
#include "model/error/hazards.hpp"

namespace mixcmp::rtl {
namespace {

std::vector<Parameter> format_parameters(FloatFormat format) {
  return {{"EXPONENT_BITS", format.exponent_bits()}, {"PRECISION", format.precision()}};
}

/// The signals of one part's decision; with a single part they are the module's own outputs.
struct PartDecision {
  std::string instance;
  Signal verdict;
  Signal decided;  ///< null in a reference, which always decides
};

enum class Decides { sometimes, always };

/// Adds the comment and the nets of a part's decision.
PartDecision begin_decision(DatapathBuilder& builder, const datapath::Step& step, std::size_t part,
                            std::size_t parts, Decides decides, std::string_view what) {
  const bool alone = parts == 1;
  builder.add(Comment{fmt::format("Cycles {} to {}: {}{}", step.start_cycle, step.ready_cycle,
                                  alone ? "" : fmt::format("part {}, ", part), what)});
  const auto output = [&](const char* name, int width) {
    const std::string wire = alone ? name : builder.pool().unique(name + part_suffix(part, parts));
    if (!alone) builder.add(Wire{width, wire, nullptr});
    return Signal{net(wire), wire, width, step.ready_cycle};
  };
  PartDecision decision{
      .instance = alone ? "decision" : builder.pool().unique("decision" + part_suffix(part, parts)),
      .verdict = output("verdict", 2),
      .decided = {}};
  if (decides == Decides::sometimes) decision.decided = output("decided", 1);
  return decision;
}

/// Builds the decisions of a lane, part by part.
class LaneDecisions {
public:
  LaneDecisions(DatapathBuilder& builder, const error::Lane& lane,
                const datapath::Schedule& schedule)
      : builder_(builder),
        lane_(lane),
        schedule_(schedule),
        format_(lane.graph.arithmetic.format) {}

  PartDecision build(std::size_t part, const Signal& out_of_range) {
    const auto build = [&](const auto& decision) {
      return this->build(part, decision, out_of_range);
    };
    return std::visit(build, lane_.parts[part].decision);
  }

private:
  PartDecision build(std::size_t part, const error::UlpDistanceDecision& decision,
                     const Signal& out_of_range) {
    const auto [f_node, g_node] = lane_.graph.parts[part];
    const datapath::Step& step = schedule_.parts[part].decision;
    const Operand f = builder_.at(builder_.value(f_node), step.start_cycle);
    const Operand g = builder_.at(builder_.value(g_node), step.start_cycle);
    const Operand exceptional = builder_.any_at(
        {builder_.flag(f_node), builder_.flag(g_node), out_of_range}, step.start_cycle);
    PartDecision made = begin(part, "certain where the encodings are GUARD_ULP or more apart.");
    std::vector<Parameter> parameters = format_parameters(format_);
    parameters.push_back({"GUARD_ULP", Literal{format_.width(), decision.guard_ulp}});
    parameters.push_back({"NONNEGATIVE", decision.nonnegative ? 1 : 0});
    parameters.push_back({"CUTS", cut_mask(step)});
    builder_.add(Instance{step.unit.module,
                          made.instance,
                          std::move(parameters),
                          {{"aclk", net("aclk")},
                           {"f", f},
                           {"g", g},
                           {"exceptional", exceptional},
                           {"verdict", made.verdict.value},
                           {"decided", made.decided.value}}});
    return made;
  }

  PartDecision build(std::size_t part, const error::AbsoluteBoundDecision& decision,
                     const Signal& out_of_range) {
    const datapath::Step& step = schedule_.parts[part].decision;
    BoundUnitBuilder bounds(builder_, lane_, decision, schedule_.parts[part],
                            part_suffix(part, lane_.parts.size()));
    bounds.build();
    std::vector<Signal> exceptions = bounds.failures();
    exceptions.push_back(builder_.flag(decision.difference));
    exceptions.push_back(out_of_range);
    const Operand difference = builder_.at(builder_.value(decision.difference), step.start_cycle);
    const Operand bound = builder_.at(bounds.bound(), step.start_cycle);
    const Operand exceptional = builder_.any_at(exceptions, step.start_cycle);
    PartDecision made = begin(part, "certain where the difference exceeds the bound of its error.");
    std::vector<Parameter> parameters = format_parameters(format_);
    parameters.push_back({"BOUND_PRECISION", decision.bound.format.precision});
    parameters.push_back({"GUARD_ULP", Literal{format_.width(), decision.guard_ulp}});
    parameters.push_back({"CUTS", cut_mask(step)});
    builder_.add(Instance{step.unit.module,
                          made.instance,
                          std::move(parameters),
                          {{"aclk", net("aclk")},
                           {"difference", difference},
                           {"bound", bound},
                           {"exceptional", exceptional},
                           {"verdict", made.verdict.value},
                           {"decided", made.decided.value}}});
    return made;
  }

  PartDecision build(std::size_t part, const error::IntervalDecision& decision,
                     const Signal& out_of_range) {
    // The unit of the paper's decision has no `exceptional` input.
    MIXCMP_CHECK(out_of_range.value == nullptr);
    const datapath::Step& step = schedule_.parts[part].decision;
    const Operand minimum = builder_.at(builder_.value(decision.minimum), step.start_cycle);
    const Operand maximum = builder_.at(builder_.value(decision.maximum), step.start_cycle);
    PartDecision made = begin(part, "case I, II or III of the paper.");
    std::vector<Parameter> parameters = format_parameters(format_);
    parameters.push_back({"CUTS", cut_mask(step)});
    builder_.add(Instance{step.unit.module,
                          made.instance,
                          std::move(parameters),
                          {{"aclk", net("aclk")},
                           {"minimum", minimum},
                           {"maximum", maximum},
                           {"verdict", made.verdict.value},
                           {"decided", made.decided.value}}});
    return made;
  }

  PartDecision begin(std::size_t part, std::string_view what) {
    return begin_decision(builder_, schedule_.parts[part].decision, part, lane_.parts.size(),
                          Decides::sometimes, what);
  }

  DatapathBuilder& builder_;
  const error::Lane& lane_;
  const datapath::Schedule& schedule_;
  FloatFormat format_;
};

PartDecision build_comparison(DatapathBuilder& builder, const TypedGraph& reference,
                              std::size_t part, const datapath::Step& step) {
  const Arithmetic& arithmetic = reference.arithmetic;
  const auto [f_node, g_node] = reference.parts[part];
  const Operand f = builder.at(builder.value(f_node), step.start_cycle);
  const Operand g = builder.at(builder.value(g_node), step.start_cycle);
  PartDecision made = begin_decision(builder, step, part, reference.parts.size(), Decides::always,
                                     "the ordering of two rounded numbers.");
  std::vector<Parameter> parameters = format_parameters(arithmetic.format);
  parameters.push_back({"GRADUAL", arithmetic.subnormals == Subnormals::gradual ? 1 : 0});
  parameters.push_back({"CUTS", cut_mask(step)});
  builder.add(
      Instance{step.unit.module,
               made.instance,
               std::move(parameters),
               {{"aclk", net("aclk")}, {"a", f}, {"b", g}, {"verdict", made.verdict.value}}});
  return made;
}

/// Concatenates one signal of every part, delayed to `cycle`; part 0 is in the lowest bits.
Operand gathered(DatapathBuilder& builder, const std::vector<PartDecision>& parts,
                 Signal PartDecision::*signal, int cycle) {
  std::vector<Operand> fields;
  for (const PartDecision& part : parts) fields.push_back(builder.at(part.*signal, cycle));
  return concatenation({fields.rbegin(), fields.rend()});
}

/// Combines the parts' verdicts into one. A single part needs no combination.
void build_combination(DatapathBuilder& builder, Combination combination,
                       const std::vector<PartDecision>& parts, const datapath::Step& step) {
  if (parts.size() == 1) return;
  const bool any = combination == Combination::any;
  const int count = static_cast<int>(parts.size());
  const bool reference = parts.front().decided.value == nullptr;
  const Operand verdicts = gathered(builder, parts, &PartDecision::verdict, step.start_cycle);
  const Operand known = reference
                            ? literal(count, low_mask(count))
                            : gathered(builder, parts, &PartDecision::decided, step.start_cycle);
  builder.add(Comment{fmt::format("Cycles {} to {}: less if {}.", step.start_cycle,
                                  step.ready_cycle, any ? "any part is" : "all parts are")});
  const std::string decided = reference ? builder.pool().unique("unused_decided") : "decided";
  if (reference) builder.add(Wire{1, decided, nullptr});
  builder.add(Instance{step.unit.module,
                       builder.pool().unique("combination"),
                       {{"PARTS", count}, {"ANY", any ? 1 : 0}, {"CUTS", cut_mask(step)}},
                       {{"aclk", net("aclk")},
                        {"verdicts", verdicts},
                        {"known", known},
                        {"verdict", net("verdict")},
                        {"decided", net(decided)}}});
}

DatapathBuilder lane_pass(const std::vector<std::string>& inputs, const error::Lane& lane,
                          ExceptionalFlags exceptional, const datapath::Schedule& schedule,
                          DelayPlan plan) {
  DatapathBuilder builder(inputs, lane.graph, lane.hazards, schedule, exceptional, std::move(plan));
  const std::vector<Signal> out_of_range = build_range_checks(builder, lane, schedule);
  builder.build_nodes();
  LaneDecisions decisions(builder, lane, schedule);
  std::vector<PartDecision> parts;
  for (std::size_t part = 0; part < lane.parts.size(); ++part) {
    parts.push_back(decisions.build(part, out_of_range[part]));
  }
  build_combination(builder, lane.graph.combination, parts, schedule.combination);
  return builder;
}

DatapathBuilder reference_pass(const std::vector<std::string>& inputs, const TypedGraph& reference,
                               const datapath::Schedule& schedule, DelayPlan plan) {
  DatapathBuilder builder(inputs, reference, error::structural_hazards(reference), schedule,
                          ExceptionalFlags::unused, std::move(plan));
  builder.build_nodes();
  std::vector<PartDecision> parts;
  for (std::size_t part = 0; part < reference.parts.size(); ++part) {
    parts.push_back(build_comparison(builder, reference, part, schedule.parts[part].decision));
  }
  build_combination(builder, reference.combination, parts, schedule.combination);
  return builder;
}

}  // namespace

Module lane_module(std::string name, const std::vector<std::string>& inputs,
                   const error::Lane& lane, const datapath::Schedule& schedule) {
  const ExceptionalFlags exceptional =
      lane.certified() ? ExceptionalFlags::gathered : ExceptionalFlags::unused;
  const DelayPlan plan = lane_pass(inputs, lane, exceptional, schedule, {}).plan();
  DatapathBuilder builder = lane_pass(inputs, lane, exceptional, schedule, plan);
  std::vector<Port> ports = builder.data_ports();
  ports.push_back({Direction::output, 2, "verdict"});
  ports.push_back({Direction::output, 1, "decided"});
  return {std::move(name), {}, std::move(ports), builder.take()};
}

Module reference_module(std::string name, const std::vector<std::string>& inputs,
                        const TypedGraph& reference, const datapath::Schedule& schedule) {
  const DelayPlan plan = reference_pass(inputs, reference, schedule, {}).plan();
  DatapathBuilder builder = reference_pass(inputs, reference, schedule, plan);
  std::vector<Port> ports = builder.data_ports();
  ports.push_back({Direction::output, 2, "verdict"});
  return {std::move(name), {}, std::move(ports), builder.take()};
}

}  // namespace mixcmp::rtl
