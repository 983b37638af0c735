#pragma once

#include <mpfr.h>

#include <utility>

namespace mixcmp::golden {

/// One mpfr_t. The precision is given at construction; every operation goes through get() and names
/// its rounding.
class BigFloat {
public:
  explicit BigFloat(mpfr_prec_t precision) { mpfr_init2(value_, precision); }
  BigFloat(const BigFloat& other);
  BigFloat(BigFloat&& other) noexcept : BigFloat(MPFR_PREC_MIN) { swap(other); }
  BigFloat& operator=(BigFloat other) noexcept {
    swap(other);
    return *this;
  }
  ~BigFloat() { mpfr_clear(value_); }

  mpfr_ptr get() { return value_; }
  mpfr_srcptr get() const { return value_; }
  mpfr_prec_t precision() const { return mpfr_get_prec(value_); }

  /// Forgets the value (it becomes NaN). Allocates only when the precision exceeds every earlier
  /// one.
  void reset(mpfr_prec_t precision) { mpfr_set_prec(value_, precision); }
  void swap(BigFloat& other) noexcept { mpfr_swap(value_, other.value_); }

private:
  mpfr_t value_;
};

/// Narrows MPFR's exponent range, which is a variable of the thread, for one scope.
class ExponentRange {
public:
  ExponentRange(mpfr_exp_t low, mpfr_exp_t high);
  ~ExponentRange();
  ExponentRange(const ExponentRange&) = delete;
  ExponentRange& operator=(const ExponentRange&) = delete;

private:
  mpfr_exp_t outer_low_;
  mpfr_exp_t outer_high_;
};

}  // namespace mixcmp::golden
