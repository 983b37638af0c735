#include "generator/datapath/schedule.hpp"

#include <algorithm>

#include "generator/datapath/fold.hpp"
#include "generator/datapath/fused_sum.hpp"
#include "generator/datapath/squared_sum.hpp"
#include "generator/datapath/unit_placer.hpp"
#include "model/error/hazards.hpp"

namespace mixcmp::datapath {
namespace {

/// Which sums are computed by the units of their squares.
std::vector<bool> sums_in_squares(const TypedGraph& graph, SquaredSums squared) {
  std::vector<bool> found(graph.nodes.size(), false);
  for (NodeId id = 0; id < static_cast<NodeId>(graph.nodes.size()); ++id) {
    found[id] = squared == SquaredSums::together && is_only_squared(graph, id);
  }
  return found;
}

class Scheduler {
public:
  Scheduler(const DelayTable& delays, double target_mhz)
      : placer_(delays, target_mhz), delays_(placer_.delays()) {}

  /// hazards: one per node; empty: nothing is ruled out.
  void place_nodes(const TypedGraph& graph, const std::vector<error::Hazards>& hazards,
                   scene::Multipliers multipliers, SquaredSums squared) {
    const std::vector<bool> inside = sums_in_squares(graph, squared);
    for (NodeId id = 0; id < static_cast<NodeId>(graph.nodes.size()); ++id) {
      const TypedNode& node = graph.nodes[id];
      const int start = ready_cycle(schedule_.steps, operands_of(node));
      if (inside[id] || !has_unit(node)) {
        schedule_.steps.push_back({.start_cycle = start, .ready_cycle = start});
      } else {
        const error::Hazards own = hazards.empty() ? error::Hazards{} : hazards[id];
        schedule_.steps.push_back(place(node_unit(graph, id, own, multipliers, squared), start));
      }
    }
  }

  void place_folded(const TypedGraph& graph, scene::Multipliers multipliers, int interval) {
    datapath::place_folded(graph, multipliers, interval, placer_, schedule_);
  }

  void place_checks(const std::vector<error::RangeCheck>& checks) {
    for (const error::RangeCheck& check : checks) {
      schedule_.checks.push_back(
          check.leading_bits == 0 ? Step{} : place(range_check_unit(check, delays_), 0));
    }
  }

  /// Places the bound, the conditions and the decision of one part of a lane.
  void decide(const error::LanePart& part, const TypedGraph& graph, const Sides& sides) {
    const FloatFormat format = graph.arithmetic.format;
    PartSchedule schedule;
    int start = 0;
    for (const std::size_t check : part.checks) {
      start = std::max(start, schedule_.checks[check].ready_cycle);
    }
    if (const auto* interval = std::get_if<error::IntervalCriterion>(&part.criterion)) {
      return decide(std::move(schedule), interval_decision_unit(format, delays_),
                    {interval->minimum, interval->maximum}, start);
    }
    if (const auto* absolute = std::get_if<error::AbsoluteBoundCriterion>(&part.criterion)) {
      place_bounds(*absolute, graph, schedule);
      for (const auto* beside : {&schedule.bounds, &schedule.conditions}) {
        for (const Step& step : *beside) start = std::max(start, step.ready_cycle);
      }
      return decide(std::move(schedule),
                    bound_decision_unit(format, absolute->bound.format, delays_),
                    {absolute->difference}, start);
    }
    decide(std::move(schedule), ulp_distance_unit(format, delays_), {sides.f, sides.g}, start);
  }

  /// Places the comparison of one part of a reference.
  void compare(const TypedGraph& graph, const Sides& part, scene::Multipliers multipliers,
               SquaredSums squared) {
    const TypedNode& f = graph.nodes[part.f];
    if (f.is_sign_of_sum()) {
      return decide({}, fused_comparison_unit(graph, f, squared, multipliers, delays_),
                    operands_of(f), 0);
    }
    decide({}, compare_unit(graph.arithmetic.format, delays_), {part.f, part.g}, 0);
  }

