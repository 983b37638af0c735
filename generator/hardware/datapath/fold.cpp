#include "generator/hardware/datapath/fold.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "generator/hardware/datapath/fold_plan.hpp"
#include "model/base/common/check.hpp"

namespace mixcmp::datapath {
namespace {

/// Operations with the same key can share a unit.
struct UnitKey {
  Operation operation;
  int exponent;  ///< for a scaling by a power of two
  FloatFormat operands;
  FloatFormat result;
  NodeId alone = -1;  ///< an operation that shares its unit with no other

  auto fields() const {
    return std::tuple(operation, exponent, operands.exponent_bits(), operands.precision(),
                      result.exponent_bits(), result.precision(), alone);
  }
  friend bool operator<(const UnitKey& a, const UnitKey& b) { return a.fields() < b.fields(); }
};

class Folder {
public:
  Folder(const TypedGraph& graph, scene::Multipliers multipliers, int interval,
         Scheduler& scheduler)
      : graph_(graph),
        multipliers_(multipliers),
        interval_(interval),
        scheduler_(scheduler),
        schedule_(scheduler.schedule()) {}

  void run() {
    schedule_.initiation_interval = interval_;
    schedule_.steps.resize(graph_.nodes.size());
    give_squares_to_multipliers();
    find_classes();
    find_nodes();
    plan();
    bind();
  }

private:
  std::size_t count() const { return graph_.nodes.size(); }

  UnitKey key_of(NodeId id) const {
    const TypedNode& node = graph_.nodes[id];
    // A fused sum needs all its terms at once, so a shared unit would take a register for each
    // term.
    if (node.operation == Operation::fused_sum) {
      return {node.operation, 0, node.operand_format, node.format, id};
    }
    const auto scaling = scaling_of(graph_, node);
    if (scaling) {
      return {Operation::convert, scaling->exponent, node.operand_format, node.format};
    }
    Operation operation = node.operation;
    if (operation == Operation::subtract) operation = Operation::add;
    if (by_multiplier_.contains(id)) operation = Operation::multiply;
    return {operation, 0, node.operand_format, node.format};
  }

  /// Chooses the squares that multipliers compute: only squares that save squarers, and no more
  /// than fit into the cycles that products leave free. So each multiplier has a product. A
  /// multiplier for squares only would be larger than a squarer.
  void give_squares_to_multipliers() {
    std::map<UnitKey, std::vector<NodeId>> squares, products;
    for (NodeId id = 0; id < static_cast<NodeId>(count()); ++id) {
      const TypedNode& node = graph_.nodes[id];
      if (!has_unit(node) || scaling_of(graph_, node)) continue;
      const UnitKey formats = {Operation::square, 0, node.operand_format, node.format};
      if (node.operation == Operation::square) squares[formats].push_back(id);
      if (node.operation == Operation::multiply) products[formats].push_back(id);
    }
    for (const auto& [formats, all] : squares) {
      const std::size_t per_unit = interval_;  // operations
      const std::size_t product_count = products[formats].size();
      const std::size_t room = (product_count + per_unit - 1) / per_unit * per_unit - product_count;
      const std::size_t left = all.size() - std::min(room, all.size());
      const std::size_t by_squarers =
          std::min(all.size(), (left + per_unit - 1) / per_unit * per_unit);
      by_multiplier_.insert(all.begin() + static_cast<std::ptrdiff_t>(by_squarers), all.end());
    }
  }

  void find_classes() {
    std::map<UnitKey, std::size_t> known;
    class_of_.assign(count(), 0);
    for (NodeId id = 0; id < static_cast<NodeId>(count()); ++id) {
      if (!has_unit(graph_.nodes[id])) continue;
      const auto [entry, is_new] = known.emplace(key_of(id), classes().size());
      if (is_new) classes().push_back({});
      class_of_[id] = entry->second;
      classes()[entry->second].operations.push_back(id);
    }
    for (UnitClass& shared : classes()) choose_unit(shared);
  }

  void choose_unit(UnitClass& shared) {
    const TypedNode& node = graph_.nodes[representative(shared)];
    const error::Hazards any_hazard = {};  // operations with other hazards may share the unit
    Unit unit = unit_for(graph_, node, any_hazard, multipliers_, scheduler_.delays());
    if (node.operation == Operation::square && multipliers_ == scene::Multipliers::logic) {
      auto serial = serial_square_unit(node, graph_.arithmetic.subnormals, scheduler_.delays());
      if (serial && is_smaller(shared, *serial, unit, node.operand_format)) unit = *serial;
    }
    shared.cycles = unit.initiation_interval;
    shared.units = units_needed(shared, unit);
    units_.push_back(scheduler_.place(std::move(unit), {}));
  }

  /// Tells whether serial squarers for a class take fewer tables than squarers that take a square
  /// in every cycle.
  bool is_smaller(const UnitClass& shared, const Unit& serial, const Unit& parallel,
                  FloatFormat operands) const {
    if (serial.initiation_interval > interval_) return false;
    const auto serials = static_cast<double>(units_needed(shared, serial));
    const auto parallels = static_cast<double>(units_needed(shared, parallel));
    return serials * serial_square_tables(operands) < parallels * logic_square_tables(operands);
  }

  /// The number of units, if each takes as many operations as the interval has room for.
  std::size_t units_needed(const UnitClass& shared, const Unit& unit) const {
    const auto most = static_cast<std::size_t>(interval_ / unit.initiation_interval);
    return (shared.operations.size() + most - 1) / most;
  }

  std::vector<UnitClass>& classes() { return folded_.classes; }

