#include "tests/support/float_samples.hpp"

#include <algorithm>

namespace mixcmp::test {

FloatFormat format_of(int precision, int exponent_bits) {
  return FloatFormat::make(precision, exponent_bits).value();
}

std::vector<Bits> special_encodings(FloatFormat format) {
  const Bits one = format.pack(false, format.bias(), 0);
  const std::vector<Bits> magnitudes = {0,
                                        1,
                                        2,
                                        format.smallest_normal(false) - 1,
                                        format.smallest_normal(false),
                                        format.smallest_normal(false) + 1,
                                        one - 1,
                                        one,
                                        one + 1,
                                        format.largest_finite(false) - 1,
                                        format.largest_finite(false),
                                        format.infinity(false),
                                        format.infinity(false) + 1,
                                        format.quiet_nan()};
  std::vector<Bits> both = magnitudes;
  for (const Bits magnitude : magnitudes) both.push_back(magnitude | format.zero(true));
  return both;
}

namespace {

Bits random_bits(std::mt19937_64& random) {
  return Bits{random()} << 64 | random();
}

Bits random_fraction(FloatFormat format, std::mt19937_64& random) {
  const Bits mask = low_mask(format.fraction_bits());
  const auto shift = static_cast<int>(random() % static_cast<unsigned>(format.fraction_bits()));
  switch (random() % 4) {
    case 0: return (random_bits(random) << shift) & mask;
    case 1: return ~(random_bits(random) << shift) & mask;
    default: return random_bits(random) & mask;
  }
}

int random_exponent(FloatFormat format, std::mt19937_64& random) {
  const int highest = format.max_biased_exponent();
  const auto offset = static_cast<int>(random() % 3);
  switch (random() % 8) {
    case 0: return std::min(offset, highest);
    case 1: return std::max(highest - offset, 0);
    default: return static_cast<int>(random() % static_cast<unsigned>(highest + 1));
  }
}

}  // namespace

Bits random_encoding(FloatFormat format, std::mt19937_64& random) {
  return format.pack(random() % 2 != 0, random_exponent(format, random),
                     random_fraction(format, random));
}

Bits random_encoding_near(FloatFormat format, Bits near, std::mt19937_64& random) {
  if (random() % 16 == 0) return near ^ (random() % 2 != 0 ? format.zero(true) : 0);
  if (random() % 4 == 0) return random_encoding(format, random);
  const int reach = format.precision() + 2;
  const int step = static_cast<int>(random() % static_cast<unsigned>(2 * reach + 1)) - reach;
  const int exponent =
      std::clamp(format.biased_exponent(near) + step, 0, format.max_biased_exponent());
  return format.pack(random() % 2 != 0, exponent, random_fraction(format, random));
}

std::vector<Arithmetic> every_arithmetic(FloatFormat format) {
  return {{format, Rounding::nearest_even, Subnormals::gradual},
          {format, Rounding::nearest_even, Subnormals::flush},
          {format, Rounding::toward_zero, Subnormals::gradual},
          {format, Rounding::toward_zero, Subnormals::flush}};
}

}  // namespace mixcmp::test
