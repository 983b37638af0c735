#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "generator/hardware/datapath/schedule.hpp"

namespace mixcmp::datapath {

/// Collects the steps of one datapath, each with as few ranks of registers as the period allows.
/// The nodes of its graph are placed in their order; everything else is placed after the nodes that
/// it reads.
class Scheduler {
public:
  Scheduler(const DelayTable& delays, double target_mhz)
      : delays_(delays), logic_ns_(std::max(0.0, 1000 / target_mhz - delays.register_ns)) {}

  const DelayTable& delays() const { return delays_; }
  Schedule& schedule() { return schedule_; }
  const Schedule& schedule() const { return schedule_; }

  /// A step that starts when the nodes `reads` are ready, but not before cycle `earliest`. Chooses
  /// the form of its unit, and the registers.
  Step place(Unit unit, const std::vector<NodeId>& reads, int earliest = 0);
  /// A step of only wires.
  Step wires(const std::vector<NodeId>& reads, int earliest = 0) const;

  /// Places the conversions of operands that arrive in the formats `arriving` into `format`; there
  /// are none if `arriving` is empty. A folded datapath has no registers in them.
  void widen(const std::vector<OperandFormat>& arriving, FloatFormat format,
             bool is_folded = false);

  /// Completes the schedule: combines the verdicts of the parts, and sets the latency and the list
  /// of slow stages.
  Schedule finish();

private:
  std::vector<bool> choose_cuts(const Unit& unit);
  void note_slow(const Unit& unit, const Stage& stage);

  DelayTable delays_;
  double logic_ns_;
  Schedule schedule_;
};

/// The operands that a node reads.
template <typename Node>
std::vector<int> operands_of(const Node& node) {
  return {node.operands.begin(), node.operands.begin() + arity(node.operation)};
}

/// The cycle in which all of `operands` are ready.
inline int ready_cycle(const std::vector<Step>& steps, const std::vector<int>& operands) {
  int cycle = 0;
  for (const int operand : operands) cycle = std::max(cycle, steps[operand].ready_cycle);
  return cycle;
}

}  // namespace mixcmp::datapath
