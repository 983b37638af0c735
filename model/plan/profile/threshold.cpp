#include "model/plan/profile/threshold.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "model/base/common/check.hpp"
#include "model/base/common/vector_clones.hpp"
#include "model/base/number/double.hpp"
#include "model/base/number/exact.hpp"
#include "model/plan/profile/envelope_kernels.hpp"

namespace mixcmp::profile {
namespace {

using envelope_kernels::for_each_lane;
using envelope_kernels::outward;

/// An upper bound of |computed value| at every precision.
double largest(const NodeEnvelope& node, std::size_t k) {
  return (std::fabs(node.value[k]) + 1.5 * node.error[k]) * outward;
}

/// An upper bound of sqrt(|f|) + sqrt(|g|), of the true values.
double sum_of_roots(const NodeEnvelope& f, const NodeEnvelope& g, double error_of_double,
                    std::size_t k) {
  return (std::sqrt(std::fabs(f.value[k]) + f.error[k] * error_of_double) +
          std::sqrt(std::fabs(g.value[k]) + g.error[k] * error_of_double)) *
         outward;
}

/// An upper bound of an integer, as a double.
double to_double(Bits bits) {
  return (std::ldexp(static_cast<double>(static_cast<std::uint64_t>(bits >> 64)), 64) +
          static_cast<double>(static_cast<std::uint64_t>(bits))) *
         outward;
}

/// The relative error as the lane encodes it: the constant that multiplies |f| or |g| in E of D -
/// E.
double encoded_error(const TypedGraph& graph, NodeId product) {
  const TypedNode& node = graph.nodes[graph.nodes[product].operands[1]];
  MIXCMP_CHECK(node.operation == Operation::constant);
  if (node.format.is_infinite(node.constant)) return envelope_kernels::infinity;
  return to_rational(node.format, node.constant).get_d() * outward;
}

bool same_node(const TypedNode& a, const TypedNode& b) {
  return a.operation == b.operation && a.operands == b.operands && a.input == b.input &&
         a.value == b.value;
}

/// Whether two graphs begin with the same `count` nodes.
bool begins_alike(const TypedGraph& a, const TypedGraph& b, std::size_t count) {
  return a.f() == b.f() && a.g() == b.g() && a.nodes.size() >= count && b.nodes.size() >= count &&
         std::equal(a.nodes.begin(), a.nodes.begin() + static_cast<std::ptrdiff_t>(count),
                    b.nodes.begin(), same_node);
}

/// The largest factor by which `guard_ulp` steps raise a number: theorem 3.
double guard_factor(const error::Lane& lane) {
  const Bits guard = std::get<error::AbsoluteBoundCriterion>(lane.criterion()).guard_ulp;
  const int precision = lane.graph.arithmetic.format.precision();
  const Bits binade = Bits{1} << (precision - 1);
  const double doublings = to_double(guard / binade);
  return std::exp2(doublings) * (1 + to_double(guard % binade) / to_double(binade)) * outward *
         outward;
}

bool looks_at_shared_nodes(const error::AbsoluteBoundCriterion& criterion,
                           const Envelope& envelope) {
  const auto shared = [&](const auto& part) { return part.value < envelope.node_count(); };
  return criterion.difference == envelope.difference() &&
         std::all_of(criterion.bound.nodes.begin(), criterion.bound.nodes.end(), shared) &&
         std::all_of(criterion.conditions.begin(), criterion.conditions.end(), shared);
}

}  // namespace

Threshold Threshold::of_order(const Envelope& envelope) {
  return {Order{}, 0, envelope.graph().f(), envelope.graph().g()};
}

Threshold Threshold::of_lanes(std::span<const error::Lane* const> lanes, const Envelope& envelope) {
  const bool known = std::all_of(lanes.begin(), lanes.end(), [&](const error::Lane* lane) {
    return lane != nullptr && lanes.front() != nullptr &&
           lane->criterion().index() == lanes.front()->criterion().index() &&
           begins_alike(lane->graph, envelope.graph(), envelope.node_count() - 1);
  });
  const double floor = std::ldexp(1.0, envelope.lowest() + 2);
  return {known ? kind_of(lanes, envelope) : Kind{Unknown{}}, floor, envelope.graph().f(),
          envelope.graph().g()};
}

Threshold::Kind Threshold::kind_of(std::span<const error::Lane* const> lanes,
                                   const Envelope& envelope) {
  const auto& criterion = lanes.front()->criterion();
  if (std::holds_alternative<error::UlpDistanceCriterion>(criterion))
    return distance(lanes, envelope);
  if (std::holds_alternative<error::IntervalCriterion>(criterion)) return interval(lanes, envelope);
  return absolute(lanes, envelope);
}

Threshold::Kind Threshold::distance(std::span<const error::Lane* const> lanes,
                                    const Envelope& envelope) {
  double guard = 0;
  for (const error::Lane* lane : lanes) {
    guard = std::max(guard,
                     to_double(std::get<error::UlpDistanceCriterion>(lane->criterion()).guard_ulp));
  }
  return Distance{std::ldexp(guard, 1 - envelope.anchor())};
}

Threshold::Kind Threshold::interval(std::span<const error::Lane* const> lanes,
                                    const Envelope& envelope) {
  double f = 0, g = 0;
  int precision = envelope.anchor();
  for (const error::Lane* lane : lanes) {
    const TypedGraph& graph = lane->graph;
    const auto& criterion = std::get<error::IntervalCriterion>(lane->criterion());
    // minimum = D - E, E = E_f + E_g, each a magnitude times a constant.
    const TypedNode& error = graph.nodes[graph.nodes[criterion.minimum].operands[1]];
    MIXCMP_CHECK(error.operation == Operation::add);
    const double scale = std::ldexp(1.0, precision - envelope.anchor());
    f = std::max(f, encoded_error(graph, error.operands[0]) * scale);
    g = std::max(g, encoded_error(graph, error.operands[1]) * scale);
    ++precision;
  }
  const double unit = envelope.unit();
  const double factor = (1 + unit) * (1 + unit) / (1 - unit) * outward;
  return Interval{f * factor, g * factor};
}

Threshold::Kind Threshold::absolute(std::span<const error::Lane* const> lanes,
                                    const Envelope& envelope) {
  const auto criterion = [&](std::size_t k) -> const error::AbsoluteBoundCriterion& {
    return std::get<error::AbsoluteBoundCriterion>(lanes[k]->criterion());
  };
  double guard = 1;
  for (const error::Lane* lane : lanes) guard = std::max(guard, guard_factor(*lane));
  Absolute absolute{.bounds = {}, .factor = guard * outward / (1 - envelope.unit())};
  const int last = envelope.anchor() + static_cast<int>(lanes.size()) - 1;
  for (std::size_t first = 0, next = 0; first < lanes.size(); first = next) {
    // The bound may refer only to the shared nodes and the difference, as the envelope has no
    // others.
    if (!looks_at_shared_nodes(criterion(first), envelope)) return Unknown{};
    while (next < lanes.size() &&
           BoundEnvelope::same_structure(criterion(first), criterion(next))) {
      ++next;
    }
    const int precision = envelope.anchor() + static_cast<int>(first);
    absolute.bounds.emplace_back(lanes.subspan(first, next - first), precision, last, envelope);
  }
  return absolute;
}

namespace {

using fixed::FixedNode;

/// A distance of f and g from which one fixed-point lane certainly decides.
struct Margin {
  double constant = 0;
  double per_root = 0;  ///< per sqrt(|f|) + sqrt(|g|)
};

double magnitude(const Range& range) {
  return std::max(std::fabs(range.low.get_d()), std::fabs(range.high.get_d())) * outward;
}

Margin margin_of(const fixed::ConstantThresholds& thresholds, const FixedNode& difference,
                 const std::vector<FixedNode>&) {
  const double unit = difference.format.unit().get_d();
  const double limit =
      std::max(std::fabs(thresholds.greater_from.get_d()), std::fabs(thresholds.less_to.get_d()));
  return {.constant = limit * unit * outward + magnitude(difference.error)};
}

/// The roots of f and g together have errors of at most slope / 2, and the lane decides if the
/// computed roots are `apart`. Proof: docs/theory.md, "The distance of roots for the norm".
Margin margin_of(const fixed::NormThresholds& thresholds, const FixedNode& difference,
                 const std::vector<FixedNode>& nodes) {
  const double unit = difference.format.unit().get_d();
  const double radius_unit = std::ldexp(1.0, thresholds.unit_exponent(nodes));
  const double above = std::ldexp(unit, thresholds.shift_above) / radius_unit;
  const double below = std::ldexp(unit, thresholds.shift_below) / radius_unit;
  const double offset = (thresholds.offset_above.get_d() + 1) * unit,
               slope = std::max(above, below);
  const double apart = thresholds.radius_is_squared
                           ? std::max(2 * slope, std::sqrt(slope * radius_unit + offset))
                           : std::max({above / 2, below, std::sqrt(offset)});
  return {.constant = 0, .per_root = (slope / 2 + apart) * outward};
}

/// The largest threshold of all steps is valid for every comparison.
Margin margin_of(const fixed::RunningThresholds& thresholds, const FixedNode& difference,
                 const std::vector<FixedNode>&) {
  const auto largest = std::max_element(thresholds.of_steps.begin(), thresholds.of_steps.end());
  const double unit = difference.format.unit().get_d();
  return {.constant = largest->get_d() * unit * outward + magnitude(difference.error)};
}

/// Common cuts multiply the cut values by at least t = 2^-`most dropped`. So the lane decides if f
/// and g are 1 / t^degree times as far apart. Proof: docs/theory.md, theorem 2.
Margin before_cuts(Margin margin, const fixed::FixedLane& lane, const mpq_class& degree) {
  const int most = fixed::most_dropped_in_common(lane);
  const double grown = std::exp2(most * degree.get_d()) * outward;
  return {.constant = margin.constant * grown, .per_root = margin.per_root * std::sqrt(grown)};
}

bool has_limits(const fixed::FixedLane& lane) {
  return std::any_of(lane.nodes.begin(), lane.nodes.end(), fixed::is_limit);
}

}  // namespace

Threshold Threshold::of_fixed_lanes(std::span<const fixed::FixedLane* const> lanes,
                                    std::size_t part, const Envelope& envelope) {
  Roots roots{.constant = 0,
              .per_root = 0,
              .error_of_double = std::ldexp(outward, envelope.anchor() - double_digits)};
  const fixed::FixedLane* block_lane = nullptr;
  double scale = outward;
  for (const fixed::FixedLane* lane : lanes) {
    if (lane != nullptr) {
      if (lane->format.is_block) block_lane = lane;
      if (has_limits(*lane)) return {Unknown{}, 0, envelope.graph().f(), envelope.graph().g()};
      const fixed::FixedPart& decided = lane->parts[part];
      const FixedNode& difference = lane->nodes[decided.difference];
      const Margin of_cut = std::visit(
          [&](const auto& thresholds) { return margin_of(thresholds, difference, lane->nodes); },
          decided.criterion);
      const Margin margin = before_cuts(of_cut, *lane, decided.degree);
      roots.constant = std::max(roots.constant, margin.constant * scale);
      roots.per_root = std::max(roots.per_root, margin.per_root * scale);
    }
    scale *= 2;
  }
  if (block_lane != nullptr) {
    return {block(roots, *block_lane, part, envelope), 0, envelope.graph().f(),
            envelope.graph().g()};
  }
  return {roots, 0, envelope.graph().f(), envelope.graph().g()};
}

/// The unit depends on all operands that the lane reads. If the part does not have them all, its
/// envelope does not determine the unit.
Threshold::Kind Threshold::block(const Roots& of_scaled, const fixed::FixedLane& lane,
                                 std::size_t part, const Envelope& envelope) {
  Block block{.of_scaled = of_scaled,
              .degree = lane.parts[part].degree.get_d(),
              .inputs = {},
              .least_scale = std::ldexp(1.0, fixed::least_block_exponent(lane.input_format))};
  const std::vector<TypedNode>& nodes = envelope.graph().nodes;
  for (const int input : fixed::inputs_read(lane)) {
    const auto found = std::find_if(nodes.begin(), nodes.end(), [&](const TypedNode& node) {
      return node.operation == Operation::input && node.input == input;
    });
    if (found == nodes.end()) return Unknown{};
    block.inputs.push_back(static_cast<NodeId>(found - nodes.begin()));
  }
  return block;
}

MIXCMP_VECTOR_CLONES void Threshold::evaluate(const EnvelopeBlock& block, EnvelopeRow& scaled,
                                              EnvelopeRow& fixed, EnvelopeRow& wild) const {
  const NodeEnvelope& f = block.nodes[f_];
  const NodeEnvelope& g = block.nodes[g_];
  scaled.fill(0);
  fixed.fill(0);
  if (const auto* roots = std::get_if<Roots>(&kind_)) {
    for_each_lane([&](std::size_t k) {
      scaled[k] =
          (roots->constant + roots->per_root * sum_of_roots(f, g, roots->error_of_double, k)) *
          outward;
    });
  } else if (const auto* in_block = std::get_if<Block>(&kind_)) {
    const Roots& below_one = in_block->of_scaled;
    alignas(64) EnvelopeRow scale;
    scale.fill(in_block->least_scale);
    for (const NodeId input : in_block->inputs) {
      const NodeEnvelope& read = block.nodes[input];
      for_each_lane([&](std::size_t k) { scale[k] = std::max(scale[k], 2 * largest(read, k)); });
    }
    if (in_block->degree == 2) {  // usual, and std::pow is slow
      for_each_lane([&](std::size_t k) { scale[k] *= scale[k]; });
    } else {
      for_each_lane([&](std::size_t k) { scale[k] = std::pow(scale[k], in_block->degree); });
    }
    for_each_lane([&](std::size_t k) {
      const double grown = scale[k] * outward;
      const double of_roots = sum_of_roots(f, g, below_one.error_of_double, k);
      scaled[k] =
          (below_one.constant * grown + below_one.per_root * std::sqrt(grown) * of_roots) * outward;
    });
  } else if (std::holds_alternative<Unknown>(kind_)) {
    wild.fill(1);
  } else {
    evaluate_of_floats(block, scaled, fixed, wild);
  }
}

/// The difference of the computed f and g is off by their errors.
MIXCMP_VECTOR_CLONES void Threshold::evaluate_of_floats(const EnvelopeBlock& block,
                                                        EnvelopeRow& scaled, EnvelopeRow& fixed,
                                                        EnvelopeRow& wild) const {
  const NodeEnvelope& f = block.nodes[f_];
  const NodeEnvelope& g = block.nodes[g_];
  if (const auto* distance = std::get_if<Distance>(&kind_)) {
    for_each_lane([&](std::size_t k) {
      const double lf = largest(f, k), lg = largest(g, k);
      scaled[k] = (lf < lg ? lg : lf) * distance->steps;
    });
  } else if (const auto* interval = std::get_if<Interval>(&kind_)) {
    for_each_lane([&](std::size_t k) {
      scaled[k] = largest(f, k) * interval->f + largest(g, k) * interval->g;
    });
  } else if (const auto* absolute = std::get_if<Absolute>(&kind_)) {
    for (const BoundEnvelope& bound : absolute->bounds) bound.raise(block, scaled, fixed, wild);
    for_each_lane([&](std::size_t k) {
      scaled[k] *= absolute->factor;
      fixed[k] *= absolute->factor;
    });
  }
  for_each_lane([&](std::size_t k) {
    scaled[k] += f.error[k] + g.error[k];
    fixed[k] += floor_;
  });
}

}  // namespace mixcmp::profile
