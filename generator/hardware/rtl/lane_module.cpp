#include "generator/hardware/rtl/lane_module.hpp"

#include <algorithm>

#include "generator/hardware/datapath/fixed_units.hpp"
#include "generator/hardware/rtl/bound_unit_builder.hpp"
#include "generator/hardware/rtl/fixed_nodes.hpp"
#include "generator/hardware/rtl/float_nodes.hpp"
#include "generator/hardware/rtl/part_decision.hpp"
#include "generator/hardware/rtl/range_checks.hpp"
#include "model/base/common/cases.hpp"
#include "model/base/common/check.hpp"
#include "model/base/number/dyadic.hpp"
#include "model/base/number/exact.hpp"

namespace mixcmp::rtl {
namespace {

using fixed::FixedLane;

/// The nodes, checks and decisions of a lane in floating point.
class FloatParts {
public:
  FloatParts(DatapathBuilder& datapath, const error::Lane& lane, const datapath::Schedule& schedule)
      : datapath_(datapath),
        lane_(lane),
        schedule_(schedule),
        nodes_(datapath, lane.graph, lane.hazards, schedule,
               lane.certified() ? ExceptionalFlags::gathered : ExceptionalFlags::unused),
        format_(lane.graph.arithmetic.format) {}

  void build_nodes() {
    out_of_range_ = build_range_checks(datapath_, lane_, schedule_);
    nodes_.build();
  }

  Combination combination() const { return lane_.graph.combination; }
  Decides decides() const { return Decides::sometimes; }

  DecisionUnit decision(std::size_t part) {
    const auto unit = [&](const auto& criterion) { return decision(part, criterion); };
    return std::visit(unit, lane_.parts[part].criterion);
  }

private:
  DecisionUnit decision(std::size_t part, const error::UlpDistanceCriterion& criterion) {
    const auto [f_node, g_node] = lane_.graph.parts[part];
    const int start = start_of(part);
    const Operand f = datapath_.at(nodes_.value(f_node), start);
    const Operand g = datapath_.at(nodes_.value(g_node), start);
    const Operand exceptional =
        datapath_.any_at({nodes_.flag(f_node), nodes_.flag(g_node), out_of_range_[part]}, start);
    return {"certain where the encodings are GUARD_ULP or more apart.",
            with_format({{"GUARD_ULP", Literal{format_.width(), criterion.guard_ulp}},
                         {"NONNEGATIVE", criterion.nonnegative ? 1 : 0}}),
            {{"f", f}, {"g", g}, {"exceptional", exceptional}}};
  }

  DecisionUnit decision(std::size_t part, const error::AbsoluteBoundCriterion& criterion) {
    BoundUnitBuilder bounds(datapath_, nodes_, lane_, criterion, schedule_.parts[part],
                            part_suffix(part, lane_.parts.size()));
    bounds.build();
    std::vector<Signal> exceptions = bounds.failures();
    exceptions.push_back(nodes_.flag(criterion.difference));
    exceptions.push_back(out_of_range_[part]);
    const int start = start_of(part);
    const Operand difference = datapath_.at(nodes_.value(criterion.difference), start);
    const Operand bound = datapath_.at(bounds.bound(), start);
    const Operand exceptional = datapath_.any_at(exceptions, start);
    return {"certain where the difference exceeds the bound of its error.",
            with_format({{"BOUND_PRECISION", criterion.bound.format.precision},
                         {"GUARD_ULP", Literal{format_.width(), criterion.guard_ulp}}}),
            {{"difference", difference}, {"bound", bound}, {"exceptional", exceptional}}};
  }

  DecisionUnit decision(std::size_t part, const error::IntervalCriterion& criterion) {
    // The unit of the paper's decision has no `exceptional` input.
    MIXCMP_CHECK(out_of_range_[part].value == nullptr);
    const Operand minimum = datapath_.at(nodes_.value(criterion.minimum), start_of(part));
    const Operand maximum = datapath_.at(nodes_.value(criterion.maximum), start_of(part));
    return {"case I, II or III of the paper.",
            with_format({}),
            {{"minimum", minimum}, {"maximum", maximum}}};
  }

  int start_of(std::size_t part) const { return schedule_.parts[part].decision.start_cycle; }

  std::vector<Parameter> with_format(const std::vector<Parameter>& further) const {
    std::vector<Parameter> parameters = format_parameters(format_);
    parameters.insert(parameters.end(), further.begin(), further.end());
    return parameters;
  }

