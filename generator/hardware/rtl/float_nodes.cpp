#include "generator/hardware/rtl/float_nodes.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "model/base/common/check.hpp"

namespace mixcmp::rtl {
namespace {

/// The hazards of a unit that computes operations with either of these hazards.
error::Hazards either(const error::Hazards& a, const error::Hazards& b) {
  return {.special_operand = a.special_operand || b.special_operand,
          .overflow = a.overflow || b.overflow,
          .underflow = a.underflow || b.underflow,
          .cancellation = a.cancellation || b.cancellation};
}

}  // namespace

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
      names_(name_nodes(graph, datapath.ports(), datapath.pool())),
      selecting_(graph, schedule, datapath.pool()) {
  name_sums_inside_squares();
}

/// A sum that its square's unit computes has no wire: its formula stands for it in comments.
void FloatNodes::name_sums_inside_squares() {
  for (NodeId id = 0; id < static_cast<NodeId>(graph_.nodes.size()); ++id) {
    if (is_inside_its_square(id)) names_[id] = fmt::format("({})", formula(graph_, id, names_));
  }
}

void FloatNodes::build() {
  declare_unused_flags();
  declare_selecting_units();
  for (NodeId id = 0; id < static_cast<NodeId>(graph_.nodes.size()); ++id) build_node(id);
  selecting_.sort_by_phase();
  build_selecting_units();
}

/// Declares the results of shared units ahead of the units: a unit may read a result that another
/// computed in an earlier interval.
void FloatNodes::declare_selecting_units() {
  if (selecting_.units().empty()) return;
  datapath_.add(Comment{"The results of the units that several operations share."});
  for (const auto& [index, unit] : selecting_.units()) {
    datapath_.add(Wire{unit.node.format.width(), unit.name + "_result", nullptr});
  }
}

void FloatNodes::build_selecting_units() {
  for (const auto& [index, unit] : selecting_.units()) build_selecting_unit(unit, index);
}

/// The input `start` of a unit that takes several cycles for an operation: 1 when its operand is
/// there.
Operand FloatNodes::build_start(const std::string& unit, std::vector<Literal> phases) {
  const std::string name = datapath_.pool().unique(unit + "_start");
  datapath_.add(PhaseFlag{name, std::move(phases)});
  return net(name);
}

/// The phases in which the operands of a shared unit are there. If it selects them, that is a cycle
/// after they are read into its registers.
std::vector<Literal> FloatNodes::start_phases(const SelectingUnits::Unit& unit,
                                              bool selects) const {
  std::vector<Literal> phases;
  for (const PhaseCase& read : unit.cases) {
    phases.push_back(datapath_.phase(static_cast<int>(read.phase.value) + (selects ? 1 : 0)));
  }
  return phases;
}

/// A unit of a folded datapath, behind the registers of its operands if it has any.
void FloatNodes::build_selecting_unit(const SelectingUnits::Unit& unit, std::size_t index) {
  const datapath::SharedUnit& shared = schedule_.shared_units[index];
  std::vector<std::string> registers;
  std::vector<Connection> connections;
  for (std::size_t k = 0; k < unit.cases.front().values.size(); ++k) {
    const std::string port = k == 0 ? "a" : "b";
    if (shared.selects) {
      registers.push_back(datapath_.pool().unique(unit.name + "_" + port));
      connections.push_back({port, net(registers.back())});
    } else {
      connections.push_back({port, unit.cases.front().values[k]});
    }
  }
  connections.push_back({"y", net(unit.name + "_result")});
  connections.push_back({"exceptional", bit(unused_name_, unused_flags_++)});
  error::Hazards hazards = {false, false, false, false};
  for (const NodeId id : shared.operations) hazards = either(hazards, hazards_of(id));
  datapath_.add(Comment{fmt::format(
      "The {}: {} operations, {} cycles from operands to result.", unit.name, unit.cases.size(),
      std::count(shared.cuts.begin(), shared.cuts.end(), true) + (shared.selects ? 1 : 0))});
  if (shared.selects) {
    datapath_.add(
        PhaseRegisters{unit.node.operand_format.width(), std::move(registers), unit.cases});
  } else {
    for (const PhaseCase& read : unit.cases) {
      datapath_.add(
          Comment{fmt::format("Phase {}: {}.", static_cast<int>(read.phase.value), read.comment)});
    }
  }
  if (shared.unit.initiation_interval > 1) {
    const Operand start = build_start(unit.name, start_phases(unit, shared.selects));
    connections.insert(connections.begin(), {"start", start});
  }
  datapath_.add_unit({shared.unit, shared.cuts}, "unit_" + unit.name,
                     unit_parameters(unit.node, hazards, shared.unit), std::move(connections));
}

void FloatNodes::declare_unused_flags() {
  int count = static_cast<int>(selecting_.units().size());
  for (NodeId id = 0; id < static_cast<NodeId>(graph_.nodes.size()); ++id) {
    const TypedNode& node = graph_.nodes[id];
    const bool has_own_unit =
        !schedule_.steps[id].unit.module.empty() && selecting_.find(id) == nullptr;
    const bool has_flag =
        !(node.operation == Operation::square && is_inside_its_square(node.operands[0]));
    if (has_own_unit && has_flag && !gathers_flag(id)) ++count;
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
    case Operation::input:
      values_[id].value = net(datapath_.port(node.input));
      values_[id].lasts = datapath_.initiation_interval() - 1;
      break;
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
    case Operation::maximum:
    case Operation::fused_sum: build_unit(id); break;
    case Operation::function:
    case Operation::look_up: break;
  }
}

void FloatNodes::build_sign_change(NodeId id) {
  const TypedNode& node = graph_.nodes[id];
  const Signal operand = values_[node.operands[0]];
  const int top = node.format.width() - 1;
  const bool negate = node.operation == Operation::negate;
  // A literal has no bits to select: give the constant a name first.
  std::string source;
  if (operand.constant) {
    source = datapath_.pool().unique(operand.name + "_bits");
    datapath_.add(Wire{node.format.width(), source, operand.value});
  } else {
    source = std::get<Net>(operand.value->node).name;
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
  values_[id].lasts = operand.lasts;
  flags_[id] = flags_[node.operands[0]];
}

/// Tells whether a sum is computed by the unit of its square.
bool FloatNodes::is_inside_its_square(NodeId id) const {
  const Operation operation = graph_.nodes[id].operation;
  const bool adds = operation == Operation::add || operation == Operation::subtract;
  return adds && schedule_.steps[id].unit.module.empty();
}

/// Builds a square together with the sum that it squares.
void FloatNodes::build_squared_sum(NodeId id) {
  const TypedNode& node = graph_.nodes[id];
  const datapath::Step& step = schedule_.steps[id];
  const NodeId sum = node.operands[0];
  const std::vector<Operand> operands = unit_operands(sum);
  std::vector<Parameter> parameters = format_parameters(node.format);
  parameters.push_back({"SUBTRACT", graph_.nodes[sum].operation == Operation::subtract ? 1 : 0});
  const bool gradual = graph_.arithmetic.subnormals == Subnormals::gradual;
  parameters.push_back({"GRADUAL", gradual ? 1 : 0});
  append_technology_parameters(step.unit, parameters);
  datapath_.describe(step, fmt::format("{}^2, in {}; the sum that is squared is also rounded.",
                                       names_[sum], node.format.name()));
  values_[id] = datapath_.declare(names_[id], node.format.width(), step.ready_cycle);
  datapath_.add_unit(step, "unit_" + names_[id], std::move(parameters),
                     {{"a", operands[0]}, {"b", operands[1]}, {"y", values_[id].value}});
}

void FloatNodes::build_unit(NodeId id) {
  const TypedNode& node = graph_.nodes[id];
  const datapath::Step& step = schedule_.steps[id];
  if (is_inside_its_square(id) || node.is_sign_of_sum()) return;
  if (node.operation == Operation::square && is_inside_its_square(node.operands[0])) {
    return build_squared_sum(id);
  }
  std::vector<Operand> operands = unit_operands(id);
  if (const SelectingUnits::Unit* unit = selecting_.find(id)) {
    if (node.operation == Operation::subtract) {
      operands[1] = sign_changed(operands[1], node.operand_format.width());
    }
    const bool by_multiplier = unit->node.operation == Operation::multiply;
    if (node.operation == Operation::square && by_multiplier) operands.push_back(operands.front());
    selecting_.read(id, datapath_.phase(step.start_cycle),
                    fmt::format("{} = {}", names_[id], formula(graph_, id, names_)),
                    std::move(operands));
    values_[id].value = net(unit->name + "_result");
    return;
  }
  datapath_.describe(step, description(id));
  values_[id] = datapath_.declare(names_[id], node.format.width(), step.ready_cycle);
  std::vector<Connection> connections;
  for (std::size_t k = 0; k < operands.size(); ++k) {
    connections.push_back({k == 0 ? "a" : "b", operands[k]});
  }
  connections.push_back({"y", values_[id].value});
  connections.push_back({"exceptional", flag_output(id)});
  if (step.unit.initiation_interval > 1) {
    const Operand start = build_start(names_[id], {datapath_.phase(step.start_cycle)});
    connections.insert(connections.begin(), {"start", start});
  }
  datapath_.add_unit(step, "unit_" + names_[id], unit_parameters(node, hazards_of(id), step.unit),
                     std::move(connections));
  if (exceptional_ == ExceptionalFlags::gathered) gather_flags(id);
}

/// The operands that the unit of a node reads in the node's start cycle.
std::vector<Operand> FloatNodes::unit_operands(NodeId id) {
  const TypedNode& node = graph_.nodes[id];
  const int cycle = schedule_.steps[id].start_cycle;
  if (const auto scaling = datapath::scaling_of(graph_, node)) {
    const Operand operand = datapath_.at(values_[scaling->operand], cycle);
    return {scaling->negated ? negated(id, operand) : operand};
  }
  if (node.operation == Operation::fused_sum) return term_operands(node, cycle);
  std::vector<Operand> operands;
  for (int k = 0; k < arity(node.operation); ++k) {
    operands.push_back(datapath_.at(values_[node.operands[k]], cycle));
  }
  return operands;
}

bool FloatNodes::squares_a_sum(const FusedTerm& term) const {
  return term.is_square() && is_inside_its_square(term.a);
}

std::vector<Operand> FloatNodes::term_operands(const TypedNode& node, int cycle) {
  const int width = node.operand_format.width();
  bool any_second = false;
  std::vector<Operand> first, second;
  for (auto term = node.terms.rbegin(); term != node.terms.rend(); ++term) {
    const bool of_sum = squares_a_sum(*term);
    const auto [a, b] = of_sum ? graph_.nodes[term->a].operands : std::array{term->a, term->b};
    const bool has_second = of_sum || (term->is_product() && !term->is_square());
    first.push_back(datapath_.at(values_[a], cycle));
    second.push_back(has_second ? datapath_.at(values_[b], cycle) : zeros(width));
    any_second |= has_second;
  }
  const auto unread = zeros(width * static_cast<int>(node.terms.size()));
  return {concatenation(std::move(first)), any_second ? concatenation(std::move(second)) : unread};
}

/// The parameters of the terms. A mask of zeros is the default, so it is left out.
std::vector<Parameter> FloatNodes::term_parameters(const TypedNode& node) const {
  const int count = static_cast<int>(node.terms.size());
  std::vector<Parameter> parameters = {{"TERMS", count}};
  const auto mask = [&](const char* name, auto has) {
    Bits bits = 0;
    for (int k = 0; k < count; ++k) bits |= Bits{has(node.terms[static_cast<std::size_t>(k)])} << k;
    if (bits != 0) parameters.push_back({name, Literal{count, bits}});
  };
  const auto squares_result_of = [&](const FusedTerm& term, Operation operation) {
    return squares_a_sum(term) && graph_.nodes[term.a].operation == operation;
  };
  mask("SQUARES", [&](const FusedTerm& term) { return term.is_square() && !squares_a_sum(term); });
  mask("PLAIN", [](const FusedTerm& term) { return !term.is_product(); });
  mask("SUMS", [&](const FusedTerm& term) { return squares_result_of(term, Operation::add); });
  mask("DIFFERENCES",
       [&](const FusedTerm& term) { return squares_result_of(term, Operation::subtract); });
  mask("NEGATED", [](const FusedTerm& term) { return term.negated; });
  return parameters;
}

/// The operand of a scaling with its sign changed.
Operand FloatNodes::negated(NodeId id, const Operand& operand) {
  const int width = graph_.nodes[id].operand_format.width();
  const std::string factor = datapath_.pool().unique(names_[id] + "_factor");
  datapath_.add(Wire{width, factor, operand});
  return concatenation({inverted(bit(factor, width - 1)), slice(factor, width - 2, 0)});
}

/// Tells whether the unit's `exceptional` output is read. That of a square root always is: hazards
/// never rule out a negative operand.
bool FloatNodes::gathers_flag(NodeId id) const {
  if (exceptional_ == ExceptionalFlags::unused) return false;
  if (hazards_.empty() || graph_.nodes[id].operation == Operation::square_root) return true;
  const error::Hazards& hazards = hazards_[id];
  return hazards.special_operand || hazards.overflow || hazards.underflow;
}

Operand FloatNodes::flag_output(NodeId id) {
  if (!gathers_flag(id)) return bit(unused_name_, unused_flags_++);
  flags_[id] = datapath_.declare(datapath_.pool().unique(names_[id] + "_exceptional"), 1,
                                 schedule_.steps[id].ready_cycle);
  return flags_[id].value;
}

/// Builds the flag that travels with the value: it is set if this operation or one before it was
/// exceptional.
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

std::string FloatNodes::description(NodeId id) const {
  const TypedNode& node = graph_.nodes[id];
  return fmt::format("{}, {} {}.", formula(graph_, id, names_),
                     node.format == node.operand_format ? "in" : "rounded once to",
                     node.format.name());
}

error::Hazards FloatNodes::hazards_of(NodeId id) const {
  return hazards_.empty() ? error::Hazards{} : hazards_[id];
}

std::vector<Parameter> FloatNodes::unit_parameters(const TypedNode& node,
                                                   const error::Hazards& hazards,
                                                   const datapath::Unit& unit) const {
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
  if (node.operation == Operation::fused_sum) {
    for (Parameter& parameter : term_parameters(node)) parameters.push_back(std::move(parameter));
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
  if (!hazards.special_operand) parameters.push_back({"SPECIAL_OPERANDS", 0});
  if (!hazards.overflow) parameters.push_back({"OVERFLOW", 0});
  if (!hazards.underflow) parameters.push_back({"UNDERFLOW", 0});
  if (!hazards.cancellation) parameters.push_back({"CANCELLATION", 0});
  append_technology_parameters(unit, parameters);
  return parameters;
}

}  // namespace mixcmp::rtl
