#include <fmt/core.h>
#include <gtest/gtest.h>

#include <optional>
#include <random>
#include <string>

#include "model/base/number/dyadic.hpp"
#include "model/lane/function/piecewise.hpp"
#include "model/lane/function/taylor.hpp"
#include "tests/support/function_values.hpp"

/// Tests piecewise polynomials of 17 to 24 bits against values by MPFR: at all neighbours of the
/// ends of pieces, and at MIXCMP_SAMPLES random arguments for each function and width.
namespace mixcmp::test::sampled_test {
namespace {

using function::Piecewise;

constexpr int value_digits = 120;

/// The arguments of docs/make_function_errors, of which a lane takes W bits.
Range range_of(Function::Kind function) {
  switch (function) {
    case Function::expm1:
    case Function::tan: return {-1, 1};
    case Function::log:
    case Function::log2: return {mpq_class(1, 16), 16};
    case Function::log1p: return {mpq_class(-1, 2), 1};
    case Function::atan: return {-8, 8};
    default: return {-4, 4};
  }
}

class Sampled : public testing::TestWithParam<std::tuple<Function::Kind, int>> {
protected:
  Sampled() {
    const auto [function, bits] = GetParam();
    const Range range = range_of(function);
    const mpq_class most = absolute(range).high;
    const int top = static_cast<int>(floor_log2(most));
    const bool is_signed = range.low < 0;
    format_ = {bits + (is_signed ? 1 : 0), top - bits, is_signed};
    least_ = floor_of(range.low / format_.unit());
    greatest_ = std::min(floor_of(range.high / format_.unit()), format_.largest());
    if (least_ < format_.smallest()) least_ = format_.smallest();
  }

  /// In the finest unit of W bits or a coarser one for which a table has enough words.
  std::optional<Piecewise> made() const {
    const auto [function, bits] = GetParam();
    const Range values = function::value(function, function::Interval(range_of(function))).range();
    const int finest = static_cast<int>(floor_log2(absolute(values).high)) + 1 - bits;
    for (int unit = finest; unit < finest + 8; ++unit) {
      auto found = function::approximate(function, {format_}, least_, greatest_, unit);
      if (found) return found;
    }
    return std::nullopt;
  }

  void expect_right(const Piecewise& piecewise, const mpz_class& x) {
    const Function function = std::get<0>(GetParam());
    if (x < least_ || x > greatest_) return;
    ++checked_;
    const mpq_class computed = function::evaluate(piecewise, x) * piecewise.result.unit();
    const Range truth = value_at(function, x * format_.unit(), value_digits);
    ASSERT_TRUE(computed - truth.low >= piecewise.error.low &&
                computed - truth.high <= piecewise.error.high)
        << to_string(function) << " of " << x << " in " << format_.name() << " is off by "
        << mpq_class(computed - truth.low).get_d();
  }

  FixedFormat format_;
  mpz_class least_, greatest_;
  std::uint64_t checked_ = 0;
};

TEST_P(Sampled, ArgumentsHaveResultsWithinTheError) {
  const auto piecewise = made();
  ASSERT_TRUE(piecewise);
  // Pieces in floating point end at powers of two as well; those are ends of pieces in fixed point.
  const mpz_class code_span = shifted_left(1, piecewise->piece_bits);
  std::uint64_t ends = 0;
  for (mpz_class x = least_; x <= greatest_ && !HasFatalFailure();) {
    mpz_class next;  // the first argument of the next piece
    if (piecewise->is_floating) {
      const function::FloatingCode code{format_.width};
      const mpz_class from = (code.of(x) / code_span + 1) * code_span;
      const mpz_class field = from >> static_cast<mp_bitcnt_t>(code.fraction_bits());
      const mpz_class hidden = shifted_left(1, code.fraction_bits());
      const int exponent = static_cast<int>(field.get_si()) - code.offset();
      next = ceiling_of(scaled(mpq_class(hidden + from % hidden), exponent - code.fraction_bits()));
    } else {
      next = (floor_of(mpq_class(x) / code_span) + 1) * code_span;
    }
    for (int near = -2; near <= 1; ++near) expect_right(*piecewise, next + near);
    x = next;
    ++ends;
  }
  EXPECT_GE(ends, 2U);
  std::mt19937_64 random(static_cast<unsigned>(std::get<1>(GetParam())));
  const mpz_class span = greatest_ - least_ + 1;
  for (int k = 0; k < MIXCMP_SAMPLES && !HasFatalFailure(); ++k) {
    expect_right(*piecewise, least_ + mpz_class(random() >> 1) % span);
  }
  EXPECT_GT(checked_, MIXCMP_SAMPLES + ends);
}

INSTANTIATE_TEST_SUITE_P(Functions, Sampled,
                         testing::Combine(testing::ValuesIn(all_functions),
                                          testing::Values(17, 20, 24)),
                         [](const auto& tested) {
                           return fmt::format("{}_{}", to_string(std::get<0>(tested.param)),
                                              std::get<1>(tested.param));
                         });

}  // namespace
}  // namespace mixcmp::test::sampled_test
