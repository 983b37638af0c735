#include "model/base/number/decimal.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "model/base/number/exact.hpp"
#include "tests/support/float_samples.hpp"

namespace mixcmp::test::decimal_test {
namespace {

/// A dyadic rational as "<digits>e-<places>" in decimal, or "0x<digits>p-<places>" in hexadecimal.
struct Places {
  mpz_class digits;
  unsigned long places;
};

Places decimal_places(const mpq_class& dyadic) {
  const unsigned long places = mpz_scan1(dyadic.get_den_mpz_t(), 0);
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 5, places);
  return {dyadic.get_num() * power, places};
}

std::string decimal_text(const mpz_class& digits, unsigned long places) {
  return fmt::format("{}e-{}", digits.get_str(), places);
}

std::string hexadecimal_text(const mpz_class& digits, unsigned long places) {
  return fmt::format("0x{}p-{}", digits.get_str(16), places);
}

Bits parse(FloatFormat format, const std::string& text) {
  const auto bits = from_text(format, text);
  EXPECT_TRUE(bits.ok()) << text;
  return bits.ok() ? *bits : 0;
}

/// Checks that the midpoint of two neighbours, and texts a hair below and above it, are rounded
/// once.
void judge_midpoint(FloatFormat format, Bits low) {
  const mpq_class middle = (to_rational(format, low) + to_rational(format, low + 1)) / 2;
  const Bits even = low % 2 == 0 ? low : low + 1;
  const Places decimal = decimal_places(middle);
  EXPECT_EQ(parse(format, decimal_text(decimal.digits, decimal.places)), even);
  EXPECT_EQ(parse(format, decimal_text(decimal.digits * 10 - 1, decimal.places + 1)), low);
  EXPECT_EQ(parse(format, decimal_text(decimal.digits * 10 + 1, decimal.places + 1)), low + 1);
  const unsigned long places = mpz_scan1(middle.get_den_mpz_t(), 0);
  const mpz_class& digits = middle.get_num();
  EXPECT_EQ(parse(format, hexadecimal_text(digits, places)), even);
  EXPECT_EQ(parse(format, hexadecimal_text(digits * 16 - 1, places + 4)), low);
  EXPECT_EQ(parse(format, hexadecimal_text(digits * 16 + 1, places + 4)), low + 1);
}

TEST(FromText, RoundsOnceAtEveryMidpointOfASmallFormat) {
  const FloatFormat format = format_of(4, 4);
  for (Bits low = 0; low < format.largest_finite(false); ++low) judge_midpoint(format, low);
}

TEST(FromText, RoundsOnceAtMidpointsOfWideFormats) {
  std::mt19937_64 random(1);
  for (const FloatFormat format : {format_of(24, 8), format_of(53, 11), format_of(113, 8)}) {
    for (int trial = 0; trial < 300; ++trial) {
      const Bits low = format.magnitude(random_encoding(format, random));
      if (low < format.largest_finite(false)) judge_midpoint(format, low);
    }
    judge_midpoint(format, 0);
    judge_midpoint(format, format.smallest_normal(false) - 1);
  }
}

TEST(FromText, AgreesWithTheStandardLibrary) {
  std::mt19937_64 random(2);
  for (int trial = 0; trial < 20'000; ++trial) {
    const auto exponent = static_cast<int>(random() % 660) - 340;
    const std::string text = fmt::format("{}.{}e{}", random() % 100, random(), exponent);
    const double expected = std::strtod(text.c_str(), nullptr);
    std::uint64_t word;
    std::memcpy(&word, &expected, sizeof word);
    EXPECT_EQ(parse(format_of(53, 11), text), word) << text;
  }
}

TEST(FromText, OverflowsToInfinityAtTheMidpointBeyondTheLargest) {
  const FloatFormat format = format_of(4, 3);  // largest 15, infinity from 15.5
  EXPECT_EQ(parse(format, "15.4999999999999999999999"), format.largest_finite(false));
  EXPECT_EQ(parse(format, "15.5"), format.infinity(false));
  EXPECT_EQ(parse(format, "-1e1000000"), format.infinity(true));
  EXPECT_EQ(parse(format, "-1e99999999999999999999"), format.infinity(true));
  EXPECT_EQ(parse(format, "-1e-99999999999999999999"), format.zero(true));
}

/// What E4M3 lacks is its one NaN, without a sign.
TEST(FromText, WithoutInfinitiesTheNanIsBeyondTheLargest) {
  const FloatFormat format = FloatFormat::e4m3();
  EXPECT_EQ(parse(format, "464"), format.largest_finite(false));
  EXPECT_EQ(parse(format, "-464"), format.largest_finite(true));
  for (const char* text :
       {"464.0000001", "-480", "500", "-1e99999999999999999999", "inf", "-inf", "nan", "-nan"}) {
    EXPECT_EQ(parse(format, text), format.quiet_nan()) << text;
  }
  for (Bits bits = 0; bits < 256; ++bits) {
    const Bits expected = format.is_nan(bits) ? format.quiet_nan() : bits;
    EXPECT_EQ(parse(format, to_text(format, bits)), expected) << to_hex(bits, 8);
  }
}

TEST(FromText, ReadsEveryAcceptedForm) {
  const FloatFormat format = format_of(24, 8);
  EXPECT_EQ(parse(format, "12.5"), Bits{0x41480000});
  EXPECT_EQ(parse(format, "+12.5E0"), Bits{0x41480000});
  EXPECT_EQ(parse(format, "-.125e+2"), Bits{0xc1480000});
  EXPECT_EQ(parse(format, "0x1.9p3"), Bits{0x41480000});
  EXPECT_EQ(parse(format, "-0XC.8P0"), Bits{0xc1480000});
  EXPECT_EQ(parse(format, "-0"), Bits{0x80000000});
  EXPECT_EQ(parse(format, "inf"), format.infinity(false));
  EXPECT_EQ(parse(format, "-inf"), format.infinity(true));
  EXPECT_EQ(parse(format, "-Infinity"), format.infinity(true));
  EXPECT_EQ(parse(format, "INF"), format.infinity(false));
  EXPECT_EQ(parse(format, "nan"), format.quiet_nan());
}

TEST(FromText, RefusesWhatIsNotANumber) {
  for (const char* text : {"", "-", ".", "1e", "1e+", "1.2.3", "0x", "0x.p1", "1p3", "0x1e+3", " 1",
                           "1 ", "1@3", "0b1", "--1", "infinit", "1,5", "nan(1)"}) {
    const auto bits = from_text(format_of(24, 8), text);
    ASSERT_FALSE(bits.ok()) << text;
    EXPECT_EQ(bits.error().received, fmt::format("\"{}\"", text));
    EXPECT_NE(bits.error().accepted.find("decimal"), std::string::npos);
  }
}

TEST(ToText, ReadsBackForEveryEncodingOfBinary16) {
  const FloatFormat format = format_of(11, 5);
  for (Bits bits = 0; bits < Bits{1} << 16; ++bits) {
    const Bits expected = format.is_nan(bits) ? format.quiet_nan() : bits;
    ASSERT_EQ(parse(format, to_text(format, bits)), expected) << to_hex(bits, 16);
  }
}

/// The significant digits of a printed number, without leading and trailing zeros.
std::string significant_digits(const std::string& text) {
  std::string digits;
  for (const char c : text.substr(0, text.find('e'))) {
    if ('0' <= c && c <= '9' && !(digits.empty() && c == '0')) digits += c;
  }
  return digits.substr(0, digits.find_last_not_of('0') + 1);
}

TEST(ToText, IsAsShortAsTheStandardLibrarys) {
  const FloatFormat format = format_of(53, 11);
  std::mt19937_64 random(3);
  for (int trial = 0; trial < 5'000; ++trial) {
    Bits bits = random_encoding(format, random);
    if (trial % 4 == 0) bits = format.pack(false, format.biased_exponent(bits), 0);
    const auto word = static_cast<std::uint64_t>(bits);
    double value;
    std::memcpy(&value, &word, sizeof value);
    if (!std::isfinite(value)) continue;
    char shortest[64] = {};
    std::to_chars(shortest, shortest + sizeof shortest, value, std::chars_format::scientific);
    EXPECT_EQ(significant_digits(to_text(format, bits)), significant_digits(shortest));
  }
}

TEST(ToText, ChoosesTheReadableNotation) {
  const FloatFormat format = format_of(53, 11);
  for (const char* text : {"0", "-0", "1", "-100", "0.1", "12.345", "0.00001", "1e-6", "1e17",
                           "12345678901234568", "1.5e300", "5e-324", "inf", "-inf", "nan"}) {
    EXPECT_EQ(to_text(format, parse(format, text)), text);
  }
}

}  // namespace
}  // namespace mixcmp::test::decimal_test
