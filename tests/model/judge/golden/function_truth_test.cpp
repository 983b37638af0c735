#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "model/base/number/decimal.hpp"
#include "model/base/number/dyadic.hpp"
#include "model/base/number/exact.hpp"
#include "model/base/number/verdict.hpp"
#include "model/judge/golden/evaluate.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/function_values.hpp"
#include "tests/support/graphs.hpp"

/// Tests golden::true_verdict on functions: values that are exact, arguments without a value, ties
/// that are proven and those that stay undetermined.
namespace mixcmp::test::function_truth_test {
namespace {

using golden::true_verdict;

const FloatFormat binary64 = format_of(53, 11);

std::string truth(const std::string& f, const std::string& g,
                  const std::vector<std::string>& values) {
  std::vector<Bits> inputs;
  for (const std::string& value : values) inputs.push_back(from_text(binary64, value).value());
  return std::string(to_string(true_verdict(graph_of(f, g), binary64, inputs)));
}

TEST(FunctionTruth, KnowsExactValues) {
  for (const char* zero : {"0", "-0"}) {
    for (const char* f : {"sin(a)", "tan(a)", "atan(a)", "sinh(a)", "tanh(a)", "expm1(a)",
                          "log1p(a)", "log(1 - a)", "log2(a + 1)"}) {
      EXPECT_EQ(truth(f, "0", {zero}), "equal") << f;
      EXPECT_EQ(truth(f, "b", {zero, "4.9e-324"}), "less") << f;
      EXPECT_EQ(truth(f, "b", {zero, "-4.9e-324"}), "greater") << f;
    }
    for (const char* f : {"exp(a)", "exp2(a)", "cos(a)", "cosh(a)"}) {
      EXPECT_EQ(truth(f, "1", {zero}), "equal") << f;
      EXPECT_EQ(truth(f, "b", {zero, "0x1.0000000000001p0"}), "less") << f;
      EXPECT_EQ(truth(f, "b", {zero, "0x1.fffffffffffffp-1"}), "greater") << f;
    }
  }
  EXPECT_EQ(truth("exp2(a)", "8", {"3"}), "equal");
  EXPECT_EQ(truth("exp2(a)", "1 / 8", {"-3"}), "equal");
  EXPECT_EQ(truth("exp2(a)", "b", {"-1074", "4.9e-324"}), "equal");
  EXPECT_EQ(truth("log2(a)", "3", {"8"}), "equal");
  EXPECT_EQ(truth("log2(a)", "b", {"4.9e-324", "-1074"}), "equal");
  EXPECT_EQ(truth("exp(sin(a))", "cos(a)", {"0"}), "equal");
  EXPECT_EQ(truth("log(1)", "a", {"0"}), "equal");
}

/// The least number's exponential is the nearest to 1 of all operands'.
TEST(FunctionTruth, TellsValuesNextToExactOnes) {
  EXPECT_EQ(truth("exp(a)", "1", {"4.9e-324"}), "greater");
  EXPECT_EQ(truth("exp(a)", "1", {"-4.9e-324"}), "less");
  EXPECT_EQ(truth("expm1(a)", "a", {"4.9e-324"}), "greater");
  EXPECT_EQ(truth("log1p(a)", "a", {"4.9e-324"}), "less");
  EXPECT_EQ(truth("sin(a)", "a", {"4.9e-324"}), "less");
  EXPECT_EQ(truth("sin(a)", "a", {"-4.9e-324"}), "greater");
  EXPECT_EQ(truth("cos(a)", "1", {"4.9e-324"}), "less");
  EXPECT_EQ(truth("cosh(a)", "1", {"1e-300"}), "greater");
  EXPECT_EQ(truth("tan(a)", "atan(a)", {"1e-100"}), "greater");
  EXPECT_EQ(truth("log2(a)", "b", {"0x1.0000000000001p3", "3"}), "greater");
  EXPECT_EQ(truth("tanh(a)", "1", {"1000"}), "less");
  EXPECT_EQ(truth("exp(-a)", "0", {"1e6"}), "greater");
  EXPECT_EQ(truth("exp(a)", "exp(b)", {"1", "0x1.0000000000001p0"}), "less");
}

TEST(FunctionTruth, HasNoValueOutsideTheDomain) {
  for (const char* f : {"log(a)", "log2(a)", "log1p(a - 1)", "exp(log(a))"}) {
    for (const char* a : {"0", "-0", "-4.9e-324", "-1", "-1e300", "inf", "-inf", "nan"}) {
      EXPECT_EQ(truth(f, "b", {a, "1"}), "unordered") << f << " of " << a;
    }
    EXPECT_EQ(truth(f, "b", {"4.9e-324", "1"}), "less") << f;
  }
  EXPECT_EQ(truth("log1p(a)", "b", {"-1", "1"}), "unordered");
  EXPECT_EQ(truth("log(a - b)", "b", {"0.1", "0.1"}), "unordered");
  EXPECT_EQ(truth("log(sqrt(a)^2 - a)", "b", {"0.1", "1"}), "unordered");
  EXPECT_EQ(truth("log(exp(a) - exp(b))", "b", {"0.1", "0.1"}), "unordered");
  EXPECT_EQ(truth("exp(a)", "1", {"inf"}), "unordered");
}

/// Doubles are never at a pole or at another zero.
TEST(FunctionTruth, KnowsLargeAnglesAndThoseNextToPoles) {
  EXPECT_EQ(truth("tan(a)", "1e16", {"0x1.921fb54442d18p0"}), "greater");
  EXPECT_EQ(truth("tan(a)", "-1e15", {"0x1.921fb54442d19p0"}), "less");
  EXPECT_EQ(truth("sin(a)", "0", {"0x1.921fb54442d18p1"}), "greater");
  EXPECT_EQ(truth("sin(a)", "-0.9", {"1e22"}), "greater");
  EXPECT_EQ(truth("sin(a)", "-0.8", {"1e22"}), "less");  // sin(1e22) = -0.852
  EXPECT_EQ(truth("cos(a)^2 + sin(a)^2", "1.0000001", {"1e300"}), "less");
  EXPECT_EQ(truth("abs(sin(a))", "1e-18", {"0x1.6ac5b262ca1ffp849"}), "greater");
}

TEST(FunctionTruth, OfAnglesIsThatOfAllQuadrants) {
  const auto angle = [](const char* y, const char* x, const char* other) {
    return truth("atan2(a, b)", other, {y, x});
  };
  EXPECT_EQ(angle("1", "1", "0.785398163397448"), "greater");  // pi / 4
  EXPECT_EQ(angle("1", "1", "0.785398163397449"), "less");
  EXPECT_EQ(angle("1", "-1", "2.356194490192344"), "greater");  // 3 pi / 4
  EXPECT_EQ(angle("1", "-1", "2.356194490192346"), "less");
  EXPECT_EQ(angle("-1", "-1", "-2.356194490192346"), "greater");
  EXPECT_EQ(angle("-1", "-1", "-2.356194490192344"), "less");
  EXPECT_EQ(angle("-1e-300", "1e300", "0"), "less");
  EXPECT_EQ(angle("-1e-300", "-1e300", "-3.14"), "less");
  EXPECT_EQ(angle("0", "-2", "3.14159265358979"), "greater");
  EXPECT_EQ(angle("0", "-2", "3.14159265358980"), "less");
  EXPECT_EQ(angle("-5", "0", "-1.570796326794897"), "greater");
  EXPECT_EQ(angle("-5", "0", "-1.570796326794896"), "less");
  EXPECT_EQ(angle("0", "0", "0"), "unordered");
}

TEST(FunctionTruth, OfRemaindersIsExact) {
  EXPECT_EQ(truth("mod(a, 0.1)", "0.1", {"0.3"}), "less");  // the double below 0.3: 0.0999...
  EXPECT_EQ(truth("mod(a, 0.1)", "0.09999", {"0.3"}), "greater");
  EXPECT_EQ(truth("mod(a, 360)", "350", {"-10"}), "equal");
  EXPECT_EQ(truth("mod(a, 360)", "0", {"720"}), "equal");
  EXPECT_EQ(truth("mod(a, 3)", "1", {"1e22"}), "equal");
  EXPECT_EQ(truth("sign(a)", "1", {"0"}), "equal");
  EXPECT_EQ(truth("sign(a)", "0", {"-1e-300"}), "less");
}

TEST(FunctionTruth, OfPowersIsExactWhereTheyAreRational) {
  EXPECT_EQ(truth("a^(2/3)", "4", {"8"}), "equal");
  EXPECT_EQ(truth("a^-1.5", "8", {"0.25"}), "equal");
  EXPECT_EQ(truth("a^2.4", "0", {"0"}), "equal");
  EXPECT_EQ(truth("a^-0.3", "1", {"0"}), "unordered");
  EXPECT_EQ(truth("a^(1/3)", "0", {"-8"}), "unordered");
  EXPECT_EQ(truth("a^17", "-131072", {"-2"}), "equal");
}

bool falls(const Function& function) {
  if (function.kind() == Function::power) return function.parameter() < 0;
  return function == Function::cos;
}

/// Arguments of equal value, computed in different ways.
TEST(FunctionTruth, OfTheSameFunctionOfEqualNumbersIsATie) {
  for (const Function& function : tested_functions()) {
    if (function.kind() == Function::table) continue;  // no file
    const std::string name = applied_text(function, "x");
    const auto of = [&](const std::string& x) { return applied_text(function, "(" + x + ")"); };
    EXPECT_EQ(truth(of("a"), of("b"), {"0.7", "0.7"}), "equal") << name;
    EXPECT_EQ(truth(of("a"), of("b"), {"0.7", "0x1.6666666666667p-1"}),
              falls(function) ? "greater" : "less")
        << name;
    EXPECT_EQ(truth(of("sqrt(a)^2"), of("a / 3 * 3"), {"0.7"}), "equal") << name;
    EXPECT_EQ(truth(of("a") + " * b", "a * " + of("b"), {"0.7", "0.7"}), "equal") << name;
    EXPECT_EQ(truth(of("a") + " - " + of("b"), "0", {"0.7", "0.7"}), "equal") << name;
    EXPECT_EQ(truth("sqrt(" + of("a") + " - " + of("b") + ")", "0", {"0.7", "0.7"}), "equal");
  }
  EXPECT_EQ(truth("exp(sin(a)) + exp(a)", "exp(b) + exp(sin(b))", {"1", "1"}), "equal");
  EXPECT_EQ(truth("max(exp(a), 0) + exp(a)^2", "max(exp(b), 0) + exp(b)^2", {"1", "1"}), "equal");
  EXPECT_EQ(truth("exp(a)", "sinh(b)", {"1", "1"}), "greater");
}

/// No separation is known of values that are not algebraic.
TEST(FunctionTruth, OfOtherTiesIsUndetermined) {
  EXPECT_EQ(truth("exp(log(a))", "a", {"3"}), "undetermined");
  EXPECT_EQ(truth("exp(a) * exp(b)", "exp(a + b)", {"1", "0.5"}), "undetermined");
  EXPECT_EQ(truth("sin(a)^2 + cos(a)^2", "1", {"1"}), "undetermined");
  EXPECT_EQ(truth("1 / (log(a^2) - 2 * log(a))", "1", {"3"}), "undetermined");
  EXPECT_EQ(truth("log(exp(a) * exp(-a) - 1)", "1", {"3"}), "undetermined");
  EXPECT_EQ(truth("min(exp(log(a)), 1)", "a", {"3"}), "less");
}

/// Sums of doublings of a difference of functions: each pair of nodes is tried once.
TEST(FunctionTruth, OfManySharedOperandsIsATie) {
  Graph graph;
  NodeId left = graph.apply(Function::exp, graph.input("a"));
  NodeId right = graph.apply(Function::exp, graph.input("b"));
  for (int k = 0; k < 60; ++k) {
    const Operation operation = k % 2 == 0 ? Operation::add : Operation::multiply;
    left = graph.apply(operation, left, graph.apply(Operation::maximum, left, graph.input("a")));
    right = graph.apply(operation, right, graph.apply(Operation::maximum, right, graph.input("b")));
    if (k % 2 != 0) {
      left = graph.apply(Function::atan, left);
      right = graph.apply(Function::atan, right);
    }
  }
  graph.compare(left, right);
  const Bits operand = from_text(binary64, "0.7").value();
  EXPECT_EQ(true_verdict(graph, binary64, std::vector<Bits>{operand, operand}), Verdict::equal);
}

/// Operands of few digits, and a number at or next to the value.
TEST(FunctionTruth, IsThatOfMpfr) {
  std::mt19937_64 random(1);
  const FloatFormat format = format_of(24, 8);
  for (const Function& function : tested_functions()) {
    Graph graph;
    const NodeId applied = graph.apply(function, graph.input("a"));
    graph.compare(applied, graph.input("b"));
    for (int k = 0; k < 300; ++k) {
      const auto numerator = static_cast<int>(random() % 20001) - 10000;
      const mpq_class x = scaled(mpq_class(numerator), -10 - static_cast<int>(random() % 8));
      if (!domain(function).contains(x)) continue;
      const Range value = value_at(function, x);
      Bits near = from_rational(format, value.low);
      if (random() % 2 == 0) near += random() % 2 == 0 ? 1 : -1;
      if (format.is_nan(near) || format.is_infinite(near)) continue;
      const mpq_class other = to_rational(format, near);
      const Verdict expected = value.low > other    ? Verdict::greater
                               : value.high < other ? Verdict::less
                                                    : Verdict::equal;
      const std::vector<Bits> inputs = {from_rational(format, x), near};
      EXPECT_EQ(true_verdict(graph, format, inputs), expected) << to_string(function) << " " << x;
    }
  }
}

}  // namespace
}  // namespace mixcmp::test::function_truth_test
