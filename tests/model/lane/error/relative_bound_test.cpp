#include <gtest/gtest.h>

#include "model/base/number/exact.hpp"
#include "model/lane/error/error_analysis.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/graphs.hpp"
#include "tests/support/sphere.hpp"

namespace mixcmp::test::relative_bound_test {
namespace {

using error::Lane;
using error::NodeBound;
using error::RelativeBound;

const FloatFormat reference = format_of(53, 8);

struct Setting {
  LaneInputs inputs = LaneInputs::exact;
  Rounding rounding = Rounding::nearest_even;
  Subnormals subnormals = Subnormals::flush;
  int precision = 17;
  std::vector<bool> nonnegative = {};
};

Result<Lane> certify(const Graph& graph, Setting setting) {
  const Arithmetic arithmetic{format_of(setting.precision, 8), setting.rounding,
                              setting.subnormals};
  setting.nonnegative.resize(graph.inputs().size(), false);
  return relative_lane(lane_graph(graph, reference, arithmetic, setting.inputs),
                       setting.nonnegative);
}

/// The bound of f that is known in a lane.
NodeBound bound_of(const std::string& f, Setting setting) {
  const Graph graph = graph_of(f, "0");
  const Arithmetic arithmetic{format_of(setting.precision, 8), setting.rounding,
                              setting.subnormals};
  setting.nonnegative.resize(graph.inputs().size(), false);
  const auto typed = lane_graph(graph, reference, arithmetic, setting.inputs);
  return error::analyse_errors(typed, setting.nonnegative).nodes[typed.f()];
}

std::vector<int> checked_inputs(const Lane& lane) {
  std::vector<int> inputs;
  for (const error::RangeCheck& check : lane.checks) inputs.push_back(check.input);
  return inputs;
}

mpq_class power(const mpq_class& base, int exponent) {
  return exponent == 0 ? mpq_class(1) : mpq_class(base * power(base, exponent - 1));
}

mpq_class unit(int precision) {
  return mpq_class(1, mpz_class(1) << precision);
}

/// Expects f's relative bound t to be [low, high].
void expect_bound(const std::string& f, const Setting& setting, const mpq_class& low,
                  const mpq_class& high) {
  const NodeBound bound = bound_of(f, setting);
  ASSERT_TRUE(bound.relative) << f << ": " << bound.reason;
  EXPECT_EQ(bound.relative->low, low) << f;
  EXPECT_EQ(bound.relative->high, high) << f;
}

TEST(RelativeBound, CountsTheRoundingsOfEachOperation) {
  const mpq_class u = unit(17);
  const mpq_class down = 1 - u, up = 1 + u;
  expect_bound("a", {}, down, up);
  expect_bound("a - b", {}, down, up);
  expect_bound("a + b", {}, down, up);
  expect_bound("(a - b)^2", {}, power(down, 3), power(up, 3));
  expect_bound("(a - b) * (c + d)", {}, power(down, 3), power(up, 3));
  expect_bound("(a - b) / (c + d)", {}, down / up * down, up / down * up);
  expect_bound("a^2 + (b - c)^2", {}, power(down, 4), power(up, 4));
  expect_bound("max(a^2, (b - c)^2)", {}, power(down, 3), power(up, 3));
  expect_bound("-abs(a * b)", {}, down, up);
  expect_bound("a * b", {.inputs = LaneInputs::rounded}, power(down, 3), power(up, 3));
}

/// Each operand has the relative error of one rounding to its own digits.
TEST(RelativeBound, CountsTheRoundingOfInputsToTheirDigits) {
  const mpq_class u = unit(17), v = unit(20);
  const Setting of_20{.inputs = LaneInputs::of_digits(20)};
  expect_bound("a * b", of_20, power(1 - v, 2) * (1 - u), power(1 + v, 2) * (1 + u));
  expect_bound("a", of_20, 1 - u, 1 + u);
  const mpq_class up = 1 + 2 * u, far = 1 + 2 * v;
  expect_bound("a * b", {.inputs = LaneInputs::of_digits(20), .rounding = Rounding::toward_zero}, 1,
               far * far * up);
}

TEST(RelativeBound, IsOneSidedTowardZero) {
  const mpq_class up = 1 + 2 * unit(17);
  const Setting toward_zero{.rounding = Rounding::toward_zero};
  expect_bound("(a - b)^2", toward_zero, 1, power(up, 3));
  expect_bound("a^2 / (b - c)^2", toward_zero, 1 / power(up, 3), up * up);
}

TEST(RelativeBound, IsExactWhereNothingIsRounded) {
  const Setting wide{.precision = 106};
  expect_bound("a", wide, 1, 1);
  expect_bound("a * b", wide, 1, 1);
  expect_bound("a^2", wide, 1, 1);
  expect_bound("-min(abs(a), b)", wide, 1, 1);
  expect_bound("2 * max(a * b, c)", {.precision = 106}, 1, 1);
  const mpq_class u = unit(17);
  expect_bound("(a - b)^2 / 4", {}, power(1 - u, 3), power(1 + u, 3));
  expect_bound("0.125 * (a - b)^2", {}, power(1 - u, 3), power(1 + u, 3));
  expect_bound("3 * (a - b)^2", {}, power(1 - u, 4), power(1 + u, 4));
}

/// Operands of three digits, in lanes of fewer digits and of more.
TEST(RelativeBound, IsExactOnlyWhereAllDigitsOfAResultAreKept) {
  const auto is_exact = [](const std::string& f, int digits) {
    const auto typed =
        lane_graph(graph_of(f, "0"), format_of(3, 8), {format_of(digits, 8)}, LaneInputs::exact);
    const std::vector<bool> nonnegative(static_cast<std::size_t>(typed.input_count), false);
    return error::is_exact(*error::analyse_errors(typed, nonnegative).nodes[typed.f()].relative);
  };
  EXPECT_FALSE(is_exact("a^2", 5)) << "7^2 = 49 has six digits";
  EXPECT_TRUE(is_exact("a^2", 6));
  EXPECT_FALSE(is_exact("a * b", 5));
  EXPECT_TRUE(is_exact("a * b", 6));
  EXPECT_FALSE(is_exact("2 * a", 2)) << "2 * 7 has three digits";
  EXPECT_TRUE(is_exact("2 * a", 3));
  EXPECT_FALSE(is_exact("a / 4", 2));
  EXPECT_TRUE(is_exact("a / 4", 3));
}

TEST(RelativeBound, ReplacesAConstantByItsEncoding) {
  const mpq_class u = unit(17);
  const mpq_class written(1, 10);
  const mpq_class encoded = to_rational(format_of(17, 8), from_rational(format_of(17, 8), written));
  ASSERT_NE(encoded, written);
  const mpq_class ratio = written / encoded;
  expect_bound("0.1 * (a - b)", {}, ratio * power(1 - u, 2), ratio * power(1 + u, 2));
}

TEST(RelativeBound, EnclosesASquareRootOutward) {
  const mpq_class u = unit(17);
  const NodeBound bound = bound_of("sqrt(a - b)", {.precision = 17});
  ASSERT_TRUE(bound.unrounded);
  const mpq_class low = bound.unrounded->low, high = bound.unrounded->high;
  const mpq_class hair(1, mpz_class(1) << 250);
  EXPECT_LE(low * low, 1 - u);
  EXPECT_GE(high * high, 1 + u);
  EXPECT_GT((low + hair) * (low + hair), 1 - u);
  EXPECT_LT((high - hair) * (high - hair), 1 + u);
}

TEST(RelativeBound, NeedsEqualSignsForSumsOfRoundedOperands) {
  const mpq_class u = unit(17);
  for (const char* sum : {"a^2 + b^2", "a^2 - -(b^2)", "-(a^2) - b^2", "-(a^2) + -sqrt(b)",
                          "abs(a - b) + max(a - b, c^2)", "min(-(a^2), b) - c^2",
                          "(a^2) * (b^2) + (-(a^2)) / (-(b^2))"}) {
    EXPECT_TRUE(bound_of(sum, {}).relative) << sum;
  }
  for (const char* sum : {"a^2 - b^2", "a * b + c^2", "min(a * b, c^2) + c^2", "a^3 + b^2",
                          "max(-(a^2), b) - c^2", "a^2 + b^2 / c", "(a - b) + c", "a - 0.1"}) {
    EXPECT_FALSE(bound_of(sum, {}).relative) << sum;
  }
  expect_bound("-(a^2) - b^2", {}, power(1 - u, 2), power(1 + u, 2));
}

TEST(RelativeBound, TakesSignsFromRangesAndSaysWhich) {
  const Graph graph = graph_of("a * b + c", "d^2");
  const auto lane = certify(graph, {.nonnegative = {true, true, true, true}});
  ASSERT_TRUE(lane.ok());
  EXPECT_EQ(checked_inputs(*lane), (std::vector<int>{0, 1, 2}));
  EXPECT_TRUE(certified_decision(*lane).nonnegative);
  EXPECT_FALSE(certify(graph, {.nonnegative = {true, false, true, true}}).ok());
}

TEST(RelativeBound, ChecksNoSignThatTheProofDoesNotNeed) {
  const auto sphere = certify(sphere_graph(), {.nonnegative = std::vector<bool>(8, true)});
  EXPECT_TRUE(sphere->checks.empty());
  EXPECT_TRUE(certified_decision(*sphere).nonnegative);
  const auto product = certify(graph_of("a * b", "c"), {.nonnegative = {true, true, true}});
  EXPECT_TRUE(product->checks.empty());
  EXPECT_FALSE(certified_decision(*product).nonnegative) << "nobody checks the signs";
}

TEST(CertifiedLane, CountsOnMagnitudesOnlyWhereNoSideIsNegative) {
  const auto of_magnitudes = [](const std::string& f, const std::string& g) {
    return certified_decision(certify(graph_of(f, g), {}).value()).nonnegative;
  };
  EXPECT_TRUE(of_magnitudes("a^2", "abs(b)"));
  EXPECT_FALSE(of_magnitudes("a^2", "b"));
  EXPECT_FALSE(of_magnitudes("b", "a^2"));
}

TEST(CertifiedLane, GuardsTheFactorThatARunningBoundLeavesOut) {
  const auto guard = [](const std::string& f) {
    const auto graph =
        lane_graph(graph_of(f, "d"), reference, {format_of(8, 8)}, LaneInputs::exact);
    const std::vector<std::optional<Range>> ranges(static_cast<std::size_t>(graph.input_count));
    const Lane lane =
        error::certified_lane(graph, {.kind = BoundKind::running, .ranges = ranges}).value();
    return std::get<error::AbsoluteBoundCriterion>(lane.criterion()).guard_ulp;
  };
  EXPECT_GE(guard("(a * b - c)^2"), Bits{1}) << "the error of a * b, times one rounding";
  EXPECT_EQ(guard("a"), Bits{0});
}

TEST(CertifiedLane, NamesTheOperationAndWhatHelps) {
  const auto rounded = certify(sphere_graph(), {.inputs = LaneInputs::rounded});
  ASSERT_FALSE(rounded.ok());
  EXPECT_EQ(rounded.error().field, "reduced.error_bound");
  EXPECT_NE(rounded.error().message.find("difference cxi - cxj"), std::string::npos);
  EXPECT_NE(rounded.error().accepted.find("reduced.inputs = \"exact\""), std::string::npos);
  EXPECT_EQ(rounded.error().accepted.find("range"), std::string::npos);

  const auto sum = certify(graph_of("a * b + c^2", "d"), {});
  EXPECT_NE(sum.error().message.find("sum a * b + c^2"), std::string::npos);
  EXPECT_NE(sum.error().accepted.find("range"), std::string::npos);
  EXPECT_EQ(sum.error().accepted.find("\"exact\""), std::string::npos);
}

TEST(CertifiedLane, RefusesConstantsThatItsFormatLoses) {
  const auto message = [](const char* f, Subnormals subnormals) {
    const auto lane =
        certify(graph_of(f, "b^2"), {.inputs = LaneInputs::rounded, .subnormals = subnormals});
    return lane.ok() ? "" : lane.error().message;
  };
  EXPECT_NE(message("1e-60 * a^2", Subnormals::gradual).find("rounds to zero"), std::string::npos);
  EXPECT_NE(message("1e60 * a^2", Subnormals::gradual).find("overflows"), std::string::npos);
  EXPECT_NE(message("1e-39 * a^2", Subnormals::flush).find("subnormal"), std::string::npos);
  EXPECT_EQ(message("1e-39 * a^2", Subnormals::gradual), "");
}

/// value(key) of a positive encoding, for any key.
mpq_class value_of(FloatFormat format, Bits key) {
  return to_rational(format, key);
}

/// Theorem 2 and its converse, over all encodings: `steps` multiply by more than `ratio`, one fewer
/// does not.
TEST(GuardUlp, IsTheSmallestThatTheBoundsAllow) {
  const FloatFormat format = format_of(4, 4);
  for (int numerator = 33; numerator < 300; numerator += 7) {
    const mpq_class ratio(numerator, 32);
    const Bits guard = error::guard_ulp({1, 1}, {1, ratio}, format.precision());
    bool one_fewer_suffices = true;
    for (Bits g = 1; g + guard <= format.largest_finite(false); ++g) {
      EXPECT_GT(value_of(format, g + guard), ratio * value_of(format, g)) << ratio;
      one_fewer_suffices &= value_of(format, g + guard - 1) > ratio * value_of(format, g);
    }
    EXPECT_FALSE(one_fewer_suffices) << ratio;
  }
}

TEST(GuardUlp, IsSymmetricAndZeroForExactFunctions) {
  const RelativeBound exact, loose{mpq_class(9, 10), mpq_class(12, 10)};
  EXPECT_EQ(guard_ulp(exact, exact, 24), Bits{0});
  EXPECT_EQ(guard_ulp(exact, loose, 24), guard_ulp(loose, exact, 24));
  EXPECT_EQ(guard_ulp_before_rounding(exact, exact, 24), Bits{1});
}

TEST(GuardUlp, NeverDecidesWhereTheBoundsAreBeyondAnyFormat) {
  const mpq_class huge(mpz_class(1) << 40'000);
  EXPECT_EQ(error::guard_ulp({1, 1}, {1, huge}, 113), ~Bits{0});
  EXPECT_EQ(error::guard_ulp_before_rounding({1, 1}, {1, huge}, 113), ~Bits{0});
}

/// The bounds of x^80 and more are worth more steps than this narrow format has encodings.
TEST(GuardUlp, FitsTheWidthOfTheFormat) {
  const FloatFormat narrow = format_of(4, 2);
  for (const char* f : {"(x^5)^16", "(x^13)^16", "(((x^16)^16)^16)^16"}) {
    const Graph graph = graph_of(f, "y");
    const auto lane =
        relative_lane(lane_graph(graph, reference, {narrow}, LaneInputs::exact), {false, false});
    EXPECT_LE(certified_decision(*lane).guard_ulp, low_mask(narrow.width())) << f;
    EXPECT_GT(certified_decision(*lane).guard_ulp, 2 * narrow.largest_finite(false)) << f;
  }
}

TEST(CertifiedLane, NamesADivisorThatMayBeZero) {
  const auto typed =
      lane_graph(graph_of("a / (b - c)", "a"), reference, {format_of(17, 8)}, LaneInputs::exact);
  const std::vector<std::optional<Range>> ranges(3, Range{1, 4});
  const auto lane = error::certified_lane(typed, {.kind = BoundKind::constant, .ranges = ranges});
  ASSERT_FALSE(lane.ok());
  EXPECT_NE(lane.error().message.find("b - c may be zero"), std::string::npos);
  EXPECT_NE(lane.error().accepted.find("ranges that keep it away"), std::string::npos);
}

/// Each step squares the bound, and would double its digits if it were kept exactly.
TEST(CertifiedLane, GivesUpOnPowersOfPowers) {
  Graph graph;
  NodeId power = graph.input("x");
  for (int k = 0; k < 99; ++k) power = graph.apply(Operation::square, power);
  graph.compare(power, graph.input("y"));
  const auto lane = certify(graph, {});
  ASSERT_FALSE(lane.ok());
  EXPECT_NE(lane.error().message.find("out of bounds"), std::string::npos) << lane.error().message;
}

/// Past the digits that are kept, the bound still encloses the result of exact arithmetic.
TEST(RelativeBounds, OfLongProductsAreRoundedOutward) {
  const NodeBound bound = bound_of("((x^16)^16)^2", {});
  mpq_class low(131071, 131072), exact = 1;
  for (int k = 0; k < 511; ++k) exact *= low;
  EXPECT_LE(bound.relative->low, exact);
  EXPECT_GT(bound.relative->low, exact * (1 - mpq_class(1, mpz_class(1) << 400)));
  const mpq_class high(131073, 131072);
  EXPECT_GE(bound.relative->high, power(high, 511));
}

TEST(GuardUlp, OfTheSphereIsSeven) {
  for (const int precision : {8, 11, 17, 24, 32, 52}) {
    const auto lane = certify(sphere_graph(), {.precision = precision});
    EXPECT_EQ(certified_decision(*lane).guard_ulp, Bits{7}) << precision;
    const auto truncated =
        certify(sphere_graph(), {.rounding = Rounding::toward_zero, .precision = precision});
    EXPECT_LE(certified_decision(*truncated).guard_ulp, Bits{9}) << precision;
  }
}

Bits guard_of(const std::string& f, const std::string& g, Rounding rounding) {
  const Arithmetic reduced = {format_of(8, 8), rounding, Subnormals::flush};
  const auto lane =
      relative_lane(lane_graph(graph_of(f, g), format_of(24, 8), reduced, LaneInputs::rounded), {});
  return certified_decision(lane.value()).guard_ulp;
}

/// Rounding keeps order: a selection among rounded numbers is the rounding of the selected number.
TEST(GuardUlp, OfSelectionsOfRoundedInputsIsOneStep) {
  for (const auto rounding : {Rounding::nearest_even, Rounding::toward_zero}) {
    EXPECT_EQ(guard_of("a", "b", rounding), 1);
    EXPECT_EQ(guard_of("max(a, b)", "min(c, d)", rounding), 1);
    EXPECT_EQ(guard_of("-abs(min(a, -b))", "max(-c, abs(d))", rounding), 1);
    EXPECT_EQ(guard_of("max(a, 2)", "min(b, 0)", rounding), 1) << "constants of the format";
    EXPECT_GT(guard_of("max(a * b, c)", "d", rounding), 1);
    EXPECT_GT(guard_of("2 * (a * b)", "c", rounding), 1) << "what is rounded before is inexact";
  }
  EXPECT_EQ(guard_of("max(a, 0.3)", "b", Rounding::nearest_even), 1);
  EXPECT_GT(guard_of("max(a, 0.3)", "b", Rounding::toward_zero), 1)
      << "constants are encoded to nearest";
}

}  // namespace
}  // namespace mixcmp::test::relative_bound_test
