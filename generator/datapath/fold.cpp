#include "generator/datapath/fold.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <tuple>

#include "model/common/check.hpp"

namespace mixcmp::datapath {
namespace {

/// Operations with the same key can share a unit.
struct UnitKey {
  Operation operation;
  int exponent;  ///< of a scaling by a power of two
  FloatFormat operands;
  FloatFormat result;
  NodeId alone = -1;  ///< of an operation that shares its unit with no other

  auto fields() const {
    return std::tuple(operation, exponent, operands.exponent_bits(), operands.precision(),
                      result.exponent_bits(), result.precision(), alone);
  }
  friend bool operator<(const UnitKey& a, const UnitKey& b) { return a.fields() < b.fields(); }
};

/// Operations that share units, and these.
struct UnitClass {
  std::vector<NodeId> operations;
  Step step;               ///< of each of its units, if started in cycle 0
  std::size_t first_unit;  ///< index of shared_units
  std::size_t units;
};

class Folder {
public:
  Folder(const TypedGraph& graph, scene::Multipliers multipliers, int interval, UnitPlacer& placer,
         Schedule& schedule)
      : graph_(graph),
        multipliers_(multipliers),
        interval_(interval),
        placer_(placer),
        schedule_(schedule) {}

  void run() {
    schedule_.initiation_interval = interval_;
    schedule_.steps.resize(graph_.nodes.size());
    find_classes();
    find_ways_left();
    place_all();
  }

private:
  std::size_t count() const { return graph_.nodes.size(); }

  UnitKey key_of(NodeId id) const {
    const TypedNode& node = graph_.nodes[id];
    // Its terms are all there at once, so that sharing it would take a register for each.
    if (node.operation == Operation::fused_sum) {
      return {node.operation, 0, node.operand_format, node.format, id};
    }
    const auto scaling = scaling_of(graph_, node);
    if (scaling) {
      return {Operation::convert, scaling->exponent, node.operand_format, node.format};
    }
    Operation operation = node.operation;
    if (operation == Operation::subtract) operation = Operation::add;
    if (operation == Operation::square && has_product(node)) operation = Operation::multiply;
    return {operation, 0, node.operand_format, node.format};
  }

  /// Tells whether a multiplication of the node's formats needs a multiplier anyway.
  bool has_product(const TypedNode& square) const {
    return std::any_of(graph_.nodes.begin(), graph_.nodes.end(), [&](const TypedNode& node) {
      return node.operation == Operation::multiply && !scaling_of(graph_, node) &&
             node.operand_format == square.operand_format && node.format == square.format;
    });
  }

  void find_classes() {
    std::map<UnitKey, std::size_t> known;
    class_of_.assign(count(), 0);
    for (NodeId id = 0; id < static_cast<NodeId>(count()); ++id) {
      const TypedNode& node = graph_.nodes[id];
      if (!has_unit(node)) continue;
      const auto [entry, is_new] = known.emplace(key_of(id), classes_.size());
      if (is_new) classes_.push_back({});
      class_of_[id] = entry->second;
      classes_[entry->second].operations.push_back(id);
    }
    for (UnitClass& shared : classes_) make_units(shared);
  }

  void make_units(UnitClass& shared) {
    shared.step = placer_.place(
        unit_for(graph_, graph_.nodes[representative(shared)], multipliers_, placer_.delays()), 0);
    shared.first_unit = schedule_.shared_units.size();
    shared.units = (shared.operations.size() + interval_ - 1) / interval_;
    schedule_.shared_units.resize(shared.first_unit + shared.units,
                                  {shared.step.unit, shared.step.cuts, {}, selects(shared)});
    busy_.resize(schedule_.shared_units.size(), std::vector<bool>(interval_, false));
  }

  /// The operation whose unit computes all of the class: a multiplication where there is one.
  NodeId representative(const UnitClass& shared) const {
    const auto product =
        std::find_if(shared.operations.begin(), shared.operations.end(),
                     [&](NodeId id) { return graph_.nodes[id].operation == Operation::multiply; });
    return product == shared.operations.end() ? shared.operations.front() : *product;
  }

  /// Cycles from the operands of a node to its result. A unit with several operations reads its
  /// operands through a register.
  int latency(NodeId id) const {
    if (!has_unit(graph_.nodes[id])) return 0;
    const UnitClass& shared = classes_[class_of_[id]];
    return shared.step.ready_cycle + (selects(shared) ? 1 : 0);
  }

