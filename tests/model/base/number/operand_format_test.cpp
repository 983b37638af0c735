#include "model/base/number/operand_format.hpp"

#include <gtest/gtest.h>

#include <string>

#include "model/base/number/exact.hpp"
#include "tests/support/float_samples.hpp"

namespace mixcmp::test::operand_format_test {
namespace {

TEST(OperandFormat, IsNamed) {
  const auto fixed = [](const char* name) { return *OperandFormat::parse_fixed(name)->fixed(); };
  EXPECT_EQ(fixed("uint10"), (FixedFormat{.width = 10, .unit_exponent = 0, .is_signed = false}));
  EXPECT_EQ(fixed("int8"), (FixedFormat{.width = 8, .unit_exponent = 0, .is_signed = true}));
  EXPECT_EQ(fixed("q3.12"), (FixedFormat{.width = 16, .unit_exponent = -12, .is_signed = true}));
  EXPECT_EQ(fixed("uq0.8"), (FixedFormat{.width = 8, .unit_exponent = -8, .is_signed = false}));
  for (const char* name :
       {"uint1", "uint64", "int2", "int64", "q0.1", "q31.32", "uq32.32", "s17e8", "s53e11"}) {
    const auto format = OperandFormat::parse(name);
    ASSERT_TRUE(format.ok()) << name;
    EXPECT_EQ(format->name(), name);
  }
  EXPECT_EQ(OperandFormat::parse("binary32")->name(), "s24e8");
  EXPECT_EQ(OperandFormat::parse("q31.32")->width(), 64);
}

TEST(OperandFormat, OtherNamesAreRefused) {
  for (const char* name :
       {"", "uint", "uint0", "uint65", "int1", "int08", "uint-1", "uint 8", "int8x", "q3", "q3.",
        "q.3", "q3.0", "q40.24", "uq40.25", "q3.1.2", "Uint8"}) {
    const auto format = OperandFormat::parse_fixed(name);
    ASSERT_FALSE(format.ok()) << name;
    EXPECT_EQ(format.error().received, "\"" + std::string(name) + "\"");
  }
  EXPECT_FALSE(OperandFormat::parse_fixed("s24e8").ok());
}

/// Every number of every format up to eight bits, its neighbours, and the numbers beyond its ends.
TEST(OperandFormat, NamesFromElsewhereLeadToTheStandards) {
  const auto advice = [](const char* name) {
    const auto format = OperandFormat::parse(name);
    return format.ok() ? "" : format.error().accepted.substr(0, format.error().accepted.find(';'));
  };
  EXPECT_EQ(advice("float16"), "binary16 (the same format)");
  EXPECT_EQ(advice("bf16"), "bfloat16 (the same format)");
  EXPECT_EQ(advice("double"), "binary64 (the same format)");
  EXPECT_EQ(advice("float8").substr(0, 5), "uint1") << "no name of one format";
  EXPECT_EQ(advice("").substr(0, 5), "uint1");
}

TEST(OperandFormat, WordsAreTwosComplement) {
  const FloatFormat from = format_of(24, 8);
  for (const char* name :
       {"uint1", "uint5", "uint8", "int2", "int8", "q0.7", "q3.4", "uq3.3", "uq0.8"}) {
    const auto parsed = OperandFormat::parse_fixed(name);
    ASSERT_TRUE(parsed.ok()) << name;
    const FixedFormat& format = *parsed->fixed();
    for (mpz_class n = format.smallest() - 3; n <= format.largest() + 3; ++n) {
      const Bits number = from_rational(from, n * format.unit());
      const bool is_held = format.smallest() <= n && n <= format.largest();
      ASSERT_EQ(parsed->holds(from, number), is_held) << name << ", " << n;
      ASSERT_FALSE(parsed->holds(from, from_rational(from, (n + mpq_class(1, 2)) * format.unit())));
      if (!is_held) continue;
      const mpz_class word = n >= 0 ? n : mpz_class(n + (mpz_class(1) << format.width));
      ASSERT_EQ(to_integer(parsed->word_of(from, number)), word) << name << ", " << n;
    }
  }
}

TEST(OperandFormat, TheWidestWordsHaveSixtyFourBits) {
  const FloatFormat from = format_of(113, 15);
  const auto word = [&](const char* name, const mpq_class& value) {
    return to_integer(OperandFormat::parse(name)->word_of(from, from_rational(from, value)));
  };
  const mpz_class all = (mpz_class(1) << 64) - 1;
  EXPECT_EQ(word("uint64", all), all);
  EXPECT_EQ(word("int64", -1), all);
  EXPECT_EQ(word("int64", mpq_class(-(mpz_class(1) << 63))), mpz_class(1) << 63);
  EXPECT_FALSE(OperandFormat::parse("int64")->holds(from, from_rational(from, all)));
  EXPECT_FALSE(OperandFormat::parse("uint64")->holds(from, from_rational(from, all + 1)));
}

TEST(OperandFormat, SpecialNumbersAreNotHeld) {
  const FloatFormat from = format_of(11, 5);
  const OperandFormat format = *OperandFormat::parse("int16");
  for (const Bits special : {from.quiet_nan(), from.infinity(false), from.infinity(true), Bits{1},
                             from.smallest_normal(true)}) {
    EXPECT_FALSE(format.holds(from, special));
  }
  EXPECT_TRUE(format.holds(from, from.zero(true)));
  EXPECT_EQ(format.word_of(from, from.zero(true)), Bits{0});
  EXPECT_TRUE(OperandFormat(from).holds(from, from.quiet_nan()));
  EXPECT_EQ(OperandFormat(from).word_of(from, from.quiet_nan()), from.quiet_nan());
}

/// Every number of formats of 8 and 16 bits, encoded in wider formats: words come back, and a
/// number with one digit more is not held.
TEST(OperandFormat, EveryFloatingPointWordComesBack) {
  for (const char* name : {"E4M3", "E5M2", "s4e4", "binary16", "bfloat16", "s5e3"}) {
    const auto format = OperandFormat::parse(name);
    ASSERT_TRUE(format.ok()) << name;
    const FloatFormat own = *format->floating();
    for (const FloatFormat from : {own, format_of(24, 8), format_of(16, 10), format_of(53, 11)}) {
      ASSERT_TRUE(format->is_held_by(from));
      for (Bits word = 0; word < Bits{1} << own.width(); ++word) {
        const Bits number = converted(from, own, word);
        ASSERT_TRUE(format->holds(from, number));
        const Bits expected = own.is_nan(word) ? own.quiet_nan() : word;
        ASSERT_EQ(to_integer(format->word_of(from, number)), to_integer(expected))
            << name << " in " << from.name() << ", word " << to_hex(word, own.width());
      }
    }
  }
}

TEST(OperandFormat, OtherNumbersAreNotHeldInFloatingPoint) {
  const FloatFormat from = format_of(24, 8);
  const OperandFormat format = *OperandFormat::parse("s3e5");
  const auto held = [&](const mpq_class& value) {
    return format.holds(from, from_rational(from, value));
  };
  EXPECT_TRUE(held(57344));
  EXPECT_FALSE(held(65536)) << "beyond the largest number";
  EXPECT_TRUE(held(mpq_class(7, 4)));
  EXPECT_FALSE(held(mpq_class(9, 8))) << "four digits";
  EXPECT_TRUE(held(mpq_class(3, 65536))) << "subnormal";
  EXPECT_FALSE(held(mpq_class(3, 131072))) << "below a subnormal's unit";
}

TEST(OperandFormat, IsHeldByWiderFormats) {
  const auto is_held = [](const char* name, int precision, int exponent_bits) {
    return OperandFormat::parse(name)->is_held_by(format_of(precision, exponent_bits));
  };
  EXPECT_TRUE(is_held("bfloat16", 8, 8));
  EXPECT_FALSE(is_held("bfloat16", 11, 5)) << "exponents";
  EXPECT_FALSE(is_held("binary16", 8, 8)) << "digits";
  EXPECT_TRUE(is_held("E4M3", 4, 5));
  EXPECT_FALSE(is_held("E4M3", 4, 4)) << "256 and more";
  EXPECT_FALSE(is_held("E4M3", 3, 5)) << "digits";
  EXPECT_TRUE(is_held("s4e4", 4, 4));
  EXPECT_TRUE(is_held("uint24", 24, 8));
  EXPECT_FALSE(is_held("uint25", 24, 8));
  EXPECT_TRUE(is_held("q0.7", 7, 5));
  EXPECT_FALSE(is_held("q0.7", 7, 4)) << "a subnormal number of s7e4";
}

TEST(OperandFormat, AFormatWithoutInfinitiesLacksThemAndItsNansNumber) {
  const OperandFormat format = *OperandFormat::parse("E4M3");
  EXPECT_EQ(format.name(), "E4M3");
  EXPECT_EQ(format.width(), 8);
  const FloatFormat from = format_of(24, 8);
  const auto held = [&](const mpq_class& value) {
    return format.holds(from, from_rational(from, value));
  };
  EXPECT_TRUE(held(448));
  EXPECT_FALSE(held(480)) << "the NaN's fields";
  EXPECT_FALSE(held(-480));
  EXPECT_FALSE(held(512));
  EXPECT_TRUE(held(mpq_class(7, 512)));
  EXPECT_FALSE(held(mpq_class(7, 1024))) << "below a subnormal's unit";
  EXPECT_FALSE(format.holds(from, from.infinity(false)));
  EXPECT_TRUE(format.holds(from, from.quiet_nan()));
  EXPECT_EQ(format.word_of(from, from.quiet_nan()), Bits{0x7f});
  EXPECT_NE(OperandFormat::parse("float16").error().accepted.find("E4M3"), std::string::npos);
}

std::string holding(const std::vector<const char*>& names) {
  std::vector<OperandFormat> formats;
  for (const char* name : names) formats.push_back(*OperandFormat::parse(name));
  const FloatFormat format = format_holding(formats);
  for (const OperandFormat& each : formats) EXPECT_TRUE(each.is_held_by(format)) << each.name();
  return format.name();
}

TEST(OperandFormat, TheSmallestFormatThatHoldsSeveral) {
  EXPECT_EQ(holding({"binary16", "bfloat16"}), "s11e8");
  EXPECT_EQ(holding({"E5M2"}), "s3e5");
  EXPECT_EQ(holding({"E4M3"}), "s4e5") << "448 is beyond e4";
  EXPECT_EQ(holding({"E4M3", "binary32"}), "s24e8");
  EXPECT_EQ(holding({"uint10", "binary16"}), "s53e11");
  EXPECT_EQ(holding({"uint60", "int4"}), "s60e11");
}

TEST(OperandFormat, WidthsAddUp) {
  const std::vector<OperandFormat> formats = {*OperandFormat::parse("uint10"),
                                              *OperandFormat::parse("q3.12"),
                                              *OperandFormat::parse("s53e11")};
  EXPECT_EQ(total_width(formats), 10 + 16 + 64);
}

}  // namespace
}  // namespace mixcmp::test::operand_format_test
