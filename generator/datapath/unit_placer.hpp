#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "generator/datapath/schedule.hpp"

namespace mixcmp::datapath {

/// Places units in time, each with as few ranks of registers as the period allows.
class UnitPlacer {
public:
  UnitPlacer(const DelayTable& delays, double target_mhz)
      : delays_(delays), logic_ns_(std::max(0.0, 1000 / target_mhz - delays.register_ns)) {}

  const DelayTable& delays() const { return delays_; }

  /// Chooses the form of `unit`, whose operands are read in cycle `start`, and its registers.
  Step place(Unit unit, int start);
  /// Completes a schedule whose parts are placed: combines their verdicts, and sets the latency and
  /// the list of slow stages.
  Schedule finish(Schedule schedule);

private:
  std::vector<bool> choose_cuts(const Unit& unit);
  void note_slow(const Unit& unit, const Stage& stage);

  DelayTable delays_;
  double logic_ns_;
  std::vector<std::string> slow_stages_;
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
