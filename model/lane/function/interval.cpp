#include "model/lane/function/interval.hpp"

#include <utility>
#include <vector>

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

mpfi_ptr made() {
  const mpfi_ptr value = new __mpfi_struct;
  mpfi_init2(value, Interval::digits);
  return value;
}

void clear(mpfi_ptr value) {
  mpfi_clear(value);
  delete value;
}

/// Intervals that wait for another use: series make and drop many, and memory takes longer than
/// their arithmetic.
class Pool {
public:
  ~Pool();
  mpfi_ptr take() {
    if (free_.empty()) return made();
    const mpfi_ptr last = free_.back();
    free_.pop_back();
    return last;
  }
  void give_back(mpfi_ptr value) { free_.push_back(value); }

private:
  std::vector<mpfi_ptr> free_;
};

/// Intervals of static lifetime end after their thread's pool.
thread_local bool has_pool = true;
thread_local Pool pool;

Pool::~Pool() {
  has_pool = false;
  for (const mpfi_ptr each : free_) clear(each);
}

}  // namespace

Interval::Interval() : value_(has_pool ? pool.take() : made()) {}

Interval::~Interval() {
  if (value_ == nullptr) return;
  if (has_pool) {
    pool.give_back(value_);
  } else {
    clear(value_);
  }
}

Interval& Interval::operator=(Interval&& other) noexcept {
  std::swap(value_, other.value_);
  return *this;
}

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

}  // namespace mixcmp::function
