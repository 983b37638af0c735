#include "model/lane/fixed/formulas.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "model/base/number/double.hpp"
#include "model/base/number/dyadic.hpp"
#include "model/comparison/expression/formula.hpp"
#include "model/comparison/expression/text.hpp"
#include "model/judge/golden/fixed_evaluate.hpp"
#include "model/judge/proof/function_structure.hpp"
#include "model/lane/fixed/logarithms.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/function_comparisons.hpp"
#include "tests/support/function_values.hpp"
#include "tests/support/graphs.hpp"

/// Which operations become one table, and which products sums of logarithms.
namespace mixcmp::test::formulas_test {
namespace {

using fixed::FixedLane;
using Texts = std::vector<std::string>;

/// The lane of f against z, the last input.
FixedLane lane_of(const std::string& f, std::vector<Range> ranges, int bits = 13) {
  ranges.push_back({-1024, 1024});
  const FunctionComparison comparison = {"", {{f, "z"}}, std::move(ranges)};
  return comparison.lane(format_of(24, 8), bits).value();
}

/// The functions of a lane, in the order of its nodes.
Texts functions_of(const FixedLane& lane) {
  Texts texts;
  const auto functions = proof::functions_of(lane);
  for (const proof::FunctionNodes& each : *functions) {
    texts.push_back(applied_text(*lane.nodes[each.result].function, "x"));
  }
  return texts;
}

TEST(Formulas, AreOneTable) {
  EXPECT_EQ(functions_of(lane_of("1 / (1 + exp(-a))", {{-4, 4}})), Texts{"1 / (exp(-x) + 1)"});
  EXPECT_EQ(functions_of(lane_of("3 * sin((a - b) / 2)^2 + 1", {{0, 2}, {0, 2}})),
            Texts{"sin(x * 0.5)^2 * 3 + 1"});
  EXPECT_EQ(functions_of(lane_of("a * exp(-a^2)", {{0, 2}})), Texts{"x * exp(-x^2)"});
  EXPECT_EQ(functions_of(lane_of("sqrt(a^2 + 1)", {{0, 2}})), Texts{"sqrt(x^2 + 1)"});
}

TEST(Formulas, EndAtWhatTheyDoNotHold) {
  EXPECT_EQ(functions_of(lane_of("exp(abs(a))^2", {{-2, 2}})), Texts{"exp(x)^2"});
  EXPECT_EQ(functions_of(lane_of("exp(within(a^2, 0, 2))", {{-2, 2}})), Texts{"exp(x)"});
  EXPECT_EQ(functions_of(lane_of("log(1 + exp(a) * b)", {{-2, 2}, {0, 1}})),
            (Texts{"exp(x)", "log(x + 1)"}));
}

TEST(Formulas, AreNotMadeOfOneFunctionOrRoot) {
  for (const char* f :
       {"exp(-a / 3 + 1)", "sqrt(a)", "a^2 + a", "sqrt(2 * a + 1) - 3", "1 / a", "sqrt(2) * a"}) {
    EXPECT_FALSE(fixed::with_formulas(graph_of(f, "b"), {Range{1, 2}, Range{1, 2}})) << f;
  }
}

/// 1 / ((a - 1)^2 + 10^-9) has too large a table; sin(b)^2 has one of its own nevertheless.
TEST(Formulas, WithoutATableLeaveTheOthers) {
  const FixedLane lane =
      lane_of("sin(a)^2 + exp(b) / (1e-9 + (exp(b) - 2)^2) / 1e9", {{0, 2}, {0, 1}}, 13);
  EXPECT_EQ(functions_of(lane).front(), "sin(x)^2");
  EXPECT_GT(functions_of(lane).size(), 2U);
}

/// They are keys of tables that were made before.
TEST(Formulas, AreEqualIfAllOfThemIs) {
  const auto with_domain = [](const char* f, std::optional<Range> arguments) {
    Formula formula = parsed_formula(f).expression();
    formula.arguments = std::move(arguments);
    return Function::of_formula(std::move(formula));
  };
  const std::vector<Function> different = {
      with_domain("exp(a) + 1", {}),          with_domain("exp(a) + 2", {}),
      with_domain("exp(a) - 1", {}),          with_domain("exp2(a) + 1", {}),
      with_domain("exp(a) + 1 + a", {}),      with_domain("exp(a) + 1", Range{0, 1}),
      with_domain("exp(a) + 1", Range{0, 2}), with_domain("exp(a) + 1", Range{1, 2}),
  };
  for (std::size_t i = 0; i < different.size(); ++i) {
    for (std::size_t k = 0; k < different.size(); ++k) {
      EXPECT_EQ(different[i] == different[k], i == k) << i << ", " << k;
      EXPECT_EQ(different[i]<different[k], different[k]> different[i]) << i << ", " << k;
    }
  }
  EXPECT_EQ(with_domain("exp(a) + 1", Range{0, 1}), with_domain("exp(a) + 1", Range{0, 1}));
}

const Function& function_at(const Graph& graph, NodeId id) {
  return *graph.nodes()[static_cast<std::size_t>(id)].function;
}

TEST(Formulas, ReadASharedTable) {
  const auto formulas =
      fixed::with_formulas(graph_of("b * exp(a)", "1 / (1 + exp(a))"), {Range{0, 1}, Range{0, 1}});
  ASSERT_TRUE(formulas);
  EXPECT_EQ(to_text(*formulas, formulas->f(), 60), "b * exp(a)");
  EXPECT_EQ(applied_text(function_at(*formulas, formulas->g()), "x"), "1 / (x + 1)");
  const NodeId argument = formulas->nodes()[static_cast<std::size_t>(formulas->g())].operands[0];
  EXPECT_EQ(function_at(*formulas, argument), Function::exp);
}

/// Without them the logarithm is a function by itself, of the formula 1 - exp(-a).
TEST(Formulas, NeedRangesForWhatMayHaveNoValue) {
  const Graph graph = graph_of("log(1 - exp(-a))", "b");
  const auto outermost = [&](const std::optional<Range>& range) {
    const auto formulas = fixed::with_formulas(graph, {range, Range{0, 1}});
    return function_at(*formulas, formulas->f()).kind();
  };
  EXPECT_EQ(outermost(Range{0, 1}), Function::log);
  EXPECT_EQ(outermost(std::nullopt), Function::log);
  EXPECT_EQ(outermost(Range{1, 2}), Function::formula);
  EXPECT_TRUE(fixed::with_formulas(graph_of("sin(a)^2", "b"), {}));
}

/// Whether a lane of f(a) against z decides the comparison with a large z.
bool decides(const FixedLane& lane, double a) {
  const FloatFormat format = format_of(24, 8);
  const std::vector<Bits> operands = {from_double(format, a), from_double(format, 1000)};
  return golden::evaluate_lane(lane, operands).decided;
}

/// The lane's format has numbers below 1/2, down to 0, which has no value.
TEST(Formulas, LeaveWhatIsBeyondTheirDomainUndecided) {
  const FixedLane lane = lane_of("log(1 - exp(-a))", {{mpq_class(1, 2), 8}});
  ASSERT_EQ(functions_of(lane).size(), 1U);
  EXPECT_TRUE(decides(lane, 0.5));
  EXPECT_TRUE(decides(lane, 7.75));
  EXPECT_FALSE(decides(lane, 0));
  EXPECT_FALSE(decides(lane, 0x1p-20));
}

/// (a - 1)^1.5 has no value below 1, though interval arithmetic has a bound there.
TEST(Formulas, HaveADomainEvenWhereIntervalsAreBounded) {
  const FixedLane lane = lane_of("(a - 1)^1.5 + sin(a)", {{mpq_class(3, 2), 8}});
  ASSERT_EQ(functions_of(lane).size(), 1U);
  EXPECT_TRUE(decides(lane, 1.5));
  EXPECT_TRUE(decides(lane, 7.75));
  EXPECT_FALSE(decides(lane, 0.75));
  EXPECT_FALSE(decides(lane, 0));
}

/// The argument counts units of 2^(4 - 13), and the slope is 1/4 at most.
TEST(Formulas, ErrByTheArgumentsRoundingAndOneTable) {
  const FixedLane lane = lane_of("1 / (1 + exp(-a))", {{-8, 8}});
  const auto functions = proof::functions_of(lane);
  const Range& error = lane.nodes[functions->front().result].error;
  EXPECT_LT(absolute(error).high, power_of_two(4 - 13) / 4 + power_of_two(-11));
}

TEST(Formulas, AreWrittenAsTheExpressionsThatTheyStandFor) {
  const auto text = [](const char* f) {
    const Graph graph = graph_of(f, "c");
    const std::vector<std::optional<Range>> ranges(graph.inputs().size(), Range{1, 2});
    const auto formulas = fixed::with_formulas(graph, ranges);
    return to_text(*formulas, formulas->f(), 200);
  };
  EXPECT_EQ(text("exp(a - b)^2 + 1"), "exp(a - b)^2 + 1");
  EXPECT_EQ(text("(a - b) * exp(a - b)"), "(a - b) * exp(a - b)");
  EXPECT_EQ(text("a * sin(cos(a - b))"), "a * sin(cos(a - b))");
  EXPECT_EQ(text("b + 1 / (1 + exp(abs(sin(a)^2 + 1)))"), "b + 1 / (1 + exp(abs(sin(a)^2 + 1)))");
}

TEST(Logarithms, AreAddedWhereFactorsSpanManyBinades) {
  const Range wide = {mpq_class(1, 1024), 1024};
  EXPECT_EQ(functions_of(lane_of("exp(-a / b)", {wide, wide})),
            (Texts{"log2(x)", "log2(x)", "exp(-exp2(x))"}));
  EXPECT_EQ(functions_of(lane_of("atan(a^2 * sqrt(b) / 5)", {wide, wide})),
            (Texts{"log2(x) * 2", "log2(x) * 0.5", "atan(exp2(x) * 0.2)"}));
  EXPECT_EQ(functions_of(lane_of("exp(-a / b)", {{1, 2}, {1, 2}})), (Texts{"x^-1", "exp(x)"}));
}

TEST(Logarithms, OfProductsAreSums) {
  const Range wide = {mpq_class(1, 1024), 1024};
  EXPECT_EQ(functions_of(lane_of("log(a^2 / b)", {wide, wide})), (Texts{"log(x) * 2", "log(x)"}));
  EXPECT_EQ(functions_of(lane_of("log(3 * a / b)", {wide, wide})),
            (Texts{"log2(x)", "log2(x)", "log(exp2(x) * 3)"}));
}

/// Logarithms help the second part, and leave the first as it is.
TEST(Logarithms, AreAddedForOnePartOfTwo) {
  const Range wide = {mpq_class(1, 1024), 1024};
  const FunctionComparison comparison = {
      "", {{"c", "d"}, {"atan(a^2 * sqrt(b) / 50)", "d"}}, {{0, 1}, {0, 1}, wide, wide}};
  EXPECT_EQ(functions_of(comparison.lane(format_of(24, 8), 14).value()),
            (Texts{"log2(x) * 2", "log2(x) * 0.5", "atan(exp2(x) * 0.02)"}));
}

/// With logarithms this lane errs 0.81 times as much, which is not worth three tables.
TEST(Logarithms, AreNotAddedForALittleLessError) {
  EXPECT_EQ(functions_of(lane_of("atan(a * b / 5000)", {{1, 1024}, {1, 1024}})),
            Texts{"atan(x / 5000)"});
}

/// The product of integers is exact.
TEST(Logarithms, AreNotAddedWhereFactorsErrLess) {
  const FunctionComparison comparison = {"",
                                         {{"atan(a * b / 50000)", "c"}},
                                         {{1, 1023}, {1, 1023}, {0, 2}},
                                         {"uint10", "uint10", "q1.8"}};
  EXPECT_EQ(functions_of(comparison.lane(format_of(24, 8), 13).value()), Texts{"atan(x / 50000)"});
}

/// log(a / b) would become log(a) - log(b), whose limits have no number in common with its own.
TEST(Logarithms, LeaveWhatHasOtherLimits) {
  const Range wide = {mpq_class(1, 1024), 1024};
  const Graph graph = graph_of("within(log(a / b), -1, 0)", "within(log(a) - log(b), 0.5, 1)");
  EXPECT_FALSE(fixed::with_logarithms(graph, {wide, wide}));
}

/// A factor that cancels still needs a value: 0 / 0 has none.
TEST(Logarithms, AreNotAddedOfWhatCancels) {
  const Range wide = {mpq_class(1, 1024), 1024};
  const std::vector<std::optional<Range>> ranges = {wide, wide, wide};
  EXPECT_TRUE(fixed::with_logarithms(graph_of("exp(a * b * c)", "1"), ranges));
  EXPECT_FALSE(fixed::with_logarithms(graph_of("exp(a * b / c * c)", "1"), ranges));
  EXPECT_FALSE(fixed::with_logarithms(graph_of("exp(a * b / (a * b))", "c"), ranges));
}

TEST(Logarithms, AreOfNumbersAboveZero) {
  const Range wide = {mpq_class(1, 1024), 1024};
  const Graph graph = graph_of("exp(-a * b)", "c");
  EXPECT_TRUE(fixed::with_logarithms(graph, {wide, wide, wide}));
  EXPECT_FALSE(fixed::with_logarithms(graph, {wide, Range{0, 1024}, wide}));
  EXPECT_FALSE(fixed::with_logarithms(graph, {wide, Range{-1, 1024}, wide}));
  EXPECT_FALSE(fixed::with_logarithms(graph, {wide, std::nullopt, wide}));
  EXPECT_FALSE(fixed::with_logarithms(graph_of("a * b", "c"), {wide, wide, wide}));
  EXPECT_FALSE(fixed::with_logarithms(graph_of("exp(a^2)", "c"), {wide, wide}));
}

/// As written, a / b errs by more than its whole range.
TEST(Logarithms, ErrLittleOverManyDecades) {
  const Range decades = {mpq_class(1, 1000000), 1000000};
  const FixedLane lane = lane_of("exp(-a / b)", {decades, decades}, 17);
  const auto functions = proof::functions_of(lane);
  EXPECT_LT(absolute(lane.nodes[functions->back().result].error).high, power_of_two(-9));
}

}  // namespace
}  // namespace mixcmp::test::formulas_test
