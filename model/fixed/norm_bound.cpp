#include "model/fixed/norm_bound.hpp"

#include "model/number/dyadic.hpp"

namespace mixcmp::fixed {
namespace {

/// Appends the elements of a sum of squares; false where the node is something else or rounds.
bool add_elements(const std::vector<FixedNode>& nodes, NodeId id, std::vector<NodeId>& elements) {
  const FixedNode& node = nodes[id];
  if (node.dropped_bits > 0) return false;
  if (node.operation == Operation::square) {
    elements.push_back(node.operands[0]);
    return true;
  }
  return node.operation == Operation::add && add_elements(nodes, node.operands[0], elements) &&
         add_elements(nodes, node.operands[1], elements);
}

/// The square root of value >= 0, rounded up.
mpq_class root_above(const mpq_class& value) {
  constexpr int digits = 64;
  const mpq_class root = root_of(value, digits);
  return root * root == value ? root : root * (1 + power_of_two(1 - digits));
}

/// A bound of the Euclidean norm of the errors of x.
mpq_class norm_of_errors(const std::vector<FixedNode>& nodes, const std::vector<NodeId>& elements) {
  mpq_class sum = 0;
  for (const NodeId id : elements) sum += square(nodes[id].error).high;
  return root_above(sum);
}

/// How far the magnitude of the real radius may exceed the radius as computed. A real radius that
/// is negative has come below zero by its error.
mpq_class radius_above(const FixedNode& radius) {
  const bool is_nonnegative = radius.value.low - radius.error.high >= 0;
  return is_nonnegative ? mpq_class(-radius.error.low) : absolute(radius.error).high;
}

/// The exponent of the least power of two, from 2^0 on, that is not below a slope.
int shift_for(const mpq_class& slope) {
  if (slope <= 1) return 0;
  const auto below = static_cast<int>(floor_log2(slope));
  return power_of_two(below) == slope ? below : below + 1;
}

}  // namespace

std::optional<NormSides> norm_sides(const std::vector<FixedNode>& nodes, NodeId sum,
                                    NodeId square) {
  NormSides sides{.elements = {}, .radius = nodes[square].operands[0]};
  if (nodes[square].operation != Operation::square || nodes[square].dropped_bits > 0) return {};
  if (!add_elements(nodes, sum, sides.elements)) return {};
  return sides;
}

NormThresholds norm_thresholds(const std::vector<FixedNode>& nodes, const NormSides& sides,
                               const FixedNode& difference) {
  const FixedNode& radius = nodes[sides.radius];
  const mpq_class norm = norm_of_errors(nodes, sides.elements);
  const mpq_class above = std::max<mpq_class>(0, norm + radius_above(radius));
  const mpq_class below = std::max<mpq_class>(0, norm + radius.error.high);
  const mpq_class unit = difference.format.unit();
  const mpq_class per_radius = 2 * radius.format.unit() / unit;
  return {.radius = sides.radius,
          .shift_above = shift_for(above * per_radius),
          .offset_above = floor_of(above * above / unit) + 1,
          .shift_below = shift_for(below * per_radius)};
}

}  // namespace mixcmp::fixed