  DatapathBuilder& datapath_;
  const error::Lane& lane_;
  const datapath::Schedule& schedule_;
  FloatNodes nodes_;
  FloatFormat format_;
  std::vector<Signal> out_of_range_;  ///< [part]: an operand fails a check
};

/// The nodes, checks and decisions of a lane in fixed point.
class FixedParts {
public:
  FixedParts(DatapathBuilder& datapath, const FixedLane& lane, const datapath::Schedule& schedule,
             Decides decides)
      : datapath_(datapath),
        lane_(lane),
        schedule_(schedule),
        decides_(decides),
        nodes_(datapath, lane, schedule) {}

  void build_nodes() { nodes_.build(); }

  Combination combination() const { return lane_.combination; }
  Decides decides() const { return decides_; }

  DecisionUnit decision(std::size_t part) {
    const auto unit = [&](const auto& thresholds) { return decision(part, thresholds); };
    return std::visit(unit, lane_.parts[part].criterion);
  }

private:
  DecisionUnit decision(std::size_t part, const fixed::ConstantThresholds& thresholds) {
    const int width = difference_bits(part);
    // A constant beyond every difference decides like the nearest constant that the unit can have.
    const mpz_class above = shifted_left(1, width - 1);
    const mpz_class greater_from = std::clamp<mpz_class>(thresholds.greater_from, -above, above);
    const mpz_class less_to = std::clamp<mpz_class>(thresholds.less_to, -above - 1, above - 1);
    return unit(part,
                lane_.is_reference        ? "the order of f and g as computed."
                : thresholds.decides_ties ? "exact, certain everywhere."
                                          : "certain where the difference exceeds its error.",
                {{"WIDTH", width},
                 {"GREATER_FROM", twos_complement(width + 1, greater_from)},
                 {"LESS_TO", twos_complement(width + 1, less_to)},
                 {"EXACT", lane_.is_reference        ? 2
                           : thresholds.decides_ties ? 1
                                                     : 0}},
                {});
  }

