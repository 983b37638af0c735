#include "model/judge/golden/fixed_evaluate.hpp"

#include <algorithm>

#include "model/base/common/check.hpp"
#include "model/base/number/dyadic.hpp"
#include "model/judge/golden/arithmetic.hpp"

namespace mixcmp::golden {
namespace {

using fixed::FixedLane;
using fixed::FixedNode;
using fixed::FixedPart;
using Integer = std::optional<mpz_class>;

/// value * 2^shift, rounded down.
mpz_class shifted(const mpz_class& value, int shift) {
  mpz_class result;
  if (shift >= 0) {
    mpz_mul_2exp(result.get_mpz_t(), value.get_mpz_t(), static_cast<mp_bitcnt_t>(shift));
  } else {
    mpz_fdiv_q_2exp(result.get_mpz_t(), value.get_mpz_t(), static_cast<mp_bitcnt_t>(-shift));
  }
  return result;
}

/// The `count` low bits of a number in two's complement, as a number without a sign.
mpz_class low_bits(const mpz_class& value, int count) {
  mpz_class result;
  mpz_fdiv_r_2exp(result.get_mpz_t(), value.get_mpz_t(), static_cast<mp_bitcnt_t>(count));
  return result;
}

/// In block floating point, e of theorem 6 (docs/fixed_point.md); 0 elsewhere. None if an operand
/// is infinite or a NaN.
std::optional<int> block_exponent(const FixedLane& lane, std::span<const Bits> inputs) {
  if (!lane.format.is_block) return 0;
  const FloatFormat format = lane.input_format;
  int exponent = fixed::least_block_exponent(format);
  for (const int input : fixed::inputs_read(lane)) {
    if (format.is_nan(inputs[input]) || format.is_infinite(inputs[input])) return std::nullopt;
    const mpq_class magnitude = to_rational(format, format.magnitude(inputs[input]));
    if (magnitude == 0) continue;
    exponent = std::max(exponent, static_cast<int>(floor_log2(magnitude)) + 1);
  }
  return exponent;
}

/// The format whose numbers are 2^exponent times as large.
FixedFormat scaled(FixedFormat format, int exponent) {
  format.unit_exponent += exponent;
  return format;
}

/// An operand as an integer of an input's format, whose unit is 2^scale times as large: its
/// magnitude is truncated, and all bits are inverted if its sign bit is set. A promised multiple of
/// the unit is exact. None if the format does not hold the magnitude or the sign, or if the promise
/// is broken.
Integer converted(FloatFormat from, Bits bits, const FixedNode& input, int scale) {
  const FixedFormat to = scaled(input.format, scale);
  if (from.is_nan(bits) || from.is_infinite(bits)) return std::nullopt;
  if (from.sign(bits) && !to.is_signed) return std::nullopt;
  const mpq_class value = to_rational(from, from.magnitude(bits));
  const mpz_class parts = shifted(value.get_num(), std::max(0, -to.unit_exponent));
  const mpz_class per_unit = value.get_den() * shifted(1, std::max(0, to.unit_exponent));
  const mpz_class magnitude = parts / per_unit;
  if (magnitude >= shifted(1, to.magnitude_bits())) return std::nullopt;
  if (!input.is_promised) return from.sign(bits) ? mpz_class(-magnitude - 1) : magnitude;
  if (magnitude * per_unit != parts) return std::nullopt;
  return from.sign(bits) ? mpz_class(-magnitude) : magnitude;
}

/// An operand's encoding as an integer without a sign.
mpz_class encoding(Bits bits) {
  const auto upper = static_cast<unsigned long>(bits >> 64);
  return shifted(upper, 64) + static_cast<unsigned long>(bits);
}

/// A number that arrived in fixed point, without the low bits that the input drops.
mpz_class cut(FloatFormat from, Bits bits, const FixedFormat& to) {
  const mpq_class value = to_rational(from, bits);
  return floor_of(mixcmp::scaled(value, -to.unit_exponent));
}

mpz_class operate(Operation operation, const mpz_class& a, const mpz_class& b) {
  switch (operation) {
    case Operation::convert: return a;
    case Operation::negate: return -a;
    case Operation::absolute: return abs(a);
    case Operation::add: return a + b;
    case Operation::subtract: return a - b;
    case Operation::multiply: return a * b;
    case Operation::square: return a * a;
    case Operation::minimum: return std::min(a, b);
    case Operation::maximum: return std::max(a, b);
    case Operation::input:
    case Operation::constant:
    case Operation::divide:
    case Operation::square_root:
    case Operation::function:
    case Operation::look_up:
    case Operation::fused_sum: break;
  }
  MIXCMP_CHECK(false);
}

/// The square root, in units of 2^to, of a number in units of 2^from, rounded down.
mpz_class root(const mpz_class& value, int from, int to) {
  return sqrt(shifted(value, from - 2 * to));
}

bool aligns_operands(Operation operation) {
  return operation == Operation::add || operation == Operation::subtract || is_choice(operation);
}

/// A number in the node's units; none if it is outside the node's limits.
Integer within(const FixedNode& node, const mpz_class& value) {
  const mpq_class number = value * node.format.unit();
  return number < node.value.low || number > node.value.high ? Integer() : value;
}

/// The word of a look-up: its address is the argument's upper bits, in two's complement.
mpz_class word_of(const FixedNode& node, const std::vector<FixedNode>& nodes,
                  const mpz_class& argument) {
  const mpz_class upper = shifted(argument, -fixed::piece_bits(nodes, node));
  return node.words[low_bits(upper, node.words.address_bits()).get_ui()];
}

Integer result_of(const FixedNode& node, const std::vector<FixedNode>& nodes,
                  const std::vector<Integer>& values) {
  mpz_class operands[2];
  int finest = 0;
  for (int k = 0; k < arity(node.operation); ++k) {
    const int unit = nodes[node.operands[k]].format.unit_exponent;
    finest = k == 0 ? unit : std::min(finest, unit);
  }
  for (int k = 0; k < arity(node.operation); ++k) {
    const Integer& operand = values[node.operands[k]];
    if (!operand) return std::nullopt;
    const int unit = nodes[node.operands[k]].format.unit_exponent;
    operands[k] = aligns_operands(node.operation) ? shifted(*operand, unit - finest) : *operand;
  }
  if (node.operation == Operation::square_root) {
    return root(operands[0], finest, node.format.unit_exponent);
  }
  if (node.operation == Operation::look_up) return word_of(node, nodes, operands[0]);
  if (fixed::is_floating_code(node)) {
    const function::FloatingCode code{nodes[node.operands[0]].format.width};
    return operands[0] >= 0 ? Integer(code.of(operands[0])) : std::nullopt;
  }
  if (node.conversion == fixed::Conversion::place) {
    return low_bits(operands[0], node.format.width);
  }
  if (fixed::is_limit(node)) return within(node, operands[0]);
  return shifted(operate(node.operation, operands[0], operands[1]), -node.dropped_bits);
}

/// Whether an integer is one of the node's format.
bool fits(const mpz_class& value, const FixedFormat& format) {
  return value >= format.smallest() && value <= format.largest();
}

/// How many low bits the common cuts drop: the fewest with which each of them fits a magnitude of W
/// bits. None if an operand of one of them has no value.
std::optional<int> common_drop(const FixedLane& lane, const std::vector<Integer>& values) {
  int dropped = 0;
  for (const NodeId id : fixed::cut_in_common(lane)) {
    if (!values[id]) return std::nullopt;
    const FixedFormat format{.width = lane.format.bits + 1, .is_signed = true};
    while (!fits(shifted(*values[id], -dropped), format)) ++dropped;
  }
  return dropped;
}

/// 2^k for the least k >= 0 with value < 4^k.
mpz_class power_above_root(const mpz_class& value) {
  mpz_class power = 1;
  while (value >= power * power) power *= 2;
  return power;
}

LaneResult decide(const fixed::ConstantThresholds& thresholds, const mpz_class& difference,
                  const FixedLane&, const std::vector<Integer>&) {
  if (difference >= thresholds.greater_from) return {true, Verdict::greater};
  if (difference <= thresholds.less_to) return {true, Verdict::less};
  return {thresholds.decides_ties, Verdict::equal};
}

LaneResult decide(const fixed::NormThresholds& thresholds, const mpz_class& difference,
                  const FixedLane&, const std::vector<Integer>& values) {
  const mpz_class& value = *values[thresholds.radius];
  const mpz_class radius = thresholds.radius_is_squared ? power_above_root(value) : value;
  if (difference >= shifted(radius, thresholds.shift_above) + thresholds.offset_above) {
    return {true, Verdict::greater};
  }
  return {difference < -shifted(radius, thresholds.shift_below), Verdict::less};
}

/// The smallest step in which an integer of `bits` bits of magnitude is below 2^(bits - last +
/// step).
int step_of(const mpz_class& value, int bits, int last) {
  int step = 0;
  while (step < last &&
         !fits(value, {.width = bits - last + step + 1, .unit_exponent = 0, .is_signed = true})) {
    ++step;
  }
  return step;
}

/// The verdict of the negated difference.
Verdict negated(Verdict verdict) {
  if (verdict == Verdict::less) return Verdict::greater;
  return verdict == Verdict::greater ? Verdict::less : verdict;
}

LaneResult decide(const fixed::RunningThresholds& thresholds, const mpz_class& difference,
                  const FixedLane& lane, const std::vector<Integer>& values) {
  const int last = static_cast<int>(thresholds.of_steps.size()) - 1;
  int step = 0;
  for (const NodeId id : thresholds.watched) {
    step = std::max(step, step_of(*values[id], lane.nodes[id].format.magnitude_bits(), last));
  }
  const mpz_class& threshold = thresholds.of_steps[step];
  if (difference >= threshold) return {true, Verdict::greater};
  return {difference < -threshold, Verdict::less};
}

LaneResult evaluate_part(const FixedLane& lane, const FixedPart& part,
                         const std::vector<Integer>& values) {
  const Integer& difference = values[part.difference];
  if (!difference) return {false, Verdict::unordered};
  LaneResult result = std::visit(
      [&](const auto& thresholds) { return decide(thresholds, *difference, lane, values); },
      part.criterion);
  if (part.swapped) result.verdict = negated(result.verdict);
  return result;
}

}  // namespace

std::vector<Integer> evaluate(const FixedLane& lane, std::span<const Bits> inputs) {
  MIXCMP_CHECK(inputs.size() == lane.input_names.size());
  const std::optional<int> scale = block_exponent(lane, inputs);
  std::vector<Integer> values;
  for (const FixedNode& node : lane.nodes) {
    if (node.operation == Operation::input && !scale) {
      values.emplace_back();
    } else if (node.is_encoding) {
      values.emplace_back(shifted(encoding(inputs[node.input]), -node.dropped_bits));
    } else if (node.operation == Operation::input && fixed::arriving_fixed(lane, node)) {
      values.emplace_back(cut(lane.input_format, inputs[node.input], node.format));
    } else if (node.operation == Operation::input) {
      values.push_back(converted(lane.input_format, inputs[node.input], node, *scale));
    } else if (node.operation == Operation::constant) {
      values.emplace_back(node.constant);
    } else if (fixed::is_common_cut(node)) {
      const std::optional<int> dropped = common_drop(lane, values);
      values.push_back(dropped ? Integer(shifted(*values[node.operands[0]], -*dropped))
                               : Integer());
    } else {
      values.push_back(result_of(node, lane.nodes, values));
    }
  }
  return values;
}

bool takes(const FixedLane& lane, int input, Bits operand) {
  // In block floating point every finite number fits in the largest possible unit.
  const int scale = lane.format.is_block ? lane.input_format.max_exponent() + 1 : 0;
  return std::all_of(lane.nodes.begin(), lane.nodes.end(), [&](const FixedNode& node) {
    return node.operation != Operation::input || node.input != input || node.is_encoding ||
           fixed::arriving_fixed(lane, node) || converted(lane.input_format, operand, node, scale);
  });
}

LaneResult evaluate_lane(const FixedLane& lane, std::span<const Bits> inputs) {
  const std::vector<Integer> values = evaluate(lane, inputs);
  std::vector<LaneResult> parts;
  for (const FixedPart& part : lane.parts) parts.push_back(evaluate_part(lane, part, values));
  const LaneResult result = combine_parts(lane.combination, parts);
  if (lane.is_reference && !result.decided) return {true, Verdict::unordered};
  return result;
}

Verdict evaluate_reference(const fixed::ReferenceDatapath& reference,
                           std::span<const Bits> inputs) {
  if (const auto* fixed = std::get_if<FixedLane>(&reference)) {
    return evaluate_lane(*fixed, inputs).verdict;
  }
  return evaluate_reference(std::get<TypedGraph>(reference), inputs);
}

}  // namespace mixcmp::golden
