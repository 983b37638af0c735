#pragma once

#include <cstdint>
#include <vector>

#include "model/base/number/float_format.hpp"
#include "tests/rtl_templates/fp/units_under_test.hpp"

namespace mixcmp::test {

/// Zeros, the ends of the subnormal and of the normal numbers, ones and their neighbours, the ends
/// of the result format's range, infinities and NaNs, all with both signs.
std::vector<Bits> special_values(FloatFormat operands, FloatFormat result);

/// Vector `index` of the stream `seed`. It is drawn by field, so that near exponents,
/// cancellations, ties, exact results, overflow and underflow are frequent. They depend on
/// `result`.
Stimulus random_stimulus(FloatFormat operands, FloatFormat result, uint64_t seed, uint64_t index);

/// A random value and one of its neighbours within two ulps, with either sign.
Stimulus neighbour_stimulus(FloatFormat operands, FloatFormat result, uint64_t seed,
                            uint64_t index);

}  // namespace mixcmp::test
