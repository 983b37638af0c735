#include "model/base/number/bound_format.hpp"

#include "model/base/common/check.hpp"
#include "model/base/number/dyadic.hpp"
#include "model/base/number/exact.hpp"

namespace mixcmp::inline number {

Bits encode_bound(BoundFormat format, const mpq_class& value) {
  MIXCMP_CHECK(value >= 0);
  if (value == 0) return 0;
  const long exponent = floor_log2(value);
  const long field = exponent + format.bias();
  if (field < 1) return format.smallest();
  if (field >= (1L << format.exponent_bits) - 1) return format.infinity();
  // 2^(P-1)..2^P. The last of these carries into the exponent field: it gives the next power of
  // two or, after the largest number, infinity.
  const mpz_class significand = ceiling_of(scaled(value, format.precision - 1 - exponent));
  return (Bits(field - 1) << (format.precision - 1)) + to_bits(significand);
}

mpq_class bound_value(BoundFormat format, Bits bound) {
  MIXCMP_CHECK(bound < format.infinity());
  if (bound == 0) return 0;
  const int fraction_bits = format.precision - 1;
  const auto field = static_cast<int>(bound >> fraction_bits);
  const Bits significand = Bits{1} << fraction_bits | (bound & low_mask(fraction_bits));
  return scaled(to_integer(significand), field - format.bias() - fraction_bits);
}

}  // namespace mixcmp::inline number
