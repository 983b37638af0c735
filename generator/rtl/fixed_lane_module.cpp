#include "generator/rtl/fixed_lane_module.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string>

#include "generator/datapath/fixed_units.hpp"
#include "generator/rtl/fixed_nodes.hpp"
#include "generator/rtl/part_decision.hpp"
#include "model/number/dyadic.hpp"
#include "model/number/exact.hpp"

namespace mixcmp::rtl {
namespace {

using fixed::FixedLane;

/// Builds the decisions of a lane, part by part.
class FixedDecisions {
public:
  FixedDecisions(DatapathBuilder& datapath, FixedNodes& nodes, const FixedLane& lane,
                 const datapath::Schedule& schedule)
      : datapath_(datapath), nodes_(nodes), lane_(lane), schedule_(schedule) {}

  PartDecision build(std::size_t part) {
    const auto build = [&](const auto& thresholds) { return this->build(part, thresholds); };
    return std::visit(build, lane_.parts[part].criterion);
  }

private:
  PartDecision build(std::size_t part, const fixed::ConstantThresholds& thresholds) {
    const int width = difference_bits(part);
    // Constants beyond every difference decide as the nearest one does.
    const mpz_class above = shifted_left(1, width - 1);
    const mpz_class greater_from = std::clamp<mpz_class>(thresholds.greater_from, -above, above);
    const mpz_class less_to = std::clamp<mpz_class>(thresholds.less_to, -above - 1, above - 1);
    return add(part,
               thresholds.exact ? "exact, certain everywhere."
                                : "certain where the difference exceeds its error.",
               {{"WIDTH", width},
                {"GREATER_FROM", twos_complement(width + 1, greater_from)},
                {"LESS_TO", twos_complement(width + 1, less_to)},
                {"EXACT", thresholds.exact ? 1 : 0}},
               {});
  }

  PartDecision build(std::size_t part, const fixed::NormThresholds& thresholds) {
    const Signal& radius = nodes_.value(thresholds.radius);
    const int start = step(part).start_cycle;
    const Operand beyond_reach =
        datapath_.any_at({nodes_.beyond_reach(lane_.parts[part].difference)}, start);
    const int threshold = datapath::threshold_bits(lane_, thresholds);
    return add(part,
               "certain where the difference exceeds what follows from the norm of the errors.",
               {{"WIDTH", difference_bits(part)},
                {"RADIUS_WIDTH", radius.width},
                {"ROOT", thresholds.radius_is_squared ? 1 : 0},
                {"THRESHOLD_WIDTH", threshold},
                {"SHIFT_ABOVE", thresholds.shift_above},
                {"OFFSET_ABOVE", Literal{threshold, to_bits(thresholds.offset_above)}},
                {"SHIFT_BELOW", thresholds.shift_below},
                {"SWAPPED", lane_.parts[part].swapped ? 1 : 0}},
               {{"radius", datapath_.at(radius, start)}, {"beyond_reach", beyond_reach}});
  }

  /// Builds the unit that finds the threshold, then a decision like that of a norm with a slope of
  /// 1, no offset and no reaches.
  PartDecision build(std::size_t part, const fixed::RunningThresholds& thresholds) {
    const Signal threshold = build_threshold(part, thresholds);
    return add(part, "certain where the difference exceeds the threshold of its step.",
               {{"WIDTH", difference_bits(part)},
                {"RADIUS_WIDTH", threshold.width},
                {"ROOT", 0},
                {"THRESHOLD_WIDTH", threshold.width + 1},
                {"SHIFT_ABOVE", 0},
                {"OFFSET_ABOVE", Literal{threshold.width + 1, 0}},
                {"SHIFT_BELOW", 0},
                {"SWAPPED", 0}},
               {{"radius", datapath_.at(threshold, step(part).start_cycle)},
                {"beyond_reach", literal(1, 0)}});
  }

