#include "generator/schematic/float_pipeline.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "generator/schematic/datapath_pipeline.hpp"
#include "generator/schematic/pipeline_maker.hpp"
#include "model/expression/text.hpp"

namespace mixcmp::schematic {
namespace {

using datapath::Step;
using page::UnitRole;

std::string name_of(const TypedGraph& graph, int input) {
  return graph.input_names[static_cast<std::size_t>(input)];
}

/// The boxes of a graph's nodes, in floating point.
class FloatBoxes {
public:
  FloatBoxes(PipelineMaker& maker, const TypedGraph& graph, const datapath::Schedule& schedule)
      : maker_(maker), graph_(graph) {
    for (std::size_t k = 0; k < graph.nodes.size(); ++k) {
      boxes_.push_back(add(static_cast<NodeId>(k), schedule.steps[k]));
    }
  }

  int box(NodeId node) const { return boxes_[static_cast<std::size_t>(node)]; }

  /// The boxes that a comparison of a reference reads.
  std::vector<int> compared(const Sides& part) const {
    const TypedNode& f = graph_.nodes[part.f];
    if (!f.is_sign_of_sum()) return {box(part.f), box(part.g)};
    std::vector<int> terms;
    for (const NodeId operand : operands_of(f)) terms.push_back(box(operand));
    return terms;
  }

  /// The boxes of these inputs.
  std::vector<int> inputs(const std::vector<int>& numbers) const {
    std::vector<int> found;
    for (std::size_t k = 0; k < graph_.nodes.size(); ++k) {
      const TypedNode& node = graph_.nodes[k];
      if (node.operation != Operation::input) continue;
      if (std::find(numbers.begin(), numbers.end(), node.input) == numbers.end()) continue;
      found.push_back(boxes_[k]);
    }
    return found;
  }

private:
  int add(NodeId id, const Step& step) {
    const TypedNode& node = graph_.nodes[id];
    if (node.operation == Operation::constant || node.is_sign_of_sum()) return PipelineMaker::none;
    if (node.operation == Operation::input) {
      return maker_.add_input(name_of(graph_, node.input), node.format.name());
    }
    std::vector<int> operands;
    for (const NodeId operand : operands_of(node)) operands.push_back(box(operand));
    return maker_.add({.title = side_of(id) + title_of(graph_.nodes, graph_.input_names, id),
                       .format = node.format.name(),
                       .meaning = meaning_of(graph_.nodes, graph_.input_names, id)},
                      step, operands);
  }

  /// "f: " and "g: " of the sides of a comparison, with their parts' numbers.
  std::string side_of(NodeId id) const {
    const std::size_t parts = graph_.parts.size();
    for (std::size_t part = 0; part < parts; ++part) {
      const std::string number = parts == 1 ? "" : fmt::format("[{}]", part);
      if (graph_.parts[part].f == id) return fmt::format("f{}: ", number);
      if (graph_.parts[part].g == id) return fmt::format("g{}: ", number);
    }
    return "";
  }

  PipelineMaker& maker_;
  const TypedGraph& graph_;
  std::vector<int> boxes_;  ///< [node]
};

/// The boxes that decide the parts of a lane.
class FloatDecisions {
public:
  FloatDecisions(PipelineMaker& maker, const FloatBoxes& boxes, const error::Lane& lane,
                 const datapath::Schedule& schedule)
      : maker_(maker), boxes_(boxes), lane_(lane), schedule_(schedule) {}

  int add(std::size_t part) {
    const auto operands_of = [&](const auto& criterion) { return operands(part, criterion); };
    std::vector<int> operands = std::visit(operands_of, lane_.parts[part].criterion);
    if (!lane_.parts[part].checks.empty()) operands.push_back(add_checks(part));
    return maker_.add({.title = decision_title(part, lane_.parts.size()),
                       .format = "verdict, decided",
                       .meaning = describe_criterion(lane_),
                       .role = UnitRole::decision},
                      schedule_.parts[part].decision, operands);
  }

private:
  std::vector<int> operands(std::size_t part, const error::UlpDistanceCriterion& /*relative*/) {
    const Sides& sides = lane_.graph.parts[part];
    return {boxes_.box(sides.f), boxes_.box(sides.g)};
  }

  std::vector<int> operands(std::size_t /*part*/, const error::IntervalCriterion& interval) {
    return {boxes_.box(interval.minimum), boxes_.box(interval.maximum)};
  }

