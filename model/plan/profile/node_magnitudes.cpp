#include "model/plan/profile/node_magnitudes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "model/base/common/check.hpp"

namespace mixcmp::profile {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int unknown = NodeMagnitude::unknown;
/// Covers the roundings of the limits' own computation in double.
constexpr double outward = 1 + 0x1p-40;

/// Exponents are clamped to this, far outside any format, so sums of them do not overflow.
constexpr int furthest = 1 << 20;

int sum_or_unknown(int a, int b) {
  if (a == unknown || b == unknown || a + b < -furthest) return unknown;
  return std::min(a + b, furthest);
}

/// The largest k such that 2^k divides x; x is finite and not 0.
int grid_of(double x) {
  int exponent = 0;
  const auto significand = static_cast<long long>(std::ldexp(std::frexp(x, &exponent), 53));
  return exponent - 53 + __builtin_ctzll(static_cast<unsigned long long>(std::llabs(significand)));
}

NodeMagnitude constant_magnitude(const TypedNode& node, int precision) {
  const double value = std::fabs(node.value.get_d());
  if (node.value == 0) return {.largest = 0, .grid = 0, .least = 0};
  if (value == 0 || !std::isfinite(value)) return {.largest = infinity};
  // The constant is encoded in its own format or in `precision` digits. The factor 2 covers the
  // rounding.
  const int least = std::ilogb(value) - 1;
  const int digits = std::max(precision, node.format.precision());
  return {.largest = value * 2, .grid = least - digits, .least = least};
}

/// The magnitude of the exact result on computed operands.
NodeMagnitude exact_magnitude(const TypedNode& node, const NodeMagnitude& a,
                              const NodeMagnitude& b) {
  switch (node.operation) {
    case Operation::convert:
    case Operation::negate:
    case Operation::absolute: return a;
    case Operation::add:
    case Operation::subtract: {
      const int grid = std::min(a.grid, b.grid);
      return {.largest = a.largest + b.largest, .grid = grid, .least = grid};
    }
    case Operation::multiply:
      return {.largest = a.largest * b.largest,
              .grid = sum_or_unknown(a.grid, b.grid),
              .least = sum_or_unknown(a.least, b.least)};
    case Operation::square:
      return {.largest = a.largest * a.largest,
              .grid = sum_or_unknown(a.grid, a.grid),
              .least = sum_or_unknown(a.least, a.least)};
    case Operation::divide: return {.largest = infinity};
    case Operation::square_root:
      return {.largest = std::sqrt(a.largest),
              .least = a.least == unknown ? unknown : (a.least >> 1)};
    case Operation::minimum:
    case Operation::maximum:
      return {.largest = std::max(a.largest, b.largest),
              .grid = std::min(a.grid, b.grid),
              .least = std::min(a.least, b.least)};
    case Operation::input:
    case Operation::constant:
    case Operation::function:
    case Operation::look_up:
    case Operation::fused_sum: break;
  }
  MIXCMP_CHECK(false);
}

/// The magnitude after rounding: a number of `precision` digits that is at least 2^least is a
/// multiple of 2^(least - precision + 1).
NodeMagnitude rounded(NodeMagnitude exact, int precision) {
  if (exact.least != unknown) exact.grid = std::max(exact.grid, exact.least - precision + 1);
  if (exact.grid != unknown) exact.least = std::max(exact.least, exact.grid);
  const double factor = 1 + std::ldexp(1.0, 1 - precision);
  exact.largest = std::isnan(exact.largest) ? infinity : exact.largest * factor;
  return exact;
}

}  // namespace

bool rounds(Operation operation) {
  switch (operation) {
    case Operation::convert:
    case Operation::add:
    case Operation::subtract:
    case Operation::multiply:
    case Operation::square:
    case Operation::divide:
    case Operation::square_root:
    case Operation::fused_sum: return true;
    case Operation::function:
    case Operation::look_up: break;
    case Operation::input:
    case Operation::constant:
    case Operation::negate:
    case Operation::absolute:
    case Operation::minimum:
    case Operation::maximum: return false;
  }
  MIXCMP_CHECK(false);
}

NodeMagnitude magnitude_of(const std::vector<double>& values) {
  NodeMagnitude magnitude{.largest = 0, .grid = -unknown, .least = -unknown};
  for (const double value : values) {
    if (!std::isfinite(value)) {
      magnitude.largest = infinity;
    } else if (value != 0) {
      magnitude.largest = std::max(magnitude.largest, std::fabs(value));
      magnitude.grid = std::min(magnitude.grid, grid_of(value));
      magnitude.least = std::min(magnitude.least, std::ilogb(value));
    }
  }
  // All values are zero: any exponents are valid, and no arithmetic on 0 overflows.
  if (magnitude.least == -unknown) magnitude.grid = magnitude.least = 0;
  return magnitude;
}

std::vector<NodeMagnitude> node_magnitudes(const TypedGraph& lane, int precision,
                                           const std::vector<NodeMagnitude>& inputs) {
  std::vector<NodeMagnitude> magnitudes;
  for (const TypedNode& node : lane.nodes) {
    const NodeMagnitude none{.largest = 0};
    const auto operand = [&](int k) {
      return node.operands[k] < 0 ? none : magnitudes[node.operands[k]];
    };
    NodeMagnitude magnitude = none;
    if (node.operation == Operation::input) {
      magnitude = inputs[node.input];
    } else if (node.operation == Operation::constant) {
      magnitude = constant_magnitude(node, precision);
    } else {
      magnitude = exact_magnitude(node, operand(0), operand(1));
    }
    // An input of a first operator may be rounded to more digits than the lane has.
    const int digits = std::max(precision, node.format.precision());
    if (rounds(node.operation)) magnitude = rounded(magnitude, digits);
    magnitude.largest *= outward;
    magnitudes.push_back(magnitude);
  }
  return magnitudes;
}

}  // namespace mixcmp::profile
