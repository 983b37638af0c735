#pragma once

#include <gmpxx.h>

#include "model/base/number/float_format.hpp"

/// Exact conversions between encodings and numbers, in GMP integers. The golden model has its own,
/// in MPFR, so that each can judge the other.
namespace mixcmp::inline number {

/// The value of a finite encoding.
mpq_class to_rational(FloatFormat format, Bits bits);

/// The encoding nearest to `value`, with ties to even and gradual subnormals. The largest number's
/// successor, were there one, counts as beyond_largest: values nearer to it become beyond_largest,
/// and so does the midpoint, unless the largest number's last bit is 0. Zero becomes +0.
Bits from_rational(FloatFormat format, const mpq_class& value);

/// The encoding in `to` nearest to a number in `from`. The signs of zeros stay, and infinities if
/// `to` has some; otherwise they become the NaN. Every NaN becomes the quiet NaN.
Bits converted(FloatFormat to, FloatFormat from, Bits bits);

/// The encoding nearest to numerator / denominator, for denominator > 0 and any common factors.
Bits from_ratio(FloatFormat format, const mpz_class& numerator, const mpz_class& denominator);

/// The encoding of the smallest number of the format that is at least `value` >= 0, subnormals
/// included; beyond_largest above the largest.
Bits from_rational_up(FloatFormat format, const mpq_class& value);

/// A magnitude with a sign; a NaN stays as it is.
Bits with_sign(FloatFormat format, bool negative, Bits magnitude);

/// The low 128 bits of a non-negative integer.
Bits to_bits(const mpz_class& value);
mpz_class to_integer(Bits bits);

}  // namespace mixcmp::inline number
