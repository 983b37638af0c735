#include "model/base/number/bound_format.hpp"

#include <gtest/gtest.h>

#include <random>

#include "model/base/number/dyadic.hpp"
#include "model/judge/golden/bound_arithmetic.hpp"

namespace mixcmp::test::bound_format_test {
namespace {

TEST(EncodeBound, IsTheLeastBoundNotBelow) {
  const BoundFormat format = {.precision = 3, .exponent_bits = 4};  // bias 7
  EXPECT_EQ(encode_bound(format, 0), 0u);
  EXPECT_EQ(encode_bound(format, 1), 7u << 2);
  EXPECT_EQ(encode_bound(format, mpq_class(5, 4)), (7u << 2) + 1);
  EXPECT_EQ(encode_bound(format, mpq_class(10001, 8000)), (7u << 2) + 2);
  EXPECT_EQ(encode_bound(format, mpq_class(71, 40)), 8u << 2) << "1.775 is above 1.75: 2";
  EXPECT_EQ(encode_bound(format, power_of_two(-6)), format.smallest());
  EXPECT_EQ(encode_bound(format, power_of_two(-1000) / 3), format.smallest());
  EXPECT_EQ(encode_bound(format, 224), format.infinity() - 1) << "the largest: 1.75 * 2^7";
  EXPECT_EQ(encode_bound(format, mpq_class(2241, 10)), format.infinity());
  EXPECT_EQ(encode_bound(format, power_of_two(1000)), format.infinity());
}

TEST(EncodeBound, IsTheGoldenModels) {
  std::mt19937_64 random(1);
  for (const BoundFormat format : {BoundFormat{1, 8}, BoundFormat{4, 8}, BoundFormat{8, 5},
                                   BoundFormat{24, 8}, BoundFormat{52, 11}}) {
    for (int k = 0; k < 20'000; ++k) {
      mpq_class value(static_cast<unsigned long>(random() >> random() % 64),
                      static_cast<unsigned long>(random() >> random() % 63) | 1);
      value.canonicalize();
      value *= power_of_two(static_cast<long>(random() % 400) - 200);
      EXPECT_EQ(encode_bound(format, value), golden::bound_constant(format, value))
          << value << " in " << format.precision << " digits";
    }
  }
}

/// Bounds of one digit more than a 64-bit word holds.
TEST(EncodeBound, HasAsManyDigitsAsALane) {
  const BoundFormat format = {.precision = 65, .exponent_bits = 8};
  const Bits one = Bits{127} << 64;
  EXPECT_EQ(encode_bound(format, 1 + power_of_two(-64)), one + 1);
  EXPECT_EQ(encode_bound(format, 2 - power_of_two(-64)), one + low_mask(64));
}

TEST(BoundValue, IsWhatEncodesToTheSameBound) {
  for (const BoundFormat format : {BoundFormat{1, 4}, BoundFormat{3, 4}, BoundFormat{5, 3}}) {
    mpq_class before = -1;
    for (Bits bound = 0; bound < format.infinity(); ++bound) {
      if (bound != 0 && bound < format.smallest()) continue;
      const mpq_class value = bound_value(format, bound);
      EXPECT_GT(value, before);
      EXPECT_EQ(encode_bound(format, value), bound);
      before = value;
    }
  }
}

}  // namespace
}  // namespace mixcmp::test::bound_format_test
