#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <optional>

#include "model/base/number/decimal.hpp"
#include "model/base/number/dyadic.hpp"
#include "model/comparison/expression/typed_graph.hpp"
#include "model/judge/golden/arithmetic.hpp"
#include "tests/support/fused_operands.hpp"
#include "tests/support/integer_float.hpp"

/// Tests fused sums of the golden model against integers, and against their bound by exact
/// rationals.
namespace mixcmp::test::fused_sum_test {
namespace {

using golden::FusedOperands;
using golden::Rounded;
using Terms = std::vector<FusedOperands>;

std::string describe(const Arithmetic& result, const Terms& terms) {
  const FloatFormat format = result.format;
  std::string text = fmt::format("{} {} {}:", format.name(), to_string(result.rounding),
                                 to_string(result.subnormals));
  for (const auto& [a, b, negated] : terms) {
    text += fmt::format(" {} {} * {}", negated ? "-" : "+", to_text(format, a), to_text(format, b));
  }
  return text;
}

bool is_finite(FloatFormat format, Bits bits) {
  return !format.is_nan(bits) && !format.is_infinite(bits);
}

Bits one(FloatFormat format) {
  return format.pack(false, format.bias(), 0);
}

/// The exact sum of terms, and the most that cuts take from it by theorem 12 of
/// docs/error_bounds.md.
struct ExactSum {
  mpq_class value;
  mpq_class cut;
};

/// The exact sum; none if an operand is not finite, or if the theorem does not cover the
/// arithmetic.
std::optional<ExactSum> exact_sum(const Arithmetic& result, const Terms& terms) {
  const FloatFormat format = result.format;
  if (result.rounding != Rounding::nearest_even || result.subnormals != Subnormals::gradual) {
    return std::nullopt;
  }
  mpq_class value = 0, magnitudes = 0;
  for (const auto& [a, b, negated] : terms) {
    if (!is_finite(format, a) || !is_finite(format, b)) return std::nullopt;
    const mpq_class product = golden::to_rational(format, a) * golden::to_rational(format, b);
    value += negated ? mpq_class(-product) : product;
    magnitudes += abs(product);
  }
  const mpq_class share = power_of_two(-format.precision()) / 32;
  return ExactSum{value,
                  share * std::max<mpq_class>(magnitudes, power_of_two(format.min_exponent()))};
}

void expect_within_bound(const Arithmetic& result, const Terms& terms, Bits y) {
  const FloatFormat format = result.format;
  const std::optional<ExactSum> exact = exact_sum(result, terms);
  if (!exact || !is_finite(format, y)) return;
  const mpq_class u = power_of_two(-format.precision());
  const mpq_class smallest = power_of_two(format.min_exponent() - format.fraction_bits());
  const mpq_class bound =
      std::max<mpq_class>(u * (abs(exact->value) + exact->cut), smallest / 2) + exact->cut;
  if (abs(golden::to_rational(format, y) - exact->value) <= bound) return;
  ADD_FAILURE() << describe(result, terms) << " gives " << to_text(format, y);
}

/// Checks that the verdict is that of integers, and that of the exact sum if the sum is further
/// from zero than the cuts.
void judge_comparison(const Arithmetic& result, const Terms& terms) {
  const Verdict got = golden::fused_comparison(result, result.format, terms);
  const Verdict expected = integer_float::fused_comparison(result, result.format, terms);
  EXPECT_EQ(got, expected) << describe(result, terms);
  const std::optional<ExactSum> exact = exact_sum(result, terms);
  if (!exact || abs(exact->value) <= exact->cut) return;
  EXPECT_EQ(got, exact->value < 0 ? Verdict::less : Verdict::greater) << describe(result, terms);
}

void judge(const Arithmetic& result, const Terms& terms) {
  const Rounded got = golden::fused_sum(result, result.format, terms);
  const Rounded expected = integer_float::fused_sum(result, result.format, terms);
  if (got != expected) {
    ADD_FAILURE() << describe(result, terms) << "\n  expected "
                  << to_text(result.format, expected.bits) << " " << expected.exceptional
                  << ", got " << to_text(result.format, got.bits) << " " << got.exceptional;
  }
  expect_within_bound(result, terms, got.bits);
  judge_comparison(result, terms);
}

/// Judges sums of two products, of three squares, and of a product between two plain terms.
void judge_shapes(const Arithmetic& result, const FusedOperandMaker::Operands& x) {
  const Bits unit = one(result.format);
  judge(result, {{x[0], x[1]}, {x[2], x[3], true}});
  judge(result, {{x[0], x[0]}, {x[1], x[1]}, {x[2], x[2]}});
  judge(result, {{x[2], unit}, {x[0], x[1], true}, {x[3], unit, true}});
}

/// A quarter of the operands, in every arithmetic.
class FusedSum : public testing::TestWithParam<std::uint64_t> {
public:
  static constexpr std::uint64_t quarters = 4;

protected:
  static void judge_every_tuple(FloatFormat format, int operands) {
    const Bits count = Bits{1} << format.width();
    FusedOperandMaker maker(format, 1);
    Bits tuples = 1;
    for (int k = 0; k < operands; ++k) tuples *= count;
    for (const Arithmetic& result : every_arithmetic(format)) {
      for (Bits tuple = 0; tuple < tuples && !HasFailure(); ++tuple) {
        FusedOperandMaker::Operands x = maker.next();
        Bits rest = tuple;
        for (int k = 0; k < operands; ++k, rest /= count) x[k] = rest % count;
        if ((x[0] + x[1]) % quarters == GetParam()) judge_shapes(result, x);
      }
    }
  }
};

TEST_P(FusedSum, AgreesWithIntegersOnEveryFourOperandsOfS2e2) {
  judge_every_tuple(format_of(2, 2), 4);
}

TEST_P(FusedSum, AgreesWithIntegersOnEveryTwoOperandsOfS4e4) {
  judge_every_tuple(format_of(4, 4), 2);
}

TEST_P(FusedSum, AgreesWithIntegersInWideFormats) {
  for (const FloatFormat format : {format_of(11, 5), format_of(24, 8), format_of(53, 8),
                                   format_of(53, 11), format_of(113, 15)}) {
    FusedOperandMaker maker(format, 2);
    for (const Arithmetic& result : every_arithmetic(format)) {
      for (Bits trial = 0; trial < 10'000 && !HasFailure(); ++trial) {
        const FusedOperandMaker::Operands x = maker.next();
        if (trial % quarters == GetParam()) judge_shapes(result, x);
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Quarters, FusedSum, testing::Range<std::uint64_t>(0, FusedSum::quarters));

class FusedSumOfS8e6 : public testing::Test {
protected:
  const FloatFormat format_ = format_of(8, 6);

  Bits number(const mpq_class& value) const {
    const Bits bits = golden::from_rational(format_, value);
    EXPECT_EQ(golden::to_rational(format_, bits), value);
    return bits;
  }
  Bits sum(const Terms& terms) const { return golden::fused_sum({format_}, format_, terms).bits; }
};

TEST_F(FusedSumOfS8e6, RoundsOnceWhereComposedArithmeticRoundsTwice) {
  // 129 * 129 = 16641 is 64 above a number of 8 digits, half a unit in the last place: 16640 + 1.
  const Bits a = number(129), ulp = number(1);
  const Bits product = golden::square({format_}, format_, a).bits;
  EXPECT_EQ(golden::to_rational(format_, product), 16640);
  // 16640 + 64 is a tie, and the 1 that the square has lost decides it.
  const Bits tie = number(64);
  EXPECT_EQ(golden::to_rational(format_, golden::add({format_}, format_, product, tie).bits),
            16640);
  EXPECT_EQ(golden::to_rational(format_, sum({{a, a}, {tie, ulp}})), 16768);
}

TEST_F(FusedSumOfS8e6, IsComparedWithZeroBeforeItIsRounded) {
  const auto order = [&](const Terms& terms) {
    return golden::fused_comparison({format_}, format_, terms);
  };
  // 129 * 129 = 16641, which eight digits round to 16640.
  const Bits a = number(129), b = number(16640), unit = number(1);
  EXPECT_EQ(golden::square({format_}, format_, a).bits, b);
  EXPECT_EQ(order({{a, a}, {b, unit, true}}), Verdict::greater);
  EXPECT_EQ(order({{a, a}, {b, unit, true}, {unit, unit, true}}), Verdict::equal);
  EXPECT_EQ(order({{a, a, true}, {b, unit}}), Verdict::less);
  const Bits infinity = format_.infinity(false);
  EXPECT_EQ(order({{a, a}, {infinity, unit, true}}), Verdict::less);
  EXPECT_EQ(order({{infinity, unit}, {infinity, unit, true}}), Verdict::unordered);
}

TEST_F(FusedSumOfS8e6, TiesGoToEven) {
  const Bits unit = number(1);
  EXPECT_EQ(sum({{number(16), number(16)}, {unit, unit}}), number(256));
  EXPECT_EQ(sum({{number(258), unit}, {unit, unit}}), number(260));
}

TEST_F(FusedSumOfS8e6, CancelsExactly) {
  const Bits a = number(255), b = number(253), c = number(254), unit = number(1);
  EXPECT_EQ(sum({{a, b}, {c, c, true}}), number(-1));
  EXPECT_EQ(sum({{a, b}, {a, b, true}}), format_.zero(false));
  EXPECT_EQ(sum({{a, b}, {unit, unit}, {c, c, true}}), format_.zero(false));
}

TEST_F(FusedSumOfS8e6, HasTheSignsOfIeee754) {
  const Bits up = format_.zero(false), down = format_.zero(true), unit = number(1);
  EXPECT_EQ(sum({{down, unit}, {down, unit}}), down);
  EXPECT_EQ(sum({{down, unit}, {up, unit}}), up);
  EXPECT_EQ(sum({{up, unit, true}, {down, down, true}}), down);
  // -2^-60 is below half of the smallest subnormal number, 2^-37.
  const Bits tiny = number(power_of_two(-30));
  EXPECT_EQ(sum({{tiny, tiny, true}, {down, unit}}), down);
  EXPECT_EQ(sum({{tiny, tiny, true}, {up, unit}}), up);
}

TEST_F(FusedSumOfS8e6, FollowsInfinitiesAndNans) {
  const Bits infinite = format_.infinity(false), unit = number(1), zero = format_.zero(false);
  const Bits nan = format_.quiet_nan();
  EXPECT_EQ(sum({{infinite, unit, true}, {unit, unit}}), format_.infinity(true));
  EXPECT_EQ(sum({{infinite, unit, true}, {infinite, unit}}), nan);
  EXPECT_EQ(sum({{infinite, zero}, {unit, unit}}), nan);
  EXPECT_EQ(sum({{nan, zero}, {unit, unit}}), nan);
  EXPECT_EQ(sum({{infinite, infinite}, {infinite, unit}}), infinite);
}

TEST_F(FusedSumOfS8e6, OverflowsOnceOnly) {
  // Each of the two products overflows by itself; their difference does not.
  const Bits large = number(power_of_two(30)), factor = number(4), less = number(mpq_class(7, 2));
  EXPECT_EQ(sum({{large, factor}, {large, less, true}}), number(power_of_two(29)));
}

}  // namespace
}  // namespace mixcmp::test::fused_sum_test
