#pragma once

#include <gmpxx.h>

#include "model/base/number/float_format.hpp"

/// Conversions to and from the processor's double, which is binary64.
namespace mixcmp::inline number {

constexpr int double_digits = 53, double_exponent_bits = 11;

/// Whether double holds every number of the format: at most 53 digits and 11 exponent bits.
constexpr bool fits_double(FloatFormat format) {
  return format.precision() <= double_digits && format.exponent_bits() <= double_exponent_bits;
}

/// The encoding of a double that is a number of the format (a broken invariant if it is not). Every
/// NaN becomes the format's quiet NaN.
Bits from_double(FloatFormat format, double value);

/// The double nearest to an encoding: its exact value if fits_double(format). Every NaN becomes a
/// quiet NaN.
double to_double(FloatFormat format, Bits bits);

/// The double nearest to a number, infinite beyond the largest.
double nearest_double(const mpq_class& value);

}  // namespace mixcmp::inline number
