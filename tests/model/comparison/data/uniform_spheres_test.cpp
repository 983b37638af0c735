#include "model/comparison/data/uniform_spheres.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "model/base/number/exact.hpp"
#include "model/comparison/data/philox.hpp"

namespace mixcmp::test::uniform_spheres_test {
namespace {

const FloatFormat binary64 = FloatFormat::parse("binary64").value();

double value(const data::Table& table, std::size_t row, std::size_t column) {
  return to_rational(table.format, table.at(row, column)).get_d();
}

// The known answers of the authors' Random123 distribution, kat_vectors.
TEST(Philox, GivesItsAuthorsKnownAnswers) {
  EXPECT_EQ(data::philox({0, 0, 0, 0}, {0, 0}),
            (data::PhiloxCounter{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(
      data::philox({0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff}, {0xffffffff, 0xffffffff}),
      (data::PhiloxCounter{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(
      data::philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
      (data::PhiloxCounter{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(UniformSpheres, AreTheDocumentedFunctionOfSeedAndIndex) {
  const std::uint64_t seed = 0x123456789abcdef0;
  const data::Table table =
      data::uniform_spheres({.count = 4, .side = 100, .radius_max = 25, .seed = seed}, binary64);
  const auto xy = data::philox({3, 0, 0, 0}, {0x9abcdef0, 0x12345678});
  const auto zr = data::philox({3, 0, 1, 0}, {0x9abcdef0, 0x12345678});
  const auto number = [](double limit, std::uint32_t high, std::uint32_t low) {
    return limit * (static_cast<double>((std::uint64_t{high} << 32 | low) >> 11) * 0x1p-53);
  };
  EXPECT_EQ(value(table, 3, 0), number(100, xy[0], xy[1]));
  EXPECT_EQ(value(table, 3, 1), number(100, xy[2], xy[3]));
  EXPECT_EQ(value(table, 3, 2), number(100, zr[0], zr[1]));
  EXPECT_EQ(value(table, 3, 3), number(25, zr[2], zr[3]));
}

TEST(UniformSpheres, DoNotDependOnTheirNumberButOnTheSeed) {
  const data::Table few = data::uniform_spheres({.count = 10}, binary64);
  const data::Table many = data::uniform_spheres({.count = 20}, binary64);
  EXPECT_TRUE(std::equal(few.values.begin(), few.values.end(), many.values.begin()));
  EXPECT_NE(data::uniform_spheres({.count = 10, .seed = 2}, binary64).values, few.values);
}

TEST(UniformSpheres, FillCubeAndRadiiEvenly) {
  const std::size_t count = 8192;
  const data::Table table =
      data::uniform_spheres({.count = count, .side = 100, .radius_max = 25}, binary64);
  ASSERT_EQ(table.rows(), count);
  for (std::size_t column = 0; column < 4; ++column) {
    const double limit = column == 3 ? 25 : 100;
    double sum = 0;
    for (std::size_t row = 0; row < count; ++row) {
      const double number = value(table, row, column);
      ASSERT_GE(number, 0);
      ASSERT_LT(number, limit);
      sum += number;
    }
    const double deviation = limit / std::sqrt(12.0 * count);
    EXPECT_NEAR(sum / count, limit / 2, 4 * deviation) << table.columns[column];
  }
}

}  // namespace
}  // namespace mixcmp::test::uniform_spheres_test
