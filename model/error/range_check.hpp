#pragma once

#include "model/expression/range.hpp"
#include "model/number/float_format.hpp"

namespace mixcmp::error {

enum class RequiredSign {
  any,
  nonnegative,  ///< sign bit 0: a negative zero fails, too
  nonpositive,  ///< sign bit 1: a positive zero fails, too
};

/// The check of one operand that a lane makes before it may decide: its sign, and the first
/// `leading_bits` of its magnitude's encoding (exponent first) against two limits, both inclusive.
/// It is coarser than the range that the scene declares, to be cheap. If magnitudes are checked and
/// `greatest` is that of a finite number, every NaN and infinity fails.
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
/// A check of the sign alone, for proofs that need no more.
RangeCheck sign_check(int input, RequiredSign sign);

/// Encloses every finite number that passes the check. Where magnitudes are not checked, these are
/// all finite numbers of the required sign.
Range checked_range(const RangeCheck& check, FloatFormat format);

}  // namespace mixcmp::error
