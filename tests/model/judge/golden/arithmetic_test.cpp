#include "model/judge/golden/arithmetic.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>

#include "model/base/number/decimal.hpp"
#include "model/base/number/exact.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/integer_float.hpp"

namespace mixcmp::test::arithmetic_test {
namespace {

using golden::Rounded;

using Binary = Rounded (*)(const Arithmetic&, FloatFormat, Bits, Bits);
using Unary = Rounded (*)(const Arithmetic&, FloatFormat, Bits);
using Choice = Rounded (*)(const Arithmetic&, Bits, Bits);

template <class Function>
struct Judged {
  const char* name;
  Function golden;
  Function integer;
};

constexpr Judged<Binary> binaries[] = {
    {"add", golden::add, integer_float::add},
    {"subtract", golden::subtract, integer_float::subtract},
    {"multiply", golden::multiply, integer_float::multiply},
    {"divide", golden::divide, integer_float::divide},
};
constexpr Judged<Unary> unaries[] = {
    {"square", golden::square, integer_float::square},
    {"square_root", golden::square_root, integer_float::square_root},
    {"convert", golden::convert, integer_float::convert},
};
constexpr Judged<Choice> choices[] = {
    {"minimum", golden::minimum, integer_float::minimum},
    {"maximum", golden::maximum, integer_float::maximum},
};

std::string show(FloatFormat format, Rounded rounded) {
  return fmt::format("{} ({}){}", to_hex(rounded.bits, format.width()),
                     to_text(format, rounded.bits), rounded.exceptional ? " exceptional" : "");
}

std::string describe(const char* name, const Arithmetic& result, FloatFormat operands, Bits a,
                     Bits b) {
  return fmt::format("{} {} {} {}: a = {} ({}), b = {} ({}) in {}", name, result.format.name(),
                     to_string(result.rounding), to_string(result.subnormals),
                     to_hex(a, operands.width()), to_text(operands, a), to_hex(b, operands.width()),
                     to_text(operands, b), operands.name());
}

/// A plain comparison, because a million passing EXPECT_EQ with messages would take a minute.
void expect_same(const char* name, const Arithmetic& result, FloatFormat operands, Bits a, Bits b,
                 Rounded got, Rounded expected) {
  if (got == expected) return;
  ADD_FAILURE() << describe(name, result, operands, a, b) << "\n  expected "
                << show(result.format, expected) << ", got " << show(result.format, got);
}

void judge_unaries(const Arithmetic& result, FloatFormat operands, Bits a) {
  for (const auto& [name, golden_function, integer_function] : unaries) {
    expect_same(name, result, operands, a, 0, golden_function(result, operands, a),
                integer_function(result, operands, a));
  }
}

void judge_binaries(const Arithmetic& result, FloatFormat operands, Bits a, Bits b) {
  for (const auto& [name, golden_function, integer_function] : binaries) {
    expect_same(name, result, operands, a, b, golden_function(result, operands, a, b),
                integer_function(result, operands, a, b));
  }
  if (operands != result.format) return;
  for (const auto& [name, golden_function, integer_function] : choices) {
    expect_same(name, result, operands, a, b, golden_function(result, a, b),
                integer_function(result, a, b));
  }
  EXPECT_EQ(golden::compare(operands, result.subnormals, a, b),
            integer_float::compare(operands, result.subnormals, a, b))
      << describe("compare", result, operands, a, b);
}

void judge_every_pair(FloatFormat result_format, FloatFormat operands) {
  const Bits end = Bits{1} << operands.width();
  for (const Arithmetic& result : every_arithmetic(result_format)) {
    for (Bits a = 0; a < end && !testing::Test::HasFailure(); ++a) {
      judge_unaries(result, operands, a);
      for (Bits b = 0; b < end; ++b) judge_binaries(result, operands, a, b);
    }
  }
}

TEST(Arithmetic, AgreesWithIntegersOnEveryPairOfS3e3) {
  judge_every_pair(format_of(3, 3), format_of(3, 3));
}

TEST(Arithmetic, AgreesWithIntegersOnEveryPairOfS4e4) {
  judge_every_pair(format_of(4, 4), format_of(4, 4));
}

TEST(Arithmetic, AgreesWithIntegersOnEveryPairOfS5e3) {
  judge_every_pair(format_of(5, 3), format_of(5, 3));
}

TEST(Arithmetic, AgreesWithIntegersOnEveryPairOfS2e2) {
  judge_every_pair(format_of(2, 2), format_of(2, 2));
}

TEST(Arithmetic, AgreesWithIntegersWhereTheResultIsNarrower) {
  judge_every_pair(format_of(3, 3), format_of(4, 4));
  judge_every_pair(format_of(2, 4), format_of(4, 3));
  judge_every_pair(format_of(2, 2), format_of(4, 3));
}

TEST(Arithmetic, AgreesWithIntegersWhereTheResultIsWider) {
  judge_every_pair(format_of(6, 5), format_of(4, 3));
}

class WideArithmetic : public testing::TestWithParam<FloatFormat> {};

TEST_P(WideArithmetic, AgreesWithIntegersOnSpecials) {
  const FloatFormat format = GetParam();
  for (const Arithmetic& result : every_arithmetic(format)) {
    for (const Bits a : special_encodings(format)) {
      judge_unaries(result, format, a);
      for (const Bits b : special_encodings(format)) judge_binaries(result, format, a, b);
    }
  }
}

TEST_P(WideArithmetic, AgreesWithIntegersOnRandomFields) {
  const FloatFormat format = GetParam();
  std::mt19937_64 random(1);
  for (const Arithmetic& result : every_arithmetic(format)) {
    for (int trial = 0; trial < 20'000 && !HasFailure(); ++trial) {
      const Bits a = random_encoding(format, random);
      judge_unaries(result, format, a);
      judge_binaries(result, format, a, random_encoding_near(format, a, random));
    }
  }
}

TEST_P(WideArithmetic, AgreesWithIntegersBetweenFormats) {
  const FloatFormat format = GetParam();
  std::mt19937_64 random(2);
  for (const FloatFormat other : {format_of(4, 8), format_of(17, 5), format_of(64, 8)}) {
    for (const Arithmetic& result : every_arithmetic(other)) {
      for (int trial = 0; trial < 3'000 && !HasFailure(); ++trial) {
        const Bits a = random_encoding(format, random);
        judge_unaries(result, format, a);
        judge_binaries(result, format, a, random_encoding_near(format, a, random));
      }
    }
  }
}

std::string format_name(const testing::TestParamInfo<FloatFormat>& info) {
  return info.param.name();
}

INSTANTIATE_TEST_SUITE_P(Formats, WideArithmetic,
                         testing::Values(format_of(11, 5), format_of(24, 8), format_of(53, 11),
                                         format_of(53, 8), format_of(64, 15), format_of(65, 6),
                                         format_of(113, 15)),
                         format_name);

/// Compares with the processor's own arithmetic: rounding to nearest, gradual underflow.
template <class Real, class Word>
struct Machine {
  FloatFormat format;

