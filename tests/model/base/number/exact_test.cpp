#include "model/base/number/exact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "model/base/number/double.hpp"
#include "model/base/number/dyadic.hpp"
#include "model/judge/golden/arithmetic.hpp"
#include "tests/support/float_samples.hpp"

/// Tests conversions in GMP integers against those of the golden model, which use MPFR.
namespace mixcmp::test::exact_test {
namespace {

std::string shown(FloatFormat format, Bits bits) {
  return format.name() + " " + to_hex(bits, format.width());
}

/// Judges the number itself, numbers a hair beside it, and the midpoint between it and its
/// neighbour, by the conversions in MPFR.
void judge_around(FloatFormat format, Bits bits) {
  const mpq_class value = to_rational(format, bits);
  EXPECT_EQ(value, golden::to_rational(format, bits)) << shown(format, bits);
  if (value != 0) {
    EXPECT_EQ(from_rational(format, value), bits) << shown(format, bits);
  }
  const long place = std::max(format.biased_exponent(bits), 1) - format.bias();
  const mpq_class half = power_of_two(place - format.fraction_bits() - 1);
  for (const mpq_class& offset : {mpq_class(half / 3), half, mpq_class(half * 5 / 4)}) {
    for (const mpq_class& near : {mpq_class(value + offset), mpq_class(value - offset)}) {
      EXPECT_EQ(from_rational(format, near), golden::from_rational(format, near))
          << near << " in " << format.name();
    }
  }
}

bool is_finite(FloatFormat format, Bits bits) {
  return format.biased_exponent(bits) != format.max_biased_exponent();
}

TEST(Exact, AgreesWithTheGoldenModelAroundEveryNumberOfSmallFormats) {
  for (const FloatFormat format : {format_of(2, 2), format_of(3, 4), format_of(5, 3)}) {
    for (Bits bits = 0; bits >> format.width() == 0; ++bits) {
      if (is_finite(format, bits)) judge_around(format, bits);
    }
  }
}

TEST(Exact, AgreesWithTheGoldenModelInWideFormats) {
  std::mt19937_64 random(1);
  for (const FloatFormat format :
       {format_of(24, 8), format_of(53, 11), format_of(64, 15), format_of(113, 15)}) {
    for (const Bits bits : special_encodings(format)) {
      if (is_finite(format, bits)) judge_around(format, bits);
    }
    for (int trial = 0; trial < 500; ++trial) {
      const Bits bits = random_encoding(format, random);
      if (is_finite(format, bits)) judge_around(format, bits);
    }
  }
}

TEST(Exact, OverflowsFromTheMidpointBeyondTheLargestOn) {
  const FloatFormat format = format_of(4, 3);  // largest 15, infinity from 15.5
  EXPECT_EQ(from_rational(format, mpq_class(15499, 1000)), format.largest_finite(false));
  EXPECT_EQ(from_rational(format, mpq_class(-31, 2)), format.infinity(true));
  EXPECT_EQ(from_rational(format, power_of_two(100'000)), format.infinity(false));
  EXPECT_EQ(from_rational(format, -power_of_two(-100'000)), format.zero(true));
  EXPECT_EQ(from_rational(format, 0), format.zero(false));
}

TEST(Exact, ARatioNeedsNoLowestTerms) {
  const FloatFormat format = format_of(4, 3);
  for (const int factor : {1, 2, 3, 1000}) {
    EXPECT_EQ(from_ratio(format, 9 * factor, 16 * factor), from_rational(format, mpq_class(9, 16)));
  }
}

TEST(Exact, RoundsUpToTheLeastNumberNotBelow) {
  for (const FloatFormat format : {format_of(3, 3), format_of(4, 4)}) {
    for (Bits bits = 0; bits <= format.largest_finite(false); ++bits) {
      const mpq_class value = to_rational(format, bits);
      EXPECT_EQ(from_rational_up(format, value), bits);
      EXPECT_EQ(from_rational_up(format, value + power_of_two(-100)), bits + 1);
    }
    EXPECT_EQ(from_rational_up(format, power_of_two(100)), format.infinity(false));
  }
}

const FloatFormat e4m3 = FloatFormat::e4m3();

/// The value of a word of E4M3 that is no NaN, by the table of the Open Compute Project's OFP8.
mpq_class value_of_e4m3(int word) {
  const int field = word >> 3 & 15, fraction = word & 7;
  const mpq_class magnitude =
      field == 0 ? fraction * power_of_two(-9) : (8 + fraction) * power_of_two(field - 10);
  return word < 0x80 ? magnitude : mpq_class(-magnitude);
}

TEST(WithoutInfinities, EveryWordHasTheValueOfTheSpecification) {
  for (int word = 0; word < 256; ++word) {
    const Bits bits = static_cast<Bits>(word);
    if (e4m3.is_nan(bits)) {
      EXPECT_TRUE(std::isnan(to_double(e4m3, bits)));
      EXPECT_EQ(converted(format_of(24, 8), e4m3, bits), format_of(24, 8).quiet_nan());
      continue;
    }
    EXPECT_EQ(to_rational(e4m3, bits), value_of_e4m3(word)) << word;
    EXPECT_EQ(mpq_class(to_double(e4m3, bits)), value_of_e4m3(word)) << word;
    const Bits wide = converted(format_of(24, 8), e4m3, bits);
    EXPECT_EQ(to_rational(format_of(24, 8), wide), value_of_e4m3(word)) << word;
    EXPECT_EQ(converted(e4m3, format_of(24, 8), wide), bits) << word;
  }
}

/// A midpoint goes to the even neighbour. The NaN takes everything above 464 = 448 + 16.
TEST(WithoutInfinities, NumbersAreRoundedToTheNearestAndBeyondTheLargestToTheNan) {
  const mpq_class tiny = power_of_two(-60);
  for (int word = 0; word < 0x7f; ++word) {
    const mpq_class value = value_of_e4m3(word);
    const mpq_class next = word == 0x7e ? mpq_class(480) : value_of_e4m3(word + 1);
    const mpq_class middle = (value + next) / 2;
    const Bits low = static_cast<Bits>(word), high = low + 1;
    EXPECT_EQ(from_rational(e4m3, middle - tiny), low) << word;
    EXPECT_EQ(from_rational(e4m3, middle), word % 2 == 0 ? low : high) << word;
    EXPECT_EQ(from_rational(e4m3, middle + tiny), high) << word;
    EXPECT_EQ(from_rational_up(e4m3, value), low) << word;
    EXPECT_EQ(from_rational_up(e4m3, value + tiny), high) << word;
  }
  for (const mpq_class& beyond : {mpq_class(465), mpq_class(480), mpq_class(496), mpq_class(500),
                                  mpq_class(512), mpq_class(power_of_two(100'000))}) {
    EXPECT_EQ(from_rational(e4m3, beyond), e4m3.quiet_nan()) << beyond;
    EXPECT_EQ(from_rational(e4m3, -beyond), e4m3.quiet_nan()) << beyond;
    EXPECT_EQ(from_rational_up(e4m3, beyond), e4m3.quiet_nan()) << beyond;
  }
  for (const FloatFormat from : {format_of(11, 5), format_of(53, 11)}) {
    EXPECT_EQ(converted(e4m3, from, from.infinity(false)), e4m3.quiet_nan());
    EXPECT_EQ(converted(e4m3, from, from.infinity(true)), e4m3.quiet_nan());
    EXPECT_EQ(converted(e4m3, from, from.zero(true)), e4m3.zero(true));
  }
}

TEST(Double, HoldsEveryNumberOfFormatsThatFit) {
  std::mt19937_64 random(2);
  for (const FloatFormat format : {format_of(11, 5), format_of(53, 8), format_of(53, 11)}) {
    for (int trial = 0; trial < 2'000; ++trial) {
      const Bits bits = random_encoding(format, random);
      const double value = to_double(format, bits);
      if (format.is_nan(bits)) {
        EXPECT_NE(value, value);
        continue;
      }
      EXPECT_EQ(from_double(format, value), bits) << shown(format, bits);
      if (is_finite(format, bits)) {
        EXPECT_EQ(mpq_class(value), to_rational(format, bits));
      }
    }
  }
}

TEST(Double, OfAWiderFormatIsTheNearest) {
  const FloatFormat format = format_of(113, 15);
  const auto nearest = [&](const mpq_class& value) {
    return to_double(format, from_rational(format, value));
  };
  EXPECT_EQ(nearest(1 + power_of_two(-53)), 1) << "a tie goes to even";
  EXPECT_EQ(nearest(1 + power_of_two(-53) + power_of_two(-100)), 1 + 0x1p-52);
  EXPECT_EQ(nearest(-power_of_two(2000)), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(nearest(power_of_two(-1074) * 3 / 4), 0x1p-1074);
  EXPECT_TRUE(std::signbit(to_double(format, format.zero(true))));
}

}  // namespace
}  // namespace mixcmp::test::exact_test
