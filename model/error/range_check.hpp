#pragma once

#include "model/expression/range.hpp"
#include "model/number/float_format.hpp"

namespace mixcmp::model {

enum class RequiredSign {
  any,
  nonnegative,  ///< sign bit 0: a negative zero fails, too
  nonpositive,  ///< sign bit 1: a positive zero fails, too
};

/// What a lane checks of one operand before it may decide: its sign, and `leading_bits` of its
/// magnitude's encoding (exponent first) against limits, both inclusive. Cheap, hence coarser than
/// the range that the scene declares. Fails for every NaN and infinity if the greatest is finite.
struct RangeCheck {
  int input = -1;
  RequiredSign sign = RequiredSign::any;
  int leading_bits = 0;  ///< 0: magnitudes are not checked
  Bits least = 0;
  Bits greatest = 0;

  friend bool operator==(const RangeCheck&, const RangeCheck&) = default;
};

/// The cheapest check that every number of the range passes: the exponent and three fraction bits.
RangeCheck range_check(int input, FloatFormat format, const Range& range);
/// The sign alone, for proofs that ask no more.
RangeCheck sign_check(int input, RequiredSign sign);

/// Encloses every number that passes the check; finite numbers of the format where magnitudes are
/// not checked.
Range checked_range(const RangeCheck& check, FloatFormat format);

}  // namespace mixcmp::model