  DecisionUnit decision(std::size_t part, const fixed::NormThresholds& thresholds) {
    const Signal& radius = nodes_.value(thresholds.radius);
    const int start = start_of(part);
    const Operand beyond_reach =
        datapath_.any_at({nodes_.beyond_reach(lane_.parts[part].difference)}, start);
    const int threshold = datapath::threshold_bits(lane_, thresholds);
    return unit(part,
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

  /// Builds the unit that finds the threshold. The decision is like that of a norm with a slope of
  /// 1, no offset and no reaches.
  DecisionUnit decision(std::size_t part, const fixed::RunningThresholds& thresholds) {
    const Signal threshold = build_threshold(schedule_.parts[part].threshold, thresholds);
    return unit(
        part, "certain where the difference exceeds the threshold of its step.",
        {{"WIDTH", difference_bits(part)},
         {"RADIUS_WIDTH", threshold.width},
         {"ROOT", 0},
         {"THRESHOLD_WIDTH", threshold.width + 1},
         {"SHIFT_ABOVE", 0},
         {"OFFSET_ABOVE", Literal{threshold.width + 1, 0}},
         {"SHIFT_BELOW", 0},
         {"SWAPPED", 0}},
        {{"radius", datapath_.at(threshold, start_of(part))}, {"beyond_reach", literal(1, 0)}});
  }

  Signal build_threshold(const datapath::Step& step, const fixed::RunningThresholds& thresholds) {
    const std::string name = datapath_.pool().unique("threshold");
    const int bits = datapath::threshold_bits(thresholds);
    const auto last = static_cast<int>(thresholds.of_steps.size()) - 1;
    std::vector<Operand> leading;
    for (const NodeId id : thresholds.watched) {
      const int kept = lane_.nodes[id].format.magnitude_bits() - last;
      leading.push_back(nodes_.excess_bits(id, kept, last, step.start_cycle));
    }
    std::vector<Parameter> parameters = {
        {"COUNT", static_cast<int>(leading.size())}, {"LAST", last}, {"WIDTH", bits}};
    for (std::size_t k = 0; k < thresholds.of_steps.size(); ++k) {
      parameters.push_back(
          {"THRESHOLD_" + std::to_string(k), Literal{bits, to_bits(thresholds.of_steps[k])}});
    }
    datapath_.describe(step, "the threshold, smaller where all that is multiplied is small.");
    Signal threshold = datapath_.declare(name, bits, step.ready_cycle);
    datapath_.add_unit(
        step, "unit_" + name, std::move(parameters),
        {{"leading", concatenation(std::move(leading))}, {"threshold", threshold.value}});
    return threshold;
  }

  /// Builds the unit with the operands that all decisions have, and with `operands` between these.
  DecisionUnit unit(std::size_t part, std::string what, std::vector<Parameter> parameters,
                    std::vector<Connection> operands) {
    const NodeId difference = lane_.parts[part].difference;
    const Operand out_of_range =
        datapath_.any_at({nodes_.out_of_range(difference)}, start_of(part));
    operands.insert(operands.begin(),
                    {"difference", nodes_.signed_value(difference, start_of(part))});
    operands.push_back({"out_of_range", out_of_range});
    // The unit has this output even if the lane always decides.
    if (decides_ == Decides::always) operands.push_back({"decided", net(unused_bit())});
    return {std::move(what), std::move(parameters), std::move(operands)};
  }

  std::string unused_bit() {
    std::string name = datapath_.pool().unique("unused_decided");
    datapath_.add(Wire{1, name, nullptr});
    return name;
  }

  int start_of(std::size_t part) const { return schedule_.parts[part].decision.start_cycle; }

  int difference_bits(std::size_t part) const {
    const FixedFormat& format = lane_.nodes[lane_.parts[part].difference].format;
    return format.width + (format.is_signed ? 0 : 1);
  }

  DatapathBuilder& datapath_;
  const FixedLane& lane_;
  const datapath::Schedule& schedule_;
  Decides decides_;
  FixedNodes nodes_;
};

template <class Parts>
void build_lane(DatapathBuilder& datapath, Parts lane, const datapath::Schedule& schedule) {
  lane.build_nodes();
  std::vector<PartDecision> parts;
  for (std::size_t part = 0; part < schedule.parts.size(); ++part) {
    parts.push_back(build_decision(datapath, schedule.parts[part].decision, part,
                                   schedule.parts.size(), lane.decides(), lane.decision(part)));
  }
  build_combination(datapath, lane.combination(), parts, schedule.combination);
}

/// The ports of a lane that takes operands as they arrive.
std::vector<InputPort> operand_ports(const std::vector<std::string>& inputs,
                                     const design::Lane& lane) {
  std::vector<InputPort> ports;
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    const auto input = static_cast<int>(k);
    const int width = std::visit(
        Cases{[&](const error::Lane& made) { return made.graph.arriving_format(input).width(); },
              [&](const FixedLane& made) { return fixed::operand_format(made, input).width(); }},
        lane);
    ports.push_back({inputs[k], width});
  }
  return ports;
}

/// Adds conversions to the ports whose operands arrive in formats other than those that the lane
/// reads.
std::vector<InputPort> widened(std::vector<InputPort> ports, const design::Lane& lane,
                               const datapath::Schedule& schedule) {
  std::visit(Cases{[&](const error::Lane& made) {
                     widen(ports, made.graph.arriving, made.graph.input_format, schedule);
                   },
                   [&](const FixedLane& made) {
                     widen(ports, fixed::arriving_formats(made), made.input_format, schedule);
                   }},
             lane);
  return ports;
}

}  // namespace

Module lane_module(std::string name, const std::vector<std::string>& inputs,
                   const design::Lane& lane, const datapath::Schedule& schedule) {
  return lane_module(std::move(name), operand_ports(inputs, lane), lane, schedule);
}

Module lane_module(std::string name, const std::vector<InputPort>& ports, const design::Lane& lane,
                   const datapath::Schedule& schedule) {
  const auto build = [&](DatapathBuilder& datapath) {
    std::visit(Cases{[&](const error::Lane& made) {
                       build_lane(datapath, FloatParts(datapath, made, schedule), schedule);
                     },
                     [&](const FixedLane& made) {
                       build_lane(datapath,
                                  FixedParts(datapath, made, schedule, Decides::sometimes),
                                  schedule);
                     }},
               lane);
  };
  return datapath_module(std::move(name), widened(ports, lane, schedule), lane_outputs(), build, 1,
                         schedule.entry_cycles);
}

Module fixed_reference_module(std::string name, const std::vector<std::string>& inputs,
                              const FixedLane& lane, const datapath::Schedule& schedule) {
  return datapath_module(
      std::move(name), widened(operand_ports(inputs, lane), lane, schedule),
      {{Direction::output, 2, "verdict"}},
      [&](DatapathBuilder& datapath) {
        build_lane(datapath, FixedParts(datapath, lane, schedule, Decides::always), schedule);
      },
      1, schedule.entry_cycles);
}

}  // namespace mixcmp::rtl