  Signal build_threshold(std::size_t part, const fixed::RunningThresholds& thresholds) {
    const datapath::Step& placed = schedule_.parts[part].threshold;
    const std::string name = datapath_.pool().unique("threshold");
    const int bits = datapath::threshold_bits(thresholds);
    const auto last = static_cast<int>(thresholds.of_steps.size()) - 1;
    std::vector<Operand> leading;
    for (const NodeId id : thresholds.watched) {
      const int kept = lane_.nodes[id].format.magnitude_bits() - last;
      leading.push_back(nodes_.excess_bits(id, kept, last, placed.start_cycle));
    }
    std::vector<Parameter> parameters = {
        {"COUNT", static_cast<int>(leading.size())}, {"LAST", last}, {"WIDTH", bits}};
    for (std::size_t step = 0; step < thresholds.of_steps.size(); ++step) {
      parameters.push_back(
          {"THRESHOLD_" + std::to_string(step), Literal{bits, to_bits(thresholds.of_steps[step])}});
    }
    parameters.push_back({"CUTS", cut_mask(placed)});
    datapath_.add(Comment{fmt::format(
        "Cycles {} to {}: the threshold, smaller where all that is multiplied is small.",
        placed.start_cycle, placed.ready_cycle)});
    datapath_.add(Wire{bits, name, nullptr});
    datapath_.add(Instance{placed.unit.module,
                           datapath_.pool().unique("unit_" + name),
                           std::move(parameters),
                           {{"aclk", net("aclk")},
                            {"leading", concatenation(std::move(leading))},
                            {"threshold", net(name)}}});
    return {net(name), name, bits, placed.ready_cycle};
  }

  const datapath::Step& step(std::size_t part) const { return schedule_.parts[part].decision; }

  int difference_bits(std::size_t part) const {
    const FixedFormat& format = lane_.nodes[lane_.parts[part].difference].format;
    return format.width + (format.is_signed ? 0 : 1);
  }

  /// Adds the unit, with the ports that all decisions have and `operands`.
  PartDecision add(std::size_t part, std::string_view what, std::vector<Parameter> parameters,
                   std::vector<Connection> operands) {
    const NodeId difference = lane_.parts[part].difference;
    const int start = step(part).start_cycle;
    const Operand out_of_range = datapath_.any_at({nodes_.out_of_range(difference)}, start);
    const Operand value = nodes_.signed_value(difference, start);
    const PartDecision made =
        begin_decision(datapath_, step(part), part, lane_.parts.size(), Decides::sometimes, what);
    parameters.push_back({"CUTS", cut_mask(step(part))});
    std::vector<Connection> connections = {{"aclk", net("aclk")}, {"difference", value}};
    connections.insert(connections.end(), operands.begin(), operands.end());
    connections.push_back({"out_of_range", out_of_range});
    connections.push_back({"verdict", made.verdict.value});
    connections.push_back({"decided", made.decided.value});
    datapath_.add(Instance{step(part).unit.module, made.instance, std::move(parameters),
                           std::move(connections)});
    return made;
  }

  DatapathBuilder& datapath_;
  FixedNodes& nodes_;
  const FixedLane& lane_;
  const datapath::Schedule& schedule_;
};

void build_lane(DatapathBuilder& datapath, const FixedLane& lane,
                const datapath::Schedule& schedule) {
  FixedNodes nodes(datapath, lane, schedule);
  nodes.build();
  FixedDecisions decisions(datapath, nodes, lane, schedule);
  std::vector<PartDecision> parts;
  for (std::size_t part = 0; part < lane.parts.size(); ++part) {
    parts.push_back(decisions.build(part));
  }
  build_combination(datapath, lane.combination, parts, schedule.combination);
}

}  // namespace

Module lane_module(std::string name, const std::vector<InputPort>& ports, const FixedLane& lane,
                   const datapath::Schedule& schedule) {
  return datapath_module(std::move(name), ports, lane_outputs(),
                         [&](DatapathBuilder& datapath) { build_lane(datapath, lane, schedule); });
}

}  // namespace mixcmp::rtl
