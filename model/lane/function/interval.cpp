#include "model/lane/function/interval.hpp"

#include "model/base/common/check.hpp"
#include "model/base/number/dyadic.hpp"

namespace mixcmp::function {
namespace {

mpq_class to_rational(mpfr_srcptr number) {
  MIXCMP_CHECK(mpfr_number_p(number) != 0);
  if (mpfr_zero_p(number) != 0) return 0;
  mpz_class significand;
  const mpfr_exp_t exponent = mpfr_get_z_2exp(significand.get_mpz_t(), number);
  return scaled(mpq_class(significand), exponent);
}

/// Whether a number's magnitude is below 2^exponent.
bool is_below(mpfr_srcptr number, mpfr_exp_t exponent) {
  return mpfr_zero_p(number) != 0 || (mpfr_regular_p(number) && mpfr_get_exp(number) <= exponent);
}

}  // namespace

Interval::Interval(const Range& range) : Interval() {
  mpfi_interv_q(value_, range.low.get_mpq_t(), range.high.get_mpq_t());
}

Interval Interval::unbounded() {
  Interval all;
  mpfi_set_str(all.get(), "[-inf, inf]", 10);
  return all;
}

Interval& Interval::operator=(const Interval& other) {
  mpfi_set(value_, other.value_);
  return *this;
}

bool is_bounded(mpfi_srcptr interval) {
  return is_below(&interval->left, Interval::most_exponent) &&
         is_below(&interval->right, Interval::most_exponent);
}

/// A rational number of 2^30 digits would fill memory: MPFR has exponents of that size.
mpq_class rational(mpfr_srcptr number, int outward) {
  if (!is_below(number, -Interval::most_exponent)) return to_rational(number);
  return mpfr_sgn(number) == outward ? outward * power_of_two(-Interval::most_exponent)
                                     : mpq_class(0);
}

Range range_of(mpfi_srcptr interval) {
  return {rational(&interval->left, -1), rational(&interval->right, 1)};
}

bool Interval::is_bounded() const {
  return function::is_bounded(value_);
}

Range Interval::range() const {
  return range_of(value_);
}

Interval Interval::magnitude() const {
  Interval largest;
  mpfi_mag(&largest.value_->right, value_);
  mpfr_set(&largest.value_->left, &largest.value_->right, MPFR_RNDN);
  return largest;
}

mpf_class Interval::middle() const {
  mpfr_t middle;
  mpfr_init2(middle, digits);
  mpfi_mid(middle, value_);
  mpf_class found(0, digits);
  if (!is_below(middle, -most_exponent)) mpfr_get_f(found.get_mpf_t(), middle, MPFR_RNDN);
  mpfr_clear(middle);
  return found;
}

Interval operator+(const Interval& a, const Interval& b) {
  Interval sum;
  mpfi_add(sum.value_, a.value_, b.value_);
  return sum;
}

Interval operator-(const Interval& a, const Interval& b) {
  Interval difference;
  mpfi_sub(difference.value_, a.value_, b.value_);
  return difference;
}

Interval operator*(const Interval& a, const Interval& b) {
  Interval product;
  mpfi_mul(product.value_, a.value_, b.value_);
  return product;
}

Interval operator/(const Interval& a, const Interval& b) {
  Interval quotient;
  mpfi_div(quotient.value_, a.value_, b.value_);
  return quotient;
}

Interval product_coefficient(const std::vector<Interval>& a, const std::vector<Interval>& b,
                             std::size_t k, std::size_t skipped) {
  Interval sum = 0, term;
  for (std::size_t i = skipped; i <= k; ++i) {
    if (mpfi_is_zero(a[i].get()) > 0 || mpfi_is_zero(b[k - i].get()) > 0) continue;
    mpfi_mul(term.get(), a[i].get(), b[k - i].get());
    mpfi_add(sum.get(), sum.get(), term.get());
  }
  return sum;
}

}  // namespace mixcmp::function
