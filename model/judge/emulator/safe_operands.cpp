#include "model/judge/emulator/safe_operands.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "model/base/common/check.hpp"
#include "model/base/number/double.hpp"

namespace mixcmp::emulator {
namespace {

/// The grid of a value without one: far below every grid that matters.
constexpr int no_grid = -1'000'000;

/// Limits on a node's values x. If x is not 0, 2^low <= |x| <= 2^high; every x is a multiple of
/// 2^grid.
struct Extent {
  int low = 0;
  int high = 0;
  int grid = no_grid;
  bool nonnegative = false;
  bool nonzero = false;
};

Extent of_constant(double value, int digits) {
  if (value == 0) return {.grid = 0, .nonnegative = true};
  const int exponent = std::ilogb(value);
  return {exponent, exponent + 1, exponent - digits + 1, value > 0, true};
}

/// The extent after rounding to `digits` digits. Rounding keeps the limits, which are powers of
/// two, and turns multiples of the grid into such multiples.
Extent rounded(Extent x, int digits) {
  x.grid = std::max(x.grid, x.low - digits + 1);
  return x;
}

/// The extent of a + b; `cancels` if their signs may differ.
Extent sum(const Extent& a, const Extent& b, bool cancels) {
  const int grid = std::min(a.grid, b.grid);
  return {.low = cancels ? grid : std::min(a.low, b.low),
          .high = std::max(a.high, b.high) + 1,
          .grid = grid,
          .nonnegative = !cancels,
          .nonzero = !cancels && (a.nonzero || b.nonzero)};
}

Extent product(const Extent& a, const Extent& b) {
  return {a.low + b.low, a.high + b.high, a.grid + b.grid, a.nonnegative && b.nonnegative,
          a.nonzero && b.nonzero};
}

std::optional<Extent> quotient(const Extent& a, const Extent& b) {
  if (!b.nonzero) return std::nullopt;
  return Extent{a.low - b.high, a.high - b.low, no_grid, a.nonnegative && b.nonnegative, a.nonzero};
}

std::optional<Extent> root(const Extent& a) {
  if (!a.nonnegative) return std::nullopt;
  const auto half_down = [](int exponent) { return exponent >> 1; };
  return Extent{half_down(a.low), half_down(a.high + 1), no_grid, true, a.nonzero};
}

Extent either(const Extent& a, const Extent& b, bool nonnegative) {
  return {std::min(a.low, b.low), std::max(a.high, b.high), std::min(a.grid, b.grid), nonnegative,
          a.nonzero && b.nonzero};
}

/// The extent of a node before its own rounding; none if a divisor may be 0 or a radicand negative.
std::optional<Extent> result(const TypedNode& node, const SafeOperands& operands, const Extent& a,
                             const Extent& b) {
  const bool nonnegative = a.nonnegative && b.nonnegative;
  switch (node.operation) {
    case Operation::input:
      return Extent{operands.low, operands.high, operands.low - node.format.precision() + 1};
    case Operation::constant:
      return of_constant(to_double(node.format, node.constant), node.format.precision());
    case Operation::convert: return a;
    case Operation::negate: return Extent{a.low, a.high, a.grid, false, a.nonzero};
    case Operation::absolute: return Extent{a.low, a.high, a.grid, true, a.nonzero};
    case Operation::add: return sum(a, b, !nonnegative);
    case Operation::subtract: return sum(a, b, true);
    case Operation::multiply: return product(a, b);
    case Operation::square: {
      Extent square = product(a, a);
      square.nonnegative = true;
      return square;
    }
    case Operation::divide: return quotient(a, b);
    case Operation::square_root: return root(a);
    case Operation::minimum: return either(a, b, nonnegative);
    case Operation::maximum: return either(a, b, a.nonnegative || b.nonnegative);
    case Operation::function:
    case Operation::look_up:
    case Operation::fused_sum: break;
  }
  MIXCMP_CHECK(false);
}

bool is_trusted(const Extent& x, FloatFormat format) {
  const TrustedExponents trusted = trusted_exponents(format);
  return trusted.least <= x.low && x.high < trusted.limit;
}

bool is_safe(const TypedGraph& graph, const SafeOperands& operands) {
  std::vector<Extent> extents;
  for (const TypedNode& node : graph.nodes) {
    const auto operand = [&](int k) {
      return node.operands[k] < 0 ? Extent{} : extents[node.operands[k]];
    };
    const std::optional<Extent> exact = result(node, operands, operand(0), operand(1));
    if (!exact) return false;
    const bool is_zero = node.operation == Operation::constant && !exact->nonzero;
    if (!is_zero && !is_trusted(*exact, node.format)) return false;
    extents.push_back(rounded(*exact, node.format.precision()));
  }
  return true;
}

}  // namespace

TrustedExponents trusted_exponents(FloatFormat format) {
  constexpr int widest = 500;
  return {std::max(format.min_exponent(), -widest), std::min(format.max_exponent() + 1, widest)};
}

std::optional<SafeOperands> safe_operands(const TypedGraph& graph) {
  SafeOperands operands = {0, 0};
  if (!is_safe(graph, operands)) return std::nullopt;
  const auto grow = [&](int low, int high) {
    while (is_safe(graph, {operands.low - low, operands.high + high})) {
      operands.low -= low;
      operands.high += high;
    }
  };
  grow(1, 1);
  grow(0, 1);
  grow(1, 0);
  return operands;
}

}  // namespace mixcmp::emulator
