#include "generator/rtl/reference_module.hpp"

#include "generator/rtl/float_nodes.hpp"
#include "generator/rtl/net_names.hpp"
#include "generator/rtl/part_decision.hpp"
#include "model/error/hazards.hpp"

namespace mixcmp::rtl {
namespace {

Parameter gradual_parameter(const Arithmetic& arithmetic) {
  return {"GRADUAL", arithmetic.subnormals == Subnormals::gradual ? 1 : 0};
}

/// Builds the comparison of a fused sum, `sum`, with zero.
PartDecision build_fused_comparison(DatapathBuilder& datapath, FloatNodes& nodes,
                                    const TypedGraph& reference, std::size_t part, NodeId sum,
                                    const datapath::Step& step) {
  const TypedNode& node = reference.nodes[sum];
  const std::vector<Operand> operands = nodes.term_operands(node, step.start_cycle);
  PartDecision made = begin_decision(datapath, step, part, reference.parts.size(), Decides::always,
                                     "the sign of " + formula(reference, sum, nodes.names()) +
                                         ", whose terms are cut and whose sum is not rounded.");
  std::vector<Parameter> parameters = format_parameters(reference.arithmetic.format);
  for (Parameter& term : nodes.term_parameters(node)) parameters.push_back(std::move(term));
  parameters.push_back(gradual_parameter(reference.arithmetic));
  append_technology_parameters(step.unit, parameters);
  parameters.push_back({"CUTS", cut_mask(step)});
  datapath.add(Instance{step.unit.module,
                        made.instance,
                        std::move(parameters),
                        {{"aclk", net("aclk")},
                         {"a", operands[0]},
                         {"b", operands[1]},
                         {"verdict", made.verdict.value}}});
  return made;
}

PartDecision build_comparison(DatapathBuilder& datapath, FloatNodes& nodes,
                              const TypedGraph& reference, std::size_t part,
                              const datapath::Step& step) {
  const Arithmetic& arithmetic = reference.arithmetic;
  const auto [f_node, g_node] = reference.parts[part];
  if (reference.nodes[f_node].is_sign_of_sum()) {
    return build_fused_comparison(datapath, nodes, reference, part, f_node, step);
  }
  const Operand f = datapath.at(nodes.value(f_node), step.start_cycle);
  const Operand g = datapath.at(nodes.value(g_node), step.start_cycle);
  PartDecision made = begin_decision(datapath, step, part, reference.parts.size(), Decides::always,
                                     "the ordering of two rounded numbers.");
  std::vector<Parameter> parameters = format_parameters(arithmetic.format);
  parameters.push_back(gradual_parameter(arithmetic));
  parameters.push_back({"CUTS", cut_mask(step)});
  datapath.add(
      Instance{step.unit.module,
               made.instance,
               std::move(parameters),
               {{"aclk", net("aclk")}, {"a", f}, {"b", g}, {"verdict", made.verdict.value}}});
  return made;
}

void build_reference(DatapathBuilder& datapath, const TypedGraph& reference,
                     const datapath::Schedule& schedule) {
  FloatNodes nodes(datapath, reference, error::structural_hazards(reference), schedule,
                   ExceptionalFlags::unused);
  nodes.build();
  std::vector<PartDecision> parts;
  for (std::size_t part = 0; part < reference.parts.size(); ++part) {
    parts.push_back(
        build_comparison(datapath, nodes, reference, part, schedule.parts[part].decision));
  }
  build_combination(datapath, reference.combination, parts, schedule.combination);
}

}  // namespace

Module reference_module(std::string name, const std::vector<std::string>& inputs,
                        const TypedGraph& reference, const datapath::Schedule& schedule) {
  return datapath_module(
      std::move(name), operands_of_width(inputs, reference.input_format.width()),
      {{Direction::output, 2, "verdict"}},
      [&](DatapathBuilder& datapath) { build_reference(datapath, reference, schedule); },
      schedule.initiation_interval);
}

}  // namespace mixcmp::rtl
