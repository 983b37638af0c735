#include "tests/support/function_values.hpp"

#include <mpfr.h>

#include <algorithm>

#include "model/base/common/check.hpp"
#include "model/base/number/dyadic.hpp"
#include "model/judge/golden/big_float.hpp"

namespace mixcmp::test {
namespace {

using golden::BigFloat;

int apply(Function function, mpfr_ptr y, mpfr_srcptr x, mpfr_rnd_t rounding) {
  switch (function) {
    case Function::exp: return mpfr_exp(y, x, rounding);
    case Function::exp2: return mpfr_exp2(y, x, rounding);
    case Function::expm1: return mpfr_expm1(y, x, rounding);
    case Function::log: return mpfr_log(y, x, rounding);
    case Function::log2: return mpfr_log2(y, x, rounding);
    case Function::log1p: return mpfr_log1p(y, x, rounding);
    case Function::sin: return mpfr_sin(y, x, rounding);
    case Function::cos: return mpfr_cos(y, x, rounding);
    case Function::tan: return mpfr_tan(y, x, rounding);
    case Function::atan: return mpfr_atan(y, x, rounding);
    case Function::sinh: return mpfr_sinh(y, x, rounding);
    case Function::cosh: return mpfr_cosh(y, x, rounding);
    case Function::tanh: return mpfr_tanh(y, x, rounding);
  }
  MIXCMP_CHECK(false);
}

mpq_class rational(const BigFloat& number) {
  MIXCMP_CHECK(mpfr_number_p(number.get()) != 0);
  mpq_class value;
  mpfr_get_q(value.get_mpq_t(), number.get());
  return value;
}

}  // namespace

Range value_at(Function function, const mpq_class& x, int digits) {
  BigFloat argument(std::max<mpfr_prec_t>(2, digits_of(x.get_num()))), value(digits);
  MIXCMP_CHECK(mpfr_set_q(argument.get(), x.get_mpq_t(), MPFR_RNDN) == 0);
  Range range;
  apply(function, value.get(), argument.get(), MPFR_RNDD);
  range.low = rational(value);
  apply(function, value.get(), argument.get(), MPFR_RNDU);
  range.high = rational(value);
  return range;
}

Range value_near(Function function, const Range& x) {
  if (x.low == x.high) return value_at(function, x.low);
  MIXCMP_CHECK(x.high - x.low < power_of_two(-250));
  const mpq_class most_change = power_of_two(-210);
  Range near = value_at(function, x.low);
  near.low -= most_change;
  near.high += most_change;
  return near;
}

}  // namespace mixcmp::test
