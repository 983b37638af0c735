#include "model/lane/fixed/node_enclosure.hpp"

#include <algorithm>

#include "model/base/common/check.hpp"
#include "model/base/number/dyadic.hpp"
#include "model/base/number/exact.hpp"

namespace mixcmp::fixed {
namespace {

/// The error of an absolute value: the operand's error, with either sign if the operand's sign is
/// open.
Range absolute_error(const FixedNode& a) {
  const Range truth = difference(a.value, a.error);
  if (a.value.low >= 0 && truth.low >= 0) return a.error;
  if (a.value.high <= 0 && truth.high <= 0) return negated(a.error);
  const mpq_class most = absolute(a.error).high;
  return {-most, most};
}

/// x' y' - x y for x = x' - e and y = y' - d: x' d + y' e - e d.
Range product_error(const FixedNode& a, const FixedNode& b) {
  return difference(sum(product(a.value, b.error), product(b.value, a.error)),
                    product(a.error, b.error));
}

/// x'^2 - x^2 for x = x' - e: e (2 x' - e).
Range square_error(const FixedNode& a) {
  return product(a.error, difference(sum(a.value, a.value), a.error));
}

}  // namespace

Range exact_error(Operation operation, const FixedNode& a, const FixedNode& b) {
  switch (operation) {
    case Operation::negate: return negated(a.error);
    case Operation::absolute: return absolute_error(a);
    case Operation::add: return sum(a.error, b.error);
    case Operation::subtract: return difference(a.error, b.error);
    case Operation::multiply: return product_error(a, b);
    case Operation::square: return square_error(a);
    case Operation::minimum:
    case Operation::maximum: return hull({a.error.low, a.error.high, b.error.low, b.error.high});
    case Operation::input:
    case Operation::constant:
    case Operation::convert:
    case Operation::divide:
    case Operation::square_root:
    case Operation::function:
    case Operation::look_up:
    case Operation::fused_sum: break;
  }
  MIXCMP_CHECK(false);
}

Range exact_value(Operation operation, const Range& a, const Range& b) {
  switch (operation) {
    case Operation::negate: return negated(a);
    case Operation::absolute: return absolute(a);
    case Operation::add: return sum(a, b);
    case Operation::subtract: return difference(a, b);
    case Operation::multiply: return product(a, b);
    case Operation::square: return square(a);
    case Operation::minimum: return minimum(a, b);
    case Operation::maximum: return maximum(a, b);
    case Operation::input:
    case Operation::constant:
    case Operation::convert:
    case Operation::divide:
    case Operation::square_root:
    case Operation::function:
    case Operation::look_up:
    case Operation::fused_sum: break;
  }
  MIXCMP_CHECK(false);
}

int unit_exponent_of(Operation operation, const FixedFormat& a, const FixedFormat& b) {
  if (operation == Operation::square) return 2 * a.unit_exponent;
  if (operation == Operation::multiply) return a.unit_exponent + b.unit_exponent;
  return std::min(a.unit_exponent, b.unit_exponent);
}

FixedNode exact_node(const std::vector<FixedNode>& nodes, Operation operation, NodeId a, NodeId b) {
  const FixedNode& first = nodes[a];
  const FixedNode& second = nodes[b < 0 ? a : b];
  FixedNode node{.operation = operation, .operands = {a, b}, .constant = {}};
  const bool cancels = operation == Operation::subtract && a == b;
  node.value = cancels ? Range{0, 0} : exact_value(operation, first.value, second.value);
  node.error = cancels ? Range{0, 0} : exact_error(operation, first, second);
  node.format = format_of(node.value, unit_exponent_of(operation, first.format, second.format));
  return node;
}

void narrow(Range& range, const Range& other) {
  const Range both = {std::max(range.low, other.low), std::min(range.high, other.high)};
  if (both.low <= both.high) range = both;
}

Range rounded_down(const Range& value, const mpq_class& unit) {
  return {floor_of(value.low / unit) * unit, floor_of(value.high / unit) * unit};
}

FixedFormat format_of(const Range& value, int unit_exponent) {
  const mpq_class per_unit = power_of_two(-unit_exponent);
  return FixedFormat::holding(floor_of(value.low * per_unit), ceiling_of(value.high * per_unit),
                              unit_exponent);
}

void drop_bits(FixedNode& node, int count) {
  if (count <= 0) return;
  node.dropped_bits = count;
  const mpq_class exact_unit = node.format.unit();
  const int unit_exponent = node.format.unit_exponent + count;
  const mpq_class unit = power_of_two(unit_exponent);
  node.error.low -= unit - exact_unit;
  node.value = rounded_down(node.value, unit);
  node.format = format_of(node.value, unit_exponent);
}

/// Dropping bits moves a positive end towards 0 and a negative one towards -1 unit. Dropping the
/// most bits gives the innermost ends. Dropping none, if the operand fits `bits` bits, gives the
/// outermost.
Range cut_value(const FixedNode& node, int bits, int most) {
  const mpq_class unit = node.format.unit();
  const mpz_class low = ceiling_of(node.value.low / unit), high = floor_of(node.value.high / unit);
  const mpz_class beyond = shifted_left(1, bits);
  const auto least = [&](const mpz_class& end) { return floor_of(scaled(end, -most)); };
  const mpz_class cut_low = low > 0 ? least(low) : std::max<mpz_class>(low, -beyond);
  const mpz_class cut_high = high < 0 ? least(high) : std::min<mpz_class>(high, beyond - 1);
  return {cut_low * unit, cut_high * unit};
}

/// With t = 2^-k, k = 0..most, the error is e t - r with 0 <= r <= (1 - t) unit. Its ends are
/// linear in t, so they are extreme at the least and at the greatest t.
Range cut_error(const FixedNode& node, int most) {
  const mpq_class t = power_of_two(-most);
  const mpq_class lost = node.format.unit() * (1 - t);
  return {std::min<mpq_class>(node.error.low, node.error.low * t - lost),
          std::max<mpq_class>(node.error.high, node.error.high * t)};
}

}  // namespace mixcmp::fixed