  /// The operation whose unit can compute all operations of the class: a multiplication if there is
  /// one.
  NodeId representative(const UnitClass& shared) const {
    const auto product =
        std::find_if(shared.operations.begin(), shared.operations.end(),
                     [&](NodeId id) { return graph_.nodes[id].operation == Operation::multiply; });
    return product == shared.operations.end() ? shared.operations.front() : *product;
  }

  void find_nodes() {
    folded_.interval = interval_;
    for (NodeId id = 0; id < static_cast<NodeId>(count()); ++id) {
      const TypedNode& node = graph_.nodes[id];
      folded_.nodes.push_back(
          {kind_of(node), operands_of(node), node.format.width(), 0, class_of_[id]});
    }
    for (const Sides& part : graph_.parts) {
      const TypedNode& f = graph_.nodes[part.f];
      folded_.compared.push_back(f.is_sign_of_sum() ? operands_of(f)
                                                    : std::vector<NodeId>{part.f, part.g});
    }
  }

  static FoldedNode::Kind kind_of(const TypedNode& node) {
    if (has_unit(node)) return FoldedNode::Kind::operation;
    if (node.operation == Operation::input) return FoldedNode::Kind::input;
    if (node.operation == Operation::constant) return FoldedNode::Kind::constant;
    return FoldedNode::Kind::wires;
  }

  /// A unit with several operations reads its operands through registers. If all of them are
  /// results of one other unit, they are read directly from that unit's output, if the plan allows
  /// it.
  void plan() {
    for (UnitClass& shared : classes()) shared.reads_results = may_read_results(shared);
    if (try_plan()) return;
    for (UnitClass& shared : classes()) shared.reads_results = false;
    MIXCMP_CHECK(try_plan());
  }

  bool try_plan() {
    for (FoldedNode& node : folded_.nodes) {
      if (node.kind != FoldedNode::Kind::operation) continue;
      node.latency = units_[node.unit_class].ready_cycle;
      if (selects(classes()[node.unit_class])) ++node.latency;
    }
    auto plan = list_schedule(folded_);
    if (!plan) return false;
    plan_ = waiting_takes_cells() ? reduce_storage(folded_, *plan) : *plan;
    return true;
  }

  /// Tells whether a value that waits in a register costs a logic cell. In a cell of one four-input
  /// table and one register, a register occupies the whole cell. Devices with wider tables have
  /// registers to spare, so waiting costs less there than reading a result directly from a unit's
  /// output.
  bool waiting_takes_cells() const { return !scheduler_.delays().has_wide_tables(); }

  static bool selects(const UnitClass& shared) {
    return shared.operations.size() > shared.units && !shared.reads_results;
  }

  bool may_read_results(const UnitClass& shared) const {
    if (shared.units > 1 || shared.operations.size() == 1) return false;
    const NodeId first = graph_.nodes[shared.operations.front()].operands.front();
    return std::all_of(shared.operations.begin(), shared.operations.end(), [&](NodeId id) {
      // Only squares can: a subtraction changes a sign in front of its unit, and an operand of a
      // product may be a constant.
      const Operation operation = graph_.nodes[id].operation;
      return operation == Operation::square && is_result_of(id, class_of_[first], shared);
    });
  }

  /// Tells whether the operand of a square is a result of the class `source`, which is not its own.
  bool is_result_of(NodeId id, std::size_t source, const UnitClass& own) const {
    const NodeId operand = graph_.nodes[id].operands.front();
    const UnitClass& operand_class = folded_.classes[class_of_[operand]];
    return has_unit(graph_.nodes[operand]) && class_of_[operand] == source &&
           operand_class.units == 1 && &operand_class != &own;
  }

  /// Writes the plan into the schedule.
  void bind() {
    for (std::size_t k = 0; k < classes().size(); ++k) {
      UnitClass& shared = classes()[k];
      const std::size_t first = schedule_.shared_units.size();
      schedule_.shared_units.resize(first + shared.units,
                                    {units_[k].unit, units_[k].cuts, {}, selects(shared)});
      std::stable_sort(shared.operations.begin(), shared.operations.end(),
                       [&](NodeId a, NodeId b) { return plan_.starts[a] < plan_.starts[b]; });
      for (const NodeId id : shared.operations) {
        schedule_.shared_units[first + plan_.units[id]].operations.push_back(id);
        schedule_.steps[id].unit = units_[k].unit;
        schedule_.steps[id].cuts = units_[k].cuts;
      }
    }
    for (std::size_t k = 0; k < count(); ++k) {
      schedule_.steps[k].start_cycle = plan_.starts[k];
      schedule_.steps[k].ready_cycle = plan_.starts[k] + folded_.nodes[k].latency;
      schedule_.steps[k].reads = operands_of(graph_.nodes[k]);
    }
  }

  const TypedGraph& graph_;
  scene::Multipliers multipliers_;
  int interval_;
  Scheduler& scheduler_;
  Schedule& schedule_;
  FoldedGraph folded_ = {};
  std::set<NodeId> by_multiplier_;     ///< the squares that multipliers compute
  std::vector<std::size_t> class_of_;  ///< [node]: the class of an operation
  std::vector<Step> units_;            ///< each class's unit, if started in cycle 0
  FoldPlan plan_;
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
                  int initiation_interval, Scheduler& scheduler) {
  MIXCMP_CHECK(initiation_interval > 1);
  Folder(reference, multipliers, initiation_interval, scheduler).run();
}

int last_operand_phase(const TypedGraph& reference, const Schedule& schedule) {
  int last = 0;
  const auto see = [&](const Step& step) {
    for (const NodeId id : step.reads) {
      if (is_operand(reference, id)) last = std::max(last, step.start_cycle);
    }
  };
  for (const Step& step : schedule.steps) see(step);
  for (const PartSchedule& part : schedule.parts) see(part.decision);
  return std::min(last, schedule.initiation_interval - 1);
}

}  // namespace mixcmp::datapath
