#pragma once

#include "model/base/number/float_format.hpp"
#include "model/comparison/expression/range.hpp"

namespace mixcmp::error {

enum class RequiredSign {
  any,
  nonnegative,  ///< sign bit 0: a negative zero fails
  nonpositive,  ///< sign bit 1: a positive zero fails
};

/// The check of one operand that a lane makes before it may decide. It compares the sign, and the
/// first `leading_bits` of the magnitude's encoding (exponent first) with two limits, both
/// inclusive. To be cheap, it is coarser than the range that the scene declares. If magnitudes are
/// checked and `greatest` belongs to a finite number, every NaN and infinity fails.
struct RangeCheck {
  int input = -1;
  RequiredSign sign = RequiredSign::any;
  int leading_bits = 0;  ///< 0: magnitudes are not checked
  Bits least = 0;
  Bits greatest = 0;

  friend bool operator==(const RangeCheck&, const RangeCheck&) = default;
};

/// A cheap check that every number of the range passes. It looks at the sign, the exponent and the
/// first three fraction bits.
RangeCheck range_check(int input, FloatFormat format, const Range& range);
/// A check of only the sign, for proofs that need no more.
RangeCheck sign_check(int input, RequiredSign sign);

/// Encloses every finite number that passes the check. If magnitudes are not checked, these are all
/// finite numbers of the required sign.
Range checked_range(const RangeCheck& check, FloatFormat format);

}  // namespace mixcmp::error
