#include "generator/rtl/reference_module.hpp"

#include "generator/rtl/float_nodes.hpp"
#include "generator/rtl/part_decision.hpp"
#include "model/error/hazards.hpp"

namespace mixcmp::rtl {
namespace {

PartDecision build_comparison(DatapathBuilder& datapath, const FloatNodes& nodes,
                              const TypedGraph& reference, std::size_t part,
                              const datapath::Step& step) {
  const Arithmetic& arithmetic = reference.arithmetic;
  const auto [f_node, g_node] = reference.parts[part];
  const Operand f = datapath.at(nodes.value(f_node), step.start_cycle);
  const Operand g = datapath.at(nodes.value(g_node), step.start_cycle);
  PartDecision made = begin_decision(datapath, step, part, reference.parts.size(), Decides::always,
                                     "the ordering of two rounded numbers.");
  std::vector<Parameter> parameters = format_parameters(arithmetic.format);
  parameters.push_back({"GRADUAL", arithmetic.subnormals == Subnormals::gradual ? 1 : 0});
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
