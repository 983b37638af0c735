#include "generator/hardware/rtl/selecting_units.hpp"

#include <algorithm>

#include "model/base/common/check.hpp"

namespace mixcmp::rtl {
namespace {

const char* unit_name(Operation operation) {
  switch (operation) {
    case Operation::add: return "adder";
    case Operation::multiply: return "multiplier";
    case Operation::square: return "squarer";
    case Operation::divide: return "divider";
    case Operation::square_root: return "root";
    case Operation::convert: return "converter";
    case Operation::minimum: return "smaller";
    case Operation::maximum: return "larger";
    case Operation::input:
    case Operation::constant:
    case Operation::negate:
    case Operation::absolute:
    case Operation::subtract:
    case Operation::function:
    case Operation::look_up:
    case Operation::fused_sum: break;
  }
  MIXCMP_CHECK(false);
}

/// The node that a unit for all of `operations` computes: a product if one of them is a product.
TypedNode common_node(const TypedGraph& graph, const std::vector<NodeId>& operations) {
  TypedNode node = graph.nodes[operations.front()];
  for (const NodeId id : operations) {
    if (graph.nodes[id].operation == Operation::multiply) node = graph.nodes[id];
  }
  if (node.operation == Operation::subtract) node.operation = Operation::add;
  return node;
}

}  // namespace

SelectingUnits::SelectingUnits(const TypedGraph& graph, const datapath::Schedule& schedule,
                               NamePool& pool) {
  for (std::size_t k = 0; k < schedule.shared_units.size(); ++k) {
    const datapath::SharedUnit& shared = schedule.shared_units[k];
    if (!shared.selects && shared.operations.size() == 1) continue;
    const TypedNode node = common_node(graph, shared.operations);
    const Operation named = datapath::scaling_of(graph, node) ? Operation::convert : node.operation;
    units_.emplace(k, Unit{pool.unique(unit_name(named)), node, {}});
    for (const NodeId id : shared.operations) unit_of_[id] = k;
  }
}

SelectingUnits::Unit* SelectingUnits::find(NodeId node) {
  const auto unit = unit_of_.find(node);
  return unit == unit_of_.end() ? nullptr : &units_.at(unit->second);
}

void SelectingUnits::read(NodeId node, Literal phase, std::string comment,
                          std::vector<Operand> operands) {
  units_.at(unit_of_.at(node)).cases.push_back({phase, std::move(comment), std::move(operands)});
}

void SelectingUnits::sort_by_phase() {
  for (auto& [index, unit] : units_) {
    std::sort(unit.cases.begin(), unit.cases.end(),
              [](const PhaseCase& a, const PhaseCase& b) { return a.phase.value < b.phase.value; });
  }
}

Operand sign_changed(const Operand& operand, int width) {
  if (const auto* constant = std::get_if<Literal>(&operand->node)) {
    return literal(width, constant->value ^ Bits{1} << (width - 1));
  }
  const auto* source = std::get_if<Net>(&operand->node);
  MIXCMP_CHECK(source != nullptr);
  return concatenation({inverted(bit(source->name, width - 1)), slice(source->name, width - 2, 0)});
}

}  // namespace mixcmp::rtl
