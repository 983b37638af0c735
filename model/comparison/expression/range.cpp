#include "model/comparison/expression/range.hpp"

#include <algorithm>

namespace mixcmp::inline expression {

bool contains_zero(const Range& range) {
  return range.low <= 0 && range.high >= 0;
}

Range hull(const std::vector<mpq_class>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return {*low, *high};
}

Range negated(const Range& a) {
  return {-a.high, -a.low};
}

Range sum(const Range& a, const Range& b) {
  return {a.low + b.low, a.high + b.high};
}

Range difference(const Range& a, const Range& b) {
  return {a.low - b.high, a.high - b.low};
}

Range product(const Range& a, const Range& b) {
  return hull({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
}

Range absolute(const Range& a) {
  const mpq_class low = abs(a.low), high = abs(a.high);
  if (contains_zero(a)) return {0, std::max(low, high)};
  return {std::min(low, high), std::max(low, high)};
}

Range square(const Range& a) {
  const Range magnitude = absolute(a);
  return {magnitude.low * magnitude.low, magnitude.high * magnitude.high};
}

Range minimum(const Range& a, const Range& b) {
  return {std::min(a.low, b.low), std::min(a.high, b.high)};
}

Range maximum(const Range& a, const Range& b) {
  return {std::max(a.low, b.low), std::max(a.high, b.high)};
}

}  // namespace mixcmp::inline expression
