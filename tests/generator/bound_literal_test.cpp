#include "generator/rtl/bound_literal.hpp"

#include <gtest/gtest.h>

#include <random>

#include "model/golden/bound_arithmetic.hpp"

namespace mixcmp::gen {
namespace {

using model::BoundFormat;

mpq_class power_of_two(long exponent) {
  mpq_class value = 1;
  if (exponent < 0)
    mpq_div_2exp(value.get_mpq_t(), value.get_mpq_t(), static_cast<unsigned long>(-exponent));
  if (exponent > 0)
    mpq_mul_2exp(value.get_mpq_t(), value.get_mpq_t(), static_cast<unsigned long>(exponent));
  return value;
}

TEST(BoundLiteral, IsTheLeastBoundNotBelow) {
  const BoundFormat format = {.precision = 3, .exponent_bits = 4};  // bias 7
  EXPECT_EQ(bound_literal(format, 0), 0u);
  EXPECT_EQ(bound_literal(format, 1), 7u << 2);
  EXPECT_EQ(bound_literal(format, mpq_class(5, 4)), (7u << 2) + 1);
  EXPECT_EQ(bound_literal(format, mpq_class(10001, 8000)), (7u << 2) + 2);
  EXPECT_EQ(bound_literal(format, mpq_class(71, 40)), 8u << 2) << "1.775 is above 1.75: 2";
  EXPECT_EQ(bound_literal(format, power_of_two(-6)), format.smallest());
  EXPECT_EQ(bound_literal(format, power_of_two(-1000) / 3), format.smallest());
  EXPECT_EQ(bound_literal(format, 224), format.infinity() - 1) << "the largest: 1.75 * 2^7";
  EXPECT_EQ(bound_literal(format, mpq_class(2241, 10)), format.infinity());
  EXPECT_EQ(bound_literal(format, power_of_two(1000)), format.infinity());
}

TEST(BoundLiteral, IsTheGoldenModels) {
  std::mt19937_64 random(1);
  for (const BoundFormat format : {BoundFormat{1, 8}, BoundFormat{4, 8}, BoundFormat{8, 5},
                                   BoundFormat{24, 8}, BoundFormat{52, 11}}) {
    for (int k = 0; k < 20'000; ++k) {
      mpq_class value(static_cast<unsigned long>(random() >> random() % 64),
                      static_cast<unsigned long>(random() >> random() % 63) | 1);
      value.canonicalize();
      value *= power_of_two(static_cast<long>(random() % 400) - 200);
      EXPECT_EQ(bound_literal(format, value), model::golden::bound_constant(format, value))
          << value << " in " << format.precision << " digits";
    }
  }
}

/// One digit more than a 64-bit word holds.
TEST(BoundLiteral, HasAsManyDigitsAsALane) {
  const BoundFormat format = {.precision = 65, .exponent_bits = 8};
  const model::Bits one = model::Bits{127} << 64;
  EXPECT_EQ(bound_literal(format, 1 + power_of_two(-64)), one + 1);
  EXPECT_EQ(bound_literal(format, 2 - power_of_two(-64)), one + model::low_mask(64));
}

}  // namespace
}  // namespace mixcmp::gen
