#include "model/lane/error/range_check.hpp"

#include <algorithm>

#include "model/base/common/check.hpp"
#include "model/base/number/exact.hpp"

namespace mixcmp::error {
namespace {

/// Fraction bits of a limit: neighbouring limits are 12 % apart, and a limit costs three LUTs.
constexpr int checked_fraction_bits = 3;

Bits finite_magnitude(FloatFormat format, const mpq_class& value) {
  const Bits magnitude = format.magnitude(from_rational(format, value));
  return std::min(magnitude, format.largest_finite(false));
}

RequiredSign sign_of(const Range& range) {
  if (range.low >= 0) return RequiredSign::nonnegative;
  return range.high <= 0 ? RequiredSign::nonpositive : RequiredSign::any;
}

int unchecked_bits(const RangeCheck& check, FloatFormat format) {
  return format.width() - 1 - check.leading_bits;
}

}  // namespace

RangeCheck range_check(int input, FloatFormat format, const Range& range) {
  RangeCheck check{.input = input,
                   .sign = sign_of(range),
                   .leading_bits = format.exponent_bits() +
                                   std::min(checked_fraction_bits, format.fraction_bits())};
  const int rest = unchecked_bits(check, format);
  const mpq_class low = abs(range.low), high = abs(range.high);
  check.greatest = finite_magnitude(format, std::max(low, high)) >> rest;
  if (check.sign != RequiredSign::any) {
    check.least = finite_magnitude(format, std::min(low, high)) >> rest;
  }
  return check;
}

RangeCheck sign_check(int input, RequiredSign sign) {
  return {.input = input, .sign = sign};
}

Range checked_range(const RangeCheck& check, FloatFormat format) {
  Bits least = 0, greatest = format.largest_finite(false);
  if (check.leading_bits > 0) {
    const int rest = unchecked_bits(check, format);
    least = check.least << rest;
    greatest = std::min(greatest, ((check.greatest + 1) << rest) - 1);
  }
  const mpq_class low = to_rational(format, least);
  const mpq_class high = to_rational(format, greatest);
  switch (check.sign) {
    case RequiredSign::any: return {-high, high};
    case RequiredSign::nonnegative: return {low, high};
    case RequiredSign::nonpositive: return {-high, -low};
  }
  MIXCMP_CHECK(false);
}

}  // namespace mixcmp::error