  std::vector<int> operands(std::size_t part, const error::AbsoluteBoundCriterion& absolute) {
    std::vector<int> bounds;
    for (std::size_t k = 0; k < absolute.bound.nodes.size(); ++k) {
      bounds.push_back(add_bound(absolute.bound, k, schedule_.parts[part].bounds[k], bounds));
    }
    std::vector<int> operands = {boxes_.box(absolute.difference), bounds.back()};
    for (std::size_t k = 0; k < absolute.conditions.size(); ++k) {
      const error::BoundCondition& condition = absolute.conditions[k];
      operands.push_back(maker_.add({.title = "bound holds",
                                     .format = {},
                                     .meaning = "a condition of the bound",
                                     .role = UnitRole::check},
                                    schedule_.parts[part].conditions[k],
                                    {bounds[condition.bound], boxes_.box(condition.value)}));
    }
    return operands;
  }

  int add_bound(const error::BoundGraph& bound, std::size_t k, const Step& step,
                const std::vector<int>& before) {
    const error::BoundNode& node = bound.nodes[k];
    if (node.operation == error::BoundOperation::constant) return PipelineMaker::none;
    std::vector<int> operands;
    if (node.value >= 0) operands.push_back(boxes_.box(node.value));
    std::string factor;
    for (int i = 0; i < arity(node.operation); ++i) {
      const error::BoundNode& operand = bound.nodes[node.operands[i]];
      operands.push_back(before[node.operands[i]]);
      if (operand.operation != error::BoundOperation::constant) continue;
      factor = "by the constant " + expression::rounded_text(operand.constant, 4);
    }
    const bool last = k + 1 == bound.nodes.size();
    return maker_.add(
        {.title = fmt::format("{}{}", last ? "bound: " : "", to_string(node.operation)),
         .format = fmt::format("{} digits", bound.format.precision),
         .meaning = factor,
         .role = UnitRole::bound},
        step, operands);
  }

  /// Adds one box for all range checks of a part.
  int add_checks(std::size_t part) {
    Step all;
    std::vector<int> inputs;
    std::vector<std::string> names;
    for (const std::size_t k : lane_.parts[part].checks) {
      const Step& step = schedule_.checks[k];
      if (step.ready_cycle > all.ready_cycle || all.unit.module.empty()) all = step;
      inputs.push_back(lane_.checks[k].input);
      names.push_back(name_of(lane_.graph, lane_.checks[k].input));
    }
    return maker_.add({.title = "in range?",
                       .format = {},
                       .meaning = fmt::format("operands that break their declared ranges leave "
                                              "the comparison undecided: {}",
                                              fmt::join(names, ", ")),
                       .role = UnitRole::check},
                      all, boxes_.inputs(inputs));
  }

  PipelineMaker& maker_;
  const FloatBoxes& boxes_;
  const error::Lane& lane_;
  const datapath::Schedule& schedule_;
};

}  // namespace

page::Pipeline float_lane_pipeline(const error::Lane& lane, const datapath::Schedule& schedule) {
  PipelineMaker maker;
  const FloatBoxes boxes(maker, lane.graph, schedule);
  FloatDecisions decide(maker, boxes, lane, schedule);
  std::vector<int> decisions;
  for (std::size_t part = 0; part < lane.parts.size(); ++part)
    decisions.push_back(decide.add(part));
  return maker.finish(fmt::format("Units of a lane in {}", lane.graph.arithmetic.format.name()),
                      schedule, decisions, lane.graph.combination);
}

namespace {

std::string comparison_of(const TypedGraph& reference, std::size_t part) {
  const NodeId f = reference.parts[part].f;
  if (!reference.nodes[f].is_sign_of_sum()) return "the order of f and g as rounded";
  return meaning_of(reference.nodes, reference.input_names, f) + " against 0, without rounding it";
}

}  // namespace

page::Pipeline reference_pipeline(const TypedGraph& reference, const datapath::Schedule& schedule) {
  PipelineMaker maker;
  const FloatBoxes boxes(maker, reference, schedule);
  std::vector<int> decisions;
  for (std::size_t part = 0; part < reference.parts.size(); ++part) {
    decisions.push_back(maker.add({.title = decision_title(part, reference.parts.size()),
                                   .format = "verdict",
                                   .meaning = comparison_of(reference, part),
                                   .role = UnitRole::decision},
                                  schedule.parts[part].decision,
                                  boxes.compared(reference.parts[part])));
  }
  return maker.finish(fmt::format("Units of a reference in {}", reference.arithmetic.format.name()),
                      schedule, decisions, reference.combination);
}

}  // namespace mixcmp::schematic
