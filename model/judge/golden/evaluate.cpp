#include "model/judge/golden/evaluate.hpp"

#include <algorithm>

#include "model/judge/golden/bound_arithmetic.hpp"
#include "model/judge/golden/enclosure.hpp"
#include "model/judge/golden/encoding.hpp"

namespace mixcmp::golden {
namespace {

Rounded change_sign(FloatFormat format, Bits bits, Bits changed) {
  return {changed, format.is_nan(bits) || format.is_infinite(bits)};
}

Rounded evaluate_sum(const TypedNode& node, const Arithmetic& result,
                     const std::vector<Rounded>& values) {
  const FloatFormat operands = node.operand_format;
  const Bits one = operands.pack(false, operands.bias(), 0);
  std::vector<FusedOperands> terms;
  for (const FusedTerm& term : node.terms) {
    const Bits factor = term.is_product() ? values[term.b].bits : one;
    terms.push_back({values[term.a].bits, factor, term.negated});
  }
  if (!node.is_sign_of_sum()) return fused_sum(result, operands, terms);
  switch (fused_comparison(result, operands, terms)) {
    case Verdict::less: return {operands.pack(true, operands.bias(), 0), false};
    case Verdict::equal: return {operands.zero(false), false};
    case Verdict::greater: return {one, false};
    case Verdict::unordered: return {operands.quiet_nan(), true};
  }
  MIXCMP_CHECK(false);
}

Rounded evaluate_node(const TypedNode& node, const Arithmetic& arithmetic,
                      std::span<const Bits> inputs, const std::vector<Rounded>& values) {
  const Arithmetic result = {node.format, arithmetic.rounding, arithmetic.subnormals};
  const FloatFormat operands = node.operand_format;
  const Bits a = node.operands[0] < 0 ? 0 : values[node.operands[0]].bits;
  const Bits b = node.operands[1] < 0 ? 0 : values[node.operands[1]].bits;
  switch (node.operation) {
    case Operation::input: return {inputs[node.input], false};
    case Operation::constant: return {from_rational(node.format, node.value), false};
    case Operation::convert: return convert(result, operands, a);
    case Operation::negate: return change_sign(operands, a, a ^ operands.zero(true));
    case Operation::absolute: return change_sign(operands, a, operands.magnitude(a));
    case Operation::add: return add(result, operands, a, b);
    case Operation::subtract: return subtract(result, operands, a, b);
    case Operation::multiply: return multiply(result, operands, a, b);
    case Operation::square: return square(result, operands, a);
    case Operation::divide: return divide(result, operands, a, b);
    case Operation::square_root: return square_root(result, operands, a);
    case Operation::minimum: return minimum(result, a, b);
    case Operation::maximum: return maximum(result, a, b);
    case Operation::fused_sum: return evaluate_sum(node, result, values);
    case Operation::function:
    case Operation::look_up: break;
  }
  MIXCMP_CHECK(false);
}

/// Whether an operation of this part of a lane is exceptional.
bool is_exceptional(const error::Lane& lane, std::size_t part, const std::vector<Rounded>& values) {
  const std::vector<bool> own = nodes_of_part(lane, part);
  for (std::size_t id = 0; id < values.size(); ++id) {
    if (own[id] && values[id].exceptional) return true;
  }
  return false;
}

bool breaks_a_range(const error::Lane& lane, std::size_t part, std::span<const Bits> inputs) {
  const std::vector<std::size_t>& own = lane.parts[part].checks;
  return std::any_of(own.begin(), own.end(), [&](std::size_t index) {
    const error::RangeCheck& check = lane.checks[index];
    return !passes(check, lane.graph.input_format, inputs[check.input]);
  });
}

Bits evaluate_bound_node(const error::BoundNode& node, BoundFormat format, const TypedGraph& graph,
                         const std::vector<Rounded>& values, const std::vector<Bits>& bounds) {
  const Bits a = node.operands[0] < 0 ? 0 : bounds[node.operands[0]];
  const Bits b = node.operands[1] < 0 ? 0 : bounds[node.operands[1]];
  const auto of_value = [&](auto function) {
    return function(format, graph.nodes[node.value].format, values[node.value].bits);
  };
  switch (node.operation) {
    case error::BoundOperation::constant: return bound_constant(format, node.constant);
    case error::BoundOperation::magnitude: return of_value(bound_magnitude);
    case error::BoundOperation::binade: return of_value(bound_binade);
    case error::BoundOperation::reciprocal: return of_value(bound_reciprocal);
    case error::BoundOperation::add: return bound_add(format, a, b);
    case error::BoundOperation::multiply: return bound_multiply(format, a, b);
    case error::BoundOperation::maximum: return std::max(a, b);
  }
  MIXCMP_CHECK(false);
}

/// The order of two encodings, and their distance in steps.
struct Distance {
  Verdict verdict;
  Bits ulp;
};

/// |key(f) - key(g)| with key(x) = +-magnitude; at most twice the largest magnitude, below 2^128.
Distance distance(FloatFormat format, Bits f, Bits g) {
  const Bits f_magnitude = format.magnitude(f), g_magnitude = format.magnitude(g);
  const bool both_zero = f_magnitude == 0 && g_magnitude == 0;
  if (format.sign(f) != format.sign(g) && !both_zero) {
    return {format.sign(f) ? Verdict::less : Verdict::greater, f_magnitude + g_magnitude};
  }
  if (f_magnitude == g_magnitude) return {Verdict::equal, 0};
  const bool f_larger = f_magnitude > g_magnitude;
  const Bits ulp = f_larger ? f_magnitude - g_magnitude : g_magnitude - f_magnitude;
  return {f_larger != format.sign(f) ? Verdict::greater : Verdict::less, ulp};
}

/// The decision of one criterion, before exceptional values are considered.
struct Decision {
  bool decided;
  Verdict verdict;
};

Decision decide(const error::UlpDistanceCriterion& criterion, const TypedGraph& graph,
                const Sides& sides, const std::vector<Rounded>& values) {
  const auto [verdict, ulp] =
      distance(graph.arithmetic.format, values[sides.f].bits, values[sides.g].bits);
  return {ulp >= criterion.guard_ulp, verdict};
}

/// The encoding of a bound in the lane's format.
Bits padded(BoundFormat format, Bits bound, FloatFormat lane) {
  return bound << (lane.precision() - format.precision);
}

Decision decide(const error::AbsoluteBoundCriterion& criterion, const TypedGraph& graph,
                const Sides&, const std::vector<Rounded>& values) {
  const BoundFormat format = criterion.bound.format;
  const FloatFormat lane = graph.arithmetic.format;
  const std::vector<Bits> bounds = evaluate_bound(criterion.bound, graph, values);
  const Bits difference = values[criterion.difference].bits;
  const bool valid = std::all_of(criterion.conditions.begin(), criterion.conditions.end(),
                                 [&](const error::BoundCondition& condition) {
                                   return bound_is_at_most(format, bounds[condition.bound],
                                                           graph.nodes[condition.value].format,
                                                           values[condition.value].bits);
                                 });
  return {
      valid && bounds.back() != format.infinity() &&
          lane.magnitude(difference) > padded(format, bounds.back(), lane) + criterion.guard_ulp,
      lane.sign(difference) ? Verdict::less : Verdict::greater};
}

Decision decide(const error::IntervalCriterion& criterion, const TypedGraph& graph, const Sides&,
                const std::vector<Rounded>& values) {
  const auto sign_of = [&](NodeId id) {
    return compare(graph.arithmetic.format, graph.arithmetic.subnormals, values[id].bits, 0);
  };
  const Verdict minimum = sign_of(criterion.minimum), maximum = sign_of(criterion.maximum);
  const bool is_nan = minimum == Verdict::unordered || maximum == Verdict::unordered;
  const bool greater = minimum == Verdict::greater, less = maximum == Verdict::less;
  return {!is_nan && (greater || less), greater ? Verdict::greater : Verdict::less};
}

constexpr mpfr_prec_t first_precision = 128;

/// The order of f and g of one part; none if intervals of up to `most` bits do not determine it.
std::optional<Verdict> order_of(const Graph& graph, Sides part, FloatFormat format,
                                std::span<const Bits> inputs, mpfr_prec_t most) {
  for (mpfr_prec_t precision = std::min(first_precision, most); precision <= most; precision *= 2) {
    Enclosure enclosure(graph, part, precision);
    switch (enclosure.compute(format, inputs)) {
      case Knowledge::undefined: return Verdict::unordered;
      case Knowledge::uncertain: continue;
      case Knowledge::enclosed: break;
    }
    const Interval &f = enclosure.f(), &g = enclosure.g();
    if (mpfr_less_p(f.high.get(), g.low.get())) return Verdict::less;
    if (mpfr_greater_p(f.low.get(), g.high.get())) return Verdict::greater;
    if (enclosure.are_equal()) return Verdict::equal;
  }
  return std::nullopt;
}

/// The opposite of less or greater. The combination of verdicts starts from the opposite of the
/// dominating verdict, which is neutral.
Verdict opposite(Verdict verdict) {
  return verdict == Verdict::greater ? Verdict::less : Verdict::greater;
}

LaneResult evaluate_part(const error::Lane& lane, std::size_t part, std::span<const Bits> inputs,
                         const std::vector<Rounded>& values) {
  const Decision decision = std::visit(
      [&](const auto& kind) { return decide(kind, lane.graph, lane.graph.parts[part], values); },
      lane.parts[part].criterion);
  // The paper's decision ignores exceptions; this flaw is modelled as it is.
  const bool usable = !lane.parts[part].certified() || !is_exceptional(lane, part, values);
  return {decision.decided && usable && !breaks_a_range(lane, part, inputs), decision.verdict};
}

}  // namespace

std::vector<Rounded> evaluate(const TypedGraph& graph, std::span<const Bits> inputs) {
  MIXCMP_CHECK(static_cast<int>(inputs.size()) == graph.input_count);
  std::vector<Rounded> values;
  values.reserve(graph.nodes.size());
  for (const TypedNode& node : graph.nodes) {
    values.push_back(evaluate_node(node, graph.arithmetic, inputs, values));
  }
  return values;
}

std::vector<Bits> evaluate_bound(const error::BoundGraph& bound, const TypedGraph& graph,
                                 const std::vector<Rounded>& values) {
  std::vector<Bits> bounds;
  bounds.reserve(bound.nodes.size());
  for (const error::BoundNode& node : bound.nodes) {
    bounds.push_back(evaluate_bound_node(node, bound.format, graph, values, bounds));
  }
  return bounds;
}

bool passes(const error::RangeCheck& check, FloatFormat format, Bits operand) {
  const bool negative = format.sign(operand);
  if (check.sign == error::RequiredSign::nonnegative && negative) return false;
  if (check.sign == error::RequiredSign::nonpositive && !negative) return false;
  if (check.leading_bits == 0) return true;
  const Bits leading = format.magnitude(operand) >> (format.width() - 1 - check.leading_bits);
  return check.least <= leading && leading <= check.greatest;
}

Verdict dominating_verdict(Combination combination) {
  switch (combination) {
    case Combination::all: return Verdict::greater;
    case Combination::any: return Verdict::less;
  }
  MIXCMP_CHECK(false);
}

Verdict combine(Combination combination, Verdict a, Verdict b) {
  const auto has = [&](Verdict verdict) { return a == verdict || b == verdict; };
  const Verdict last = dominating_verdict(combination);
  if (has(last)) return last;
  if (has(Verdict::unordered)) return Verdict::unordered;
  if (has(Verdict::equal)) return Verdict::equal;
  return a;
}

LaneResult combine_parts(Combination combination, std::span<const LaneResult> parts) {
  const Verdict dominating = dominating_verdict(combination);
  LaneResult result{.decided = true, .verdict = opposite(dominating)};
  for (const LaneResult& part : parts) {
    if (part.decided && part.verdict == dominating) return {true, dominating};
    result.decided &= part.decided;
    if (part.decided) result.verdict = combine(combination, result.verdict, part.verdict);
  }
  return result;
}

LaneResult evaluate_lane(const error::Lane& lane, std::span<const Bits> inputs) {
  const std::vector<Rounded> values = evaluate(lane.graph, inputs);
  std::vector<LaneResult> parts;
  for (std::size_t part = 0; part < lane.parts.size(); ++part) {
    parts.push_back(evaluate_part(lane, part, inputs, values));
  }
  return combine_parts(lane.graph.combination, parts);
}

Verdict evaluate_reference(const TypedGraph& reference, std::span<const Bits> inputs) {
  const std::vector<Rounded> values = evaluate(reference, inputs);
  Verdict verdict = opposite(dominating_verdict(reference.combination));
  for (const Sides& part : reference.parts) {
    const Verdict one = compare(reference.arithmetic.format, reference.arithmetic.subnormals,
                                values[part.f].bits, values[part.g].bits);
    verdict = combine(reference.combination, verdict, one);
  }
  return verdict;
}

std::optional<Verdict> true_verdict(const Graph& graph, FloatFormat format,
                                    std::span<const Bits> inputs) {
  return verdict_within(graph, format, inputs, last_precision(format));
}

std::optional<Verdict> verdict_within(const Graph& graph, FloatFormat format,
                                      std::span<const Bits> inputs, long bits) {
  const Verdict dominating = dominating_verdict(graph.combination());
  std::optional<Verdict> verdict = opposite(dominating);
  for (const Sides& part : graph.parts()) {
    const std::optional<Verdict> one = order_of(graph, part, format, inputs, bits);
    if (one == dominating) return dominating;
    verdict =
        verdict && one ? std::optional(combine(graph.combination(), *verdict, *one)) : std::nullopt;
  }
  return verdict;
}

}  // namespace mixcmp::golden
