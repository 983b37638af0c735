#include "generator/hardware/datapath/fold_plan.hpp"

#include <algorithm>
#include <limits>
#include <set>
#include <tuple>

#include "model/base/common/check.hpp"

namespace mixcmp::datapath {
namespace {

using Kind = FoldedNode::Kind;

/// The phases in which each unit begins an operation.
///
/// If an operation keeps its unit for several cycles, every start on that unit lies a whole
/// multiple of this time behind the first one. No phases are then lost between two operations, and
/// a unit takes as many as the interval has room for.
class Occupancy {
public:
  explicit Occupancy(const FoldedGraph& graph) : interval_(graph.interval) {
    for (const UnitClass& shared : graph.classes) {
      cycles_.push_back(shared.cycles);
      starts_.emplace_back(shared.units);
    }
  }

  /// The first unit of a class that an operation may start on in `cycle`.
  std::optional<std::size_t> free_unit(std::size_t unit_class, int cycle) const {
    const auto& units = starts_[unit_class];
    for (std::size_t unit = 0; unit < units.size(); ++unit) {
      if (is_free(units[unit], cycles_[unit_class], cycle % interval_)) return unit;
    }
    return std::nullopt;
  }

  void take(std::size_t unit_class, std::size_t unit, int cycle) {
    starts_[unit_class][unit].push_back(cycle % interval_);
  }
  /// Takes back the last `take` of a unit.
  void release(std::size_t unit_class, std::size_t unit) { starts_[unit_class][unit].pop_back(); }

private:
  bool is_free(const std::vector<int>& starts, int cycles, int phase) const {
    if (starts.empty()) return true;
    const int after_first = (phase - starts.front() + interval_) % interval_;
    return after_first % cycles == 0 && after_first + cycles <= interval_ &&
           std::find(starts.begin(), starts.end(), phase) == starts.end();
  }

  int interval_;
  std::vector<int> cycles_;                            ///< by class
  std::vector<std::vector<std::vector<int>>> starts_;  ///< phases, by class and unit
};

class ListScheduler {
public:
  explicit ListScheduler(const FoldedGraph& graph)
      : graph_(graph),
        plan_{std::vector<int>(graph.nodes.size(), 0),
              std::vector<std::size_t>(graph.nodes.size(), 0)},
        placed_(graph.nodes.size(), false),
        ways_left_(graph.nodes.size(), 0),
        readers_at_once_(graph.nodes.size()),
        occupancy_(graph) {}

  std::optional<FoldPlan> run() {
    find_ways_left();
    find_readers_at_once();
    std::vector<NodeId> left;
    for (std::size_t k = 0; k < graph_.nodes.size(); ++k) {
      if (!reads_results(static_cast<NodeId>(k))) left.push_back(static_cast<NodeId>(k));
    }
    std::stable_sort(left.begin(), left.end(),
                     [&](NodeId a, NodeId b) { return ways_left_[a] > ways_left_[b]; });
    for (int cycle = 0; !left.empty(); ++cycle) {
      if (cycle > longest()) return std::nullopt;
      // Wires that follow a node in the same cycle may come before it in the list.
      while (std::erase_if(left, [&](NodeId id) { return place(id, cycle); }) > 0) continue;
    }
    return std::move(plan_);
  }

private:
  /// The longest way from the operands of each node to a verdict.
  void find_ways_left() {
    for (std::size_t k = graph_.nodes.size(); k-- > 0;) {
      ways_left_[k] += graph_.nodes[k].latency;
      for (const NodeId operand : graph_.nodes[k].operands) {
        ways_left_[operand] = std::max(ways_left_[operand], ways_left_[k]);
      }
    }
  }

  bool reads_results(NodeId id) const {
    const FoldedNode& node = graph_.nodes[id];
    return node.kind == Kind::operation && graph_.classes[node.unit_class].reads_results;
  }

  void find_readers_at_once() {
    for (NodeId id = 0; id < static_cast<NodeId>(graph_.nodes.size()); ++id) {
      if (!reads_results(id)) continue;
      for (const NodeId operand : graph_.nodes[id].operands) {
        readers_at_once_[operand].push_back(id);
      }
    }
  }

  /// An upper bound of the schedule's length, in cycles: each node waits for the one before it, and
  /// then an interval for its unit.
  int longest() const {
    int cycles = 0;
    for (const FoldedNode& node : graph_.nodes) cycles += node.latency + graph_.interval;
    return cycles;
  }

  bool is_ready(NodeId id, int cycle) const {
    const auto& operands = graph_.nodes[id].operands;
    return std::all_of(operands.begin(), operands.end(), [&](NodeId operand) {
      return placed_[operand] && plan_.starts[operand] + graph_.nodes[operand].latency <= cycle;
    });
  }