  static Real real(Bits bits) {
    const Word word = static_cast<Word>(bits);
    Real value;
    std::memcpy(&value, &word, sizeof value);
    return value;
  }
  Bits bits(Real value) const {
    if (std::isnan(value)) return format.quiet_nan();
    Word word;
    std::memcpy(&word, &value, sizeof word);
    return word;
  }

  void judge(Bits a, Bits b) const {
    const Arithmetic result{format};
    const Real x = real(a), y = real(b);
    EXPECT_EQ(golden::add(result, format, a, b).bits, bits(x + y));
    EXPECT_EQ(golden::subtract(result, format, a, b).bits, bits(x - y));
    EXPECT_EQ(golden::multiply(result, format, a, b).bits, bits(x * y));
    EXPECT_EQ(golden::square(result, format, a).bits, bits(x * x));
    EXPECT_EQ(golden::divide(result, format, a, b).bits, bits(x / y));
    EXPECT_EQ(golden::square_root(result, format, a).bits, bits(std::sqrt(x)));
    if (testing::Test::HasFailure()) ADD_FAILURE() << describe("machine", result, format, a, b);
  }

  void judge_all(int trials) const {
    std::mt19937_64 random(3);
    for (const Bits a : special_encodings(format)) {
      for (const Bits b : special_encodings(format)) judge(a, b);
    }
    for (int trial = 0; trial < trials && !testing::Test::HasFailure(); ++trial) {
      const Bits a = random_encoding(format, random);
      judge(a, random_encoding_near(format, a, random));
    }
  }
};

TEST(Arithmetic, AgreesWithTheMachinesFloat) {
  Machine<float, std::uint32_t>{format_of(24, 8)}.judge_all(200'000);
}

TEST(Arithmetic, AgreesWithTheMachinesDouble) {
  Machine<double, std::uint64_t>{format_of(53, 11)}.judge_all(200'000);
}

/// Operands in E4M3: MPFR's value of every word is that of GMP, and the NaNs are exceptional.
TEST(Arithmetic, ConvertsEveryWordOfAFormatWithoutInfinities) {
  const FloatFormat e4m3 = FloatFormat::e4m3();
  for (const FloatFormat to : {format_of(4, 5), format_of(11, 5), format_of(24, 8)}) {
    for (Bits word = 0; word < 256; ++word) {
      const Rounded result = golden::convert({to}, e4m3, word);
      EXPECT_EQ(to_hex(result.bits, to.width()), to_hex(converted(to, e4m3, word), to.width()))
          << to.name() << ", word " << to_hex(word, 8);
      EXPECT_EQ(result.exceptional, word == 0x7f || word == 0xff) << to_hex(word, 8);
    }
  }
}

TEST(Arithmetic, ConvertsLikeTheMachine) {
  const Machine<float, std::uint32_t> narrow{format_of(24, 8)};
  const Machine<double, std::uint64_t> wide{format_of(53, 11)};
  std::mt19937_64 random(4);
  for (int trial = 0; trial < 200'000 && !HasFailure(); ++trial) {
    const Bits a = random_encoding(wide.format, random);
    const Bits single = random_encoding(narrow.format, random);
    EXPECT_EQ(golden::convert({narrow.format}, wide.format, a).bits,
              narrow.bits(static_cast<float>(wide.real(a))));
    EXPECT_EQ(golden::convert({wide.format}, narrow.format, single).bits,
              wide.bits(static_cast<double>(narrow.real(single))));
  }
}

TEST(Arithmetic, LeavesTheThreadsExponentRangeAsItWas) {
  const FloatFormat format = format_of(24, 8);
  golden::multiply({format}, format, 3, format.pack(false, 100, 5));
  const Arithmetic wide{format_of(113, 15)};
  const Bits huge = wide.format.largest_finite(false);
  EXPECT_FALSE(golden::convert(wide, wide.format, huge).exceptional);
}

TEST(Rationals, RoundOnceAtEveryMidpointOfASmallFormat) {
  const FloatFormat format = format_of(4, 3);
  const mpq_class nudge(1, 1'000'000);
  for (Bits low = 0; low < format.largest_finite(false); ++low) {
    const mpq_class below = golden::to_rational(format, low);
    const mpq_class above = golden::to_rational(format, low + 1);
    const mpq_class middle = (below + above) / 2;
    EXPECT_EQ(golden::from_rational(format, below), low);
    EXPECT_EQ(golden::from_rational(format, middle - nudge), low);
    EXPECT_EQ(golden::from_rational(format, middle), low % 2 == 0 ? low : low + 1);
    EXPECT_EQ(golden::from_rational(format, middle + nudge), low + 1);
  }
}

TEST(Rationals, AgreeWithIntegers) {
  std::mt19937_64 random(5);
  for (const FloatFormat format : {format_of(4, 3), format_of(24, 5), format_of(53, 8)}) {
    for (int trial = 0; trial < 20'000; ++trial) {
      mpq_class value(mpz_class(random() >> random() % 64),
                      mpz_class((random() >> random() % 64) | 1));
      value.canonicalize();
      if (random() % 2 != 0) value = -value;
      EXPECT_EQ(golden::from_rational(format, value),
                integer_float::from_rational({format}, value).bits)
          << value << " in " << format.name();
    }
  }
}

}  // namespace
}  // namespace mixcmp::test::arithmetic_test
