#pragma once

#include <gmpxx.h>

#include <cstdint>

#include "model/base/number/float_format.hpp"
#include "model/judge/golden/big_float.hpp"
#include "model/judge/golden/encoding.hpp"

namespace mixcmp::profile {

/// Precision, in bits, of the true values that errors are measured against.
inline constexpr mpfr_prec_t error_truth_precision = 500;

/// The maximum of |computed - truth| / |truth| over the values of one function, rounded up to 64
/// bits. Values that are not finite, or not zero although the truth is zero, are only counted.
class LargestRelativeError {
public:
  explicit LargestRelativeError(FloatFormat format) : format_(format) {
    mpfr_set_zero(largest_.get(), 1);
  }

  void measure(Bits computed, const golden::BigFloat& truth) {
    golden::decode(computed_, format_, computed);
    if (mpfr_zero_p(computed_.get()) && mpfr_zero_p(truth.get())) return;
    if (!mpfr_number_p(computed_.get()) || !mpfr_regular_p(truth.get())) {
      ++unbounded_;
      return;
    }
    mpfr_sub(difference_.get(), computed_.get(), truth.get(), MPFR_RNDA);
    mpfr_div(error_.get(), difference_.get(), truth.get(), MPFR_RNDA);
    mpfr_abs(error_.get(), error_.get(), MPFR_RNDU);
    mpfr_max(largest_.get(), largest_.get(), error_.get(), MPFR_RNDU);
  }

  mpq_class value() const {
    mpq_class value;
    mpfr_get_q(value.get_mpq_t(), largest_.get());
    return value;
  }

  /// The number of values without a relative error.
  std::uint64_t unbounded() const { return unbounded_; }

private:
  static constexpr mpfr_prec_t error_precision = 64;

  FloatFormat format_;
  std::uint64_t unbounded_ = 0;
  golden::BigFloat computed_{golden::encoding_precision};
  golden::BigFloat difference_{error_truth_precision};
  golden::BigFloat error_{error_precision};
  golden::BigFloat largest_{error_precision};
};

}  // namespace mixcmp::profile
