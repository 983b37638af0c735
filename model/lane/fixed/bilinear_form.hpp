#pragma once

#include <optional>
#include <vector>

#include "model/lane/fixed/item_split.hpp"

namespace mixcmp::fixed {

/// The lane with its differences as bilinear forms: numbers of one item or row, and products of a
/// number of one with a number of another. For squared distances of a row x to candidates a and b,
///
///     |x - a|^2 - |x - b|^2 = |a|^2 - |b|^2 + 2 x . (b - a),
///
/// x . x cancels, |a|^2 is a field of a's word (split_by_item), and there is one product in each
/// dimension, not two. The differences are the same integers in the same units, so thresholds and
/// verdicts stay.
///
/// Nothing, if no difference has products of exact sums of such numbers, or if a term depends on
/// both items and the row.
std::optional<FixedLane> in_bilinear_form(const FixedLane& lane,
                                          const std::vector<ItemInput>& inputs);

}  // namespace mixcmp::fixed
