#include "model/emulator/operand.hpp"

#include <cmath>
#include <limits>

#include "model/common/check.hpp"
#include "model/golden/big_float.hpp"
#include "model/golden/encoding.hpp"

namespace mixcmp::model::emulator {

Bits encode(FloatFormat format, double value) {
  const bool negative = std::signbit(value);
  if (std::isnan(value)) return format.quiet_nan();
  if (std::isinf(value)) return format.infinity(negative);
  if (value == 0) return format.zero(negative);
  golden::BigFloat x(format.precision());
  const int ternary = mpfr_set_d(x.get(), value, MPFR_RNDN);
  const mpfr_exp_t exponent = mpfr_get_exp(x.get()) - 1;
  MIXCMP_CHECK(ternary == 0 && exponent <= format.max_exponent());
  const Bits bits = golden::encode(format, x);
  // Digits below the format's smallest subnormal number would have been cut off.
  MIXCMP_CHECK(decode(format, bits) == value);
  return bits;
}

double decode(FloatFormat format, Bits bits) {
  if (format.is_nan(bits)) return std::numeric_limits<double>::quiet_NaN();
  golden::BigFloat x(golden::encoding_precision);
  golden::decode(x, format, bits);
  return mpfr_get_d(x.get(), MPFR_RNDN);
}

}  // namespace mixcmp::model::emulator