  /// Places a node in `cycle` if its operands are ready and a unit is free; says whether it did.
  bool place(NodeId id, int cycle) {
    if (!is_ready(id, cycle) || !may_start(id, cycle)) return false;
    start(id, cycle);
    for (const NodeId reader : readers_at_once_[id]) {
      start(reader, cycle + graph_.nodes[id].latency);
    }
    return true;
  }

  /// Tells whether a unit is free for the node, and a unit for each operation that reads its result
  /// at once.
  bool may_start(NodeId id, int cycle) const {
    const FoldedNode& node = graph_.nodes[id];
    if (node.kind != Kind::operation) return true;
    const auto& readers = readers_at_once_[id];
    return occupancy_.free_unit(node.unit_class, cycle) &&
           std::all_of(readers.begin(), readers.end(), [&](NodeId reader) {
             return occupancy_.free_unit(graph_.nodes[reader].unit_class, cycle + node.latency);
           });
  }

  void start(NodeId id, int cycle) {
    const FoldedNode& node = graph_.nodes[id];
    if (node.kind == Kind::operation) {
      plan_.units[id] = occupancy_.free_unit(node.unit_class, cycle).value();
      occupancy_.take(node.unit_class, plan_.units[id], cycle);
    }
    plan_.starts[id] = cycle;
    placed_[id] = true;
  }

  const FoldedGraph& graph_;
  FoldPlan plan_;
  std::vector<bool> placed_;
  std::vector<int> ways_left_;
  std::vector<std::vector<NodeId>> readers_at_once_;  ///< operations that read results, by node
  Occupancy occupancy_;
};

/// Searches by branch and bound, from the last operation to the first. The cycles of an operation
/// are tried from the latest one that its readers allow.
class StorageSearch {
public:
  StorageSearch(const FoldedGraph& graph, FoldPlan plan)
      : graph_(graph),
        listed_(plan.starts),
        best_(std::move(plan)),
        starts_(best_.starts),
        units_(best_.units),
        readers_(graph.nodes.size()),
        deadlines_(graph.nodes.size(), std::numeric_limits<int>::max()),
        earliest_(graph.nodes.size(), 0),
        occupancy_(graph) {}

  FoldPlan run() {
    find_readers();
    best_cost_ = cost();
    descend(0, 0);
    place_wires(best_.starts);
    return std::move(best_);
  }

private:
  /// Limits the time of a search to some milliseconds.
  static constexpr int most_trials = 5'000;
  /// A bit that waits takes a flip-flop, and often a cell of its own. Each further source of an
  /// operand takes about half a cell per bit.
  static constexpr long cost_of_waiting = 2;
  static constexpr long cost_of_source = 1;

  /// The node whose value a node carries, perhaps with another sign.
  NodeId source_of(NodeId id) const {
    while (graph_.nodes[id].kind == Kind::wires) id = graph_.nodes[id].operands.front();
    return id;
  }

  bool is_operation(NodeId id) const { return graph_.nodes[id].kind == Kind::operation; }

  const UnitClass& class_of(NodeId id) const { return graph_.classes[graph_.nodes[id].unit_class]; }

  void find_readers() {
    for (NodeId id = 0; id < static_cast<NodeId>(graph_.nodes.size()); ++id) {
      const FoldedNode& node = graph_.nodes[id];
      for (const NodeId operand : node.operands) {
        const int ready = earliest_[operand] + graph_.nodes[operand].latency;
        earliest_[id] = std::max(earliest_[id], ready);
        if (node.kind == Kind::operation) readers_[source_of(operand)].push_back(id);
      }
      if (node.kind == Kind::operation) operations_.insert(operations_.begin(), id);
    }
    for (const std::vector<NodeId>& together : graph_.compared) {
      int ready = 0;
      for (const NodeId id : together) ready = std::max(ready, ready_cycle(id));
      for (const NodeId id : together) {
        int& deadline = deadlines_[source_of(id)];
        deadline = std::min(deadline, ready);
        last_read_.emplace_back(source_of(id), ready);
      }
    }
  }

  int ready_cycle(NodeId id) const {
    const NodeId source = source_of(id);
    return starts_[source] + graph_.nodes[source].latency;
  }

  /// Registers that a value goes through, one an interval, until it is read in `cycle`.
  int registers(NodeId source, int cycle) const {
    const FoldedNode& node = graph_.nodes[source];
    if (node.kind == Kind::constant) return 0;
    const int there = node.kind == Kind::input ? graph_.interval - 1 : ready_cycle(source);
    return cycle <= there ? 0 : (cycle - there + graph_.interval - 1) / graph_.interval;
  }

  int last_read(NodeId source) const {
    int last = 0;
    for (const NodeId reader : readers_[source]) last = std::max(last, starts_[reader]);
    for (const auto& [compared, cycle] : last_read_) {
      if (compared == source) last = std::max(last, cycle);
    }
    return last;
  }

  long waiting_cost(NodeId source) const {
    return cost_of_waiting * graph_.nodes[source].width * registers(source, last_read(source));
  }

