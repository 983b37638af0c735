#include "generator/hardware/rtl/bound_unit_builder.hpp"

#include <fmt/core.h>

#include "model/base/common/check.hpp"

namespace mixcmp::rtl {
namespace {

using error::BoundNode;
using error::BoundOperation;

bool reads_value(const BoundNode& node) {
  return node.value >= 0;
}

}  // namespace

BoundUnitBuilder::BoundUnitBuilder(DatapathBuilder& datapath, const FloatNodes& nodes,
                                   const error::Lane& lane,
                                   const error::AbsoluteBoundCriterion& criterion,
                                   const datapath::PartSchedule& schedule,
                                   const std::string& suffix)
    : datapath_(datapath),
      nodes_(nodes),
      lane_(lane),
      criterion_(criterion),
      schedule_(schedule),
      names_(name_bounds(criterion.bound, suffix, nodes.names(), datapath.pool())) {
  const FloatFormat format = lane.graph.arithmetic.format;
  MIXCMP_CHECK(criterion.bound.format.exponent_bits == format.exponent_bits());
  MIXCMP_CHECK(criterion.bound.format.precision <= format.precision());
  // A bound reads only values with the lane's exponent bits. The check finds operands in the
  // reference format, which may have more exponent bits. More digits do no harm.
  for (const BoundNode& node : criterion.bound.nodes) {
    if (reads_value(node)) check_exponents(node.value);
  }
  for (const error::BoundCondition& condition : criterion.conditions) {
    check_exponents(condition.value);
  }
}

FloatFormat BoundUnitBuilder::format_of(NodeId value) const {
  return lane_.graph.nodes[value].format;
}

void BoundUnitBuilder::check_exponents(NodeId value) const {
  MIXCMP_CHECK(format_of(value).exponent_bits() == criterion_.bound.format.exponent_bits);
}

void BoundUnitBuilder::build() {
  for (std::size_t id = 0; id < criterion_.bound.nodes.size(); ++id) {
    build_node(static_cast<int>(id));
  }
  for (std::size_t k = 0; k < criterion_.conditions.size(); ++k) {
    build_condition(criterion_.conditions[k], schedule_.conditions[k]);
  }
}

void BoundUnitBuilder::build_node(int id) {
  const BoundNode& node = criterion_.bound.nodes[id];
  const int width = criterion_.bound.format.width();
  if (node.operation == BoundOperation::constant) {
    const Bits value = encode_bound(criterion_.bound.format, node.constant);
    bounds_.push_back({literal(width, value), names_[id], width, 0, true});
    return;
  }
  const datapath::Step& step = schedule_.bounds[id];
  std::vector<Connection> connections = operands(node, step.start_cycle);
  datapath_.describe(step, description(id));
  bounds_.push_back(datapath_.declare(names_[id], width, step.ready_cycle));
  connections.push_back({"y", net(names_[id])});
  datapath_.add_unit(step, "unit_" + names_[id], parameters(node), std::move(connections));
}

std::vector<Connection> BoundUnitBuilder::operands(const BoundNode& node, int cycle) {
  if (reads_value(node)) return {{"x", datapath_.at(nodes_.value(node.value), cycle)}};
  return {{"a", datapath_.at(bounds_[node.operands[0]], cycle)},
          {"b", datapath_.at(bounds_[node.operands[1]], cycle)}};
}

std::vector<Parameter> BoundUnitBuilder::parameters(const BoundNode& node) const {
  const BoundFormat format = criterion_.bound.format;
  std::vector<Parameter> parameters = {{"EXPONENT_BITS", format.exponent_bits}};
  if (reads_value(node)) {
    parameters.push_back({"PRECISION", format_of(node.value).precision()});
  }
  parameters.push_back({"BOUND_PRECISION", format.precision});
  const bool reads_subnormals =
      node.operation == BoundOperation::magnitude || node.operation == BoundOperation::binade;
  if (reads_subnormals) parameters.push_back({"GRADUAL", may_be_subnormal(node.value) ? 1 : 0});
  return parameters;
}

/// Tells whether a value may be subnormal although no operation before it was exceptional. Under
/// `flush` it may not, since an operation that reads a subnormal operand is exceptional. Otherwise
/// an input or a constant may be subnormal, and so may the result of an operation whose hazards
/// include underflow.
bool BoundUnitBuilder::may_be_subnormal(NodeId value) const {
  if (lane_.graph.arithmetic.subnormals == Subnormals::flush) return false;
  const bool is_result = arity(lane_.graph.nodes[value].operation) > 0;
  return lane_.hazards.empty() || !is_result || lane_.hazards[value].underflow;
}

void BoundUnitBuilder::build_condition(const error::BoundCondition& condition,
                                       const datapath::Step& step) {
  const Signal& bound = bounds_[condition.bound];
  const Signal& value = nodes_.value(condition.value);
  const FloatFormat format = format_of(condition.value);
  const std::string holds = datapath_.pool().unique(value.name + "_exceeds_error");
  const std::string fails = datapath_.pool().unique(value.name + "_too_small");
  std::vector<Connection> connections = {{"bound", datapath_.at(bound, step.start_cycle)},
                                         {"x", datapath_.at(value, step.start_cycle)},
                                         {"holds", net(holds)}};
  datapath_.describe(step,
                     fmt::format("the bound holds where {} <= |{}|.", bound.name, value.name));
  datapath_.add(Wire{1, holds, nullptr});
  datapath_.add(Wire{1, fails, inverted(net(holds))});
  datapath_.add_unit(step, "unit_" + holds,
                     {{"EXPONENT_BITS", format.exponent_bits()},
                      {"PRECISION", format.precision()},
                      {"BOUND_PRECISION", criterion_.bound.format.precision}},
                     std::move(connections));
  failures_.push_back({net(fails), fails, 1, step.ready_cycle});
}

std::string BoundUnitBuilder::description(int id) const {
  const BoundNode& node = criterion_.bound.nodes[id];
  const int digits = criterion_.bound.format.precision;
  const bool exact =
      node.operation == BoundOperation::binade || node.operation == BoundOperation::maximum;
  const std::string rounding = digits == 1 ? ", rounded up to a power of two"
                                           : fmt::format(", rounded up to {} digits", digits);
  const bool rounds = !exact && node.operation != BoundOperation::reciprocal;
  return fmt::format("{}{}.", bound_formula(criterion_.bound, id, names_, nodes_.names()),
                     rounds ? rounding : "");
}

}  // namespace mixcmp::rtl
