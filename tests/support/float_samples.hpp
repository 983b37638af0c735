#pragma once

#include <random>
#include <vector>

#include "model/number/float_format.hpp"

namespace mixcmp::test {

/// A format that is known to be valid.
model::FloatFormat format_of(int precision, int exponent_bits);

/// Zeros, subnormal and normal extremes, one and its neighbours, infinities and NaNs, both signs.
std::vector<model::Bits> special_encodings(model::FloatFormat format);

/// Random by field: exponents uniform, now and then close to `near` or at the ends of the range;
/// fractions uniform, or with long runs of zeros or ones.
model::Bits random_encoding(model::FloatFormat format, std::mt19937_64& random);
model::Bits random_encoding_near(model::FloatFormat format, model::Bits near,
                                 std::mt19937_64& random);

/// All four of a format: nearest and toward zero, gradual and flush.
std::vector<model::Arithmetic> every_arithmetic(model::FloatFormat format);

}  // namespace mixcmp::test
