#include "model/base/number/float_format.hpp"

#include <gtest/gtest.h>

#include "tests/support/float_samples.hpp"

namespace mixcmp::test::float_format_test {
namespace {

TEST(FloatFormat, KnowsTheLayoutOfBinary32) {
  const FloatFormat format = *FloatFormat::parse("binary32");
  EXPECT_EQ(format.name(), "s24e8");
  EXPECT_EQ(format.width(), 32);
  EXPECT_EQ(format.fraction_bits(), 23);
  EXPECT_EQ(format.bias(), 127);
  EXPECT_EQ(format.min_exponent(), -126);
  EXPECT_EQ(format.max_exponent(), 127);
  EXPECT_EQ(format.infinity(true), Bits{0xff800000});
  EXPECT_EQ(format.quiet_nan(), Bits{0x7fc00000});
  EXPECT_EQ(format.largest_finite(false), Bits{0x7f7fffff});
  EXPECT_EQ(format.smallest_normal(true), Bits{0x80800000});
}

TEST(FloatFormat, TakesEncodingsApart) {
  const FloatFormat format = *FloatFormat::parse("s24e8");
  const Bits pi = 0xc0490fdb;
  EXPECT_TRUE(format.sign(pi));
  EXPECT_EQ(format.biased_exponent(pi), 128);
  EXPECT_EQ(format.fraction(pi), Bits{0x490fdb});
  EXPECT_EQ(format.magnitude(pi), Bits{0x40490fdb});
  EXPECT_EQ(format.pack(true, 128, 0x490fdb), pi);
}

TEST(FloatFormat, ClassifiesEveryEncodingOfASmallFormat) {
  const FloatFormat format = format_of(3, 3);
  int nans = 0, infinities = 0, zeros = 0, subnormals = 0;
  for (Bits bits = 0; bits < 64; ++bits) {
    nans += format.is_nan(bits) ? 1 : 0;
    infinities += format.is_infinite(bits) ? 1 : 0;
    zeros += format.is_zero(bits) ? 1 : 0;
    subnormals += format.is_subnormal(bits) ? 1 : 0;
  }
  EXPECT_EQ(nans, 6);
  EXPECT_EQ(infinities, 2);
  EXPECT_EQ(zeros, 2);
  EXPECT_EQ(subnormals, 6);
}

TEST(FloatFormat, WithoutInfinitiesTheLargestExponentHoldsNumbersAndOneNan) {
  const FloatFormat e4m3 = FloatFormat::e4m3();
  EXPECT_EQ(e4m3.name(), "E4M3");
  EXPECT_FALSE(e4m3.has_infinities());
  EXPECT_EQ(e4m3.bias(), 7);
  EXPECT_EQ(e4m3.min_exponent(), -6);
  EXPECT_EQ(e4m3.max_exponent(), 8);
  EXPECT_EQ(e4m3.largest_finite(false), Bits{0x7e});
  EXPECT_EQ(e4m3.largest_finite(true), Bits{0xfe});
  EXPECT_EQ(e4m3.quiet_nan(), Bits{0x7f});
  EXPECT_EQ(e4m3.beyond_largest(true), e4m3.quiet_nan());
  for (Bits bits = 0; bits < 256; ++bits) {
    const bool is_nan = bits == 0x7f || bits == 0xff;
    EXPECT_EQ(e4m3.is_nan(bits), is_nan) << to_hex(bits, 8);
    EXPECT_EQ(e4m3.is_finite(bits), !is_nan) << to_hex(bits, 8);
    EXPECT_FALSE(e4m3.is_infinite(bits));
  }
  EXPECT_FALSE(e4m3 == format_of(4, 4));
  EXPECT_EQ(format_of(4, 4).beyond_largest(true), format_of(4, 4).infinity(true));
}

/// The smallest format has one number in its largest binade.
TEST(FloatFormat, WithoutInfinitiesTwoDigitsAreEnough) {
  const FloatFormat format = FloatFormat::make(2, 2, Specials::no_infinities).value();
  EXPECT_EQ(format.largest_finite(false), Bits{0b110});
  EXPECT_EQ(format.max_exponent(), 2);
  EXPECT_TRUE(format.is_nan(0b111));
}

TEST(FloatFormat, FillsAllBitsOfBinary128) {
  const FloatFormat format = *FloatFormat::parse("binary128");
  EXPECT_EQ(format.width(), 128);
  EXPECT_TRUE(format.sign(format.zero(true)));
  EXPECT_EQ(format.biased_exponent(format.infinity(true)), 32767);
  EXPECT_EQ(to_hex(format.largest_finite(true), 128), "fffeffffffffffffffffffffffffffff");
}

TEST(FloatFormat, ReadsNamesAndNotation) {
  EXPECT_EQ(*FloatFormat::parse("binary16"), format_of(11, 5));
  EXPECT_EQ(*FloatFormat::parse("bfloat16"), format_of(8, 8));
  EXPECT_EQ(*FloatFormat::parse("binary64"), format_of(53, 11));
  EXPECT_EQ(*FloatFormat::parse("binary128"), format_of(113, 15));
  EXPECT_EQ(*FloatFormat::parse("s2e2"), format_of(2, 2));
  for (const FloatFormat format : {format_of(2, 15), format_of(113, 2), format_of(17, 8)}) {
    EXPECT_EQ(*FloatFormat::parse(format.name()), format);
  }
}

TEST(FloatFormat, RefusesWhatItCannotPack) {
  for (const char* text : {"",       "s",      "e",      "s17",      "s017e8",
                           "17e8",   "s17e",   "se8",    "s1e8",     "s114e8",
                           "s17e1",  "s17e16", "s17e8x", " s17e8",   "s17 e8",
                           "s-17e8", "s17e-8", "S17E8",  "binary31", "s99999999999999999999e8"}) {
    const auto format = FloatFormat::parse(text);
    ASSERT_FALSE(format.ok()) << text;
    EXPECT_EQ(format.error().received, "\"" + std::string(text) + "\"");
    EXPECT_NE(format.error().accepted.find("P 2..113"), std::string::npos);
  }
  EXPECT_NE(FloatFormat::parse("E4M3").error().message.find("operands only"), std::string::npos);
  EXPECT_FALSE(FloatFormat::make(114, 8).ok());
  EXPECT_FALSE(FloatFormat::make(17, 1).ok());
}

TEST(ToHex, PadsToTheWidth) {
  EXPECT_EQ(to_hex(0, 1), "0");
  EXPECT_EQ(to_hex(0x1a, 8), "1a");
  EXPECT_EQ(to_hex(0x1a, 9), "01a");
  EXPECT_EQ(to_hex(low_mask(128), 128), std::string(32, 'f'));
}

}  // namespace
}  // namespace mixcmp::test::float_format_test
