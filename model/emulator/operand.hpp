#pragma once

#include "model/format/float_format.hpp"

namespace mixcmp::model::emulator {

/// Whether double holds every number of the format: at most 53 digits and 11 exponent bits.
constexpr bool fits_double(FloatFormat format) {
  return format.precision() <= 53 && format.exponent_bits() <= 11;
}

/// The encoding of a double that is a number of the format (a broken invariant if it is not). Every
/// NaN becomes the format's quiet NaN.
Bits encode(FloatFormat format, double value);

/// The double nearest to an encoding: its very value if fits_double(format). Every NaN becomes a
/// quiet NaN.
double decode(FloatFormat format, Bits bits);

}  // namespace mixcmp::model::emulator
