#include "model/lane/error/range_analysis.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>

#include "model/base/number/exact.hpp"
#include "model/comparison/expression/parser.hpp"
#include "model/judge/golden/evaluate.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/graphs.hpp"

namespace mixcmp::test::range_analysis_test {
namespace {

struct Case {
  std::string text;
  std::vector<std::optional<Range>> ranges;  ///< one per input, in order of appearance
};

TypedGraph typed(const std::string& text, Arithmetic arithmetic) {
  Graph graph;
  const NodeId root = parse_expression(graph, text, {}).value();
  graph.compare(root, root);
  return reference_graph(graph, arithmetic);
}

Arithmetic arithmetic(const char* format, Subnormals subnormals) {
  return {.format = FloatFormat::parse(format).value(), .subnormals = subnormals};
}

error::NodeRange root_of(const Case& scene, const char* format = "binary64",
                         Subnormals subnormals = Subnormals::gradual) {
  const TypedGraph graph = typed(scene.text, arithmetic(format, subnormals));
  return error::analyse_ranges(graph, scene.ranges)[static_cast<std::size_t>(graph.f())];
}

TEST(RangeAnalysis, EnclosesEachOperation) {
  const Range x = {-2, 3}, y = {4, 8};
  const auto expect = [&](const std::string& text, const mpq_class& low, const mpq_class& high) {
    const bool first_is_y = text.find('y') < text.find('x');
    const Case scene{text,
                     text.find('x') == std::string::npos   ? std::vector<std::optional<Range>>{y}
                     : text.find('y') == std::string::npos ? std::vector<std::optional<Range>>{x}
                     : first_is_y                          ? std::vector<std::optional<Range>>{y, x}
                                  : std::vector<std::optional<Range>>{x, y}};
    const Range value = root_of(scene).value;
    EXPECT_EQ(value.low, low) << text;
    EXPECT_EQ(value.high, high) << text;
  };
  expect("x + y", 2, 11);
  expect("x - y", -10, -1);
  expect("x * y", -16, 24);
  expect("x / y", mpq_class(-1, 2), mpq_class(3, 4));
  expect("-x", -3, 2);
  expect("abs(x)", 0, 3);
  expect("abs(-y)", 4, 8);
  expect("x^2", 0, 9);
  expect("y^2", 16, 64);
  expect("min(x, y)", -2, 3);
  expect("max(x, y)", 4, 8);
  expect("sqrt(y + y)", mpq_class(std::sqrt(8.0)) - mpq_class(1, mpz_class(1) << 51), 4);
  expect("x - x", 0, 0);
  expect("y / y", 1, 1);
}

TEST(RangeAnalysis, RoundsOutwardToTheFormat) {
  const Range value = root_of({"x / y", {{{1, 1}}, {{3, 3}}}}, "s11e5").value;
  EXPECT_LT(value.low, mpq_class(1, 3));
  EXPECT_GT(value.high, mpq_class(1, 3));
  EXPECT_EQ(value.high - value.low, mpq_class(1, 4096));  // one ulp of s11e5 at 1/3
}

TEST(RangeAnalysis, EventsAreRuledOutOnlyWhereTheyCannotHappen) {
  const auto may = [](const Case& scene, error::Event event,
                      Subnormals subnormals = Subnormals::gradual) {
    return root_of(scene, "binary16", subnormals).may(event);
  };
  EXPECT_FALSE(may({"x * x", {{{0, 255}}}}, error::Event::overflow));
  EXPECT_TRUE(may({"x * x", {{{0, 256}}}}, error::Event::overflow));
  EXPECT_FALSE(may({"x * x", {{{1, 2}}}}, error::Event::underflow));
  EXPECT_TRUE(may({"x * x", {{{0, 2}}}}, error::Event::underflow));
  EXPECT_FALSE(may({"x - y", {{{0, 2}}, {{0, 2}}}}, error::Event::underflow));
  EXPECT_TRUE(may({"x - y", {{{0, 2}}, {{0, 2}}}}, error::Event::underflow, Subnormals::flush));
  EXPECT_FALSE(may({"x - y", {{{3, 4}}, {{0, 2}}}}, error::Event::underflow, Subnormals::flush));
  EXPECT_FALSE(may({"x / y", {{{1, 2}}, {{1, 2}}}}, error::Event::division_by_zero));
  EXPECT_TRUE(may({"x / y", {{{1, 2}}, {{0, 2}}}}, error::Event::division_by_zero));
  EXPECT_TRUE(may({"x / y", {{{1, 2}}, {{0, 2}}}}, error::Event::overflow));
  EXPECT_FALSE(may({"sqrt(x)", {{{0, 2}}}}, error::Event::root_of_negative));
  EXPECT_TRUE(may({"sqrt(x)", {{{-1, 2}}}}, error::Event::root_of_negative));
  EXPECT_FALSE(may({"min(x, y)", {{}, {}}}, error::Event::overflow));
}

TEST(RangeAnalysis, FlushedInputsMayBeZero) {
  const mpq_class tiny(1, 100'000);  // subnormal in binary16
  EXPECT_FALSE(
      root_of({"y / x", {{{1, 1}}, {{tiny, 1}}}}, "binary16").may(error::Event::division_by_zero));
  EXPECT_TRUE(root_of({"y / x", {{{1, 1}}, {{tiny, 1}}}}, "binary16", Subnormals::flush)
                  .may(error::Event::division_by_zero));
}

TEST(RangeAnalysis, AChoiceMayFlushWhatItIsGiven) {
  const auto underflows = [](const std::string& text, Subnormals subnormals, const mpq_class& low) {
    return root_of({text, {{{low, 8}}, {{low, 8}}}}, "binary16", subnormals)
        .may(error::Event::underflow);
  };
  for (const char* choice : {"max(x, y)", "min(-x, abs(y))"}) {
    EXPECT_TRUE(underflows(choice, Subnormals::flush, -8)) << choice;
    EXPECT_FALSE(underflows(choice, Subnormals::gradual, -8)) << choice;
    EXPECT_FALSE(underflows(choice, Subnormals::flush, 1)) << choice;
  }
  EXPECT_FALSE(underflows("max(x + y, sqrt(x))", Subnormals::flush, 0)) << "results are flushed";
}

TEST(RangeAnalysis, MissingRangesAreNamedAndCountAsAnyNumber) {
  const error::NodeRange node = root_of({"x^2 + y", {std::nullopt, {{0, 1}}}});
  EXPECT_EQ(node.rangeless_inputs, std::vector<int>{0});
  EXPECT_EQ(node.value.low, 0);
  EXPECT_TRUE(node.may(error::Event::overflow));
  EXPECT_TRUE(root_of({"x + y", {{{0, 1}}, {{0, 1}}}}).rangeless_inputs.empty());
}

/// A random encoding in the range, or any finite one without a range.
Bits draw(FloatFormat format, const std::optional<Range>& range, std::mt19937_64& random) {
  while (true) {
    Bits bits = random() & static_cast<std::uint64_t>(low_mask(format.width()));
    if (format.is_nan(bits) || format.is_infinite(bits)) continue;
    if (!range) return bits;
    if (random() % 2 == 0) {  // at an end of the range or near it
      bits = from_rational(format, random() % 2 == 0 ? range->low : range->high);
    }
    const mpq_class value = to_rational(format, bits);
    if (range->low <= value && value <= range->high) return bits;
  }
}

/// Compares all finite values of one evaluation by the golden model with an analysis that follows
/// infinities.
void check_followed(const TypedGraph& graph, const std::vector<error::NodeRange>& ranges,
                    const std::vector<golden::Rounded>& results, const std::string& text) {
  const auto operand = [&](const TypedNode& node, std::size_t k) {
    return results[static_cast<std::size_t>(node.operands[k])].bits;
  };
  for (std::size_t k = 0; k < results.size(); ++k) {
    const TypedNode& node = graph.nodes[k];
    const FloatFormat format = node.format;
    if (node.operation == Operation::divide && format.is_zero(operand(node, 1))) {
      ASSERT_TRUE(ranges[k].may(error::Event::division_by_zero)) << text << ", node " << k;
    }
    if (node.operation == Operation::square_root && !format.is_nan(operand(node, 0)) &&
        !format.is_zero(operand(node, 0)) && format.sign(operand(node, 0))) {
      ASSERT_TRUE(ranges[k].may(error::Event::root_of_negative)) << text << ", node " << k;
    }
    if (format.is_nan(results[k].bits)) continue;
    if (format.is_infinite(results[k].bits)) {
      ASSERT_TRUE(ranges[k].may_be_infinite) << text << ", node " << k;
      ASSERT_TRUE(ranges[k].may_be_negative_infinite || !format.sign(results[k].bits))
          << text << ", node " << k;
      continue;
    }
    const mpq_class value = to_rational(format, results[k].bits);
    ASSERT_TRUE(ranges[k].value.low <= value && value <= ranges[k].value.high)
        << text << ", node " << k << ": " << value;
  }
}

/// Compares one evaluation by the golden model with the analysis.
void check_evaluation(const TypedGraph& graph, const std::vector<error::NodeRange>& ranges,
                      const std::vector<golden::Rounded>& results, const std::string& text) {
  std::vector<bool> exceptional_below(results.size());
  for (std::size_t k = 0; k < results.size(); ++k) {
    const TypedNode& node = graph.nodes[k];
    for (int operand = 0; operand < arity(node.operation); ++operand) {
      const auto below = static_cast<std::size_t>(node.operands[static_cast<std::size_t>(operand)]);
      exceptional_below[k] =
          exceptional_below[k] || exceptional_below[below] || results[below].exceptional;
    }
    if (exceptional_below[k]) continue;
    const bool finite =
        !node.format.is_nan(results[k].bits) && !node.format.is_infinite(results[k].bits);
    const bool may_be_exceptional =
        std::find(ranges[k].may_happen.begin(), ranges[k].may_happen.end(), true) !=
        ranges[k].may_happen.end();
    bool flushed_operand = false;
    for (int operand = 0; operand < arity(node.operation); ++operand) {
      const auto below = static_cast<std::size_t>(node.operands[static_cast<std::size_t>(operand)]);
      flushed_operand =
          flushed_operand || (graph.arithmetic.subnormals == Subnormals::flush &&
                              graph.nodes[below].format.is_subnormal(results[below].bits));
    }
    if (results[k].exceptional && !flushed_operand) {
      ASSERT_TRUE(may_be_exceptional) << text << ", node " << k;
    }
    if (!finite) {
      ASSERT_TRUE(may_be_exceptional) << text << ", node " << k;
      continue;
    }
    const mpq_class value = to_rational(node.format, results[k].bits);
    ASSERT_TRUE(ranges[k].value.low <= value && value <= ranges[k].value.high)
        << text << ", node " << k << ": " << value << " not in [" << ranges[k].value.low << ", "
        << ranges[k].value.high << "]";
  }
}

TEST(RangeAnalysis, FollowsInfinitiesWhereItIsAsked) {
  const Case scene{"x / (1 / (y * z))", {{{0, 1}}, {{1, 300}}, {{1, 300}}}};
  const TypedGraph graph = typed(scene.text, arithmetic("binary16", Subnormals::gradual));
  const auto root = [&](error::Infinities infinities) {
    return error::analyse_ranges(graph, scene.ranges,
                                 infinities)[static_cast<std::size_t>(graph.f())];
  };
  EXPECT_FALSE(root(error::Infinities::excluded).may(error::Event::division_by_zero));
  EXPECT_TRUE(root(error::Infinities::followed).may(error::Event::division_by_zero));
}

/// An infinite square is positive. The infinity of a division by zero may have either sign.
TEST(RangeAnalysis, KnowsTheSignOfInfinities) {
  const auto root_of_negative = [](const std::string& text) {
    const std::vector<std::optional<Range>> ranges = {{{0, 300}}};
    const TypedGraph graph = typed(text, arithmetic("binary16", Subnormals::gradual));
    return error::analyse_ranges(graph, ranges,
                                 error::Infinities::followed)[static_cast<std::size_t>(graph.f())]
        .may(error::Event::root_of_negative);
  };
  EXPECT_FALSE(root_of_negative("sqrt(x * x)"));
  EXPECT_FALSE(root_of_negative("sqrt(abs(1 / x))"));
  EXPECT_FALSE(root_of_negative("sqrt(x * x + x)"));
  EXPECT_TRUE(root_of_negative("sqrt(1 / x)"));
  EXPECT_TRUE(root_of_negative("sqrt(1 - x * x)"));
}

TEST(RangeAnalysis, NothingTheGoldenModelComputesEscapesIt) {
  const std::vector<Case> cases = {
      {"(x - y)^2 + z * x - w / y", {{{0, 3}}, {{mpq_class(-1, 2), 5}}, std::nullopt, {{-2, -1}}}},
      {"sqrt(x) * y + abs(z) - min(w, x * x)", {{{0, 7}}, {{-3, 3}}, {{-1, 0}}, {{2, 9}}}},
      {"max(x / y, z) / (w + 0.3)", {{{-4, 4}}, {{mpq_class(1, 9), 6}}, {{-2, 2}}, {{0, 1}}}},
      {"x / (1 / (y * y * z)) - w / (x * x)", {{{0, 1}}, {{1, 15}}, {{1, 15}}, {{1, 3}}}},
      {"max(x / y, z) + sqrt(min(w / x, y))", {{{0, 4}}, {{0, 4}}, {{-2, 2}}, {{1, 2}}}},
      {"x^5 - y^3 * z / w", {{{-2, 2}}, {{1, 3}}, {{-1, 1}}, {{mpq_class(1, 1000), 1}}}},
  };
  std::mt19937_64 random(1);
  for (const Case& scene : cases) {
    for (const Subnormals subnormals : {Subnormals::flush, Subnormals::gradual}) {
      for (const char* format : {"s4e4", "s11e5", "s8e3"}) {
        for (const Rounding rounding : {Rounding::nearest_even, Rounding::toward_zero}) {
          Arithmetic rules = arithmetic(format, subnormals);
          rules.rounding = rounding;
          const TypedGraph graph = typed(scene.text, rules);
          const std::vector<error::NodeRange> ranges = error::analyse_ranges(graph, scene.ranges);
          const std::vector<error::NodeRange> followed =
              error::analyse_ranges(graph, scene.ranges, error::Infinities::followed);
          for (int round = 0; round < 300; ++round) {
            std::vector<Bits> inputs;
            for (const auto& range : scene.ranges) {
              inputs.push_back(draw(rules.format, range, random));
            }
            const std::vector<golden::Rounded> results = golden::evaluate(graph, inputs);
            check_evaluation(graph, ranges, results, scene.text + " in " + format);
            check_followed(graph, followed, results, scene.text + " in " + format);
          }
        }
      }
    }
  }
}

/// Evaluates every pair of operands. A lane rounds sums of operands that have more digits than the
/// lane, so subnormal sums are inexact. They are exact if operands and result have one format.
TEST(RangeAnalysis, SumsOfMoreDigitsThanTheResultMayUnderflowGradually) {
  const FloatFormat arrives = format_of(4, 3);
  const std::vector<std::optional<Range>> ranges(2, Range{0, 1});
  for (const char* text : {"a + b", "a - b"}) {
    const TypedGraph graph =
        lane_graph(graph_of(text, "b"), arrives, {format_of(2, 3)}, LaneInputs::exact);
    const std::vector<error::NodeRange> analysed = error::analyse_ranges(graph, ranges);
    for (Bits a = 0; a <= from_rational(arrives, 1) && !HasFailure(); ++a) {
      for (Bits b = 0; b <= from_rational(arrives, 1); ++b) {
        const std::vector<Bits> inputs = {a, b};
        check_evaluation(graph, analysed, golden::evaluate(graph, inputs), text);
      }
    }
  }
}

}  // namespace
}  // namespace mixcmp::test::range_analysis_test
