#include "generator/datapath/fixed_schedule.hpp"

#include <algorithm>

#include "generator/datapath/fixed_units.hpp"
#include "generator/datapath/unit_placer.hpp"
#include "model/common/check.hpp"

namespace mixcmp::datapath {
namespace {

using fixed::FixedLane;
using fixed::FixedNode;

/// The nodes that the decision of a part reads.
std::vector<NodeId> decided_from(const fixed::FixedPart& part) {
  const auto* norm = std::get_if<fixed::NormThresholds>(&part.criterion);
  if (norm == nullptr) return {part.difference};
  return {part.difference, norm->radius};
}

/// The nodes that set the threshold of a running bound.
std::vector<NodeId> watched_by(const fixed::FixedPart& part) {
  const auto* running = std::get_if<fixed::RunningThresholds>(&part.criterion);
  return running == nullptr ? std::vector<NodeId>() : running->watched;
}

bool contains(const std::vector<NodeId>& nodes, NodeId id) {
  return std::find(nodes.begin(), nodes.end(), id) != nodes.end();
}

class FixedScheduler {
public:
  FixedScheduler(const FixedLane& lane, scene::Multipliers multipliers, const DelayTable& delays,
                 double target_mhz)
      : lane_(lane), multipliers_(multipliers), placer_(delays, target_mhz) {}

  Schedule run() {
    if (multipliers_ == scene::Multipliers::memory) {
      const int read_ports = placer_.delays().memory_block.read_ports;
      schedule_.square_tables = fixed::square_tables(lane_, read_ports);
    }
    if (lane_.format.is_block) {
      schedule_.largest_exponent = placer_.place(block_exponent_unit(lane_, placer_.delays()), 0);
    }
    for (const FixedNode& node : lane_.nodes) place_node(node);
    for (const fixed::FixedPart& part : lane_.parts) place_decision(part);
    outputs_cycle_ = ready_cycle(schedule_.steps, lane_.outputs);
    for (auto id = static_cast<NodeId>(lane_.nodes.size()); id-- > 0;) move_later(id);
    Schedule schedule = placer_.finish(std::move(schedule_));
    schedule.latency_cycles = std::max(schedule.latency_cycles, outputs_cycle_);
    return schedule;
  }

private:
  void place_decision(const fixed::FixedPart& part) {
    PartSchedule& placed = schedule_.parts.emplace_back();
    int start = ready_cycle(schedule_.steps, decided_from(part));
    for (const Step& check : schedule_.checks) start = std::max(start, check.ready_cycle);
    if (const auto* running = std::get_if<fixed::RunningThresholds>(&part.criterion)) {
      placed.threshold = placer_.place(step_threshold_unit(*running, placer_.delays()),
                                       ready_cycle(schedule_.steps, running->watched));
      start = std::max(start, placed.threshold.ready_cycle);
    }
    placed.decision = placer_.place(fixed_decision_unit(lane_, part, placer_.delays()), start);
  }

  void place_node(const FixedNode& node) {
    const bool is_loaded = node.operation == Operation::input && !lane_.loaded_inputs.empty();
    if (node.operation == Operation::constant || is_loaded) return schedule_.steps.push_back({});
    if (fixed::is_common_cut(node)) return place_common_cut(node);
    const int start = node.operation == Operation::input
                          ? schedule_.largest_exponent.ready_cycle
                          : ready_cycle(schedule_.steps, operands_of(node));
    if (node.operation == Operation::convert) {  // wires
      schedule_.steps.push_back(
          {.unit = {}, .cuts = {}, .start_cycle = start, .ready_cycle = start});
      if (!fixed::is_checked(node)) return;
      return schedule_.checks.push_back(
          placer_.place(check_unit(lane_, node, placer_.delays()), start));
    }
    schedule_.steps.push_back(placer_.place(unit_of(node), start));
  }

  /// All operands of common cuts are placed before the first of these.
  void place_common_cut(const FixedNode& node) {
    Step& drop = schedule_.common_drop;
    if (drop.unit.module.empty()) {
      drop = placer_.place(common_drop_unit(lane_, placer_.delays()),
                           ready_cycle(schedule_.steps, fixed::cut_in_common(lane_)));
    }
    schedule_.steps.push_back(
        placer_.place(fixed_unit(lane_, node, multipliers_, placer_.delays()), drop.ready_cycle));
  }

