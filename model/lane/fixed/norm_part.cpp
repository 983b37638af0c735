#include "model/lane/fixed/norm_part.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

#include "model/base/number/dyadic.hpp"
#include "model/lane/fixed/norm_bound.hpp"
#include "model/lane/fixed/sum_of_squares.hpp"

namespace mixcmp::fixed {
namespace {

/// f - g, or g - f if `swapped`, as |x|^2 less s^2 or |y|^2.
struct NormForm {
  NodeId sum;    ///< |x|^2
  NodeId other;  ///< s^2 or |y|^2
  bool swapped;
};

using Replaced = std::map<NodeId, NodeId>;

/// The forms of f and g: only those with a radius, if there are any.
std::vector<NormForm> forms_of(const std::vector<FixedNode>& nodes, NodeId f, NodeId g) {
  const NormForm forms[] = {{f, g, false}, {g, f, true}};
  std::vector<NormForm> with_radius;
  for (const NormForm& form : forms) {
    if (norm_sides(nodes, form.sum, form.other)) with_radius.push_back(form);
  }
  const bool have_norms = with_radius.empty() && two_norms(nodes, f, g);
  return have_norms ? std::vector(std::begin(forms), std::end(forms)) : with_radius;
}

/// The slopes of a norm's thresholds as numbers: above, and below.
std::pair<mpq_class, mpq_class> slopes_of(const std::vector<FixedNode>& nodes,
                                          const FixedPart& part) {
  const auto& thresholds = std::get<NormThresholds>(part.criterion);
  const mpq_class per_radius =
      nodes[part.difference].format.unit() / power_of_two(thresholds.unit_exponent(nodes));
  return {power_of_two(thresholds.shift_above) * per_radius,
          power_of_two(thresholds.shift_below) * per_radius};
}

bool is_better(const std::vector<FixedNode>& nodes, const FixedPart& part, const FixedPart& other) {
  const auto slopes = [&](const FixedPart& of) -> mpq_class {
    const auto [above, below] = slopes_of(nodes, of);
    return above + below;
  };
  const auto width = [&](const FixedPart& of) { return nodes[of.difference].format.width; };
  if (slopes(part) != slopes(other)) return slopes(part) < slopes(other);
  return width(part) < width(other);
}

class NormPartMaker {
public:
  NormPartMaker(FixedGraphBuilder& builder, const NormForm& form)
      : builder_(builder), form_(form) {}

  FixedPart run() { return part_of(within_reach(with_fewest_low_bits())); }

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

  std::vector<NodeId> squared_in(NodeId sum) const {
    return sum_of_squares(builder_.nodes(), sum)->elements;
  }

  /// All squared nodes get the coarsest unit that does not change the slopes.
  NormForm with_fewest_low_bits() {
    std::vector<NodeId> all = squared_in(form_.sum);
    for (const NodeId id : squared_in(form_.other)) all.push_back(id);
    const auto unit_exponent = [&](NodeId id) { return node(id).format.unit_exponent; };
    std::vector<int> units;
    for (const NodeId id : all) units.push_back(unit_exponent(id));
    const auto [finest, coarsest] = std::minmax_element(units.begin(), units.end());
    const auto slopes_with = [&](const NormForm& form) {
      const FixedPart part = part_of(form);
      return slopes_of(builder_.nodes(), part);
    };
    const auto slopes = slopes_with(form_);
    for (int unit = *coarsest; unit > *finest; --unit) {
      Replaced replaced;
      for (const NodeId id : all) {
        replaced[id] = builder_.without_low_bits(id, unit - unit_exponent(id));
      }
      const NormForm cut = replace(form_, replaced);
      if (slopes_with(cut) == slopes) return cut;
    }
    return form_;
  }

  NormForm replace(const NormForm& form, const Replaced& replaced) {
    return {builder_.with_squared(form.sum, replaced), builder_.with_squared(form.other, replaced),
            form.swapped};
  }

  /// Elements of x get no more bits than they need when none of their squares decides the part. The
  /// thresholds do not change, since the narrower sums are exact as well.
  NormForm within_reach(const NormForm& form) {
    const FixedPart whole = part_of(form);
    const mpq_class square = far_square(builder_.nodes(), whole);
    Replaced replaced;
    for (const NodeId id : squared_in(form.sum)) {
      const mpq_class unit = node(id).format.unit();
      int bits = 1;  // no format has fewer
      while (power_of_two(2L * bits) * unit * unit < square) ++bits;
      replaced[id] = builder_.within_reach(id, bits);
    }
    return {builder_.with_squared(form.sum, replaced), form.other, form.swapped};
  }

  FixedGraphBuilder& builder_;
  const NormForm form_;
};

}  // namespace

std::optional<FixedPart> norm_part(FixedGraphBuilder& builder, NodeId f, NodeId g) {
  std::optional<FixedPart> best;
  for (const NormForm& form : forms_of(builder.nodes(), f, g)) {
    FixedPart part = NormPartMaker(builder, form).run();
    if (!best || is_better(builder.nodes(), part, *best)) best = std::move(part);
  }
  return best;
}

}  // namespace mixcmp::fixed
