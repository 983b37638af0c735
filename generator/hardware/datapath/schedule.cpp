#include "generator/hardware/datapath/schedule.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "generator/hardware/datapath/fixed_units.hpp"
#include "generator/hardware/datapath/fold.hpp"
#include "generator/hardware/datapath/fused_sum.hpp"
#include "generator/hardware/datapath/multiplier_sums.hpp"
#include "generator/hardware/datapath/scheduler.hpp"
#include "generator/hardware/datapath/squared_sum.hpp"
#include "model/base/common/cases.hpp"
#include "model/base/common/check.hpp"
#include "model/lane/error/hazards.hpp"

namespace mixcmp::datapath {
namespace {

using fixed::FixedLane;
using fixed::FixedNode;

/// The latest cycle in which one of `steps` is ready.
int last_ready_cycle(const std::vector<Step>& steps) {
  int cycle = 0;
  for (const Step& step : steps) cycle = std::max(cycle, step.ready_cycle);
  return cycle;
}

/// Which sums are computed by the units of their squares.
std::vector<bool> sums_in_squares(const TypedGraph& graph, SquaredSums squared) {
  std::vector<bool> found(graph.nodes.size(), false);
  for (NodeId id = 0; id < static_cast<NodeId>(graph.nodes.size()); ++id) {
    found[id] = squared == SquaredSums::together && is_only_squared(graph, id);
  }
  return found;
}

/// Schedules graphs in floating point.
class FloatScheduler : public Scheduler {
public:
  FloatScheduler(const TypedGraph& graph, scene::Multipliers multipliers, SquaredSums squared,
                 const DelayTable& delays, double target_mhz)
      : Scheduler(delays, target_mhz),
        graph_(graph),
        multipliers_(multipliers),
        squared_(squared) {}

  /// hazards: one per node; empty: nothing is ruled out.
  void place_nodes(const std::vector<error::Hazards>& hazards) {
    const std::vector<bool> inside = sums_in_squares(graph_, squared_);
    for (NodeId id = 0; id < static_cast<NodeId>(graph_.nodes.size()); ++id) {
      const TypedNode& node = graph_.nodes[id];
      const error::Hazards own = hazards.empty() ? error::Hazards{} : hazards[id];
      schedule().steps.push_back(inside[id] || !has_unit(node)
                                     ? wires(operands_of(node))
                                     : place(node_unit(id, own), operands_of(node)));
    }
  }

  void place_checks(const std::vector<error::RangeCheck>& checks) {
    for (const error::RangeCheck& check : checks) {
      schedule().checks.push_back(check.leading_bits == 0 ? wires(nodes_of(check.input))
                                                          : place(range_check_unit(check, delays()),
                                                                  nodes_of(check.input)));
    }
  }

  /// Places the bound, the conditions and the decision of one part of a lane.
  void decide(const error::LanePart& part, const Sides& sides) {
    PartSchedule placed;
    int earliest = 0;
    for (const std::size_t check : part.checks) {
      earliest = std::max(earliest, schedule().checks[check].ready_cycle);
    }
    const FloatFormat format = graph_.arithmetic.format;
    placed.decision = std::visit(
        Cases{[&](const error::UlpDistanceCriterion&) {
                return place(ulp_distance_unit(format, delays()), {sides.f, sides.g}, earliest);
              },
              [&](const error::IntervalCriterion& interval) {
                return place(interval_decision_unit(format, delays()),
                             {interval.minimum, interval.maximum}, earliest);
              },
              [&](const error::AbsoluteBoundCriterion& absolute) {
                place_bounds(absolute, placed);
                earliest = std::max({earliest, last_ready_cycle(placed.bounds),
                                     last_ready_cycle(placed.conditions)});
                return place(bound_decision_unit(format, absolute.bound.format, delays()),
                             {absolute.difference}, earliest);
              }},
        part.criterion);
    schedule().parts.push_back(std::move(placed));
  }

