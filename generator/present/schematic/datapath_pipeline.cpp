#include "generator/present/schematic/datapath_pipeline.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "generator/present/schematic/pipeline_maker.hpp"
#include "model/comparison/expression/text.hpp"

namespace mixcmp::schematic {
namespace {

using datapath::Step;
using fixed::FixedLane;
using fixed::FixedNode;
using page::UnitRole;

/// "f: " and "g: " of the sides of a comparison, with their parts' numbers.
std::string side_of(const TypedGraph& graph, NodeId id) {
  const std::size_t parts = graph.parts.size();
  for (std::size_t part = 0; part < parts; ++part) {
    const std::string number = parts == 1 ? "" : fmt::format("[{}]", part);
    if (graph.parts[part].f == id) return fmt::format("f{}: ", number);
    if (graph.parts[part].g == id) return fmt::format("g{}: ", number);
  }
  return "";
}

void add_nodes(PipelineMaker& maker, const TypedGraph& graph, const datapath::Schedule& schedule) {
  for (NodeId id = 0; id < static_cast<NodeId>(graph.nodes.size()); ++id) {
    const TypedNode& node = graph.nodes[id];
    const std::string format = node.format.name();
    if (node.operation == Operation::constant || node.is_sign_of_sum()) {
      maker.add_node(PipelineMaker::none);
    } else if (node.operation == Operation::input) {
      maker.add_node(maker.add_input(node.input, graph.operand_format(node.input).name()));
    } else {
      maker.add_node(side_of(graph, id) + maker.title_of(id), format,
                     maker.read_by(schedule.steps[static_cast<std::size_t>(id)]));
    }
  }
}

int add_bound(PipelineMaker& maker, const error::BoundGraph& bound, std::size_t k, const Step& step,
              const std::vector<int>& before) {
  const error::BoundNode& node = bound.nodes[k];
  if (node.operation == error::BoundOperation::constant) return PipelineMaker::none;
  std::vector<int> operands = maker.read_by(step);
  std::string factor;
  for (int i = 0; i < arity(node.operation); ++i) {
    const error::BoundNode& operand = bound.nodes[node.operands[i]];
    operands.push_back(before[node.operands[i]]);
    if (operand.operation != error::BoundOperation::constant) continue;
    factor = "by the constant " + expression::rounded_text(operand.constant, 4);
  }
  const bool last = k + 1 == bound.nodes.size();
  return maker.add({.title = fmt::format("{}{}", last ? "bound: " : "", to_string(node.operation)),
                    .format = fmt::format("{} digits", bound.format.precision),
                    .meaning = factor,
                    .role = UnitRole::bound},
                   step, operands);
}

/// Adds a bound and its conditions. Returns the boxes that the decision reads.
std::vector<int> add_bounds(PipelineMaker& maker, const error::AbsoluteBoundCriterion& absolute,
                            const datapath::PartSchedule& schedule) {
  std::vector<int> bounds;
  for (std::size_t k = 0; k < absolute.bound.nodes.size(); ++k) {
    bounds.push_back(add_bound(maker, absolute.bound, k, schedule.bounds[k], bounds));
  }
  std::vector<int> found = {bounds.back()};
  for (std::size_t k = 0; k < absolute.conditions.size(); ++k) {
    const Step& step = schedule.conditions[k];
    std::vector<int> operands = maker.read_by(step);
    operands.insert(operands.begin(), bounds[absolute.conditions[k].bound]);
    found.push_back(maker.add(
        {.title = "bound holds", .meaning = "a condition of the bound", .role = UnitRole::check},
        step, operands));
  }
  return found;
}

/// Adds one box for all range checks of a part.
int add_checks(PipelineMaker& maker, const error::Lane& lane, std::size_t part,
               const datapath::Schedule& schedule) {
  Step all;
  std::vector<NodeId> reads;
  std::vector<std::string> names;
  for (const std::size_t k : lane.parts[part].checks) {
    const Step& step = schedule.checks[k];
    if (step.ready_cycle > all.ready_cycle || all.unit.module.empty()) all = step;
    reads.insert(reads.end(), step.reads.begin(), step.reads.end());
    names.push_back(maker.name_of(lane.checks[k].input));
  }
  std::sort(reads.begin(), reads.end());
  all.reads = std::move(reads);
  return maker.add({.title = "in range?",
                    .meaning = fmt::format("operands that break their declared ranges leave "
                                           "the comparison undecided: {}",
                                           fmt::join(names, ", ")),
                    .role = UnitRole::check},
                   all, maker.read_by(all));
}

page::Pipeline pipeline_of(const error::Lane& lane, const datapath::Schedule& schedule) {
  PipelineMaker maker(lane.graph.nodes, lane.graph.input_names, schedule);
  add_nodes(maker, lane.graph, schedule);
  for (std::size_t part = 0; part < lane.parts.size(); ++part) {
    const datapath::PartSchedule& placed = schedule.parts[part];
    std::vector<int> operands = maker.read_by(placed.decision);
    const auto* absolute = std::get_if<error::AbsoluteBoundCriterion>(&lane.parts[part].criterion);
    if (absolute != nullptr) {
      const std::vector<int> bounds = add_bounds(maker, *absolute, placed);
      operands.insert(operands.end(), bounds.begin(), bounds.end());
    }
    if (!lane.parts[part].checks.empty()) {
      operands.push_back(add_checks(maker, lane, part, schedule));
    }
    maker.add_decision("verdict, decided", describe_criterion(lane), operands);
  }
  return maker.finish(fmt::format("Units of a lane in {}", lane.graph.arithmetic.format.name()),
                      lane.graph.combination);
}

/// The lane's nodes, filled in as far as their texts need.
std::vector<TypedNode> nodes_for_texts(const FixedLane& lane) {
  std::vector<TypedNode> nodes;
  for (const FixedNode& node : lane.nodes) {
    nodes.push_back({.operation = node.operation,
                     .operands = node.operands,
                     .operand_format = lane.input_format,
                     .format = lane.input_format,
                     .input = node.input,
                     .value = node.format.unit() * node.constant});
  }
  return nodes;
}

/// The boxes of a lane in fixed point.
class FixedBoxes {
public:
  FixedBoxes(const FixedLane& lane, const datapath::Schedule& schedule)
      : lane_(lane),
        schedule_(schedule),
        maker_(nodes_for_texts(lane), lane.input_names, schedule) {}

