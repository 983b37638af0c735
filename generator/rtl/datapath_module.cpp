#include "generator/rtl/datapath_module.hpp"

#include <fmt/core.h>

#include "generator/rtl/bound_builder.hpp"
#include "generator/rtl/datapath_builder.hpp"
#include "generator/rtl/range_checks.hpp"
#include "model/common/check.hpp"
#include "model/error/hazards.hpp"

namespace mixcmp::gen {
namespace {

using namespace rtl;
using model::FloatFormat;
using model::TypedGraph;

std::vector<Parameter> format_parameters(FloatFormat format) {
  return {{"EXPONENT_BITS", format.exponent_bits()}, {"PRECISION", format.precision()}};
}

std::string decision_comment(const Step& step, std::string_view what) {
  return fmt::format("Cycles {} to {}: {}", step.start_cycle, step.ready_cycle, what);
}

void build_ulp_distance(DatapathBuilder& builder, const model::Lane& lane,
                        const model::UlpDistanceDecision& decision, const Signal& out_of_range,
                        const Step& step) {
  const TypedGraph& graph = lane.graph;
  const Operand f = builder.at(builder.value(graph.f), step.start_cycle);
  const Operand g = builder.at(builder.value(graph.g), step.start_cycle);
  const Operand doubtful = builder.any_at(
      {builder.flag(graph.f), builder.flag(graph.g), out_of_range}, step.start_cycle);
  builder.add(
      Comment{decision_comment(step, "certain where the encodings are GUARD_ULP or more apart.")});
  std::vector<Parameter> parameters = format_parameters(graph.arithmetic.format);
  parameters.push_back({"GUARD_ULP", Literal{graph.arithmetic.format.width(), decision.guard_ulp}});
  parameters.push_back({"NONNEGATIVE", decision.nonnegative ? 1 : 0});
  parameters.push_back({"CUTS", cut_mask(step)});
  builder.add(Instance{step.unit.module,
                       "decision",
                       std::move(parameters),
                       {{"aclk", net("aclk")},
                        {"f", f},
                        {"g", g},
                        {"exceptional", doubtful},
                        {"verdict", net("verdict")},
                        {"decided", net("decided")}}});
}

void build_absolute(DatapathBuilder& builder, const model::Lane& lane,
                    const model::AbsoluteBoundDecision& decision, const Signal& out_of_range,
                    const Schedule& schedule) {
  const FloatFormat format = lane.graph.arithmetic.format;
  const Step& step = schedule.decision;
  BoundBuilder bounds(builder, lane, decision, schedule);
  bounds.build();
  std::vector<Signal> doubts = bounds.failures();
  doubts.push_back(builder.flag(decision.difference));
  doubts.push_back(out_of_range);
  const Operand difference = builder.at(builder.value(decision.difference), step.start_cycle);
  const Operand bound = builder.at(bounds.bound(), step.start_cycle);
  const Operand doubtful = builder.any_at(doubts, step.start_cycle);
  builder.add(Comment{
      decision_comment(step, "certain where the difference exceeds the bound of its error.")});
  std::vector<Parameter> parameters = format_parameters(format);
  parameters.push_back({"BOUND_PRECISION", decision.bound.format.precision});
  parameters.push_back({"GUARD_ULP", Literal{format.width(), decision.guard_ulp}});
  parameters.push_back({"CUTS", cut_mask(step)});
  builder.add(Instance{step.unit.module,
                       "decision",
                       std::move(parameters),
                       {{"aclk", net("aclk")},
                        {"difference", difference},
                        {"bound", bound},
                        {"exceptional", doubtful},
                        {"verdict", net("verdict")},
                        {"decided", net("decided")}}});
}

void build_interval(DatapathBuilder& builder, const TypedGraph& graph,
                    const model::IntervalDecision& decision, const Step& step) {
  const Operand minimum = builder.at(builder.value(decision.minimum), step.start_cycle);
  const Operand maximum = builder.at(builder.value(decision.maximum), step.start_cycle);
  builder.add(Comment{decision_comment(step, "case I, II or III of the paper.")});
  std::vector<Parameter> parameters = format_parameters(graph.arithmetic.format);
  parameters.push_back({"CUTS", cut_mask(step)});
  builder.add(Instance{step.unit.module,
                       "decision",
                       std::move(parameters),
                       {{"aclk", net("aclk")},
                        {"minimum", minimum},
                        {"maximum", maximum},
                        {"verdict", net("verdict")},
                        {"decided", net("decided")}}});
}

void build_comparison(DatapathBuilder& builder, const TypedGraph& graph, const Step& step) {
  const Operand f = builder.at(builder.value(graph.f), step.start_cycle);
  const Operand g = builder.at(builder.value(graph.g), step.start_cycle);
  builder.add(Comment{decision_comment(step, "the ordering of two rounded numbers.")});
  std::vector<Parameter> parameters = format_parameters(graph.arithmetic.format);
  parameters.push_back(
      {"GRADUAL", graph.arithmetic.subnormals == model::Subnormals::gradual ? 1 : 0});
  parameters.push_back({"CUTS", cut_mask(step)});
  builder.add(Instance{step.unit.module,
                       "decision",
                       std::move(parameters),
                       {{"aclk", net("aclk")}, {"a", f}, {"b", g}, {"verdict", net("verdict")}}});
}

void build_lane_decision(DatapathBuilder& builder, const model::Lane& lane,
                         const Signal& out_of_range, const Schedule& schedule) {
  if (const auto* interval = std::get_if<model::IntervalDecision>(&lane.decision)) {
    // The paper's decision has no input for doubts.
    MIXCMP_CHECK(lane.checks.empty());
    build_interval(builder, lane.graph, *interval, schedule.decision);
  } else if (const auto* absolute = std::get_if<model::AbsoluteBoundDecision>(&lane.decision)) {
    build_absolute(builder, lane, *absolute, out_of_range, schedule);
  } else {
    build_ulp_distance(builder, lane, std::get<model::UlpDistanceDecision>(lane.decision),
                       out_of_range, schedule.decision);
  }
}

DatapathBuilder lane_pass(const std::vector<std::string>& inputs, const model::Lane& lane,
                          const Schedule& schedule, DelayPlan plan) {
  const ExceptionalFlags exceptional =
      lane.certified() ? ExceptionalFlags::gathered : ExceptionalFlags::unused;
  DatapathBuilder builder(inputs, lane.graph, lane.hazards, schedule, exceptional, std::move(plan));
  const Signal out_of_range = build_range_checks(builder, lane, schedule);
  builder.build_nodes();
  build_lane_decision(builder, lane, out_of_range, schedule);
  return builder;
}

DatapathBuilder reference_pass(const std::vector<std::string>& inputs, const TypedGraph& reference,
                               const Schedule& schedule, DelayPlan plan) {
  DatapathBuilder builder(inputs, reference, model::structural_hazards(reference), schedule,
                          ExceptionalFlags::unused, std::move(plan));
  builder.build_nodes();
  build_comparison(builder, reference, schedule.decision);
  return builder;
}

}  // namespace

Module lane_module(std::string name, const std::vector<std::string>& inputs,
                   const model::Lane& lane, const Schedule& schedule) {
  const DelayPlan plan = lane_pass(inputs, lane, schedule, {}).plan();
  DatapathBuilder builder = lane_pass(inputs, lane, schedule, plan);
  std::vector<Port> ports = builder.data_ports();
  ports.push_back({Direction::output, 2, "verdict"});
  ports.push_back({Direction::output, 1, "decided"});
  return {std::move(name), {}, std::move(ports), builder.take()};
}

Module reference_module(std::string name, const std::vector<std::string>& inputs,
                        const TypedGraph& reference, const Schedule& schedule) {
  const DelayPlan plan = reference_pass(inputs, reference, schedule, {}).plan();
  DatapathBuilder builder = reference_pass(inputs, reference, schedule, plan);
  std::vector<Port> ports = builder.data_ports();
  ports.push_back({Direction::output, 2, "verdict"});
  return {std::move(name), {}, std::move(ports), builder.take()};
}

}  // namespace mixcmp::gen
