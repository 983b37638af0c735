#include "model/judge/golden/evaluate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>

#include "model/base/number/decimal.hpp"
#include "model/base/number/verdict.hpp"
#include "model/judge/golden/enclosure.hpp"
#include "model/lane/error/profiled_lane.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/graphs.hpp"

namespace mixcmp::test::evaluate_test {
namespace {

using error::Lane;
using error::UlpDistanceCriterion;
using golden::evaluate;
using golden::evaluate_lane;
using golden::evaluate_reference;
using golden::LaneResult;
using golden::Rounded;
using golden::true_verdict;

const FloatFormat binary64 = format_of(53, 11);

std::vector<Bits> encode(FloatFormat format, const std::vector<std::string>& values) {
  std::vector<Bits> inputs;
  for (const std::string& value : values) inputs.push_back(from_text(format, value).value());
  return inputs;
}

double real(Bits bits) {
  const auto word = static_cast<std::uint64_t>(bits);
  double value;
  std::memcpy(&value, &word, sizeof value);
  return value;
}

TEST(Evaluate, ComputesAsTheMachineDoes) {
  const Graph graph = graph_of("min(sqrt(abs(a * b)) / (c + 0.1), -a - b)", "max(a^2, c) - b");
  const TypedGraph typed = reference_graph(graph, {binary64});
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 1'000; ++trial) {
    const double a = normal(random), b = normal(random), c = normal(random);
    std::vector<Bits> inputs;
    for (const double value : {a, b, c}) {
      inputs.push_back(golden::from_rational(binary64, mpq_class(value)));
    }
    const std::vector<Rounded> values = evaluate(typed, inputs);
    EXPECT_EQ(real(values[typed.f()].bits),
              std::fmin(std::sqrt(std::fabs(a * b)) / (c + 0.1), -a - b));
    EXPECT_EQ(real(values[typed.g()].bits), std::fmax(a * a, c) - b);
  }
}

TEST(Evaluate, RoundsConstantsFromTheirValuesNotAsTheVerilogDoes) {
  TypedGraph typed = reference_graph(graph_of("a", "0.1"), {binary64});
  typed.nodes[typed.g()].constant += 1;  // a wrong literal
  const std::vector<Rounded> values = evaluate(typed, encode(binary64, {"1"}));
  EXPECT_EQ(real(values[typed.g()].bits), 0.1);
}

TEST(Evaluate, ChangesSignsOfNansAndInfinitiesAndSaysSo) {
  const TypedGraph typed = reference_graph(graph_of("-a", "abs(a)"), {binary64});
  const auto f_and_g = [&](Bits a) {
    const std::vector<Rounded> values = evaluate(typed, std::vector<Bits>{a});
    return std::pair(values[typed.f()], values[typed.g()]);
  };
  const Bits nan = binary64.quiet_nan(), sign = binary64.zero(true);
  EXPECT_EQ(f_and_g(nan), std::pair(Rounded{nan | sign, true}, Rounded{nan, true}));
  EXPECT_EQ(f_and_g(binary64.infinity(true)), std::pair(Rounded{binary64.infinity(false), true},
                                                        Rounded{binary64.infinity(false), true}));
  EXPECT_EQ(f_and_g(sign), std::pair(Rounded{0, false}, Rounded{0, false}));
  EXPECT_EQ(f_and_g(1), std::pair(Rounded{sign | 1, false}, Rounded{1, false}));
}

/// Compares two inputs that the lane holds exactly, by a chosen criterion.
LaneResult decide(const UlpDistanceCriterion& criterion, Bits a, Bits b,
                  Subnormals subnormals = Subnormals::gradual,
                  std::vector<error::RangeCheck> checks = {}) {
  const FloatFormat format = format_of(4, 4);
  const Arithmetic arithmetic{format, Rounding::nearest_even, subnormals};
  const Lane lane =
      error::one_part_lane(lane_graph(graph_of("a", "b"), format, arithmetic, LaneInputs::rounded),
                           criterion, std::move(checks));
  return evaluate_lane(lane, std::vector<Bits>{a, b});
}

TEST(UlpDistance, DecidesFromTheGuardOn) {
  const UlpDistanceCriterion guard{.guard_ulp = 3, .nonnegative = false};
  EXPECT_FALSE(decide(guard, 40, 40).decided);
  EXPECT_FALSE(decide(guard, 42, 40).decided);
  EXPECT_FALSE(decide(guard, 40, 42).decided);
  EXPECT_TRUE(decide(guard, 43, 40).decided);
  EXPECT_EQ(decide(guard, 43, 40).verdict, Verdict::greater);
  EXPECT_TRUE(decide(guard, 40, 43).decided);
  EXPECT_EQ(decide(guard, 40, 43).verdict, Verdict::less);
}

TEST(UlpDistance, AddsMagnitudesAcrossZero) {
  const Bits sign = format_of(4, 4).zero(true);
  const UlpDistanceCriterion guard{.guard_ulp = 3, .nonnegative = false};
  EXPECT_FALSE(decide(guard, 1, sign | 1).decided);
  EXPECT_TRUE(decide(guard, 2, sign | 1).decided);
  EXPECT_EQ(decide(guard, 2, sign | 1).verdict, Verdict::greater);
  EXPECT_EQ(decide(guard, sign | 1, 2).verdict, Verdict::less);
  EXPECT_EQ(decide(guard, sign | 43, sign | 40).verdict, Verdict::less);
  EXPECT_TRUE(decide(guard, sign | 40, sign | 43).decided);
  EXPECT_EQ(decide(guard, sign | 40, sign | 43).verdict, Verdict::greater);
}

TEST(UlpDistance, DecidesEqualityWithoutAGuard) {
  const Bits sign = format_of(4, 4).zero(true);
  const UlpDistanceCriterion exact{.guard_ulp = 0, .nonnegative = false};
  for (const auto& [a, b] : {std::pair<Bits, Bits>{40, 40}, {0, sign}, {sign, 0}}) {
    EXPECT_TRUE(decide(exact, a, b).decided);
    EXPECT_EQ(decide(exact, a, b).verdict, Verdict::equal);
  }
}

TEST(UlpDistance, IsNeverDecidedWhereSomethingIsExceptional) {
  const FloatFormat format = format_of(4, 4);
  const UlpDistanceCriterion exact{.guard_ulp = 0, .nonnegative = false};
  EXPECT_FALSE(decide(exact, format.infinity(false), 40).decided);
  EXPECT_FALSE(decide(exact, 40, format.quiet_nan()).decided);
  EXPECT_FALSE(decide(exact, 40, 1, Subnormals::flush).decided);
  EXPECT_TRUE(decide(exact, 40, 1, Subnormals::gradual).decided);
}

TEST(UlpDistance, IsNeverDecidedWhereAnInputBreaksItsRange) {
  const Bits sign = format_of(4, 4).zero(true);
  const UlpDistanceCriterion exact{.guard_ulp = 0, .nonnegative = false};
  const auto decided = [&](Bits a, Bits b) {
    const auto second = error::sign_check(1, error::RequiredSign::nonnegative);
    return decide(exact, a, b, Subnormals::gradual, {second}).decided;
  };
  EXPECT_TRUE(decided(sign | 40, 40));
  EXPECT_FALSE(decided(40, sign | 40));
  EXPECT_FALSE(decided(40, sign));
}

/// The decision by equations 1-3 with f = a and g = b; both constants are 1/8 by default.
LaneResult decide_by_interval(const std::string& a, const std::string& b,
                              const mpq_class& relative_error_f = mpq_class(1, 8)) {
  const FloatFormat format = format_of(8, 6);
  TypedGraph typed = lane_graph(graph_of("a", "b"), format, {format}, LaneInputs::rounded);
  const Lane lane = error::profiled_lane(typed, relative_error_f, mpq_class(1, 8));
  return evaluate_lane(lane, encode(format, {a, b}));
}

/// The largest number is 255/128 * 2^31.
TEST(IntervalCriterion, DecidesNothingWithAConstantBeyondTheFormat) {
  const mpq_class largest = mpq_class(mpz_class(255) << 24);
  EXPECT_TRUE(decide_by_interval("1e-7", "-1e7", largest).decided);
  EXPECT_FALSE(decide_by_interval("1e-7", "-1e7", largest + 1).decided);
}

TEST(IntervalCriterion, DecidesOutsideTheError) {
  EXPECT_FALSE(decide_by_interval("8", "8").decided);
  EXPECT_FALSE(decide_by_interval("9", "8").decided);  // |D| = 1, E = 9/8 + 8/8
  EXPECT_FALSE(decide_by_interval("7", "9").decided);  // |D| = 2 = E
  EXPECT_TRUE(decide_by_interval("12", "8").decided);
  EXPECT_EQ(decide_by_interval("12", "8").verdict, Verdict::greater);
  EXPECT_TRUE(decide_by_interval("8", "12").decided);
  EXPECT_EQ(decide_by_interval("8", "12").verdict, Verdict::less);
  EXPECT_EQ(decide_by_interval("-12", "-8").verdict, Verdict::less);
  EXPECT_EQ(decide_by_interval("1", "-1").verdict, Verdict::greater);
}

TEST(IntervalCriterion, IsOpenForNans) {
  EXPECT_FALSE(decide_by_interval("nan", "8").decided);
  EXPECT_FALSE(decide_by_interval("inf", "inf").decided);
}

/// 1 / -0 is -infinity though a root is "never negative": D - E is a NaN, D + E is negative.
TEST(IntervalCriterion, IsOpenWhereOneBoundIsANan) {
  const FloatFormat format = format_of(8, 6);
  const Lane lane = error::profiled_lane(
      lane_graph(graph_of("1 / sqrt(a)", "b"), format, {format}, LaneInputs::rounded),
      mpq_class(1, 8), mpq_class(1, 8));
  EXPECT_FALSE(evaluate_lane(lane, encode(format, {"-0", "1"})).decided);
  EXPECT_TRUE(evaluate_lane(lane, encode(format, {"4", "1"})).decided);
}

TEST(Reference, OrdersWhatItComputed) {
  const TypedGraph typed = reference_graph(graph_of("a + b", "c"), {binary64});
  const auto verdict = [&](const std::vector<std::string>& values) {
    return evaluate_reference(typed, encode(binary64, values));
  };
  EXPECT_EQ(verdict({"1", "1e-30", "1"}), Verdict::equal) << "as computed, not as in truth";
  EXPECT_EQ(verdict({"1", "1", "1"}), Verdict::greater);
  EXPECT_EQ(verdict({"-1", "1", "-0"}), Verdict::equal);
  EXPECT_EQ(verdict({"inf", "1", "inf"}), Verdict::equal);
  EXPECT_EQ(verdict({"inf", "-inf", "1"}), Verdict::unordered);
}

std::optional<Verdict> truth(const std::string& f, const std::string& g,
                             const std::vector<std::string>& values) {
  return true_verdict(graph_of(f, g), binary64, encode(binary64, values));
}

/// Checks that the interval of few digits contains that of many, and that neither is empty.
void expect_nested(const golden::Interval& outer, const golden::Interval& inner) {
  EXPECT_TRUE(mpfr_lessequal_p(outer.low.get(), inner.low.get()));
  EXPECT_TRUE(mpfr_lessequal_p(inner.low.get(), inner.high.get()));
  EXPECT_TRUE(mpfr_lessequal_p(inner.high.get(), outer.high.get()));
}

TEST(Enclosure, ContainsTheEnclosureOfMoreDigits) {
  std::mt19937_64 random(2);
  for (const char* f :
       {"sqrt(a) * sqrt(b)", "-sqrt(a) * sqrt(b)", "sqrt(a) * -sqrt(b)", "-sqrt(a) * -sqrt(b)",
        "sqrt(a) / sqrt(b)", "-sqrt(a) / sqrt(b)", "sqrt(a) / -sqrt(b)", "-sqrt(a) / -sqrt(b)",
        "abs(sqrt(a))", "abs(-sqrt(a))", "(sqrt(a) - sqrt(b))^2", "abs(sqrt(a) * sqrt(a) - a)",
        "(sqrt(a) * sqrt(a) - a) * (sqrt(b) * sqrt(b) - b)", "sqrt(sqrt(a) + 0.1)",
        "sqrt(a) - sqrt(b)", "min(sqrt(a), -sqrt(b))", "max(a / 3, b / 7)"}) {
    const Graph graph = graph_of(f, "0.1");
    golden::Enclosure few(graph, 128), many(graph, 1024);
    for (int trial = 0; trial < 100; ++trial) {
      std::vector<Bits> inputs(graph.inputs().size());
      for (Bits& input : inputs) input = binary64.magnitude(random_encoding(binary64, random));
      if (few.compute(binary64, inputs) != golden::Knowledge::enclosed) continue;
      ASSERT_EQ(many.compute(binary64, inputs), golden::Knowledge::enclosed);
      expect_nested(few.f(), many.f());
      expect_nested(few.g(), many.g());
      ASSERT_FALSE(HasFailure()) << f;
    }
  }
}

TEST(TrueVerdict, SeesThroughRounding) {
  EXPECT_EQ(truth("a + b", "c", {"1", "1e-30", "1"}), Verdict::greater);
  EXPECT_EQ(truth("a + b", "c", {"1e300", "-1e-300", "1e300"}), Verdict::less);
  EXPECT_EQ(truth("0.1 + 0.2", "a", {"0.3"}), Verdict::greater) << "0.3 is written, a is rounded";
  EXPECT_EQ(truth("a * b", "c", {"1e-300", "1e-300", "0"}), Verdict::greater) << "no underflow";
}

TEST(TrueVerdict, SeesTheSmallestNumberBesideTheLargest) {
  const FloatFormat wide = FloatFormat::make(24, 15).value();
  const std::vector<Bits> ends = {1, wide.largest_finite(false)};
  EXPECT_EQ(true_verdict(graph_of("a + b", "b"), wide, ends), Verdict::greater);
  EXPECT_EQ(true_verdict(graph_of("a + b^2", "b^2"), wide, ends), Verdict::greater);
}

TEST(TrueVerdict, KnowsEquality) {
  EXPECT_EQ(truth("a^2 + b^2", "c^2", {"3", "-4", "5"}), Verdict::equal);
  EXPECT_EQ(truth("sqrt(a)", "b", {"9", "3"}), Verdict::equal);
  EXPECT_EQ(truth("a / b", "c", {"1", "4", "0.25"}), Verdict::equal);
  EXPECT_EQ(truth("a", "b", {"0", "-0"}), Verdict::equal);
  EXPECT_EQ(truth("1 / 3", "a / b", {"1", "3"}), Verdict::equal) << "at the last precision";
}

TEST(TrueVerdict, EnclosesEveryOperationOnEverySign) {
  EXPECT_EQ(truth("abs(a)", "b", {"-2", "1.5"}), Verdict::greater);
  EXPECT_EQ(truth("-a", "b", {"-2", "1.5"}), Verdict::greater);
  EXPECT_EQ(truth("min(a, b)", "max(a, b)", {"-2", "1.5"}), Verdict::less);
  EXPECT_EQ(truth("(a / 3)^2", "b", {"-3", "1"}), Verdict::equal);
  EXPECT_EQ(truth("(a / 3 - b)^2", "c", {"0.3", "0.1", "1e-30"}), Verdict::less);
  EXPECT_EQ(truth("abs(a / 3 - b)", "c", {"-0.3", "0.1", "0.19"}), Verdict::greater);
  EXPECT_EQ(truth("a / 3 * (b / 7)", "c", {"-1", "1", "-0.047"}), Verdict::less);
  EXPECT_EQ(truth("(a / 3) / (b / 7)", "c", {"-1", "-1", "2.3"}), Verdict::greater);
  EXPECT_EQ(truth("sqrt(a) * sqrt(a)", "b", {"2", "2.0000000000000004"}), Verdict::less);
}

TEST(TrueVerdict, IsUnorderedWhereThereIsNoRealValue) {
  EXPECT_EQ(truth("a", "b", {"nan", "1"}), Verdict::unordered);
  EXPECT_EQ(truth("a", "b", {"1", "-inf"}), Verdict::unordered);
  EXPECT_EQ(truth("1 / a", "b", {"-0", "1"}), Verdict::unordered);
  EXPECT_EQ(truth("1 / (a - b)", "b", {"1", "1"}), Verdict::unordered);
  EXPECT_EQ(truth("sqrt(a)", "b", {"-1e-300", "1"}), Verdict::unordered);
  EXPECT_EQ(truth("sqrt(a / 3 - 2 * a / 3)", "b", {"1", "1"}), Verdict::unordered);
  EXPECT_EQ(truth("1 / (a / 3 - 2 * a / 6)", "b", {"1", "1"}), Verdict::unordered)
      << "a divisor that is zero but never certainly so";
}

TEST(TrueVerdict, IgnoresWhatFAndGDoNotNeed) {
  Graph graph = graph_of("a", "1");
  graph.apply(Operation::square_root, graph.apply(Operation::negate, graph.f()));
  EXPECT_EQ(true_verdict(graph, binary64, encode(binary64, {"2"})), Verdict::greater);
}

}  // namespace
}  // namespace mixcmp::test::evaluate_test
