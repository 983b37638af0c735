#pragma once

#include <gmpxx.h>

#include "model/base/common/bits.hpp"

namespace mixcmp::inline number {

/// The format of upper bounds in hardware: non-negative numbers of `precision` digits. With one
/// digit they are powers of two. They are packed without a sign: biased exponent, then precision -
/// 1 fraction bits. Exponent field 0 with fraction 0 is zero. An exponent field of all ones with
/// fraction 0 is infinity, which bounds nothing. There are no subnormals. The bias is that of a
/// FloatFormat with the same exponent bits, so a bound followed by zeros compares as an integer
/// with a magnitude of that format.
struct BoundFormat {
  int precision;      ///< 1..52, at most the lane's
  int exponent_bits;  ///< the lane's

  int width() const { return exponent_bits + precision - 1; }
  int bias() const { return (1 << (exponent_bits - 1)) - 1; }
  Bits infinity() const { return low_mask(exponent_bits) << (precision - 1); }
  Bits smallest() const { return Bits{1} << (precision - 1); }

  friend bool operator==(const BoundFormat&, const BoundFormat&) = default;
};

/// The encoding of the smallest bound that is at least `value` >= 0: the smallest number for a
/// positive value below it, infinity above the largest.
Bits encode_bound(BoundFormat format, const mpq_class& value);

/// The exact value of a finite bound.
mpq_class bound_value(BoundFormat format, Bits bound);

}  // namespace mixcmp::inline number
