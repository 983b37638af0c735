#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "model/base/number/dyadic.hpp"
#include "model/base/number/exact.hpp"
#include "model/base/number/operand_format.hpp"
#include "model/judge/golden/evaluate.hpp"
#include "model/lane/error/certified_lane.hpp"
#include "model/lane/error/exactness.hpp"
#include "model/lane/error/exponent_range.hpp"
#include "model/lane/error/hazards.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/graphs.hpp"
#include "tests/support/hazard_judge.hpp"
#include "tests/support/sphere.hpp"

/// Tests the effects of ranges and grids: checks, hazards, exponent bits, exactness.
namespace mixcmp::test::range_use_test {
namespace {

using error::Hazards;
using error::Lane;
using error::RangeCheck;
using golden::evaluate_reference;
using golden::passes;
using golden::true_verdict;

using Ranges = std::vector<std::optional<Range>>;

bool is_finite(FloatFormat format, Bits bits) {
  return !format.is_nan(bits) && !format.is_infinite(bits);
}

const std::vector<Range> some_ranges = {
    {0, 100}, {1, 3}, {-4, 4}, {-9, -1}, {mpq_class(1, 3), mpq_class(10, 3)}, {0, 0}, {-7, 1000}};

/// Every number in the range passes, every number that passes is in the checked range, and no NaN
/// or infinity passes.
TEST(RangeCheck, IsCoarserThanTheRangeAndAsWideAsItSays) {
  for (const FloatFormat format : {format_of(4, 4), format_of(6, 5), format_of(3, 3)}) {
    for (const Range& range : some_ranges) {
      const RangeCheck check = error::range_check(0, format, range);
      const Range checked = checked_range(check, format);
      for (Bits bits = 0; bits < Bits{1} << format.width(); ++bits) {
        const bool pass = passes(check, format, bits);
        if (!is_finite(format, bits)) {
          EXPECT_FALSE(pass);
          continue;
        }
        const mpq_class value = to_rational(format, bits);
        const bool negative_zero = value == 0 && format.sign(bits);
        const bool required = range.low <= value && value <= range.high && value != 0;
        EXPECT_TRUE(pass || !required) << value;
        if (pass && !negative_zero) {
          EXPECT_TRUE(checked.low <= value && value <= checked.high) << value;
        }
      }
    }
  }
}

TEST(RangeCheck, LetsPassLittleBeyondTheRange) {
  const FloatFormat format = format_of(53, 8);
  const Range checked = checked_range(error::range_check(0, format, {1, 100}), format);
  EXPECT_EQ(checked.low, 1);
  EXPECT_LT(checked.high, 104);
  EXPECT_EQ(checked_range(error::range_check(0, format, {-3, 100}), format).low, -checked.high);
}

TEST(RangeCheck, ThatChecksSignsAloneLetsNansPass) {
  const FloatFormat format = format_of(8, 5);
  const RangeCheck check = error::sign_check(0, error::RequiredSign::nonnegative);
  EXPECT_TRUE(passes(check, format, format.quiet_nan()));
  EXPECT_FALSE(passes(check, format, format.zero(true)));
}

/// Checks, on every operand pair that passes the checks, that no operation meets a hazard that was
/// ruled out.
void hold_hazards(const std::string& f, const Ranges& ranges, FloatFormat reference,
                  const Arithmetic& reduced, LaneInputs inputs) {
  const Graph graph = graph_of(f, "b");
  const auto lane = error::certified_lane(lane_graph(graph, reference, reduced, inputs),
                                          {.kind = BoundKind::running, .ranges = ranges});
  ASSERT_TRUE(lane.ok()) << f;
  ASSERT_EQ(lane->hazards.size(), lane->graph.nodes.size()) << f;
  for (Bits index = 0; index < Bits{1} << (2 * reference.width()); ++index) {
    const std::vector<Bits> operands = {index & low_mask(reference.width()),
                                        index >> reference.width()};
    EXPECT_EQ(broken_promise(*lane, operands), "") << f;
  }
}

TEST(Hazards, ThatAreRuledOutDoNotOccur) {
  const Ranges ranges = {Range{mpq_class(1, 2), 6}, Range{1, 3}};
  for (const char* f : {"a + b", "a - b", "a * b", "a^2", "a / b", "sqrt(a)", "min(a, b)",
                        "(a + 9) * b", "sqrt(a + b) / b"}) {
    for (const Arithmetic& arithmetic : every_arithmetic(format_of(4, 5))) {
      hold_hazards(f, ranges, format_of(4, 4), arithmetic, LaneInputs::exact);
      hold_hazards(f, ranges, format_of(4, 4), arithmetic, LaneInputs::rounded);
    }
  }
}

Hazards hazards_of(const std::string& f, const Ranges& ranges, FloatFormat lane) {
  const auto typed =
      lane_graph(graph_of(f, "b"), format_of(24, 8),
                 {lane, Rounding::nearest_even, Subnormals::flush}, LaneInputs::exact);
  const auto certified =
      error::certified_lane(typed, {.kind = BoundKind::running, .ranges = ranges});
  if (certified->hazards.empty()) return {};
  return certified->hazards[static_cast<size_t>(typed.f())];
}

/// Both operands are normal, their difference is subnormal and exact: the unit must be built for
/// it.
TEST(Hazards, GradualDifferencesMayBeSubnormal) {
  const FloatFormat format = format_of(10, 4);
  const auto typed =
      lane_graph(graph_of("a - b", "c"), format_of(24, 8), {format}, LaneInputs::rounded);
  const Range normal{mpq_class(16, 1000), mpq_class(1, 10)};
  const auto lane =
      error::certified_lane(typed, {.kind = BoundKind::running, .ranges = Ranges(3, normal)});
  EXPECT_TRUE(lane->hazards[static_cast<size_t>(typed.f())].underflow);
}

TEST(Hazards, AreRuledOutWhereTheRangesDoSo) {
  const Ranges apart = {Range{2, 6}, Range{1, 3}};
  const Hazards none{.special_operand = false, .overflow = false, .underflow = false};
  EXPECT_EQ(hazards_of("a * b", apart, format_of(8, 8)), none);
  EXPECT_EQ(hazards_of("a / b", apart, format_of(8, 8)), none);
  EXPECT_TRUE(hazards_of("a - b", apart, format_of(8, 8)).underflow) << "may cancel";
  EXPECT_TRUE(hazards_of("a - b", apart, format_of(8, 8)).cancellation);
  EXPECT_FALSE(hazards_of("a + b", apart, format_of(8, 8)).cancellation);
  EXPECT_FALSE(hazards_of("a - -b", apart, format_of(8, 8)).cancellation);
  EXPECT_TRUE(hazards_of("a + b", {std::nullopt, Range{1, 3}}, format_of(8, 8)).cancellation);
  EXPECT_FALSE(hazards_of("a^2 + b^2", {std::nullopt, std::nullopt}, format_of(8, 8)).cancellation);
  EXPECT_TRUE(hazards_of("a * b", apart, format_of(8, 3)).overflow);
  EXPECT_TRUE(hazards_of("a / b", {Range{2, 6}, Range{-1, 3}}, format_of(8, 8)).overflow);
  EXPECT_TRUE(hazards_of("a * b", {Range{2, 6}, std::nullopt}, format_of(8, 8)).special_operand);
}

/// On every operand pair that passes the checks, a NaN or an infinity meets only units that are
/// built for it, even behind an exceptional operation.
TEST(Hazards, NansAndInfinitiesReachOnlyWhatIsBuiltForThem) {
  const FloatFormat reference = format_of(3, 3);
  const Ranges ranges = {Range{mpq_class(1, 2), 6}, Range{1, 3}};
  for (const char* f : {"sqrt(a - b) * b", "abs(sqrt(a - b)) + a", "(b / (a - b)) * b"}) {
    const auto lane = error::certified_lane(
        lane_graph(graph_of(f, "b"), reference, {format_of(3, 4)}, LaneInputs::exact),
        {.kind = BoundKind::running, .ranges = ranges});
    ASSERT_TRUE(lane.ok()) << f;
    ASSERT_FALSE(lane->hazards.empty()) << f;
    int met = 0;
    for (Bits index = 0; index < Bits{1} << (2 * reference.width()) && !HasFailure(); ++index) {
      const std::vector<Bits> operands = {index & low_mask(reference.width()),
                                          index >> reference.width()};
      const auto passes_its = [&](const RangeCheck& check) {
        return passes(check, reference, operands[static_cast<size_t>(check.input)]);
      };
      if (!std::all_of(lane->checks.begin(), lane->checks.end(), passes_its)) continue;
      const auto values = golden::evaluate(lane->graph, operands);
      for (size_t id = 0; id < values.size(); ++id) {
        const TypedNode& node = lane->graph.nodes[id];
        for (int k = 0; error::has_unit(node.operation) && k < arity(node.operation); ++k) {
          const auto operand = static_cast<size_t>(node.operands[static_cast<size_t>(k)]);
          if (is_finite(lane->graph.nodes[operand].format, values[operand].bits)) continue;
          ++met;
          EXPECT_TRUE(lane->hazards[id].special_operand) << f << ", node " << id;
        }
      }
    }
    EXPECT_GT(met, 0) << f;
  }
}

TEST(LaneExponentBits, AreTheFewestThatReachBothEnds) {
  const Graph graph = sphere_graph();
  const auto bits = [&](int precision, const Range& range) {
    return error::lane_exponent_bits(graph, format("s53e8"), {format_of(precision, 8)},
                                     LaneInputs::exact, Ranges(8, range));
  };
  EXPECT_EQ(bits(17, {0, 100}), 6) << "2^15 / 2^34 = 2^-19; e5 ends at 2^-14, e6 at 2^-30";
  EXPECT_EQ(bits(4, {0, 100}), 5) << "43264 = 208^2 is beyond e4's 2^8, below e5's 2^16";
  EXPECT_EQ(bits(24, {0, 100}), 7);
  EXPECT_EQ(bits(52, {0, 100}), 8);
  EXPECT_EQ(bits(8, {0, 1e15}), 8);
  EXPECT_EQ(error::lane_exponent_bits(graph, format("s53e8"), {format_of(17, 8)}, LaneInputs::exact,
                                      Ranges(8, std::nullopt)),
            8)
      << "without ranges";
}

TEST(LaneExponentBits, ServeEveryPart) {
  const auto bits = [](const std::vector<std::pair<std::string, std::string>>& parts) {
    return error::lane_exponent_bits(graph_of(parts, Combination::all), format("s53e8"),
                                     {format_of(4, 8)}, LaneInputs::exact, {Range{0, 100}});
  };
  EXPECT_EQ(bits({{"a", "1"}}), 4) << "100 is below e4's 2^8";
  EXPECT_EQ(bits({{"a", "1"}, {"a^3", "1"}}), 6) << "a million is above e5's 2^16";
  EXPECT_EQ(bits({{"a^3", "1"}, {"a", "1"}}), 6);
}

/// For all operands on the grid, a node that is called exact holds the real value.
TEST(ExactNodes, NodesAreExact) {
  const FloatFormat reference = format_of(12, 5);
  const mpq_class grid(1, 4);
  const Range range{-5, 6};
  const Ranges ranges(2, range);
  const std::vector<std::optional<mpq_class>> grids(2, grid);
  int exact_functions = 0;
  for (const char* f :
       {"a + b", "a - b", "a * b", "a^2", "(a - b)^2", "a / 8", "abs(a) * -b", "min(a, b) + 0.75",
        "max(a, 0) - b", "a^3", "a / b", "sqrt(a)", "a + 0.1", "a * 0.375", "(a - b)^2 + a^2",
        "6 + (a / 8)^2", "(a / 8)^2 - 6", "max((a / 8)^2, -8) + 6"}) {
    const Graph graph = graph_of(f, "b");
    const auto typed = reference_graph(graph, {reference});
    const auto exact = error::exact_nodes(typed, ranges, grids);
    if (!exact[static_cast<size_t>(typed.f())]) continue;
    ++exact_functions;
    for (mpq_class a = range.low; a <= range.high; a += grid) {
      for (mpq_class b = range.low; b <= range.high; b += grid) {
        const std::vector<Bits> operands = {from_rational(reference, a),
                                            from_rational(reference, b)};
        EXPECT_EQ(to_string(evaluate_reference(typed, operands)),
                  to_string(true_verdict(graph, reference, operands)))
            << f << " " << a << " " << b;
      }
    }
  }
  EXPECT_EQ(exact_functions, 11) << "all but a^3, a / b, the root, the tenth and the sixes";
}

TEST(ExactNodes, ProductsMayOverflow) {
  const auto is_exact = [](int exponent_bits) -> bool {
    TypedGraph typed = reference_graph(graph_of("a * b", "a"), {format_of(6, exponent_bits)});
    typed.arriving.assign(2, OperandFormat(format_of(3, 2)));
    return error::exact_nodes(
        typed, Ranges(2),
        std::vector(2, std::optional<mpq_class>()))[static_cast<size_t>(typed.f())];
  };
  EXPECT_FALSE(is_exact(2)) << "3.5^2 is beyond 4";
  EXPECT_TRUE(is_exact(3));
}

TEST(ExactNodes, EndsWhereTheDigitsEnd) {
  const auto exact = [](int precision, const mpq_class& grid, const Range& range) -> bool {
    const auto typed = reference_graph(graph_of("(a - b)^2", "c"), {format_of(precision, 8)});
    return error::exact_nodes(typed, Ranges(3, range),
                              std::vector(3, std::optional(grid)))[static_cast<size_t>(typed.f())];
  };
  EXPECT_TRUE(exact(20, mpq_class(1, 8), {0, 128})) << "1024^2 = 2^20 quanta";
  EXPECT_FALSE(exact(19, mpq_class(1, 8), {0, 128}));
  EXPECT_FALSE(exact(20, mpq_class(1, 16), {0, 128}));
  EXPECT_TRUE(exact(20, 1, {-512, 512}));
}

using Grids = std::vector<std::optional<mpq_class>>;

/// The format's name, or why there is none. `names`: of the operands' formats.
std::string exact_format(const Graph& graph, const std::vector<const char*>& names,
                         const std::optional<Range>& range = {},
                         const std::optional<mpq_class>& grid = {}) {
  std::vector<OperandFormat> formats;
  for (const char* name : names) formats.push_back(*OperandFormat::parse(name));
  const auto format =
      error::exact_format(graph, formats, Ranges(names.size(), range), Grids(names.size(), grid));
  return format.ok() ? format->name() : format.error().message;
}

TEST(ExactFormat, HoldsEveryResult) {
  EXPECT_EQ(exact_format(graph_of("a", "b"), {"uint10", "int4"}), "s53e11");
  // The product has 80 digits, and so has the difference.
  EXPECT_EQ(exact_format(graph_of("a * b", "a"), {"uint40", "uint40"}), "s80e11");
  EXPECT_EQ(exact_format(graph_of("a", "b"), {"uq0.60", "uint4"}), "s60e11");
}

/// No result is below the smallest normal number, even if subnormals are flushed: the products
/// count units of 2^-1030.
TEST(ExactFormat, HasNoSubnormalResults) {
  EXPECT_EQ(exact_format(graph_of("a * 0x1p-970", "b * 0x1p-970"), {"uq0.60", "uq0.60"}), "s60e12");
  EXPECT_EQ(exact_format(graph_of("a * 0x1p-1022", "b"), {"uint4", "uint4"}), "s53e11");
  EXPECT_EQ(exact_format(graph_of("a * 0x1p-1023", "b"), {"uint4", "uint4"}), "s53e12");
}

TEST(ExactFormat, HoldsSquaresThatAreDividedLater) {
  EXPECT_EQ(exact_format(graph_of("a^2 / 0x1p100", "b"), {"uint50", "uint4"}), "s100e11");
  EXPECT_EQ(exact_format(graph_of("(0x1p600 * a)^2 / 0x1p1200", "b"), {"uint8", "uint8"}),
            "s53e12");
  EXPECT_EQ(exact_format(graph_of("a^2 / 0x1p120", "b"), {"uint60", "uint4"}),
            "it needs 120 digits");
}

TEST(ExactFormat, NeedsOperationsThatAreExact) {
  EXPECT_EQ(exact_format(graph_of("a + 0.1", "b + 0.1"), {"uint8", "uint8"}),
            "a constant is no multiple of a power of two");
}

/// Limits leave comparisons undecided, but round nothing.
TEST(ExactFormat, IsThatOfAComparisonWithLimits) {
  EXPECT_EQ(exact_format(graph_of("within(a, 0, 7) * b", "b"), {"int6", "int6"}), "s53e11");
}

TEST(ExactFormat, HoldsProductsOfNumbersInFloatingPoint) {
  EXPECT_EQ(exact_format(graph_of("a * b", "a"), {"binary32", "binary32"}), "s48e10");
  EXPECT_EQ(exact_format(graph_of("a * b", "-b * 0.75"), {"binary32", "bfloat16"}), "s32e10");
  EXPECT_EQ(exact_format(graph_of("a * 1.75", "b"), {"binary32", "binary32"}), "s27e9");
  EXPECT_EQ(exact_format(graph_of("max(a, b) * a", "b"), {"binary32", "bfloat16"}), "s48e10");
  EXPECT_EQ(exact_format(graph_of("a * b", "max(a, b)"), {"binary64", "binary64"}), "s106e13");
  EXPECT_EQ(exact_format(graph_of("a^3", "b"), {"binary64", "binary64"}), "it needs 159 digits");
  EXPECT_EQ(exact_format(graph_of("a * b", "a"), {"binary32", "uint10"}), "s53e11");
}

TEST(ExactFormat, HoldsSumsWhoseWidthIsBounded) {
  EXPECT_EQ(exact_format(graph_of("a * a + b * b", "a"), {"E4M3", "E4M3"}), "s37e6");
  EXPECT_EQ(exact_format(graph_of("a * b + a", "b"), {"E5M2", "E5M2"}), "s64e7");
  EXPECT_EQ(exact_format(graph_of("a + b", "a"), {"binary32", "binary32"}), "it needs 278 digits");
  EXPECT_EQ(exact_format(graph_of("a + b", "a"), {"binary32", "binary32"}, Range{0, 100},
                         mpq_class(1, 1024)),
            "s24e8");
  EXPECT_EQ(exact_format(graph_of("(a - b)^2", "a"), {"binary32", "binary32"}, Range{0, 100},
                         mpq_class(1, 1024)),
            "s34e8");
}

TEST(ExactFormat, IsRefusedWhereAnOperationRounds) {
  EXPECT_EQ(exact_format(graph_of("a / b", "a"), {"binary32", "binary32"}),
            "quotients are rounded");
  EXPECT_EQ(exact_format(graph_of("sqrt(a)", "b"), {"binary32", "binary32"}),
            "square roots are rounded");
}

/// Every pair of numbers, subnormals and those at the ends of a range among them.
TEST(ExactFormat, MakesEveryVerdictTheOrderOfTheRealNumbers) {
  const FloatFormat small = format_of(3, 2);
  for (const char* f : {"a * b", "a * b + a", "(a - b)^2", "a^3 - b", "max(a, b) * 0.375",
                        "abs(a * b - 1.5)", "(a * b - a / 8)^2"}) {
    Graph graph = graph_of(f, "b * 1.25");
    const auto format = error::exact_format(graph, {OperandFormat(small), OperandFormat(small)},
                                            Ranges(2), Grids(2));
    ASSERT_TRUE(format.ok()) << f << ": " << format.error().to_string();
    const auto typed = reference_graph(graph, {*format});
    for (Bits a = 0; a < Bits{1} << small.width(); ++a) {
      for (Bits b = 0; b < Bits{1} << small.width(); ++b) {
        if (!small.is_finite(a) || !small.is_finite(b)) continue;
        const std::vector<Bits> operands = {converted(*format, small, a),
                                            converted(*format, small, b)};
        EXPECT_EQ(to_string(evaluate_reference(typed, operands)),
                  to_string(true_verdict(graph, *format, operands)))
            << f << " " << int(a) << " " << int(b);
      }
    }
    // A digit less, and some operation rounds.
    const auto nodes = [&](int precision, int exponent_bits) {
      TypedGraph narrow = sides_graph(graph, {format_of(precision, exponent_bits)});
      narrow.arriving.assign(2, OperandFormat(small));
      return error::exact_nodes(narrow, Ranges(2), Grids(2));
    };
    const auto all = [](const std::vector<bool>& exact) {
      return std::find(exact.begin(), exact.end(), false) == exact.end();
    };
    EXPECT_TRUE(all(nodes(format->precision(), format->exponent_bits()))) << f;
    EXPECT_FALSE(all(nodes(format->precision() - 1, format->exponent_bits()))) << f;
  }
}

/// The fewest digits with which no node rounds.
int exact_digits(const Graph& graph, FloatFormat arriving, Sums sums) {
  const std::size_t inputs = graph.inputs().size();
  for (int precision = arriving.precision();; ++precision) {
    TypedGraph typed = reference_graph(graph, {.format = format_of(precision, 6), .sums = sums});
    typed.arriving.assign(inputs, OperandFormat(arriving));
    const std::vector<bool> exact = error::exact_nodes(typed, Ranges(inputs), Grids(inputs));
    if (std::find(exact.begin(), exact.end(), false) == exact.end()) return precision;
  }
}

/// The sign of a fused sum needs fewer digits than the sides have.
TEST(ExactNodes, SignsOfFusedSumsAreExactWhereNoDigitIsCut) {
  const FloatFormat small = format_of(3, 2);
  const Graph graph = graph_of("a * b", "c * b - a");
  const int fused = exact_digits(graph, small, Sums::fused);
  EXPECT_LT(fused, exact_digits(graph, small, Sums::composed));
  const FloatFormat wide = format_of(fused, 6);
  const TypedGraph typed = reference_graph(graph, {.format = wide, .sums = Sums::fused});
  std::vector<Bits> numbers;
  for (Bits word = 0; word < Bits{1} << small.width(); ++word) {
    if (small.is_finite(word)) numbers.push_back(converted(wide, small, word));
  }
  for (const Bits a : numbers) {
    for (const Bits b : numbers) {
      for (const Bits c : numbers) {
        const std::vector<Bits> operands = {a, b, c};
        ASSERT_EQ(to_string(evaluate_reference(typed, operands)),
                  to_string(true_verdict(graph, wide, operands)))
            << to_rational(wide, a) << " " << to_rational(wide, b) << " " << to_rational(wide, c);
      }
    }
  }
}

TEST(ExactNodes, FusedSumsMayCutDigitsOfSmallTerms) {
  const Ranges ranges(2, Range{-8, 8});
  const Grids grids(2, mpq_class(1, 64));
  const auto is_exact = [&](int precision) {
    const auto typed = reference_graph(graph_of("a * b", "b * b + a"),
                                       {.format = format_of(precision, 8), .sums = Sums::fused});
    const auto exact = error::exact_nodes(typed, ranges, grids);
    return std::find(exact.begin(), exact.end(), false) == exact.end();
  };
  // Products are multiples of 2^-12 and at most 2^6; three terms have seven guard digits.
  EXPECT_TRUE(is_exact(11));
  EXPECT_FALSE(is_exact(10));
}

/// With subnormals, terms below the smallest normal number are cut as beside that number.
TEST(ExactNodes, FusedSumsMayCutTermsBelowTheSmallestNormalNumber) {
  const auto sign_is_exact = [](int grid_exponent) {
    const auto typed = reference_graph(graph_of("a * b", "b * b"),
                                       {.format = format_of(11, 5), .sums = Sums::fused});
    const Grids grids(2, power_of_two(grid_exponent));
    const auto exact = error::exact_nodes(typed, Ranges(2, Range{0, power_of_two(-13)}), grids);
    return bool(exact[static_cast<std::size_t>(typed.f())]);
  };
  EXPECT_TRUE(sign_is_exact(-15)) << "2^-30 is above 2^(-14 - 11 - 6)";
  EXPECT_FALSE(sign_is_exact(-16));
}

}  // namespace
}  // namespace mixcmp::test::range_use_test
