#include "generator/datapath/fold_plan.hpp"

#include <algorithm>
#include <limits>
#include <set>
#include <tuple>

#include "model/common/check.hpp"

namespace mixcmp::datapath {
namespace {

using Kind = FoldedNode::Kind;

class ListScheduler {
public:
  explicit ListScheduler(const FoldedGraph& graph)
      : graph_(graph),
        starts_(graph.nodes.size(), 0),
        placed_(graph.nodes.size(), false),
        ways_left_(graph.nodes.size(), 0),
        busy_(graph.classes.size(), std::vector<std::size_t>(graph.interval, 0)) {}

  std::optional<std::vector<int>> run() {
    find_ways_left();
    std::vector<NodeId> left(graph_.nodes.size());
    for (std::size_t k = 0; k < left.size(); ++k) left[k] = static_cast<NodeId>(k);
    std::stable_sort(left.begin(), left.end(),
                     [&](NodeId a, NodeId b) { return ways_left_[a] > ways_left_[b]; });
    for (int cycle = 0; !left.empty(); ++cycle) {
      // Wires that follow a node in the same cycle may come before it in the list.
      while (std::erase_if(left, [&](NodeId id) { return place(id, cycle); }) > 0) continue;
      if (std::any_of(left.begin(), left.end(), [&](NodeId id) { return is_late(id, cycle); })) {
        return std::nullopt;
      }
    }
    return std::move(starts_);
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

  bool is_ready(NodeId id, int cycle) const {
    const auto& operands = graph_.nodes[id].operands;
    return std::all_of(operands.begin(), operands.end(), [&](NodeId operand) {
      return placed_[operand] && starts_[operand] + graph_.nodes[operand].latency <= cycle;
    });
  }

  /// Tells whether a node that reads results has missed them.
  bool is_late(NodeId id, int cycle) const {
    const FoldedNode& node = graph_.nodes[id];
    return node.kind == Kind::operation && graph_.classes[node.unit_class].reads_results &&
           is_ready(id, cycle);
  }

  /// Places a node in `cycle` if its operands are ready and a unit is free; says whether it did.
  bool place(NodeId id, int cycle) {
    if (!is_ready(id, cycle)) return false;
    const FoldedNode& node = graph_.nodes[id];
    if (node.kind == Kind::operation) {
      std::size_t& busy = busy_[node.unit_class][cycle % graph_.interval];
      if (busy == graph_.classes[node.unit_class].units) return false;
      ++busy;
    }
    starts_[id] = cycle;
    placed_[id] = true;
    return true;
  }

  const FoldedGraph& graph_;
  std::vector<int> starts_;
  std::vector<bool> placed_;
  std::vector<int> ways_left_;
  std::vector<std::vector<std::size_t>> busy_;  ///< units, by class and phase
};

/// Searches by branch and bound, from the last operation to the first: each is tried from the
/// latest cycle on that those which read it allow.
class StorageSearch {
public:
  StorageSearch(const FoldedGraph& graph, std::vector<int> starts)
      : graph_(graph),
        listed_(std::move(starts)),
        best_(listed_),
        starts_(best_),
        readers_(graph.nodes.size()),
        deadlines_(graph.nodes.size(), std::numeric_limits<int>::max()),
        earliest_(graph.nodes.size(), 0),
        busy_(graph.classes.size(), std::vector<std::size_t>(graph.interval, 0)) {}

  std::vector<int> run() {
    find_readers();
    best_cost_ = cost();
    for (auto& phases : busy_) std::fill(phases.begin(), phases.end(), 0);
    descend(0, 0);
    return place_wires(std::move(best_));
  }

private:
  /// Bounds the time: some milliseconds.
  static constexpr int most_trials = 5'000;
  /// A bit that waits takes a flip-flop, and often a cell of its own. A place more to read from
  /// takes about half a cell a bit.
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

  /// What a whole plan costs.
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
      std::size_t& busy = busy_[node.unit_class][cycle % graph_.interval];
      if (busy == class_of(id).units) continue;
      ++trials_;
      ++busy;
      starts_[id] = cycle;
      descend(index + 1, so_far + waiting_cost(id));
      --busy;
    }
  }

  bool reads_input(NodeId id) const {
    const auto& operands = graph_.nodes[id].operands;
    return std::any_of(operands.begin(), operands.end(), [&](NodeId operand) {
      return graph_.nodes[source_of(operand)].kind == Kind::input;
    });
  }

  /// What feeds a datapath needs a cycle to bring the next operands once these are read.
  int last_read_of_inputs() const { return graph_.interval - 2; }

  void keep_if_better() {
    if (!results_are_read_at_once()) return;
    const long found = cost();
    if (found >= best_cost_) return;
    best_cost_ = found;
    best_ = starts_;
  }

  bool results_are_read_at_once() const {
    return std::all_of(operations_.begin(), operations_.end(), [&](NodeId id) {
      const auto& operands = graph_.nodes[id].operands;
      return !class_of(id).reads_results ||
             std::all_of(operands.begin(), operands.end(),
                         [&](NodeId operand) { return ready_cycle(operand) == starts_[id]; });
    });
  }

  std::vector<int> place_wires(std::vector<int> starts) const {
    for (std::size_t k = 0; k < starts.size(); ++k) {
      if (graph_.nodes[k].kind != Kind::wires) continue;
      starts[k] = 0;
      for (const NodeId operand : graph_.nodes[k].operands) {
        starts[k] = std::max(starts[k], starts[operand] + graph_.nodes[operand].latency);
      }
    }
    return starts;
  }

  const FoldedGraph& graph_;
  std::vector<int> listed_;  ///< by the list schedule
  std::vector<int> best_;
  long best_cost_ = 0;
  std::vector<int> starts_;
  std::vector<NodeId> operations_;                 ///< the last one first
  std::vector<std::vector<NodeId>> readers_;       ///< operations, of each value
  std::vector<int> deadlines_;                     ///< of compared values
  std::vector<std::pair<NodeId, int>> last_read_;  ///< compared values, and when
  std::vector<int> earliest_;
  std::vector<std::vector<std::size_t>> busy_;  ///< units, by class and phase
  int trials_ = 0;
};

}  // namespace

std::optional<std::vector<int>> list_schedule(const FoldedGraph& graph) {
  return ListScheduler(graph).run();
}

std::vector<int> reduce_storage(const FoldedGraph& graph, std::vector<int> starts) {
  return StorageSearch(graph, std::move(starts)).run();
}

}  // namespace mixcmp::datapath
