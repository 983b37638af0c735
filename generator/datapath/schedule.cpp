#include "generator/datapath/schedule.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "model/common/check.hpp"

namespace mixcmp::gen {
namespace {

using model::NodeId;
using model::Operation;
using model::TypedGraph;
using model::TypedNode;

bool is_wires(Operation operation) {
  switch (operation) {
    case Operation::input:
    case Operation::constant:
    case Operation::negate:
    case Operation::absolute: return true;
    case Operation::convert:
    case Operation::add:
    case Operation::subtract:
    case Operation::multiply:
    case Operation::square:
    case Operation::divide:
    case Operation::square_root:
    case Operation::minimum:
    case Operation::maximum: return false;
  }
  MIXCMP_CHECK(false);
}

class Scheduler {
public:
  Scheduler(const DelayTable& delays, double target_mhz)
      : delays_(delays), logic_ns_(std::max(0.0, 1000 / target_mhz - delays.register_ns)) {}

  Schedule run(const TypedGraph& graph, Unit decision, const std::vector<NodeId>& decided_from) {
    for (const TypedNode& node : graph.nodes) {
      const int start = latest(operands_of(node));
      if (is_wires(node.operation)) {
        schedule_.steps.push_back({.start_cycle = start, .ready_cycle = start});
      } else {
        schedule_.steps.push_back(
            place(unit_for(node, graph.arithmetic.subnormals, delays_), start));
      }
    }
    schedule_.decision = place(std::move(decision), latest(decided_from));
    schedule_.latency_cycles = schedule_.decision.ready_cycle;
    return std::move(schedule_);
  }

private:
  static std::vector<NodeId> operands_of(const TypedNode& node) {
    return {node.operands.begin(), node.operands.begin() + model::arity(node.operation)};
  }

  int latest(const std::vector<NodeId>& nodes) const {
    int cycle = 0;
    for (const NodeId node : nodes) cycle = std::max(cycle, schedule_.steps[node].ready_cycle);
    return cycle;
  }

  Step place(Unit unit, int start) {
    std::vector<bool> cuts = choose_cuts(unit);
    const int latency = static_cast<int>(std::count(cuts.begin(), cuts.end(), true));
    return {std::move(unit), std::move(cuts), start, start + latency};
  }

  /// Greedy from the operands on: a register goes in front of the first stage that would not fit.
  /// For a chain of stages this needs the fewest registers.
  std::vector<bool> choose_cuts(const Unit& unit) {
    MIXCMP_CHECK(!unit.stages.empty());
    std::vector<bool> cuts(unit.stages.size(), false);
    double path_ns = 0;
    for (std::size_t k = 0; k < unit.stages.size(); ++k) {
      const double stage_ns = unit.stages[k].delay_ns;
      if (k > 0 && path_ns + stage_ns > logic_ns_) {
        cuts[k - 1] = true;
        path_ns = 0;
      }
      path_ns += stage_ns;
      if (stage_ns > logic_ns_) note_slow(unit, unit.stages[k]);
    }
    cuts.back() = true;
    return cuts;
  }

  void note_slow(const Unit& unit, const Stage& stage) {
    const std::string note =
        fmt::format("{}, stage \"{}\": about {:.1f} ns of logic, the target leaves {:.1f} ns",
                    unit.module, stage.name, stage.delay_ns, logic_ns_);
    auto& notes = schedule_.slow_stages;
    if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(note);
  }

  DelayTable delays_;
  double logic_ns_;
  Schedule schedule_;
};

}  // namespace

Schedule schedule_lane(const model::Lane& lane, const DelayTable& delays, double target_mhz) {
  const TypedGraph& graph = lane.graph;
  Scheduler scheduler(delays, target_mhz);
  if (const auto* interval = std::get_if<model::IntervalDecision>(&lane.decision)) {
    return scheduler.run(graph, interval_decision_unit(graph.arithmetic.format, delays),
                         {interval->minimum, interval->maximum});
  }
  return scheduler.run(graph, ulp_distance_unit(graph.arithmetic.format, delays),
                       {graph.f, graph.g});
}

Schedule schedule_reference(const TypedGraph& reference, const DelayTable& delays,
                            double target_mhz) {
  return Scheduler(delays, target_mhz)
      .run(reference, compare_unit(reference.arithmetic.format, delays),
           {reference.f, reference.g});
}

}  // namespace mixcmp::gen