  page::Pipeline run(const std::string& title) {
    add_operands();
    for (std::size_t k = 0; k < lane_.nodes.size(); ++k) add_node(static_cast<NodeId>(k));
    for (const datapath::PartSchedule& part : schedule_.parts) add_decision(part);
    return maker_.finish(title, lane_.combination);
  }

private:
  /// Adds the operands as they arrive and, in block floating point, the unit that finds their
  /// largest exponent.
  void add_operands() {
    for (const FixedNode& node : lane_.nodes) {
      if (node.operation != Operation::input) continue;
      const std::string format = lane_.loaded_inputs.empty()
                                     ? fixed::operand_format(lane_, node.input).name()
                                     : node.format.name();
      operands_.push_back(maker_.add_input(node.input, format));
    }
    if (schedule_.largest_exponent.unit.module.empty()) return;
    exponent_ = maker_.add({.title = "largest exponent",
                            .meaning = "the power of two by which all operands are divided"},
                           schedule_.largest_exponent, operands_);
  }

  void add_node(NodeId id) {
    const FixedNode& node = lane_.nodes[id];
    if (node.operation == Operation::constant) return maker_.add_node(PipelineMaker::none);
    if (fixed::is_read_as_it_arrives(lane_, node)) {
      return maker_.add_node(operands_[next_operand_++]);
    }
    std::vector<int> operands = maker_.read_by(schedule_.steps[static_cast<std::size_t>(id)]);
    if (node.operation == Operation::input) {
      operands = {operands_[next_operand_++], exponent_};
    } else if (fixed::is_common_cut(node)) {
      operands.push_back(common_drop());
    }
    maker_.add_node(title(id), node.format.name(), operands);
    if (fixed::is_checked(node)) add_check(id);
  }

  int common_drop() {
    if (drop_ != PipelineMaker::none) return drop_;
    drop_ = maker_.add(
        {.title = "common cut", .meaning = "how many low bits are dropped of all of these"},
        schedule_.common_drop, maker_.read_by(schedule_.common_drop));
    return drop_;
  }

