#include "model/base/number/double.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "model/base/common/check.hpp"
#include "model/base/number/exact.hpp"

namespace mixcmp::inline number {
namespace {

FloatFormat binary64() {
  static const FloatFormat format = FloatFormat::make(53, 11).value();
  return format;
}

/// The value of a finite encoding whose digits double can hold.
double exact_double(FloatFormat format, Bits bits) {
  const int field = format.biased_exponent(bits);
  const Bits leading = field == 0 ? 0 : Bits{1} << format.fraction_bits();
  const auto significand = static_cast<std::uint64_t>(leading | format.fraction(bits));
  const int exponent = std::max(field, 1) - format.bias() - format.fraction_bits();
  const double magnitude = std::ldexp(static_cast<double>(significand), exponent);
  return format.sign(bits) ? -magnitude : magnitude;
}

}  // namespace

Bits from_double(FloatFormat format, double value) {
  const bool negative = std::signbit(value);
  if (std::isnan(value)) return format.quiet_nan();
  if (std::isinf(value)) return format.infinity(negative);
  const Bits bits = from_rational(format, mpq_class(value)) | format.zero(negative);
  MIXCMP_CHECK(to_double(format, bits) == value);
  return bits;
}

double to_double(FloatFormat format, Bits bits) {
  const double sign = format.sign(bits) ? -1.0 : 1.0;
  if (format.is_nan(bits)) return std::numeric_limits<double>::quiet_NaN();
  if (format.is_infinite(bits)) return sign * std::numeric_limits<double>::infinity();
  if (fits_double(format)) return exact_double(format, bits);
  return std::copysign(nearest_double(to_rational(format, bits)), sign);
}

double nearest_double(const mpq_class& value) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(from_rational(binary64(), value)));
}

}  // namespace mixcmp::inline number