  /// The places that the operands of a class are read from.
  long source_cost(const UnitClass& shared) const {
    std::set<std::tuple<std::size_t, NodeId, int>> sources;
    int width = 0;
    for (const NodeId id : shared.operations) {
      const auto& operands = graph_.nodes[id].operands;
      for (std::size_t port = 0; port < operands.size(); ++port) {
        const NodeId source = source_of(operands[port]);
        const int waited = registers(source, starts_[id]);
        const bool is_result = is_operation(source) && waited == 0;
        const NodeId place =
            is_result ? -1 - static_cast<NodeId>(graph_.nodes[source].unit_class) : source;
        sources.emplace(port, place, waited);
        width = std::max(width, graph_.nodes[source].width);
      }
    }
    return cost_of_source * width * static_cast<long>(sources.size());
  }

  /// The cost of a whole plan.
  long cost() const {
    long cost = 0;
    for (NodeId id = 0; id < static_cast<NodeId>(graph_.nodes.size()); ++id) {
      if (graph_.nodes[id].kind != Kind::wires) cost += waiting_cost(id);
    }
    for (const UnitClass& shared : graph_.classes) cost += source_cost(shared);
    return cost;
  }

  /// Places the operations from the `index`-th on; those before it cost `so_far`.
  void descend(std::size_t index, long so_far) {
    if (so_far >= best_cost_) return;
    if (index == operations_.size()) return keep_if_better();
    const NodeId id = operations_[index];
    const FoldedNode& node = graph_.nodes[id];
    int latest = deadlines_[id];
    int earliest = earliest_[id];
    for (const NodeId reader : readers_[id]) {
      latest = std::min(latest, starts_[reader]);
      if (class_of(reader).reads_results)
        earliest = std::max(earliest, starts_[reader] - node.latency);
    }
    latest -= node.latency;
    if (reads_input(id)) latest = std::min(latest, std::max(listed_[id], last_read_of_inputs()));
    earliest = std::max(earliest, latest - graph_.interval + 1);
    for (int cycle = latest; cycle >= earliest && trials_ < most_trials; --cycle) {
      const auto unit = occupancy_.free_unit(node.unit_class, cycle);
      if (!unit) continue;
      ++trials_;
      occupancy_.take(node.unit_class, *unit, cycle);
      starts_[id] = cycle;
      units_[id] = *unit;
      descend(index + 1, so_far + waiting_cost(id));
      occupancy_.release(node.unit_class, *unit);
    }
  }

  bool reads_input(NodeId id) const {
    const auto& operands = graph_.nodes[id].operands;
    return std::any_of(operands.begin(), operands.end(), [&](NodeId operand) {
      return graph_.nodes[source_of(operand)].kind == Kind::input;
    });
  }

  /// The last cycle in which inputs may be read: their source needs one more cycle to bring the
  /// next operands.
  int last_read_of_inputs() const { return graph_.interval - 2; }

  void keep_if_better() {
    if (!results_are_read_at_once()) return;
    const long found = cost();
    if (found >= best_cost_) return;
    best_cost_ = found;
    best_ = {starts_, units_};
  }

  bool results_are_read_at_once() const {
    return std::all_of(operations_.begin(), operations_.end(), [&](NodeId id) {
      const auto& operands = graph_.nodes[id].operands;
      return !class_of(id).reads_results ||
             std::all_of(operands.begin(), operands.end(),
                         [&](NodeId operand) { return ready_cycle(operand) == starts_[id]; });
    });
  }

  void place_wires(std::vector<int>& starts) const {
    for (std::size_t k = 0; k < starts.size(); ++k) {
      if (graph_.nodes[k].kind != Kind::wires) continue;
      starts[k] = 0;
      for (const NodeId operand : graph_.nodes[k].operands) {
        starts[k] = std::max(starts[k], starts[operand] + graph_.nodes[operand].latency);
      }
    }
  }

  const FoldedGraph& graph_;
  std::vector<int> listed_;  ///< starts, by the list schedule
  FoldPlan best_;
  long best_cost_ = 0;
  std::vector<int> starts_;
  std::vector<std::size_t> units_;
  std::vector<NodeId> operations_;                 ///< the last one first
  std::vector<std::vector<NodeId>> readers_;       ///< the operations that read each value
  std::vector<int> deadlines_;                     ///< [node]: for compared values
  std::vector<std::pair<NodeId, int>> last_read_;  ///< compared values, and the cycles
  std::vector<int> earliest_;
  Occupancy occupancy_;
  int trials_ = 0;
};

}  // namespace

std::optional<FoldPlan> list_schedule(const FoldedGraph& graph) {
  return ListScheduler(graph).run();
}

FoldPlan reduce_storage(const FoldedGraph& graph, FoldPlan plan) {
  return StorageSearch(graph, std::move(plan)).run();
}

}  // namespace mixcmp::datapath
