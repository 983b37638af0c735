#pragma once

#include <string>
#include <vector>

#include "generator/datapath/units.hpp"
#include "model/error/combined_lane.hpp"
#include "model/scene/scene.hpp"

namespace mixcmp::gen {

/// One operation bound to a unit and placed in time. Cycle 0 is the cycle in which the operands of
/// a comparison are at the datapath's inputs.
struct Step {
  Unit unit;               ///< module is empty where the operation is only wires
  std::vector<bool> cuts;  ///< which cut points are registered; the last always is
  int start_cycle = 0;     ///< operands are read
  int ready_cycle = 0;     ///< the result is there
};

/// What turns f and g of one part into a verdict.
struct PartSchedule {
  std::vector<Step> bounds;      ///< one per node of a lane's absolute bound
  std::vector<Step> conditions;  ///< one per condition of that bound
  Step decision;
};

/// When each node of a graph is computed; every path is balanced by delays of
/// start_cycle - (ready_cycle of the operand).
struct Schedule {
  std::vector<Step> steps;   ///< one per node of the graph that all parts share
  std::vector<Step> checks;  ///< one per range check of a lane; wires where it is a sign alone
  std::vector<PartSchedule> parts;
  Step combination;        ///< of several parts' verdicts, once all are there; else nothing
  int latency_cycles = 0;  ///< from operands to verdict
  /// Stages that no cut can bring under the period, as estimated from the delay table.
  std::vector<std::string> slow_stages;
};

/// Schedules each operation as soon as possible, with as few registers in each unit as the period
/// (before routing, by the delay table) allows; a unit's output is always registered.
/// `target_mhz` > 0.
Schedule schedule_lane(const model::CombinedLane& lane, model::Multipliers multipliers,
                       const DelayTable& delays, double target_mhz);
Schedule schedule_reference(const model::CombinedGraph& reference, model::Multipliers multipliers,
                            const DelayTable& delays, double target_mhz);

}  // namespace mixcmp::gen