  /// The unit of the node that is placed next.
  Unit unit_of(const FixedNode& node) const {
    const auto id = static_cast<NodeId>(schedule_.steps.size());
    const auto* table = fixed::table_of(schedule_.square_tables, id);
    return table != nullptr ? memory_square_unit(*table, placer_.delays())
                            : fixed_unit(lane_, node, multipliers_, placer_.delays());
  }

  /// Moves a node to the cycle in which its result is needed first, if that takes fewer registers.
  /// The readers of the node have been moved before.
  void move_later(NodeId id) {
    const FixedNode& node = lane_.nodes[id];
    if (arity(node.operation) == 0 || fixed::is_common_cut(node)) return;
    const int cycles = first_use(id) - schedule_.steps[id].ready_cycle;
    const long before = register_bits(id);
    shift(id, cycles);
    if (register_bits(id) >= before) shift(id, -cycles);
  }

  void shift(NodeId id, int cycles) {
    schedule_.steps[id].start_cycle += cycles;
    schedule_.steps[id].ready_cycle += cycles;
  }

  /// The registers that delay a node and its operands.
  long register_bits(NodeId id) const {
    const FixedNode& node = lane_.nodes[id];
    long bits = delay_bits(id);
    for (int k = 0; k < arity(node.operation); ++k) {
      const bool repeated = k == 1 && node.operands[0] == node.operands[1];
      if (!repeated) bits += delay_bits(node.operands[k]);
    }
    return bits;
  }

  long delay_bits(NodeId id) const {
    const FixedNode& node = lane_.nodes[id];
    if (node.operation == Operation::constant) return 0;
    const std::vector<int> uses = uses_of(id);
    const int last = *std::max_element(uses.begin(), uses.end());
    return static_cast<long>(node.format.width) * (last - schedule_.steps[id].ready_cycle);
  }

  int first_use(NodeId id) const {
    const std::vector<int> uses = uses_of(id);
    return *std::min_element(uses.begin(), uses.end());
  }

  /// The cycles in which a node's result is read.
  std::vector<int> uses_of(NodeId id) const {
    std::vector<int> cycles = checks_of(id);
    if (contains(lane_.outputs, id)) cycles.push_back(outputs_cycle_);
    if (contains(fixed::cut_in_common(lane_), id)) {
      cycles.push_back(schedule_.common_drop.start_cycle);
    }
    for (std::size_t reader = 0; reader < lane_.nodes.size(); ++reader) {
      if (!contains(operands_of(lane_.nodes[reader]), id)) continue;
      cycles.push_back(schedule_.steps[reader].start_cycle);
    }
    for (std::size_t part = 0; part < lane_.parts.size(); ++part) {
      const PartSchedule& placed = schedule_.parts[part];
      if (contains(watched_by(lane_.parts[part]), id)) {
        cycles.push_back(placed.threshold.start_cycle);
      }
      if (contains(decided_from(lane_.parts[part]), id)) {
        cycles.push_back(placed.decision.start_cycle);
      }
    }
    MIXCMP_CHECK(!cycles.empty());
    return cycles;
  }

  /// The cycles in which checks read a node.
  std::vector<int> checks_of(NodeId id) const {
    std::vector<int> cycles;
    auto check = schedule_.checks.begin();
    for (const FixedNode& node : lane_.nodes) {
      if (!fixed::is_checked(node)) continue;
      if (node.operands[0] == id) cycles.push_back(check->start_cycle);
      ++check;
    }
    return cycles;
  }

  const FixedLane& lane_;
  scene::Multipliers multipliers_;
  UnitPlacer placer_;
  Schedule schedule_;
  int outputs_cycle_ = 0;  ///< in which all outputs are read
};

}  // namespace

Schedule schedule_lane(const FixedLane& lane, scene::Multipliers multipliers,
                       const DelayTable& delays, double target_mhz) {
  return FixedScheduler(lane, multipliers, delays, target_mhz).run();
}

}  // namespace mixcmp::datapath
