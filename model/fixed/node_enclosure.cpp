#include "model/fixed/node_enclosure.hpp"

#include "model/common/check.hpp"

namespace mixcmp::fixed {
namespace {

/// The error of an absolute value: that of the operand, of either sign where its sign is open.
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
    case Operation::square_root: break;
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
    case Operation::square_root: break;
  }
  MIXCMP_CHECK(false);
}

}  // namespace mixcmp::fixed