  /// Places the comparison of one part of a reference.
  void compare(const Sides& part) {
    const TypedNode& f = graph_.nodes[part.f];
    PartSchedule& placed = schedule().parts.emplace_back();
    placed.decision =
        f.is_sign_of_sum()
            ? place(fused_comparison_unit(graph_, f, squared_, multipliers_, delays()),
                    operands_of(f))
            : place(compare_unit(graph_.arithmetic.format, delays()), {part.f, part.g});
  }

private:
  Unit node_unit(NodeId id, const error::Hazards& hazards) const {
    const TypedNode& node = graph_.nodes[id];
    if (node.operation == Operation::fused_sum) {
      return fused_sum_unit(graph_, node, squared_, multipliers_, delays());
    }
    if (squared_ == SquaredSums::together && squared_sum_of(graph_, id)) {
      return squared_sum_unit(node.format, graph_.arithmetic.subnormals, multipliers_, delays());
    }
    return unit_for(graph_, node, hazards, multipliers_, delays());
  }

  std::vector<NodeId> nodes_of(int input) const {
    std::vector<NodeId> found;
    for (NodeId id = 0; id < static_cast<NodeId>(graph_.nodes.size()); ++id) {
      const TypedNode& node = graph_.nodes[id];
      if (node.operation == Operation::input && node.input == input) found.push_back(id);
    }
    return found;
  }

  void place_bounds(const error::AbsoluteBoundCriterion& criterion, PartSchedule& placed) {
    const BoundFormat format = criterion.bound.format;
    for (const error::BoundNode& node : criterion.bound.nodes) {
      if (node.operation == error::BoundOperation::constant) {
        placed.bounds.push_back({});
        continue;
      }
      const bool reads_value = node.value >= 0;
      const FloatFormat value =
          reads_value ? graph_.nodes[node.value].format : graph_.arithmetic.format;
      Unit unit = bound_unit(node.operation, value, format, delays());
      placed.bounds.push_back(
          reads_value ? place(std::move(unit), {node.value})
                      : place(std::move(unit), {}, ready_cycle(placed.bounds, operands_of(node))));
    }
    for (const error::BoundCondition& condition : criterion.conditions) {
      placed.conditions.push_back(place(bound_at_most_unit(format, delays()), {condition.value},
                                        placed.bounds[condition.bound].ready_cycle));
    }
  }

  const TypedGraph& graph_;
  scene::Multipliers multipliers_;
  SquaredSums squared_;
};

/// Schedules lanes in fixed point.
class FixedScheduler : public Scheduler {
public:
  FixedScheduler(const FixedLane& lane, scene::Multipliers multipliers, const DelayTable& delays,
                 double target_mhz)
      : Scheduler(delays, target_mhz), lane_(lane), multipliers_(multipliers) {}

  Schedule run() {
    widen(fixed::arriving_formats(lane_), lane_.input_format);
    if (multipliers_ == scene::Multipliers::memory) {
      const devices::MemoryBlock& block = delays().memory_block;
      schedule().square_tables = fixed::square_tables(lane_, block.read_ports, block.bits);
    }
    if (multipliers_ == scene::Multipliers::embedded) {
      schedule().multiplier_sums = multiplier_sums(lane_, delays());
      for (const auto& [sum, product] : schedule().multiplier_sums) joining_.insert(product);
    }
    if (lane_.format.is_block) {
      schedule().largest_exponent = place(block_exponent_unit(lane_, delays()), {});
    }
    for (const FixedNode& node : lane_.nodes) place_node(node);
    for (const fixed::FixedPart& part : lane_.parts) place_decision(part);
    outputs_cycle_ = ready_cycle(schedule().steps, lane_.outputs);
    for (auto id = static_cast<NodeId>(lane_.nodes.size()); id-- > 0;) move_later(id);
    Schedule made = finish();
    made.latency_cycles = std::max(made.latency_cycles, made.entry_cycles + outputs_cycle_);
    return made;
  }

private:
  void place_node(const FixedNode& node) {
    if (node.operation == Operation::constant || fixed::is_read_as_it_arrives(lane_, node)) {
      return schedule().steps.push_back({});
    }
    if (fixed::is_common_cut(node)) return place_common_cut(node);
    if (fixed::is_wires(node)) {
      schedule().steps.push_back(wires(operands_of(node)));
      if (!fixed::is_checked(node)) return;
      return schedule().checks.push_back(
          place(check_unit(lane_, node, delays()), operands_of(node)));
    }
    const bool is_input = node.operation == Operation::input;
    const auto id = static_cast<NodeId>(schedule().steps.size());
    Step step = place(unit_of(node), operands_of(node),
                      is_input ? schedule().largest_exponent.ready_cycle : 0);
    if (joining_.contains(id)) leave_one_register(step);
    schedule().steps.push_back(std::move(step));
  }

