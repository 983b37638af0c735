#include "model/lane/fixed/norm_bound.hpp"

#include <algorithm>

#include "model/base/number/dyadic.hpp"
#include "model/lane/fixed/sum_of_squares.hpp"

namespace mixcmp::fixed {
namespace {

/// Digits of norms, which are rounded up.
constexpr int norm_digits = 64;

/// The greatest value of the low bits that the node drops.
mpq_class dropped_by(const FixedNode& node) {
  return node.format.unit() * (1 - power_of_two(-node.dropped_bits));
}

/// The elements of a sum of squares that drops no bits; none if the node is something else.
std::optional<std::vector<NodeId>> exact_elements(const std::vector<FixedNode>& nodes, NodeId sum) {
  auto squares = sum_of_squares(nodes, sum);
  const auto drops = [&](NodeId id) { return nodes[id].dropped_bits > 0; };
  if (!squares || std::any_of(squares->results.begin(), squares->results.end(), drops)) return {};
  return std::move(squares->elements);
}

/// A bound of the Euclidean norm of the errors of these nodes.
mpq_class norm_of_all(const std::vector<FixedNode>& nodes, const std::vector<NodeId>& elements) {
  mpq_class sum = 0;
  for (const NodeId id : elements) sum += square(nodes[id].error).high;
  return root_above(sum, norm_digits);
}

/// By how much the magnitude of the real radius may exceed the computed radius, which is not
/// negative. The magnitude of a negative real radius is at most the error.
mpq_class radius_above(const FixedNode& radius) {
  const bool is_nonnegative = radius.value.low - radius.error.high >= 0;
  return is_nonnegative ? mpq_class(-radius.error.low) : absolute(radius.error).high;
}

/// The exponent of the least power of two, from 2^0 on, that is at least a slope.
int shift_for(const mpq_class& slope) {
  if (slope <= 1) return 0;
  const auto below = static_cast<int>(floor_log2(slope));
  return power_of_two(below) == slope ? below : below + 1;
}

}  // namespace

std::optional<NormSides> norm_sides(const std::vector<FixedNode>& nodes, NodeId sum,
                                    NodeId square) {
  auto elements = exact_elements(nodes, sum);
  const bool is_square = nodes[square].operation == Operation::square;
  if (!elements || !is_square || nodes[square].dropped_bits > 0) return std::nullopt;
  return NormSides{.elements = std::move(*elements), .radius = nodes[square].operands[0]};
}

std::optional<NormSides> two_norms(const std::vector<FixedNode>& nodes, NodeId f, NodeId g) {
  auto elements = exact_elements(nodes, f), others = exact_elements(nodes, g);
  if (!elements || !others) return std::nullopt;
  return NormSides{
      .elements = std::move(*elements), .radius = g, .radius_elements = std::move(*others)};
}

std::optional<SquaredNorm> squared_norm(const std::vector<FixedNode>& nodes, NodeId sum) {
  const auto squares = sum_of_squares(nodes, sum);
  if (!squares) return std::nullopt;
  SquaredNorm norm{.error = norm_of_all(nodes, squares->elements), .dropped = 0};
  for (const NodeId id : squares->results) norm.dropped += dropped_by(nodes[id]);
  return norm;
}

int NormThresholds::unit_exponent(const std::vector<FixedNode>& nodes) const {
  const int own = nodes[radius].format.unit_exponent;
  return radius_is_squared ? own / 2 : own;  // the exponent of a square's unit is even
}

NormThresholds norm_thresholds(const std::vector<FixedNode>& nodes, const NormSides& sides,
                               const FixedNode& difference) {
  NormThresholds thresholds{.radius = sides.radius, .radius_is_squared = sides.radius_is_squared()};
  const FixedNode& radius = nodes[sides.radius];
  const mpq_class norm = norm_of_all(nodes, sides.elements);
  const mpq_class other = norm_of_all(nodes, sides.radius_elements);
  const mpq_class above = norm + (sides.radius_is_squared() ? other : radius_above(radius));
  const mpq_class below = norm + (sides.radius_is_squared() ? other : radius.error.high);
  const mpq_class unit = difference.format.unit();
  const mpq_class per_radius = 2 * power_of_two(thresholds.unit_exponent(nodes)) / unit;
  const mpq_class least = std::max<mpq_class>(0, above);
  thresholds.shift_above = shift_for(least * per_radius);
  thresholds.offset_above = floor_of(least * least / unit) + 1;
  thresholds.shift_below = shift_for(below * per_radius);
  return thresholds;
}

mpq_class far_square(const std::vector<FixedNode>& nodes, const FixedPart& part) {
  const auto& thresholds = std::get<NormThresholds>(part.criterion);
  const FixedNode& difference = nodes[part.difference];
  const FixedNode& radius = nodes[thresholds.radius];
  const mpz_class most = floor_of(radius.value.high / radius.format.unit());
  const mpz_class s =
      thresholds.radius_is_squared ? shifted_left(1, (digits_of(most) + 1) / 2) : most;
  const mpz_class threshold = shifted_left(s, thresholds.shift_above) + thresholds.offset_above;
  return nodes[difference.operands[1]].value.high + threshold * difference.format.unit();
}

}  // namespace mixcmp::fixed
