#pragma once

#include <gmpxx.h>

#include <algorithm>
#include <compare>

#include "model/comparison/expression/range.hpp"

namespace mixcmp::inline expression {

/// x -> factor x + offset.
struct AffineMap {
  mpq_class factor = 1, offset = 0;

  bool is_identity() const { return factor == 1 && offset == 0; }
  mpq_class at(const mpq_class& x) const { return factor * x + offset; }
  Range of(const Range& range) const {
    const mpq_class low = at(range.low), high = at(range.high);
    return {std::min(low, high), std::max(low, high)};
  }
  /// The map of this map's results: x -> outer(factor x + offset).
  AffineMap then(const AffineMap& outer) const { return {outer.factor * factor, outer.at(offset)}; }

  friend bool operator==(const AffineMap&, const AffineMap&) = default;
};

}  // namespace mixcmp::inline expression
