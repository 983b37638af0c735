#include "generator/schematic/fixed_pipeline.hpp"

#include <fmt/core.h>

#include "generator/schematic/datapath_pipeline.hpp"
#include "generator/schematic/pipeline_maker.hpp"

namespace mixcmp::schematic {
namespace {

using datapath::Step;
using fixed::FixedLane;
using fixed::FixedNode;
using page::UnitRole;

/// The lane's nodes, filled in as far as their texts need. Formats are of no importance there.
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
  FixedBoxes(PipelineMaker& maker, const FixedLane& lane, const datapath::Schedule& schedule)
      : maker_(maker), lane_(lane), schedule_(schedule), texts_(nodes_for_texts(lane)) {}

  void add_nodes() {
    add_operands();
    for (std::size_t k = 0; k < lane_.nodes.size(); ++k) add_node(static_cast<NodeId>(k));
  }

  int add_decision(std::size_t part) {
    const fixed::FixedPart& decided = lane_.parts[part];
    std::vector<int> operands = {box(decided.difference)};
    operands.insert(operands.end(), checks_.begin(), checks_.end());
    const Step& threshold = schedule_.parts[part].threshold;
    if (threshold.unit.module.empty()) {
      for (const NodeId node : fixed::read_by(decided.criterion)) operands.push_back(box(node));
    } else {
      std::vector<int> watched;
      for (const NodeId node : fixed::read_by(decided.criterion)) watched.push_back(box(node));
      operands.push_back(maker_.add({.title = "threshold",
                                     .format = {},
                                     .meaning = "smaller where all that is multiplied is small",
                                     .role = UnitRole::bound},
                                    threshold, watched));
    }
    return maker_.add({.title = decision_title(part, lane_.parts.size()),
                       .format = "verdict, decided",
                       .meaning = describe_criterion(lane_),
                       .role = UnitRole::decision},
                      schedule_.parts[part].decision, operands);
  }

private:
  int box(NodeId node) const { return boxes_[static_cast<std::size_t>(node)]; }

  /// Adds the operands as they arrive and, in block floating point, the unit that finds their
  /// largest exponent.
  void add_operands() {
    for (const FixedNode& node : lane_.nodes) {
      if (node.operation != Operation::input) continue;
      const bool loaded = !lane_.loaded_inputs.empty();
      operands_.push_back(
          maker_.add_input(name_of(node), loaded ? node.format.name() : lane_.input_format.name()));
    }
    if (schedule_.largest_exponent.unit.module.empty()) return;
    exponent_ = maker_.add({.title = "largest exponent",
                            .format = {},
                            .meaning = "the power of two by which all operands are divided",
                            .role = UnitRole::arithmetic},
                           schedule_.largest_exponent, operands_);
  }

  void add_node(NodeId id) {
    const FixedNode& node = lane_.nodes[id];
    const Step& step = schedule_.steps[static_cast<std::size_t>(id)];
    if (node.operation == Operation::constant) return boxes_.push_back(PipelineMaker::none);
    if (node.operation == Operation::input && !lane_.loaded_inputs.empty()) {
      return boxes_.push_back(operands_[next_operand_++]);  // converted when it was loaded
    }
    std::vector<int> operands;
    for (int k = 0; k < arity(node.operation); ++k) operands.push_back(box(node.operands[k]));
    if (node.operation == Operation::input) {
      operands = {operands_[next_operand_++], exponent_};
    } else if (fixed::is_common_cut(node)) {
      operands.push_back(common_drop());
    }
    boxes_.push_back(maker_.add({.title = title(id),
                                 .format = node.format.name(),
                                 .meaning = meaning_of(texts_, lane_.input_names, id)},
                                step, operands));
    if (fixed::is_checked(node)) add_check(id);
  }

  int common_drop() {
    if (drop_ != PipelineMaker::none) return drop_;
    std::vector<int> cut;
    for (const NodeId node : fixed::cut_in_common(lane_)) cut.push_back(box(node));
    drop_ = maker_.add({.title = "common cut",
                        .format = {},
                        .meaning = "how many low bits are dropped of all of these",
                        .role = UnitRole::arithmetic},
                       schedule_.common_drop, cut);
    return drop_;
  }

  void add_check(NodeId id) {
    const Step& step = schedule_.checks[checks_.size()];
    const std::string what = fixed::is_reach(lane_.nodes[id]) ? "beyond reach?" : "within limits?";
    checks_.push_back(maker_.add({.title = what,
                                  .format = {},
                                  .meaning = meaning_of(texts_, lane_.input_names, id),
                                  .role = UnitRole::check},
                                 step, {box(lane_.nodes[id].operands[0])}));
  }

  std::string title(NodeId id) const {
    const FixedNode& node = lane_.nodes[id];
    if (node.operation == Operation::input) return "convert";
    if (node.operation != Operation::convert) {
      for (const fixed::FixedPart& part : lane_.parts) {
        if (part.difference == id) return part.swapped ? "g - f" : "f - g";
      }
      return title_of(texts_, lane_.input_names, id);
    }
    if (fixed::is_common_cut(node)) return "cut in common";
    if (fixed::is_limit(node)) return "limited";
    if (fixed::is_reach(node)) return "low bits";
    return fmt::format("drop {} bits", node.dropped_bits);
  }

  std::string name_of(const FixedNode& input) const {
    return lane_.input_names[static_cast<std::size_t>(input.input)];
  }

  PipelineMaker& maker_;
  const FixedLane& lane_;
  const datapath::Schedule& schedule_;
  std::vector<TypedNode> texts_;
  std::vector<int> operands_;  ///< of inputs, in the order of the nodes
  std::size_t next_operand_ = 0;
  std::vector<int> boxes_;  ///< [node]
  std::vector<int> checks_;
  int exponent_ = PipelineMaker::none;
  int drop_ = PipelineMaker::none;
};

}  // namespace

page::Pipeline fixed_lane_pipeline(const FixedLane& lane, const datapath::Schedule& schedule) {
  PipelineMaker maker;
  FixedBoxes boxes(maker, lane, schedule);
  boxes.add_nodes();
  std::vector<int> decisions;
  for (std::size_t part = 0; part < lane.parts.size(); ++part) {
    decisions.push_back(boxes.add_decision(part));
  }
  return maker.finish(fmt::format("Units of a lane in {}", lane.format.name()), schedule, decisions,
                      lane.combination);
}

page::Pipeline item_pipeline(const FixedLane& loader, const datapath::Schedule& schedule) {
  PipelineMaker maker;
  FixedBoxes(maker, loader, schedule).add_nodes();
  return maker.finish("Units of the conversion of an item", schedule, {}, loader.combination);
}

}  // namespace mixcmp::schematic
