#include "generator/hardware/rtl/reference_module.hpp"

#include "generator/hardware/rtl/float_nodes.hpp"
#include "generator/hardware/rtl/lane_module.hpp"
#include "generator/hardware/rtl/net_names.hpp"
#include "generator/hardware/rtl/part_decision.hpp"
#include "model/lane/error/hazards.hpp"

namespace mixcmp::rtl {
namespace {

Parameter gradual_parameter(const Arithmetic& arithmetic) {
  return {"GRADUAL", arithmetic.subnormals == Subnormals::gradual ? 1 : 0};
}

/// The comparison of a fused sum, `sum`, with zero.
DecisionUnit fused_comparison(FloatNodes& nodes, const TypedGraph& reference, NodeId sum,
                              const datapath::Step& step) {
  const TypedNode& node = reference.nodes[sum];
  const std::vector<Operand> operands = nodes.term_operands(node, step.start_cycle);
  std::vector<Parameter> parameters = format_parameters(reference.arithmetic.format);
  for (Parameter& term : nodes.term_parameters(node)) parameters.push_back(std::move(term));
  parameters.push_back(gradual_parameter(reference.arithmetic));
  append_technology_parameters(step.unit, parameters);
  return {"the sign of " + formula(reference, sum, nodes.names()) +
              ", whose terms are cut and whose sum is not rounded.",
          std::move(parameters),
          {{"a", operands[0]}, {"b", operands[1]}}};
}

DecisionUnit comparison(DatapathBuilder& datapath, FloatNodes& nodes, const TypedGraph& reference,
                        const Sides& part, const datapath::Step& step) {
  if (reference.nodes[part.f].is_sign_of_sum()) {
    return fused_comparison(nodes, reference, part.f, step);
  }
  const Operand f = datapath.at(nodes.value(part.f), step.start_cycle);
  const Operand g = datapath.at(nodes.value(part.g), step.start_cycle);
  std::vector<Parameter> parameters = format_parameters(reference.arithmetic.format);
  parameters.push_back(gradual_parameter(reference.arithmetic));
  return {"the ordering of two rounded numbers.", std::move(parameters), {{"a", f}, {"b", g}}};
}

void build_reference(DatapathBuilder& datapath, const TypedGraph& reference,
                     const datapath::Schedule& schedule) {
  FloatNodes nodes(datapath, reference, error::structural_hazards(reference), schedule,
                   ExceptionalFlags::unused);
  nodes.build();
  std::vector<PartDecision> parts;
  for (std::size_t part = 0; part < reference.parts.size(); ++part) {
    const datapath::Step& step = schedule.parts[part].decision;
    parts.push_back(
        build_decision(datapath, step, part, reference.parts.size(), Decides::always,
                       comparison(datapath, nodes, reference, reference.parts[part], step)));
  }
  build_combination(datapath, reference.combination, parts, schedule.combination);
}

}  // namespace

Module reference_module(std::string name, const std::vector<std::string>& inputs,
                        const design::ReferenceDatapath& reference,
                        const datapath::Schedule& schedule) {
  if (const auto* const fixed = std::get_if<fixed::FixedLane>(&reference)) {
    return fixed_reference_module(std::move(name), inputs, *fixed, schedule);
  }
  const auto& graph = std::get<TypedGraph>(reference);
  std::vector<InputPort> ports = operands_of_width(inputs, graph.input_format.width());
  widen(ports, graph.arriving, graph.input_format, schedule);
  return datapath_module(
      std::move(name), ports, {{Direction::output, 2, "verdict"}},
      [&](DatapathBuilder& datapath) { build_reference(datapath, graph, schedule); },
      schedule.initiation_interval, schedule.entry_cycles);
}

}  // namespace mixcmp::rtl
