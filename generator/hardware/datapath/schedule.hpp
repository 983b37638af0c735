#pragma once

#include <map>
#include <string>
#include <vector>

#include "generator/hardware/datapath/units.hpp"
#include "model/design/design.hpp"
#include "model/lane/fixed/square_tables.hpp"
#include "model/scene/scene.hpp"

namespace mixcmp::datapath {

/// One operation bound to a unit and placed in time. Cycle 0 is the cycle in which the operands of
/// a comparison are at the datapath's inputs, all in one format: see Schedule::entry_cycles.
struct Step {
  /// unit.module is empty if the operation is only wires, or is a sum that the unit of its square
  /// computes.
  Unit unit;
  std::vector<bool> cuts;          ///< which cut points are registers; the last always is
  int start_cycle = 0;             ///< the cycle in which the operands are read
  int ready_cycle = 0;             ///< the cycle in which the result is at the output
  std::vector<NodeId> reads = {};  ///< nodes of the graph, each once
};

/// The schedule of the units that turn f and g of one part into a verdict.
struct PartSchedule {
  std::vector<Step> bounds;      ///< one per node of a lane's absolute bound
  std::vector<Step> conditions;  ///< one per condition of that bound
  Step threshold = {};  ///< finds the threshold of a running bound in fixed point; else no unit
  Step decision;
};

/// A unit of a folded reference, shared by operations that start in different phases.
struct SharedUnit {
  Unit unit;
  std::vector<bool> cuts;
  std::vector<NodeId> operations;  ///< by their start cycles
  /// Operands are read through registers, since they come from several places. A unit without these
  /// registers has one operation, or reads all operands from one other unit in the cycles in which
  /// they leave it.
  bool selects = false;
};

/// The cycle in which each node of a graph is computed. All paths are balanced: an operand is
/// delayed by start_cycle of the operation that reads it, less its own ready_cycle.
struct Schedule {
  /// Cycles between the starts of two comparisons. Above 1 the reference is folded: in cycle c its
  /// phase is c modulo the interval, and the units are `shared_units`. A unit that selects reads
  /// operands in start_cycle into registers of its own.
  int initiation_interval = 1;
  std::vector<SharedUnit> shared_units;
  int last_operand_phase = 0;  ///< operands of the comparison have to stay until then
  /// Converts operands that arrive with fewer exponent bits than the datapath's inputs have: one
  /// per input, without a unit where the exponent fits. Empty: all fit.
  std::vector<Step> widenings;
  /// The cycles that the widest of these conversions takes. The other operands are delayed as long,
  /// and cycle 0 of all other steps is this many cycles behind the ports.
  int entry_cycles = 0;
  /// Finds the largest exponent of the operands in block floating point. Without block floating
  /// point it has no unit.
  Step largest_exponent;
  /// Finds how many bits the common cuts drop, with guard digits. Without guard digits it has no
  /// unit.
  Step common_drop;
  std::vector<Step> steps;  ///< one per node of the graph that all parts share
  /// In floating point there is one step per range check; a check of only the sign is wires. In
  /// fixed point there is one step per limit and reach.
  std::vector<Step> checks;
  /// The squares of a lane in fixed point that are read from memories; each also has a step.
  std::vector<fixed::SquareTable> square_tables;
  /// In fixed point: the sums that embedded multipliers make, each with the product that joins it.
  std::map<NodeId, NodeId> multiplier_sums = {};
  std::vector<PartSchedule> parts;
  Step combination;        ///< combines the verdicts of several parts; no unit for one part
  int latency_cycles = 0;  ///< from operands at the ports to verdict
  /// Stages that no cut can bring under the period, as estimated from the delay table.
  std::vector<std::string> slow_stages;
};

/// Schedules each operation as soon as possible, with as few registers in each unit as the period
/// (before routing, by the delay table) allows; a unit's output is always registered. In fixed
/// point, each operation that has time to spare then moves as late as possible, if that saves
/// registers: a product is wider than its operands, so it waits for the sum that it joins.
/// `target_mhz` > 0.
Schedule schedule_lane(const design::Lane& lane, scene::Multipliers multipliers,
                       const DelayTable& delays, double target_mhz);
Schedule schedule_reference(const design::ReferenceDatapath& reference,
                            const design::ReferenceStructure& structure, const DelayTable& delays,
                            double target_mhz);

}  // namespace mixcmp::datapath
