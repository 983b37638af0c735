#include "generator/rtl/float_lane_module.hpp"

#include "generator/rtl/bound_unit_builder.hpp"
#include "generator/rtl/float_nodes.hpp"
#include "generator/rtl/part_decision.hpp"
#include "generator/rtl/range_checks.hpp"
#include "model/common/check.hpp"

namespace mixcmp::rtl {
namespace {

/// Builds the decisions of a lane, part by part.
class LaneDecisions {
public:
  LaneDecisions(DatapathBuilder& datapath, const FloatNodes& nodes, const error::Lane& lane,
                const datapath::Schedule& schedule)
      : datapath_(datapath),
        nodes_(nodes),
        lane_(lane),
        schedule_(schedule),
        format_(lane.graph.arithmetic.format) {}

  PartDecision build(std::size_t part, const Signal& out_of_range) {
    const auto build = [&](const auto& criterion) {
      return this->build(part, criterion, out_of_range);
    };
    return std::visit(build, lane_.parts[part].criterion);
  }

private:
  PartDecision build(std::size_t part, const error::UlpDistanceCriterion& criterion,
                     const Signal& out_of_range) {
    const auto [f_node, g_node] = lane_.graph.parts[part];
    const datapath::Step& step = schedule_.parts[part].decision;
    const Operand f = datapath_.at(nodes_.value(f_node), step.start_cycle);
    const Operand g = datapath_.at(nodes_.value(g_node), step.start_cycle);
    const Operand exceptional = datapath_.any_at(
        {nodes_.flag(f_node), nodes_.flag(g_node), out_of_range}, step.start_cycle);
    PartDecision made = begin(part, "certain where the encodings are GUARD_ULP or more apart.");
    std::vector<Parameter> parameters = format_parameters(format_);
    parameters.push_back({"GUARD_ULP", Literal{format_.width(), criterion.guard_ulp}});
    parameters.push_back({"NONNEGATIVE", criterion.nonnegative ? 1 : 0});
    parameters.push_back({"CUTS", cut_mask(step)});
    datapath_.add(Instance{step.unit.module,
                           made.instance,
                           std::move(parameters),
                           {{"aclk", net("aclk")},
                            {"f", f},
                            {"g", g},
                            {"exceptional", exceptional},
                            {"verdict", made.verdict.value},
                            {"decided", made.decided.value}}});
    return made;
  }

  PartDecision build(std::size_t part, const error::AbsoluteBoundCriterion& criterion,
                     const Signal& out_of_range) {
    const datapath::Step& step = schedule_.parts[part].decision;
    BoundUnitBuilder bounds(datapath_, nodes_, lane_, criterion, schedule_.parts[part],
                            part_suffix(part, lane_.parts.size()));
    bounds.build();
    std::vector<Signal> exceptions = bounds.failures();
    exceptions.push_back(nodes_.flag(criterion.difference));
    exceptions.push_back(out_of_range);
    const Operand difference = datapath_.at(nodes_.value(criterion.difference), step.start_cycle);
    const Operand bound = datapath_.at(bounds.bound(), step.start_cycle);
    const Operand exceptional = datapath_.any_at(exceptions, step.start_cycle);
    PartDecision made = begin(part, "certain where the difference exceeds the bound of its error.");
    std::vector<Parameter> parameters = format_parameters(format_);
    parameters.push_back({"BOUND_PRECISION", criterion.bound.format.precision});
    parameters.push_back({"GUARD_ULP", Literal{format_.width(), criterion.guard_ulp}});
    parameters.push_back({"CUTS", cut_mask(step)});
    datapath_.add(Instance{step.unit.module,
                           made.instance,
                           std::move(parameters),
                           {{"aclk", net("aclk")},
                            {"difference", difference},
                            {"bound", bound},
                            {"exceptional", exceptional},
                            {"verdict", made.verdict.value},
                            {"decided", made.decided.value}}});
    return made;
  }

  PartDecision build(std::size_t part, const error::IntervalCriterion& criterion,
                     const Signal& out_of_range) {
    // The unit of the paper's decision has no `exceptional` input.
    MIXCMP_CHECK(out_of_range.value == nullptr);
    const datapath::Step& step = schedule_.parts[part].decision;
    const Operand minimum = datapath_.at(nodes_.value(criterion.minimum), step.start_cycle);
    const Operand maximum = datapath_.at(nodes_.value(criterion.maximum), step.start_cycle);
    PartDecision made = begin(part, "case I, II or III of the paper.");
    std::vector<Parameter> parameters = format_parameters(format_);
    parameters.push_back({"CUTS", cut_mask(step)});
    datapath_.add(Instance{step.unit.module,
                           made.instance,
                           std::move(parameters),
                           {{"aclk", net("aclk")},
                            {"minimum", minimum},
                            {"maximum", maximum},
                            {"verdict", made.verdict.value},
                            {"decided", made.decided.value}}});
    return made;
  }

  PartDecision begin(std::size_t part, std::string_view what) {
    return begin_decision(datapath_, schedule_.parts[part].decision, part, lane_.parts.size(),
                          Decides::sometimes, what);
  }

  DatapathBuilder& datapath_;
  const FloatNodes& nodes_;
  const error::Lane& lane_;
  const datapath::Schedule& schedule_;
  FloatFormat format_;
};

void build_lane(DatapathBuilder& datapath, const error::Lane& lane,
                const datapath::Schedule& schedule) {
  const ExceptionalFlags exceptional =
      lane.certified() ? ExceptionalFlags::gathered : ExceptionalFlags::unused;
  FloatNodes nodes(datapath, lane.graph, lane.hazards, schedule, exceptional);
  const std::vector<Signal> out_of_range = build_range_checks(datapath, lane, schedule);
  nodes.build();
  LaneDecisions decisions(datapath, nodes, lane, schedule);
  std::vector<PartDecision> parts;
  for (std::size_t part = 0; part < lane.parts.size(); ++part) {
    parts.push_back(decisions.build(part, out_of_range[part]));
  }
  build_combination(datapath, lane.graph.combination, parts, schedule.combination);
}

}  // namespace

Module lane_module(std::string name, const std::vector<InputPort>& ports, const error::Lane& lane,
                   const datapath::Schedule& schedule) {
  return datapath_module(std::move(name), ports, lane_outputs(),
                         [&](DatapathBuilder& datapath) { build_lane(datapath, lane, schedule); });
}

}  // namespace mixcmp::rtl
