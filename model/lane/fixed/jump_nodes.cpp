#include <algorithm>

#include "model/base/number/dyadic.hpp"
#include "model/lane/fixed/graph_builder.hpp"
#include "model/lane/fixed/node_enclosure.hpp"

/// Functions that jump: sign(x) and mod(x, y). Proof: docs/fixed_point.md, theorem 11.
namespace mixcmp::fixed {
namespace {

/// Jumps of mod(x, y) in the range of x.
constexpr int most_jumps = 1 << 10;

constexpr int most_reciprocal_bits = 64;

/// Integers c, b and s such that floor((X c + b) / 2^s) is a wanted quotient.
struct Reciprocal {
  mpz_class number, offset;
  int shift;
};

/// The offset nearest to 0 with which floor((X c + b) / 2^s) is floor((X - error) / divisor) for
/// least <= X <= greatest; none if there is no such offset. Both are step functions that grow with
/// X: they are equal if they are at both sides of every step.
std::optional<mpz_class> offset_of(const mpz_class& number, int shift, const mpz_class& least,
                                   const mpz_class& greatest, const mpq_class& error,
                                   const mpq_class& divisor) {
  const mpz_class first = floor_of((least - error) / divisor);
  const mpz_class last = floor_of((greatest - error) / divisor);
  mpz_class low = shifted_left(first, shift) - least * number;
  mpz_class high = shifted_left(last + 1, shift) - 1 - greatest * number;
  for (mpz_class k = first + 1; k <= last; ++k) {
    const mpz_class step = ceiling_of(k * divisor + error);  // the least X with this quotient
    const mpz_class whole = shifted_left(k, shift);
    low = std::max<mpz_class>(low, whole - step * number);
    high = std::min<mpz_class>(high, whole - 1 - (step - 1) * number);
  }
  if (low > high) return std::nullopt;
  return low > 0 ? low : high < 0 ? high : mpz_class(0);
}

std::optional<Reciprocal> reciprocal_of(const mpz_class& least, const mpz_class& greatest,
                                        const mpq_class& error, const mpq_class& divisor) {
  const int first = std::max(0, static_cast<int>(floor_log2(divisor)));
  for (int shift = first; shift <= first + most_reciprocal_bits; ++shift) {
    const mpq_class exact = power_of_two(shift) / divisor;
    for (const mpz_class& number : {floor_of(exact), ceiling_of(exact)}) {
      if (number == 0) continue;
      const auto offset = offset_of(number, shift, least, greatest, error, divisor);
      if (offset) return Reciprocal{number, *offset, shift};
    }
  }
  return std::nullopt;
}

/// The error of a number that is off by the same in every comparison, as by a rounded constant.
std::optional<mpq_class> known_error(const FixedNode& node) {
  if (node.error.low != node.error.high) return std::nullopt;
  return node.error.low;
}

}  // namespace

NodeId FixedGraphBuilder::exact_constant(const mpz_class& number, int unit_exponent,
                                         const mpq_class& meant) {
  FixedNode node{.operation = Operation::constant, .constant = number};
  const mpq_class value = scaled(mpq_class(number), unit_exponent);
  node.value = {value, value};
  node.format = format_of(node.value, unit_exponent);
  node.error = {value - meant, value - meant};
  return add(std::move(node));
}

/// A computed number has the sign of the real one if it was only rounded down, to a multiple of its
/// unit: it is below 0 if and only if the real one is.
Result<FixedNode> FixedGraphBuilder::sign(NodeId id, NodeId argument) {
  const FixedNode& computed = nodes_[argument];
  const Range real = mixcmp::difference(computed.value, computed.error);
  if (real.low >= 0) return nodes_[exact_constant(1, 0, 1)];
  if (real.high < 0) return nodes_[exact_constant(-1, 0, -1)];
  if (computed.error.high > 0 || computed.error.low <= -computed.format.unit()) {
    return refused(id, "the sign of a rounded number is not known near 0",
                   "the sign of an exact number: inputs that are integers or in fixed point, "
                   "without more bits than W");
  }
  return word_of(Function::sign, argument, function::Words(std::vector<mpz_class>{1, -1}), 0);
}

/// k = floor((X - e) / y), the argument's product with a rounded reciprocal without its fraction,
/// where e is the argument's error if that is known. `count`: the values of k.
Result<NodeId> FixedGraphBuilder::whole_quotient(NodeId id, const Function& function,
                                                 NodeId argument, const Range& count) {
  const FixedNode computed = nodes_[argument];
  const mpq_class unit = computed.format.unit();
  if (count.high - count.low > most_jumps) {
    return refused(id, "the argument ranges over too many multiples of the divisor",
                   "a narrower range of the inputs");
  }
  const mpq_class error = known_error(computed).value_or(0) / unit;
  const auto reciprocal =
      reciprocal_of(floor_of(computed.value.low / unit), floor_of(computed.value.high / unit),
                    error, function.parameter() / unit);
  if (!reciprocal) {
    return refused(id, "the divisor is too small for the argument's bits",
                   "a larger divisor, or fewer bits");
  }
  const auto constant = [&](const mpz_class& number, int unit_exponent) {
    return exact_constant(number, unit_exponent, scaled(mpq_class(number), unit_exponent));
  };
  const int unit_exponent = -reciprocal->shift - computed.format.unit_exponent;
  FixedNode whole =
      exactly(Operation::multiply, argument, constant(reciprocal->number, unit_exponent));
  if (reciprocal->offset != 0) {
    whole.function = function;
    const NodeId multiple = add(itself(std::move(whole)));
    whole = exactly(Operation::add, multiple, constant(reciprocal->offset, -reciprocal->shift));
  }
  const int dropped = -whole.format.unit_exponent;
  if (whole.format.width < dropped + format_of(count, 0).width) {
    return refused(id, "the divisor is larger than the argument's range",
                   "a smaller divisor, or the argument itself where it is not below 0");
  }
  drop_bits(whole, dropped);
  whole.value = count;
  whole.error = {0, 0};
  whole.format = format_of(count, 0);
  whole.function = function;
  return add(std::move(whole));
}

/// X - k M, where M is y rounded.
Result<FixedNode> FixedGraphBuilder::remainder(NodeId id, const Function& function,
                                               NodeId argument) {
  const FixedNode computed = nodes_[argument];
  const mpq_class& divisor = function.parameter();
  const auto error = known_error(computed);
  const auto quotients = [&](const Range& range) -> Range {
    return {floor_of(range.low / divisor), floor_of(range.high / divisor)};
  };
  // One multiple is subtracted if all real arguments have the same quotient.
  const Range real = mixcmp::difference(computed.value, computed.error);
  const bool jumps = quotients(real).low != quotients(real).high;
  const mpq_class moved = error.value_or(0);
  const Range count = quotients(jumps ? mixcmp::difference(computed.value, {moved, moved}) : real);
  NodeId quotient = -1;
  if (jumps) {
    MIXCMP_TRY(found, whole_quotient(id, function, argument, count));
    quotient = found;
  } else {
    quotient = exact_constant(count.low.get_num(), 0, count.low);
  }
  const mpq_class most = std::max<mpq_class>(1, absolute(count).high);
  const int finest = static_cast<int>(floor_log2(divisor) - floor_log2(most)) - 1;
  const int unit_exponent = std::min(computed.format.unit_exponent, finest - options_.format.bits);
  const mpz_class rounded = floor_of(scaled(divisor, -unit_exponent) + mpq_class(1, 2));
  const NodeId period = exact_constant(rounded, unit_exponent, divisor);
  const NodeId multiple = add(exactly(Operation::multiply, quotient, period));
  FixedNode result = exactly(Operation::subtract, argument, multiple);
  const Range off = mixcmp::product(count, nodes_[period].error);  // k M - k y
  if (jumps) {
    narrow(result.value, mixcmp::difference({moved, divisor + moved}, off));
    const mpq_class unit = result.format.unit();
    result.value = {ceiling_of(result.value.low / unit) * unit,
                    floor_of(result.value.high / unit) * unit};
    result.format = format_of(result.value, result.format.unit_exponent);
  }
  if (jumps && !error) {
    return away_from_jumps(id, std::move(result), function, computed.error, off);
  }
  result.function = function;
  return result;
}

/// The result of mod(x, y), limited to where the real argument has the quotient k as well: the
/// result is away from both ends by the argument's error.
Result<FixedNode> FixedGraphBuilder::away_from_jumps(NodeId id, FixedNode result,
                                                     const Function& function, const Range& error,
                                                     const Range& off) {
  const mpq_class& divisor = function.parameter();
  if (options_.is_reference) {
    return refused(id, "a rounded argument near a multiple of the divisor may be on either side",
                   "an exact argument: more bits, or inputs that are integers or in fixed point");
  }
  const mpq_class unit = result.format.unit();
  const Range limits = {ceiling_of((error.high - off.low) / unit) * unit,
                        (ceiling_of((divisor + error.low - off.high) / unit) - 1) * unit};
  if (limits.low > limits.high) {
    return refused(id, "the argument's error is as large as the divisor", "more bits");
  }
  const Range with_argument = result.error;
  FixedNode limited = conversion(Conversion::limit, add(itself(std::move(result))));
  limited.value = limits;
  limited.error = with_argument;
  limited.function = function;
  limited.format = format_of(limits, limited.format.unit_exponent);
  return limited;
}

}  // namespace mixcmp::fixed
