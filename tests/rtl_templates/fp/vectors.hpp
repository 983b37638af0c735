#pragma once

#include <cstdint>
#include <vector>

#include "model/base/number/float_format.hpp"
#include "tests/rtl_templates/fp/units_under_test.hpp"

namespace mixcmp::test {

/// Zeros, subnormals and normals at their ends, ones and their neighbours, the ends of the result
/// format's range, infinities and NaNs, of both signs.
std::vector<Bits> special_values(FloatFormat operands, FloatFormat result);

/// Vector `index` of the stream `seed`: drawn by field, so that near exponents, cancellations,
/// ties, exact results, overflow and underflow are frequent. `result` sets where they lie.
Stimulus random_stimulus(FloatFormat operands, FloatFormat result, uint64_t seed, uint64_t index);

/// A random value against one of its neighbours within two ulps, of either sign.
Stimulus neighbour_stimulus(FloatFormat operands, FloatFormat result, uint64_t seed,
                            uint64_t index);

}  // namespace mixcmp::test
