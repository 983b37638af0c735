#include "model/judge/golden/bound_arithmetic.hpp"

#include "model/base/common/check.hpp"
#include "model/judge/golden/arithmetic.hpp"
#include "model/judge/golden/big_float.hpp"
#include "model/judge/golden/encoding.hpp"

namespace mixcmp::golden {
namespace {

/// An MPFR number with the precision of `format`.
BigFloat number(BoundFormat format) {
  return BigFloat(format.precision);
}

BigFloat decoded(BoundFormat format, Bits bound) {
  BigFloat x = number(format);
  const int fraction_bits = format.precision - 1;
  const auto field = static_cast<int>(bound >> fraction_bits);
  if (bound == 0) {
    mpfr_set_zero(x.get(), 1);
  } else if (bound == format.infinity()) {
    mpfr_set_inf(x.get(), 1);
  } else {
    const Bits significand = (Bits{1} << fraction_bits) | (bound & low_mask(fraction_bits));
    mpfr_set_ui_2exp(x.get(), static_cast<unsigned long>(significand),
                     field - format.bias() - fraction_bits, MPFR_RNDU);
  }
  return x;
}

/// The encoding of a number that has been rounded up to the format's digits with unbounded
/// exponents.
Bits encoded(BoundFormat format, const BigFloat& x) {
  if (mpfr_zero_p(x.get()) != 0) return 0;
  if (mpfr_number_p(x.get()) == 0) return format.infinity();
  const mpfr_exp_t field = mpfr_get_exp(x.get()) - 1 + format.bias();
  if (field < 1) return format.smallest();
  if (field >= (1 << format.exponent_bits) - 1) return format.infinity();
  BigFloat scaled = x;
  mpfr_set_exp(scaled.get(), format.precision);
  const Bits significand = mpfr_get_ui(scaled.get(), MPFR_RNDU);
  return (Bits(field) << (format.precision - 1)) | (significand & low_mask(format.precision - 1));
}

BigFloat operand_value(FloatFormat operand, Bits x) {
  BigFloat value(encoding_precision);
  decode(value, operand, x);
  return value;
}

/// floor(log2 |x|), x not zero.
mpfr_exp_t exponent(const BigFloat& x) {
  return mpfr_get_exp(x.get()) - 1;
}

Bits power_of_two(BoundFormat format, mpfr_exp_t power) {
  BigFloat x = number(format);
  mpfr_set_ui_2exp(x.get(), 1, power, MPFR_RNDU);
  return encoded(format, x);
}

}  // namespace

Bits bound_constant(BoundFormat format, const mpq_class& value) {
  MIXCMP_CHECK(value >= 0);
  BigFloat x = number(format);
  mpfr_set_q(x.get(), value.get_mpq_t(), MPFR_RNDU);
  return encoded(format, x);
}

Bits bound_magnitude(BoundFormat format, FloatFormat operand, Bits x) {
  const BigFloat value = operand_value(operand, x);
  BigFloat magnitude = number(format);
  mpfr_abs(magnitude.get(), value.get(), MPFR_RNDU);
  return encoded(format, magnitude);
}

Bits bound_binade(BoundFormat format, FloatFormat operand, Bits x) {
  const BigFloat value = operand_value(operand, x);
  if (mpfr_zero_p(value.get()) != 0) return 0;
  if (mpfr_number_p(value.get()) == 0) return format.infinity();
  return power_of_two(format, exponent(value));
}

Bits bound_reciprocal(BoundFormat format, FloatFormat operand, Bits x) {
  if (operand.biased_exponent(x) == 0 ||
      operand.biased_exponent(x) == operand.max_biased_exponent()) {
    return format.infinity();
  }
  return power_of_two(format, -exponent(operand_value(operand, x)));
}

Bits bound_add(BoundFormat format, Bits a, Bits b) {
  BigFloat sum = number(format);
  mpfr_add(sum.get(), decoded(format, a).get(), decoded(format, b).get(), MPFR_RNDU);
  return encoded(format, sum);
}

Bits bound_multiply(BoundFormat format, Bits a, Bits b) {
  BigFloat product = number(format);
  mpfr_mul(product.get(), decoded(format, a).get(), decoded(format, b).get(), MPFR_RNDU);
  return encoded(format, product);
}

bool bound_is_at_most(BoundFormat format, Bits bound, FloatFormat operand, Bits x) {
  return mpfr_cmpabs(decoded(format, bound).get(), operand_value(operand, x).get()) <= 0;
}

}  // namespace mixcmp::golden