  void add_check(NodeId id) {
    const Step& step = schedule_.checks[checks_.size()];
    const std::string what = fixed::is_reach(lane_.nodes[id]) ? "beyond reach?" : "within limits?";
    checks_.push_back(
        maker_.add({.title = what, .meaning = maker_.meaning_of(id), .role = UnitRole::check}, step,
                   maker_.read_by(step)));
  }

  void add_decision(const datapath::PartSchedule& part) {
    std::vector<int> operands = maker_.read_by(part.decision);
    operands.insert(operands.begin() + 1, checks_.begin(), checks_.end());  // behind the difference
    if (!part.threshold.unit.module.empty()) {
      operands.push_back(maker_.add({.title = "threshold",
                                     .meaning = "smaller where all that is multiplied is small",
                                     .role = UnitRole::bound},
                                    part.threshold, maker_.read_by(part.threshold)));
    }
    maker_.add_decision("verdict, decided", describe_criterion(lane_), operands);
  }

  std::string title(NodeId id) const {
    const FixedNode& node = lane_.nodes[id];
    if (node.operation == Operation::input) return "convert";
    if (node.operation == Operation::look_up) {
      const std::string function = to_string(*node.function);
      if (node.function->kind() == Function::sign) return function;
      return node.power < 0 ? function + ": start" : fmt::format("{}: c{}", function, node.power);
    }
    if (node.operation != Operation::convert) {
      for (const fixed::FixedPart& part : lane_.parts) {
        if (part.difference == id) return part.swapped ? "g - f" : "f - g";
      }
      return maker_.title_of(id);
    }
    if (fixed::is_common_cut(node)) return "cut in common";
    if (fixed::is_floating_code(node)) return "leading one";
    if (node.conversion == fixed::Conversion::place) return "t";
    if (node.function) return applied_text(*node.function, "x");
    if (fixed::is_limit(node)) return "limited";
    if (fixed::is_reach(node)) return "low bits";
    return fmt::format("drop {} bits", node.dropped_bits);
  }

  const FixedLane& lane_;
  const datapath::Schedule& schedule_;
  PipelineMaker maker_;
  std::vector<int> operands_;  ///< of inputs, in the order of the nodes
  std::size_t next_operand_ = 0;
  std::vector<int> checks_;
  int exponent_ = PipelineMaker::none;
  int drop_ = PipelineMaker::none;
};

page::Pipeline pipeline_of(const FixedLane& lane, const datapath::Schedule& schedule) {
  return FixedBoxes(lane, schedule).run(fmt::format("Units of a lane in {}", lane.format.name()));
}

std::string comparison_of(const PipelineMaker& maker, const TypedGraph& reference,
                          std::size_t part) {
  const NodeId f = reference.parts[part].f;
  if (!reference.nodes[f].is_sign_of_sum()) return "the order of f and g as rounded";
  return maker.meaning_of(f) + " against 0, without rounding it";
}

}  // namespace

page::Pipeline lane_pipeline(const design::Lane& lane, const datapath::Schedule& schedule) {
  return std::visit([&](const auto& made) { return pipeline_of(made, schedule); }, lane);
}

page::Pipeline item_pipeline(const FixedLane& loader, const datapath::Schedule& schedule) {
  return FixedBoxes(loader, schedule).run("Units of the conversion of an item");
}

page::Pipeline reference_pipeline(const design::ReferenceDatapath& datapath,
                                  const datapath::Schedule& schedule) {
  const std::string title = "Units of a reference in " + design::format_name(datapath);
  if (const auto* const exact = std::get_if<FixedLane>(&datapath)) {
    return FixedBoxes(*exact, schedule).run(title);
  }
  const auto& reference = std::get<TypedGraph>(datapath);
  PipelineMaker maker(reference.nodes, reference.input_names, schedule);
  add_nodes(maker, reference, schedule);
  for (std::size_t part = 0; part < reference.parts.size(); ++part) {
    maker.add_decision("verdict", comparison_of(maker, reference, part),
                       maker.read_by(schedule.parts[part].decision));
  }
  return maker.finish(title, reference.combination);
}

}  // namespace mixcmp::schematic
