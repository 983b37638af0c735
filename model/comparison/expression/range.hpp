#pragma once

#include <gmpxx.h>

#include <vector>

namespace mixcmp::inline expression {

/// A closed interval of exact numbers.
struct Range {
  mpq_class low;
  mpq_class high;

  friend bool operator==(const Range&, const Range&) = default;
};

/// Interval arithmetic without rounding: each result tightly encloses the possible values.
bool contains_zero(const Range& range);
Range hull(const std::vector<mpq_class>& values);
Range negated(const Range& a);
Range sum(const Range& a, const Range& b);
Range difference(const Range& a, const Range& b);
Range product(const Range& a, const Range& b);
Range absolute(const Range& a);
Range square(const Range& a);
Range minimum(const Range& a, const Range& b);
Range maximum(const Range& a, const Range& b);

}  // namespace mixcmp::inline expression
