#include "generator/rtl/float_nodes.hpp"

#include <fmt/core.h>

#include "model/common/check.hpp"

namespace mixcmp::rtl {
std::vector<Parameter> format_parameters(FloatFormat format) {
  return {{"EXPONENT_BITS", format.exponent_bits()}, {"PRECISION", format.precision()}};
}

FloatNodes::FloatNodes(DatapathBuilder& datapath, const TypedGraph& graph,
                       std::vector<error::Hazards> hazards, const datapath::Schedule& schedule,
                       ExceptionalFlags exceptional)
    : datapath_(datapath),
      graph_(graph),
      hazards_(std::move(hazards)),
      schedule_(schedule),
      exceptional_(exceptional),
      unused_name_(datapath.pool().unique("unused_exceptional")),
      names_(name_nodes(graph, datapath.ports(), datapath.pool())) {}

void FloatNodes::build() {
  declare_unused_flags();
  for (NodeId id = 0; id < static_cast<NodeId>(graph_.nodes.size()); ++id) build_node(id);
}

void FloatNodes::declare_unused_flags() {
  int count = 0;
  for (NodeId id = 0; id < static_cast<NodeId>(graph_.nodes.size()); ++id) {
    if (!schedule_.steps[id].unit.module.empty() && !gathers_flag(id)) ++count;
  }
  if (count == 0) return;
  datapath_.add(Comment{exceptional_ == ExceptionalFlags::unused
                            ? "The verdict does not depend on what was exceptional on the way."
                            : "The range checks rule out that these operations are exceptional."});
  datapath_.add(Wire{count, unused_name_, nullptr, true});
}

void FloatNodes::build_node(NodeId id) {
  const TypedNode& node = graph_.nodes[id];
  values_.push_back({nullptr, names_[id], node.format.width(), schedule_.steps[id].ready_cycle});
  flags_.push_back({});
  switch (node.operation) {
    case Operation::input: values_[id].value = net(datapath_.port(node.input)); break;
    case Operation::constant:
      values_[id].value = literal(node.format.width(), node.constant);
      values_[id].constant = true;
      break;
    case Operation::negate:
    case Operation::absolute: build_sign_change(id); break;
    case Operation::convert:
    case Operation::add:
    case Operation::subtract:
    case Operation::multiply:
    case Operation::square:
    case Operation::divide:
    case Operation::square_root:
    case Operation::minimum:
    case Operation::maximum: build_unit(id); break;
  }
}

void FloatNodes::build_sign_change(NodeId id) {
  const TypedNode& node = graph_.nodes[id];
  const Signal operand = values_[node.operands[0]];
  const int top = node.format.width() - 1;
  const bool negate = node.operation == Operation::negate;
  // A literal has no bits to select: give the constant a name first.
  std::string source = operand.name;
  if (operand.constant) {
    source = datapath_.pool().unique(source + "_bits");
    datapath_.add(Wire{node.format.width(), source, operand.value});
  }
  if (!negate)
    datapath_.add(Wire{1, datapath_.pool().unique("unused_sign_of_" + source), bit(source, top)});
  const Operand sign = negate ? inverted(bit(source, top)) : literal(1, 0);
  datapath_.add(
      Comment{negate ? "A negation is its sign." : "An absolute value is its magnitude bits."});
  datapath_.add(
      Wire{node.format.width(), names_[id], concatenation({sign, slice(source, top - 1, 0)})});
  values_[id].value = net(names_[id]);
  values_[id].constant = operand.constant;
  flags_[id] = flags_[node.operands[0]];
}

void FloatNodes::build_unit(NodeId id) {
  const TypedNode& node = graph_.nodes[id];
  const datapath::Step& step = schedule_.steps[id];
  std::vector<Connection> connections = {{"aclk", net("aclk")}};
  const auto scaling = datapath::scaling_of(graph_, node);
  if (scaling) {
    const Operand operand = datapath_.at(values_[scaling->operand], step.start_cycle);
    connections.push_back({"a", scaling->negated ? negated(id, operand) : operand});
  }
  for (int k = 0; k < arity(node.operation) && !scaling; ++k) {
    connections.push_back(
        {k == 0 ? "a" : "b", datapath_.at(values_[node.operands[k]], step.start_cycle)});
  }
  connections.push_back({"y", net(names_[id])});
  datapath_.add(Comment{describe(id)});
  datapath_.add(Wire{node.format.width(), names_[id], nullptr});
  values_[id].value = net(names_[id]);
  connections.push_back({"exceptional", flag_output(id)});
  datapath_.add(Instance{step.unit.module, datapath_.pool().unique("unit_" + names_[id]),
                         unit_parameters(id), std::move(connections)});
  if (exceptional_ == ExceptionalFlags::gathered) gather_flags(id);
}

/// The operand of a scaling with its sign changed.
Operand FloatNodes::negated(NodeId id, const Operand& operand) {
  const int width = graph_.nodes[id].operand_format.width();
  const std::string factor = datapath_.pool().unique(names_[id] + "_factor");
  datapath_.add(Wire{width, factor, operand});
  return concatenation({inverted(bit(factor, width - 1)), slice(factor, width - 2, 0)});
}

/// Tells whether the unit's `exceptional` output is read. That of a square root is, whatever the
/// hazards say: they never rule out a negative operand.
bool FloatNodes::gathers_flag(NodeId id) const {
  if (exceptional_ == ExceptionalFlags::unused) return false;
  if (hazards_.empty() || graph_.nodes[id].operation == Operation::square_root) return true;
  const error::Hazards& hazards = hazards_[id];
  return hazards.special_operand || hazards.overflow || hazards.underflow;
}

Operand FloatNodes::flag_output(NodeId id) {
  if (!gathers_flag(id)) return bit(unused_name_, unused_flags_++);
  const std::string name = datapath_.pool().unique(names_[id] + "_exceptional");
  datapath_.add(Wire{1, name, nullptr});
  flags_[id] = {net(name), name, 1, schedule_.steps[id].ready_cycle};
  return net(name);
}

/// Builds the flag that travels with the value: it is set where this operation or one before it
/// was exceptional.
void FloatNodes::gather_flags(NodeId id) {
  const TypedNode& node = graph_.nodes[id];
  const int cycle = schedule_.steps[id].ready_cycle;
  std::vector<Signal> all;
  if (flags_[id].value != nullptr) all.push_back(flags_[id]);
  for (int k = 0; k < arity(node.operation); ++k) {
    const Signal& inherited = flags_[node.operands[k]];
    const bool known = k == 1 && inherited.name == flags_[node.operands[0]].name;
    if (inherited.value != nullptr && !known) all.push_back(inherited);
  }
  if (all.size() <= 1) {
    if (!all.empty()) flags_[id] = all.front();
    return;
  }
  const Operand any = datapath_.any_at(all, cycle);
  const std::string name = datapath_.pool().unique(names_[id] + "_doubtful");
  datapath_.add(Wire{1, name, any});
  flags_[id] = {net(name), name, 1, cycle};
}

std::string FloatNodes::describe(NodeId id) const {
  const TypedNode& node = graph_.nodes[id];
  const datapath::Step& step = schedule_.steps[id];
  return fmt::format("Cycles {} to {}: {}, {} {}.", step.start_cycle, step.ready_cycle,
                     formula(graph_, id, names_),
                     node.format == node.operand_format ? "in" : "rounded once to",
                     node.format.name());
}

std::vector<Parameter> FloatNodes::unit_parameters(NodeId id) const {
  const TypedNode& node = graph_.nodes[id];
  std::vector<Parameter> parameters = {{"EXPONENT_BITS", node.operand_format.exponent_bits()},
                                       {"PRECISION", node.operand_format.precision()}};
  const bool chooses = is_choice(node.operation);
  if (!chooses && node.format != node.operand_format) {
    parameters.push_back({"RESULT_EXPONENT_BITS", node.format.exponent_bits()});
    parameters.push_back({"RESULT_PRECISION", node.format.precision()});
  }
  if (node.operation == Operation::add || node.operation == Operation::subtract) {
    parameters.push_back({"SUBTRACT", node.operation == Operation::subtract ? 1 : 0});
  }
  if (chooses) parameters.push_back({"MAXIMUM", node.operation == Operation::maximum ? 1 : 0});
  if (const auto scaling = datapath::scaling_of(graph_, node)) {
    parameters.push_back({"SCALE", scaling->exponent});
  }
  const Arithmetic& arithmetic = graph_.arithmetic;
  parameters.push_back({"GRADUAL", arithmetic.subnormals == Subnormals::gradual ? 1 : 0});
  if (!chooses) {
    parameters.push_back({"TOWARD_ZERO", arithmetic.rounding == Rounding::toward_zero ? 1 : 0});
  }
  const error::Hazards hazards = hazards_.empty() ? error::Hazards{} : hazards_[id];
  if (!hazards.special_operand) parameters.push_back({"SPECIAL_OPERANDS", 0});
  if (!hazards.overflow) parameters.push_back({"OVERFLOW", 0});
  if (!hazards.underflow) parameters.push_back({"UNDERFLOW", 0});
  if (!hazards.cancellation) parameters.push_back({"CANCELLATION", 0});
  append_multiplier_parameters(schedule_.steps[id].unit, parameters);
  parameters.push_back({"CUTS", cut_mask(schedule_.steps[id])});
  return parameters;
}

}  // namespace mixcmp::rtl
