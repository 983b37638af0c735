#include "model/judge/proof/norm_conditions.hpp"

#include "model/base/number/dyadic.hpp"
#include "model/lane/fixed/sum_of_squares.hpp"

namespace mixcmp::proof {
namespace {

using fixed::FixedNode;

/// c of theorem 4.
mpq_class largest_excess(const FixedNode& radius) {
  const bool is_nonnegative = radius.value.low - radius.error.high >= 0;
  return is_nonnegative ? mpq_class(-radius.error.low) : absolute(radius.error).high;
}

}  // namespace

NormConditions::NormConditions(const std::vector<FixedNode>& nodes, const FixedNode& difference,
                               const fixed::NormThresholds& thresholds)
    : nodes_(nodes), difference_(difference), thresholds_(thresholds) {
  const auto elements = exact_elements(difference.operands[0]);
  has_form_ = difference.operation == Operation::subtract && elements &&
              is_other_side(difference.operands[1]);
  if (elements) elements_ = *elements;
  const mpq_class unit = difference.format.unit();
  const mpq_class per_radius = unit / power_of_two(thresholds.unit_exponent(nodes)) / 2;
  a_ = power_of_two(thresholds.shift_above) * per_radius;
  b_ = power_of_two(thresholds.shift_below) * per_radius;
  offset_ = thresholds.offset_above * unit;
}

bool NormConditions::hold() const {
  if (!has_form_) return false;
  const mpq_class squares = squared_errors(elements_);
  if (!thresholds_.radius_is_squared) return suffice_for_radius(squares);
  const auto others = exact_elements(thresholds_.radius);
  return others && suffice_for_two(squares, squared_errors(*others));
}

mpq_class NormConditions::far_square() const {
  return nodes_[other_side()].value.high + 2 * a_ * largest_radius() + offset_;
}

/// The elements of a sum of squares that drops no bits; none if the node is something else.
std::optional<std::vector<NodeId>> NormConditions::exact_elements(NodeId sum) const {
  const auto squares = fixed::sum_of_squares(nodes_, sum);
  if (!squares) return std::nullopt;
  for (const NodeId id : squares->results) {
    if (nodes_[id].dropped_bits > 0) return std::nullopt;
  }
  return squares->elements;
}

mpq_class NormConditions::squared_errors(const std::vector<NodeId>& elements) const {
  mpq_class sum = 0;
  for (const NodeId id : elements) sum += square(nodes_[id].error).high;
  return sum;
}

/// Whether the node is |y|^2, or the square of the radius or of the radius' operand if it is a
/// magnitude.
bool NormConditions::is_other_side(NodeId other) const {
  if (thresholds_.radius_is_squared) return other == thresholds_.radius;
  const FixedNode &square = nodes_[other], &radius = nodes_[thresholds_.radius];
  if (square.operation != Operation::square || square.dropped_bits > 0) return false;
  const bool is_magnitude = radius.operation == Operation::absolute;
  return square.operands[0] == thresholds_.radius ||
         (is_magnitude && square.operands[0] == radius.operands[0]);
}

/// The largest s: that of a radius, or the least power of two above the largest root.
mpq_class NormConditions::largest_radius() const {
  const mpq_class& largest = nodes_[thresholds_.radius].value.high;
  if (!thresholds_.radius_is_squared) return largest;
  mpq_class s = power_of_two(thresholds_.unit_exponent(nodes_));
  while (largest >= s * s) s *= 2;
  return s;
}

/// Whether a >= r + c, offset > max(0, r + c)^2 and b >= r + h, where r^2 = squares.
bool NormConditions::suffice_for_radius(const mpq_class& squares) const {
  const FixedNode& radius = nodes_[thresholds_.radius];
  const mpq_class c = largest_excess(radius);
  const auto at_least = [&](const mpq_class& factor, const mpq_class& beside) {
    return factor >= beside && (factor - beside) * (factor - beside) >= squares;
  };
  // offset - r^2 - c^2 > 2 c r, without the root.
  const mpq_class rest = offset_ - squares - c * c;
  const mpq_class twice = 4 * c * c * squares;
  const bool none_is_needed = c <= 0 && c * c >= squares;
  const bool offset_suffices = none_is_needed ? offset_ > 0
                               : c >= 0       ? rest > 0 && rest * rest > twice
                                              : rest > 0 || rest * rest < twice;
  return radius.value.low >= 0 && at_least(a_, c) && offset_suffices &&
         at_least(b_, radius.error.high);
}

/// Whether a and b are at least p + q, and offset > (p + q)^2, given p^2 and q^2.
bool NormConditions::suffice_for_two(const mpq_class& p2, const mpq_class& q2) const {
  const auto at_least = [&](const mpq_class& factor) {
    const mpq_class rest = factor * factor - p2 - q2;
    return factor >= 0 && rest >= 0 && rest * rest >= 4 * p2 * q2;
  };
  const mpq_class rest = offset_ - p2 - q2;
  return at_least(a_) && at_least(b_) && rest > 0 && rest * rest > 4 * p2 * q2;
}

}  // namespace mixcmp::proof