  bool selects(const UnitClass& shared) const { return shared.operations.size() > shared.units; }

  /// The longest way from the operands of each node to a verdict.
  void find_ways_left() {
    way_left_.assign(count(), 0);
    for (std::size_t k = count(); k-- > 0;) {
      way_left_[k] += latency(static_cast<NodeId>(k));
      for (const int operand : operands_of(graph_.nodes[k])) {
        way_left_[operand] = std::max(way_left_[operand], way_left_[k]);
      }
    }
  }

  void place_all() {
    std::vector<NodeId> left(count());
    for (NodeId id = 0; id < static_cast<NodeId>(count()); ++id) left[id] = id;
    std::stable_sort(left.begin(), left.end(),
                     [&](NodeId a, NodeId b) { return way_left_[a] > way_left_[b]; });
    placed_.assign(count(), false);
    for (int cycle = 0; !left.empty(); ++cycle) {
      // Wires that follow a node in the same cycle may come before it in the list.
      while (std::erase_if(left, [&](NodeId id) { return place(id, cycle); }) > 0) continue;
    }
  }

  /// Places a node in `cycle` if its operands are ready and a unit is free; says whether it did.
  bool place(NodeId id, int cycle) {
    for (const int operand : operands_of(graph_.nodes[id])) {
      if (!placed_[operand] || schedule_.steps[operand].ready_cycle > cycle) return false;
    }
    if (has_unit(graph_.nodes[id])) {
      const UnitClass& shared = classes_[class_of_[id]];
      const auto unit = free_unit(shared, cycle % interval_);
      if (!unit) return false;
      busy_[*unit][cycle % interval_] = true;
      schedule_.shared_units[*unit].operations.push_back(id);
      schedule_.steps[id].unit = shared.step.unit;
      schedule_.steps[id].cuts = shared.step.cuts;
    }
    schedule_.steps[id].start_cycle = cycle;
    schedule_.steps[id].ready_cycle = cycle + latency(id);
    placed_[id] = true;
    return true;
  }

  std::optional<std::size_t> free_unit(const UnitClass& shared, int phase) const {
    for (std::size_t unit = shared.first_unit; unit < shared.first_unit + shared.units; ++unit) {
      if (!busy_[unit][phase]) return unit;
    }
    return std::nullopt;
  }

  const TypedGraph& graph_;
  scene::Multipliers multipliers_;
  int interval_;
  UnitPlacer& placer_;
  Schedule& schedule_;
  std::vector<UnitClass> classes_;
  std::vector<std::size_t> class_of_;
  std::vector<std::vector<bool>> busy_;  ///< by unit and phase
  std::vector<int> way_left_;
  std::vector<bool> placed_;
};

/// Tells whether a node is an operand of the comparison, perhaps with another sign.
bool is_operand(const TypedGraph& graph, NodeId id) {
  const TypedNode& node = graph.nodes[id];
  if (node.operation == Operation::input) return true;
  const bool signs = node.operation == Operation::negate || node.operation == Operation::absolute;
  return signs && is_operand(graph, node.operands[0]);
}

}  // namespace

void place_folded(const TypedGraph& reference, scene::Multipliers multipliers,
                  int initiation_interval, UnitPlacer& placer, Schedule& schedule) {
  MIXCMP_CHECK(initiation_interval > 1);
  Folder(reference, multipliers, initiation_interval, placer, schedule).run();
}

int last_operand_phase(const TypedGraph& reference, const Schedule& schedule) {
  int last = 0;
  const auto read = [&](NodeId id, int cycle) {
    if (is_operand(reference, id)) last = std::max(last, cycle);
  };
  for (std::size_t k = 0; k < reference.nodes.size(); ++k) {
    for (const int operand : operands_of(reference.nodes[k])) {
      read(operand, schedule.steps[k].start_cycle);
    }
  }
  for (std::size_t k = 0; k < reference.parts.size(); ++k) {
    const int cycle = schedule.parts[k].decision.start_cycle;
    const TypedNode& f = reference.nodes[reference.parts[k].f];
    for (const NodeId operand : operands_of(f)) {
      if (f.is_sign_of_sum()) read(operand, cycle);
    }
    read(reference.parts[k].f, cycle);
    read(reference.parts[k].g, cycle);
  }
  return std::min(last, schedule.initiation_interval - 1);
}

}  // namespace mixcmp::datapath