  Schedule finish() { return placer_.finish(std::move(schedule_)); }

private:
  Unit node_unit(const TypedGraph& graph, NodeId id, const error::Hazards& hazards,
                 scene::Multipliers multipliers, SquaredSums squared) const {
    const TypedNode& node = graph.nodes[id];
    if (node.operation == Operation::fused_sum) {
      return fused_sum_unit(graph, node, squared, multipliers, delays_);
    }
    if (squared == SquaredSums::together && squared_sum_of(graph, id)) {
      return squared_sum_unit(node.format, graph.arithmetic.subnormals, multipliers, delays_);
    }
    return unit_for(graph, node, hazards, multipliers, delays_);
  }

  void place_bounds(const error::AbsoluteBoundCriterion& criterion, const TypedGraph& graph,
                    PartSchedule& schedule) {
    const BoundFormat format = criterion.bound.format;
    for (const error::BoundNode& node : criterion.bound.nodes) {
      if (node.operation == error::BoundOperation::constant) {
        schedule.bounds.push_back({});
        continue;
      }
      const int start = node.value >= 0 ? schedule_.steps[node.value].ready_cycle
                                        : ready_cycle(schedule.bounds, operands_of(node));
      const FloatFormat value =
          node.value >= 0 ? graph.nodes[node.value].format : graph.arithmetic.format;
      schedule.bounds.push_back(place(bound_unit(node.operation, value, format, delays_), start));
    }
    for (const error::BoundCondition& condition : criterion.conditions) {
      const int start = std::max(schedule.bounds[condition.bound].ready_cycle,
                                 schedule_.steps[condition.value].ready_cycle);
      schedule.conditions.push_back(place(bound_at_most_unit(format, delays_), start));
    }
  }

  /// Places a decision as soon as the nodes `decided_from` are ready, but not before cycle `start`.
  void decide(PartSchedule schedule, Unit decision, const std::vector<NodeId>& decided_from,
              int start) {
    start = std::max(start, ready_cycle(schedule_.steps, decided_from));
    schedule.decision = place(std::move(decision), start);
    schedule_.parts.push_back(std::move(schedule));
  }

  Step place(Unit unit, int start) { return placer_.place(std::move(unit), start); }

  UnitPlacer placer_;
  const DelayTable& delays_;
  Schedule schedule_;
};

}  // namespace

Schedule schedule_lane(const error::Lane& lane, scene::Multipliers multipliers,
                       const DelayTable& delays, double target_mhz) {
  Scheduler scheduler(delays, target_mhz);
  scheduler.place_nodes(lane.graph, lane.hazards, multipliers, SquaredSums::apart);
  scheduler.place_checks(lane.checks);
  for (std::size_t k = 0; k < lane.parts.size(); ++k) {
    scheduler.decide(lane.parts[k], lane.graph, lane.graph.parts[k]);
  }
  return scheduler.finish();
}

Schedule schedule_reference(const TypedGraph& reference,
                            const design::ReferenceStructure& structure, const DelayTable& delays,
                            double target_mhz) {
  Scheduler scheduler(delays, target_mhz);
  const bool folded = structure.initiation_interval > 1;
  const SquaredSums squared = folded ? SquaredSums::apart : SquaredSums::together;
  if (folded) {
    scheduler.place_folded(reference, structure.multipliers, structure.initiation_interval);
  } else {
    scheduler.place_nodes(reference, error::structural_hazards(reference), structure.multipliers,
                          squared);
  }
  for (const Sides& part : reference.parts) {
    scheduler.compare(reference, part, structure.multipliers, squared);
  }
  Schedule schedule = scheduler.finish();
  if (folded) schedule.last_operand_phase = last_operand_phase(reference, schedule);
  return schedule;
}

}  // namespace mixcmp::datapath
