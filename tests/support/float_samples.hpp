#pragma once

#include <random>
#include <vector>

#include "model/base/number/float_format.hpp"

namespace mixcmp::test {

/// A format that is known to be valid.
FloatFormat format_of(int precision, int exponent_bits);

/// Zeros, subnormal and normal extremes, one and its neighbours, infinities and NaNs, both signs.
std::vector<Bits> special_encodings(FloatFormat format);

/// Random by field: exponents uniform, now and then close to `near` or at the ends of the range;
/// fractions uniform, or with long runs of zeros or ones.
Bits random_encoding(FloatFormat format, std::mt19937_64& random);
Bits random_encoding_near(FloatFormat format, Bits near, std::mt19937_64& random);

/// All four of a format: nearest and toward zero, gradual and flush.
std::vector<Arithmetic> every_arithmetic(FloatFormat format);

}  // namespace mixcmp::test
