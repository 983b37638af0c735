#include "model/fixed/norm_part.hpp"

#include <algorithm>
#include <map>

#include "model/fixed/norm_bound.hpp"
#include "model/number/dyadic.hpp"

namespace mixcmp::fixed {
namespace {

/// f - g, or g - f where `swapped`, as |x|^2 less s^2 or |y|^2.
struct NormForm {
  NodeId sum;    ///< |x|^2
  NodeId other;  ///< s^2 or |y|^2
  bool swapped;
};

using Replaced = std::map<NodeId, NodeId>;

class NormPartMaker {
public:
  NormPartMaker(FixedGraphBuilder& builder, const NormForm& form)
      : builder_(builder), form_(form) {}

  FixedPart run() {
    form_ = with_fewest_low_bits();
    return part_of(within_reach(form_));
  }

private:
  const FixedNode& node(NodeId id) const { return builder_.nodes()[id]; }

  NormSides sides_of(const NormForm& form) {
    const auto two = two_norms(builder_.nodes(), form.sum, form.other);
    auto sides = norm_sides(builder_.nodes(), form.sum, form.other);
    if (!sides) return *two;
    if (node(sides->radius).value.low < 0) sides->radius = builder_.magnitude(sides->radius);
    return *sides;
  }

  FixedPart part_of(const NormForm& form) {
    const NormSides sides = sides_of(form);
    const NodeId difference = builder_.difference(form.sum, form.other);
    return {.difference = difference,
            .swapped = form.swapped,
            .criterion = norm_thresholds(builder_.nodes(), sides, node(difference))};
  }

  /// What is squared on both sides.
  std::vector<NodeId> squared(const NormForm& form) const {
    std::vector<NodeId> all = squared_in(form.sum);
    for (const NodeId id : squared_in(form.other)) all.push_back(id);
    return all;
  }

  std::vector<NodeId> squared_in(NodeId sum) const {
    const FixedNode& added = node(sum);
    if (added.operation == Operation::square) return {added.operands[0]};
    std::vector<NodeId> all = squared_in(added.operands[0]);
    for (const NodeId id : squared_in(added.operands[1])) all.push_back(id);
    return all;
  }

  /// The coarsest unit that leaves the slopes what they are.
  NormForm with_fewest_low_bits() {
    const std::vector<NodeId> all = squared(form_);
    const auto unit_exponent = [&](NodeId id) { return node(id).format.unit_exponent; };
    std::vector<int> units;
    for (const NodeId id : all) units.push_back(unit_exponent(id));
    const auto [finest, coarsest] = std::minmax_element(units.begin(), units.end());
    const auto slopes = slopes_of(part_of(form_));
    for (int unit = *coarsest; unit > *finest; --unit) {
      Replaced replaced;
      for (const NodeId id : all) {
        replaced[id] = builder_.without_low_bits(id, unit - unit_exponent(id));
      }
      const NormForm cut = replace(form_, replaced);
      if (slopes_of(part_of(cut)) == slopes) return cut;
    }
    return form_;
  }

  /// The slopes of the thresholds, as numbers.
  std::pair<mpq_class, mpq_class> slopes_of(const FixedPart& part) const {
    const auto& thresholds = std::get<NormThresholds>(part.criterion);
    const mpq_class per_radius = node(part.difference).format.unit() /
                                 power_of_two(thresholds.unit_exponent(builder_.nodes()));
    return {power_of_two(thresholds.shift_above) * per_radius,
            power_of_two(thresholds.shift_below) * per_radius};
  }

  NormForm replace(const NormForm& form, const Replaced& replaced) {
    return {builder_.with_squared(form.sum, replaced), builder_.with_squared(form.other, replaced),
            form.swapped};
  }

  /// The form whose elements of x have no more bits than they need where none of them decides the
  /// part alone. Thresholds do not grow where narrower sums are exact.
  NormForm within_reach(const NormForm& form) {
    const mpq_class square = far_square(builder_.nodes(), part_of(form));
    Replaced replaced;
    for (const NodeId id : squared_in(form.sum)) {
      const mpq_class unit = node(id).format.unit();
      int bits = 0;
      while (power_of_two(2L * bits) * unit * unit < square) ++bits;
      replaced[id] = builder_.within_reach(id, bits);
    }
    return {builder_.with_squared(form.sum, replaced), form.other, form.swapped};
  }

  FixedGraphBuilder& builder_;
  NormForm form_;
};

}  // namespace

std::optional<FixedPart> norm_part(FixedGraphBuilder& builder, NodeId f, NodeId g) {
  for (const NormForm& form : {NormForm{f, g, false}, NormForm{g, f, true}}) {
    if (!norm_sides(builder.nodes(), form.sum, form.other)) continue;
    return NormPartMaker(builder, form).run();
  }
  if (!two_norms(builder.nodes(), f, g)) return std::nullopt;
  return NormPartMaker(builder, {f, g, false}).run();
}

}  // namespace mixcmp::fixed
