#include "model/lane/function/taylor.hpp"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "model/base/number/dyadic.hpp"
#include "tests/support/function_values.hpp"

/// Tests enclosures of Taylor coefficients against divided differences of values by MPFR.
namespace mixcmp::test::taylor_test {
namespace {

using function::Interval;
using function::taylor;

constexpr int count = 8;

/// Steps of divided differences. Each costs so many digits of the next difference, and the
/// differences are off by about one step.
constexpr int step_exponent = -250;
constexpr int value_digits = 2500;

/// f^(k)(x) / k! for k = 0 .. count - 1, to about 2^-200.
std::vector<mpq_class> divided_differences(const Function& function, const mpq_class& x) {
  const mpq_class step = power_of_two(step_exponent);
  std::vector<mpq_class> differences;
  for (int k = 0; k < count; ++k) {
    differences.push_back(value_at(function, x + k * step, value_digits).low);
  }
  for (std::size_t order = 1; order < count; ++order) {
    for (std::size_t k = count - 1; k >= order; --k) {
      differences[k] = (differences[k] - differences[k - 1]) / (static_cast<int>(order) * step);
    }
  }
  return differences;
}

std::vector<Function> functions_and_formulas() {
  std::vector<Function> all = tested_functions();
  for (const Function& formula : tested_formulas()) all.push_back(formula);
  return all;
}

/// Dyadic numbers at which every function has a value.
const std::array<mpq_class, 9> points = {mpq_class(1, 1024), mpq_class(1, 8), mpq_class(3, 4),
                                         mpq_class(1),       mpq_class(5, 4), mpq_class(25, 16),
                                         mpq_class(13, 8),   mpq_class(5),    mpq_class(77, 4)};

/// And numbers below 0.
std::vector<mpq_class> points_of(const Function& function) {
  std::vector<mpq_class> all(points.begin(), points.end());
  const Domain accepted = domain(function);
  for (const mpq_class& point : points) {
    if (accepted.contains(-point)) all.push_back(-point);
  }
  if (!accepted.low || accepted.low->at < 0) all.emplace_back(0);
  return all;
}

mpq_class magnitude_of(const mpq_class& value) {
  return std::max<mpq_class>(1, abs(value));
}

TEST(Taylor, OfPointsIsThatOfDividedDifferences) {
  for (const Function& function : functions_and_formulas()) {
    for (const mpq_class& x : points_of(function)) {
      const std::vector<Interval> series = taylor(function, Interval(x), count);
      const std::vector<mpq_class> expected = divided_differences(function, x);
      ASSERT_EQ(series.size(), expected.size());
      for (std::size_t k = 0; k < count; ++k) {
        const Range found = series[k].range();
        const mpq_class off = magnitude_of(expected[k]) * power_of_two(-140);
        EXPECT_TRUE(expected[k] - off < found.low && found.high < expected[k] + off)
            << to_string(function) << "(" << x << "), coefficient " << k;
      }
    }
  }
}

TEST(Taylor, OfPointsStartsWithTheValue) {
  for (const Function& function : functions_and_formulas()) {
    for (const mpq_class& x : points_of(function)) {
      const Range found = taylor(function, Interval(x), 1).front().range();
      const Range value = value_at(function, x);
      EXPECT_TRUE(found.low <= value.low && value.high <= found.high) << to_string(function);
      EXPECT_LE(found.high - found.low, magnitude_of(value.low) * power_of_two(-185));
    }
  }
}

/// Widths of a 16th and 1; sine and cosine have their extremes inside some.
TEST(Taylor, OfIntervalsEnclosesThatOfEachPoint) {
  for (const Function& function : functions_and_formulas()) {
    for (const mpq_class& low : points_of(function)) {
      for (const mpq_class& width : {mpq_class(1, 16), mpq_class(1)}) {
        const Range range = {low, low + width};
        const std::vector<Interval> series = taylor(function, Interval(range), count);
        for (const int part : {0, 1, 4}) {
          const mpq_class x = low + width * part / 4;
          const std::vector<mpq_class> expected = divided_differences(function, x);
          for (std::size_t k = 0; k < count; ++k) {
            if (!series[k].is_bounded()) continue;
            const Range found = series[k].range();
            const mpq_class off = magnitude_of(expected[k]) * power_of_two(-140);
            ASSERT_TRUE(found.low <= expected[k] + off && expected[k] - off <= found.high)
                << to_string(function) << " on [" << range.low << ", " << range.high
                << "], coefficient " << k << " at " << x;
          }
        }
      }
    }
  }
}

TEST(Taylor, OfIntervalsInsideTheDomainIsBounded) {
  for (const Function& function : functions_and_formulas()) {
    for (const Range& range : {Range{mpq_class(1, 1024), 1},
                               {mpq_class(-7, 8), mpq_class(-1, 8)},
                               {-1, 1},
                               {mpq_class(13, 8), 4},
                               {-30, -29}}) {
      if (!domain(function).contains(range.low)) continue;
      if (function == Function::tan && range.low < -29) continue;  // a pole: -19 pi / 2
      for (const Interval& coefficient : taylor(function, Interval(range), count)) {
        EXPECT_TRUE(coefficient.is_bounded()) << to_string(function) << range.low << range.high;
      }
    }
  }
}

/// The hull of parts is narrower than what one interval gives, and holds all coefficients.
TEST(Taylor, OfAFormulaIsTakenInParts) {
  const Function formula = parsed_formula("x * exp(-x^2 / 2)");
  const Range whole = {-4, 4};
  const std::vector<Interval> at_once = taylor(formula, Interval(whole), 2);
  const std::vector<Interval> in_parts = function::taylor_on(formula, whole, 2);
  EXPECT_LT(in_parts[1].range().high - in_parts[1].range().low, mpq_class(8, 5));  // -0.45 to 1
  EXPECT_GT(at_once[1].range().high - at_once[1].range().low, 10);
  for (mpq_class x = -4; x < 4; x += mpq_class(1, 37)) {
    const std::vector<Interval> here = taylor(formula, Interval(x), 2);
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_LE(in_parts[k].range().low, here[k].range().low);
      EXPECT_GE(in_parts[k].range().high, here[k].range().high);
    }
  }
}

/// Either all coefficients have a bound or none has, since callers look at only one of them.
TEST(Taylor, OfIntervalsBeyondTheDomainIsUnbounded) {
  const auto expect_unbounded = [](const Function& function, const Range& range) {
    for (const int terms : {1, 2, count}) {
      for (const Interval& coefficient : taylor(function, Interval(range), terms)) {
        EXPECT_FALSE(coefficient.is_bounded())
            << to_string(function) << " on [" << range.low << ", " << range.high << "]";
      }
    }
  };
  for (const Function function : {Function::log, Function::log2}) {
    for (const Range& range : {Range{0, 1}, {-1, 1}, {-2, -1}, {0, 0}, {-1, 0}}) {
      expect_unbounded(function, range);
    }
  }
  for (const Range& range : {Range{-1, 1}, {-3, 1}, {-3, -2}, {-1, -1}, {-2, -1}}) {
    expect_unbounded(Function::log1p, range);
  }
  for (const Range& range : {Range{1, 2},
                             {-2, -1},
                             {-4, 4},
                             {4, 5},
                             {0, 100},
                             {10, 13},
                             {mpq_class(25, 16), mpq_class(101, 64)}}) {
    expect_unbounded(Function::tan, range);
  }
}

/// MPFR has exponents of 30 bits and more. A rational number of 2^30 digits would fill memory.
TEST(Taylor, OfLargeArgumentsHasShortEnds) {
  const mpq_class far = power_of_two(29), least = power_of_two(-Interval::most_exponent);
  for (const Function function : {Function::exp, Function::exp2, Function::sinh, Function::cosh}) {
    EXPECT_FALSE(function::value(function, Interval(Range{0, far})).is_bounded());
    EXPECT_FALSE(function::value(function, Interval(far)).is_bounded());
  }
  EXPECT_FALSE(function::value(Function::sinh, Interval(mpq_class(-far))).is_bounded());
  for (const Function function : {Function::exp, Function::exp2}) {
    EXPECT_EQ(function::value(function, Interval(mpq_class(-far))).range(), (Range{0, least}));
    const Interval values = function::value(function, Interval(Range{-far, 0}));
    EXPECT_TRUE(values.is_bounded());
    EXPECT_EQ(values.range(), (Range{0, 1}));
    const Interval negative = Interval(0) - values;
    EXPECT_EQ(negative.range(), (Range{-1, 0}));
    EXPECT_EQ((Interval(0) - function::value(function, Interval(mpq_class(-far)))).range(),
              (Range{-least, 0}));
  }
  const Interval edge(least);
  EXPECT_EQ(edge.range(), (Range{least, least}));
  EXPECT_FALSE(Interval(power_of_two(Interval::most_exponent)).is_bounded());
  EXPECT_TRUE(Interval(power_of_two(Interval::most_exponent - 1)).is_bounded());
}

/// atan(1 / x) and 1 / (1 / x) have bounded values around 0, but not all of their operations do.
TEST(Taylor, OfFormulasIsUnboundedWhereAnOperationIs) {
  for (const char* text : {"atan(1 / a)", "1 / (1 / a)", "exp(-1 / a^2)"}) {
    const Function function = parsed_formula(text);
    for (const Interval& each : taylor(function, Interval(Range{-1, 1}), 3)) {
      EXPECT_FALSE(each.is_bounded()) << text;
    }
    EXPECT_FALSE(value(function, Interval(Range{0, 1})).is_bounded()) << text;
    EXPECT_TRUE(value(function, Interval(Range{1, 2})).is_bounded()) << text;
  }
}

}  // namespace
}  // namespace mixcmp::test::taylor_test