  /// A product that joins a sum has only the register between multiplier and adder.
  static void leave_one_register(Step& step) {
    step.cuts = {true, false};
    step.ready_cycle = step.start_cycle + 1;
  }

  /// Places a common cut. All operands of common cuts are placed before the first cut.
  void place_common_cut(const FixedNode& node) {
    Step& drop = schedule().common_drop;
    if (drop.unit.module.empty()) {
      drop = place(common_drop_unit(lane_, delays()), fixed::cut_in_common(lane_));
    }
    schedule().steps.push_back(place(fixed_unit(lane_, node, multipliers_, delays()),
                                     operands_of(node), drop.ready_cycle));
  }

  void place_decision(const fixed::FixedPart& part) {
    PartSchedule placed;
    int earliest = last_ready_cycle(schedule().checks);
    std::vector<NodeId> reads = {part.difference};
    if (const auto* norm = std::get_if<fixed::NormThresholds>(&part.criterion)) {
      reads.push_back(norm->radius);
    }
    if (const auto* running = std::get_if<fixed::RunningThresholds>(&part.criterion)) {
      placed.threshold = place(step_threshold_unit(*running, delays()), running->watched);
      earliest = std::max(earliest, placed.threshold.ready_cycle);
    }
    placed.decision = place(fixed_decision_unit(lane_, part, delays()), reads, earliest);
    schedule().parts.push_back(std::move(placed));
  }

  /// The unit of the node that is placed next.
  Unit unit_of(const FixedNode& node) const {
    const auto id = static_cast<NodeId>(schedule().steps.size());
    const auto* table = fixed::table_of(schedule().square_tables, id);
    if (table != nullptr) return memory_square_unit(*table, delays());
    return schedule().multiplier_sums.contains(id)
               ? multiplier_sum_unit(delays())
               : fixed_unit(lane_, node, multipliers_, delays());
  }

  /// Moves a node to the cycle in which its result is needed first, if that takes fewer registers,
  /// or if it is a product that joins a sum. The readers of the node have been moved before.
  void move_later(NodeId id) {
    const FixedNode& node = lane_.nodes[id];
    if (arity(node.operation) == 0 || fixed::is_common_cut(node)) return;
    const std::vector<int> uses = uses_of(id);
    const int cycles =
        *std::min_element(uses.begin(), uses.end()) - schedule().steps[id].ready_cycle;
    const long before = register_bits(id);
    shift(id, cycles);
    if (register_bits(id) >= before && !joining_.contains(id)) shift(id, -cycles);
  }

  void shift(NodeId id, int cycles) {
    schedule().steps[id].start_cycle += cycles;
    schedule().steps[id].ready_cycle += cycles;
  }

  /// The registers that delay a node and its operands.
  long register_bits(NodeId id) const {
    long bits = delay_bits(id);
    for (const NodeId operand : schedule().steps[id].reads) bits += delay_bits(operand);
    return bits;
  }

