#include "model/base/number/exact.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

#include "model/base/common/check.hpp"
#include "model/base/number/dyadic.hpp"

namespace mixcmp::inline number {
namespace {

/// The result of an integer division, with the remainder's part that rounding to nearest needs.
struct Division {
  mpz_class quotient;
  int half;  ///< sign of remainder / divisor - 1/2: below, at or above the midpoint
};

/// (numerator / denominator) / 2^shift for non-negative operands.
Division divide(mpz_class numerator, mpz_class denominator, long shift) {
  mpz_class& longer = shift > 0 ? denominator : numerator;
  longer = shifted_left(longer, std::abs(shift));
  Division result;
  mpz_class remainder;
  mpz_fdiv_qr(result.quotient.get_mpz_t(), remainder.get_mpz_t(), numerator.get_mpz_t(),
              denominator.get_mpz_t());
  remainder <<= 1;
  result.half = cmp(remainder, denominator);
  return result;
}

/// The exponent of the number's last place: in its own binade, or that of subnormal numbers.
long last_place(FloatFormat format, long floor_log2) {
  return std::max<long>(floor_log2, format.min_exponent()) - format.fraction_bits();
}

/// The encoding of quotient * 2^place, where place = last_place of the value before rounding. If
/// rounding carried the quotient to the next power of two, it carries into the exponent field;
/// beyond the largest number that gives infinity, or the NaN of a format without infinities.
Bits assemble(FloatFormat format, long place, const mpz_class& quotient) {
  const long binade = place + format.fraction_bits() - format.min_exponent();
  const Bits magnitude = (Bits(binade) << format.fraction_bits()) + to_bits(quotient);
  return std::min(magnitude, format.beyond_largest(false));
}

}  // namespace

Bits with_sign(FloatFormat format, bool negative, Bits magnitude) {
  return format.is_nan(magnitude) ? magnitude : magnitude | format.zero(negative);
}

Bits to_bits(const mpz_class& value) {
  static_assert(std::numeric_limits<mp_limb_t>::digits == 64);
  MIXCMP_CHECK(mpz_size(value.get_mpz_t()) <= 2);
  return Bits{mpz_getlimbn(value.get_mpz_t(), 1)} << 64 | mpz_getlimbn(value.get_mpz_t(), 0);
}

mpz_class to_integer(Bits bits) {
  const mpz_class high = static_cast<std::uint64_t>(bits >> 64);
  return (high << 64) + static_cast<std::uint64_t>(bits);
}

mpq_class to_rational(FloatFormat format, Bits bits) {
  MIXCMP_CHECK(format.is_finite(bits));
  const int field = format.biased_exponent(bits);
  const Bits leading = field == 0 ? 0 : Bits{1} << format.fraction_bits();
  const mpq_class magnitude = scaled(to_integer(leading | format.fraction(bits)),
                                     std::max(field, 1) - format.bias() - format.fraction_bits());
  return format.sign(bits) ? mpq_class(-magnitude) : magnitude;
}

Bits converted(FloatFormat to, FloatFormat from, Bits bits) {
  const bool negative = from.sign(bits);
  if (from.is_nan(bits)) return to.quiet_nan();
  if (from.is_infinite(bits)) return to.beyond_largest(negative);
  if (from.is_zero(bits)) return to.zero(negative);
  return from_rational(to, to_rational(from, bits));
}

Bits from_ratio(FloatFormat format, const mpz_class& numerator, const mpz_class& denominator) {
  if (numerator == 0) return format.zero(false);
  const bool negative = numerator < 0;
  const mpz_class magnitude = abs(numerator);
  const long exponent = floor_log2(magnitude, denominator);
  if (exponent > format.max_exponent()) return format.beyond_largest(negative);
  const long place = last_place(format, exponent);
  Division division = divide(magnitude, denominator, place);
  const bool odd = mpz_odd_p(division.quotient.get_mpz_t()) != 0;
  if (division.half > 0 || (division.half == 0 && odd)) ++division.quotient;
  return with_sign(format, negative, assemble(format, place, division.quotient));
}

Bits from_rational(FloatFormat format, const mpq_class& value) {
  return from_ratio(format, value.get_num(), value.get_den());
}

Bits from_rational_up(FloatFormat format, const mpq_class& value) {
  MIXCMP_CHECK(value >= 0);
  if (value == 0) return format.zero(false);
  const long exponent = floor_log2(value);
  if (exponent > format.max_exponent()) return format.beyond_largest(false);
  const long place = last_place(format, exponent);
  return assemble(format, place, ceiling_of(scaled(value, -place)));
}

}  // namespace mixcmp::inline number
