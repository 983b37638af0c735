#include "model/judge/golden/big_float.hpp"

#include "model/base/common/check.hpp"

namespace mixcmp::golden {

BigFloat::BigFloat(const BigFloat& other) : BigFloat(other.precision()) {
  mpfr_set(value_, other.value_, MPFR_RNDN);  // exact: the precisions agree
}

ExponentRange::ExponentRange(mpfr_exp_t low, mpfr_exp_t high)
    : outer_low_(mpfr_get_emin()), outer_high_(mpfr_get_emax()) {
  MIXCMP_CHECK(mpfr_set_emin(low) == 0 && mpfr_set_emax(high) == 0);
}

ExponentRange::~ExponentRange() {
  mpfr_set_emin(outer_low_);
  mpfr_set_emax(outer_high_);
}

}  // namespace mixcmp::golden