  long delay_bits(NodeId id) const {
    const FixedNode& node = lane_.nodes[id];
    if (node.operation == Operation::constant) return 0;
    const std::vector<int> uses = uses_of(id);
    const int last = *std::max_element(uses.begin(), uses.end());
    return static_cast<long>(node.format.width) * (last - schedule().steps[id].ready_cycle);
  }

  /// The cycles in which a node's result is read.
  std::vector<int> uses_of(NodeId id) const {
    std::vector<int> cycles;
    const auto contains = [id](const std::vector<NodeId>& nodes) {
      return std::find(nodes.begin(), nodes.end(), id) != nodes.end();
    };
    const auto use = [&](const Step& step) {
      if (contains(step.reads)) cycles.push_back(step.start_cycle);
    };
    for (const Step& step : schedule().steps) use(step);
    for (const Step& step : schedule().checks) use(step);
    use(schedule().common_drop);
    for (const PartSchedule& part : schedule().parts) {
      use(part.threshold);
      use(part.decision);
    }
    if (contains(lane_.outputs)) cycles.push_back(outputs_cycle_);
    MIXCMP_CHECK(!cycles.empty());
    return cycles;
  }

  const FixedLane& lane_;
  scene::Multipliers multipliers_;
  std::set<NodeId> joining_;  ///< the products that join sums in multipliers
  int outputs_cycle_ = 0;     ///< the cycle in which all outputs are read
};

Schedule scheduled(const error::Lane& lane, scene::Multipliers multipliers,
                   const DelayTable& delays, double target_mhz) {
  FloatScheduler scheduler(lane.graph, multipliers, SquaredSums::apart, delays, target_mhz);
  scheduler.widen(lane.graph.arriving, lane.graph.input_format);
  scheduler.place_nodes(lane.hazards);
  scheduler.place_checks(lane.checks);
  for (std::size_t k = 0; k < lane.parts.size(); ++k) {
    scheduler.decide(lane.parts[k], lane.graph.parts[k]);
  }
  return scheduler.finish();
}

Schedule scheduled(const FixedLane& lane, scene::Multipliers multipliers, const DelayTable& delays,
                   double target_mhz) {
  return FixedScheduler(lane, multipliers, delays, target_mhz).run();
}

Schedule scheduled(const TypedGraph& reference, const design::ReferenceStructure& structure,
                   const DelayTable& delays, double target_mhz) {
  const bool folded = structure.initiation_interval > 1;
  FloatScheduler scheduler(reference, structure.multipliers,
                           folded ? SquaredSums::apart : SquaredSums::together, delays, target_mhz);
  scheduler.widen(reference.arriving, reference.input_format, folded);
  if (folded) {
    place_folded(reference, structure.multipliers, structure.initiation_interval, scheduler);
  } else {
    scheduler.place_nodes(error::structural_hazards(reference));
  }
  for (const Sides& part : reference.parts) scheduler.compare(part);
  Schedule schedule = scheduler.finish();
  if (folded) schedule.last_operand_phase = last_operand_phase(reference, schedule);
  return schedule;
}

}  // namespace

Schedule schedule_lane(const design::Lane& lane, scene::Multipliers multipliers,
                       const DelayTable& delays, double target_mhz) {
  return std::visit(
      [&](const auto& made) { return scheduled(made, multipliers, delays, target_mhz); }, lane);
}

Schedule schedule_reference(const design::ReferenceDatapath& reference,
                            const design::ReferenceStructure& structure, const DelayTable& delays,
                            double target_mhz) {
  return std::visit(Cases{[&](const TypedGraph& graph) {
                            return scheduled(graph, structure, delays, target_mhz);
                          },
                          [&](const fixed::FixedLane& lane) {
                            return scheduled(lane, structure.multipliers, delays, target_mhz);
                          }},
                    reference);
}

}  // namespace mixcmp::datapath
