#include "model/judge/golden/encoding.hpp"

#include <gmpxx.h>

#include <cstdint>
#include <limits>

namespace mixcmp::golden {
namespace {

/// Sets x to integer * 2^exponent, exactly.
void set_integer(BigFloat& x, Bits integer, int exponent) {
  const auto high = static_cast<std::uint64_t>(integer >> 64);
  const auto low = static_cast<std::uint64_t>(integer);
  mpfr_set_ui_2exp(x.get(), high, 64, MPFR_RNDN);
  mpfr_add_ui(x.get(), x.get(), low, MPFR_RNDN);
  mpfr_mul_2si(x.get(), x.get(), exponent, MPFR_RNDN);
}

Bits to_bits(const mpz_class& value) {
  static_assert(std::numeric_limits<mp_limb_t>::digits == 64);
  return Bits{mpz_getlimbn(value.get_mpz_t(), 1)} << 64 | mpz_getlimbn(value.get_mpz_t(), 0);
}

}  // namespace

void decode(BigFloat& x, FloatFormat format, Bits bits) {
  const int biased_exponent = format.biased_exponent(bits);
  const Bits fraction = format.fraction(bits);
  if (format.is_nan(bits)) return mpfr_set_nan(x.get());
  if (format.is_infinite(bits)) {
    mpfr_set_inf(x.get(), 1);
  } else if (biased_exponent == 0) {
    set_integer(x, fraction, format.min_exponent() - format.fraction_bits());
  } else {
    const Bits significand = fraction | (Bits{1} << format.fraction_bits());
    set_integer(x, significand, biased_exponent - format.bias() - format.fraction_bits());
  }
  mpfr_setsign(x.get(), x.get(), format.sign(bits), MPFR_RNDN);
}

Bits encode(FloatFormat format, const BigFloat& x) {
  const bool negative = mpfr_signbit(x.get()) != 0;
  if (mpfr_zero_p(x.get())) return format.zero(negative);
  thread_local mpz_class significand;  // allocated once: this is called for every result
  const mpfr_exp_t scale = mpfr_get_z_2exp(significand.get_mpz_t(), x.get());
  mpz_abs(significand.get_mpz_t(), significand.get_mpz_t());
  const Bits magnitude = to_bits(significand);
  const int exponent = static_cast<int>(scale) + format.fraction_bits();
  const int below = format.min_exponent() - exponent;
  if (below > 0) return format.pack(negative, 0, magnitude >> below);
  return format.pack(negative, exponent + format.bias(), format.fraction(magnitude));
}

}  // namespace mixcmp::golden
