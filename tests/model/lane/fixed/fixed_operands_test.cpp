#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "model/base/number/double.hpp"
#include "model/base/number/exact.hpp"
#include "model/judge/emulator/emulator.hpp"
#include "model/judge/emulator/wide_lane.hpp"
#include "model/judge/golden/evaluate.hpp"
#include "model/judge/golden/fixed_evaluate.hpp"
#include "model/lane/fixed/exact_lane.hpp"
#include "tests/support/bounded_comparisons.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/graphs.hpp"

/// Tests lanes whose operands arrive in fixed point, on every operand of small formats.
namespace mixcmp::test::fixed_operands_test {
namespace {

using fixed::FixedLane;

std::vector<OperandFormat> formats(const std::vector<const char*>& names) {
  std::vector<OperandFormat> made;
  for (const char* name : names) made.push_back(*OperandFormat::parse(name));
  return made;
}

/// Signed and unsigned integers and fractions, in the order of a graph's inputs.
std::vector<OperandFormat> small_formats(const Graph& graph) {
  const std::vector<OperandFormat> all = formats({"int3", "uint3", "q1.1"});
  return {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(graph.inputs().size())};
}

Result<FixedLane> lane_of(const Graph& graph, const std::vector<OperandFormat>& operands,
                          int bits) {
  return fixed::fixed_lane(graph, format_of(53, 11),
                           {.format = {.bits = bits},
                            .bound = {},
                            .ranges = std::vector<std::optional<Range>>(operands.size()),
                            .operand_formats = operands});
}

/// Every tuple of numbers that the formats hold.
std::vector<std::vector<double>> every_tuple(const std::vector<OperandFormat>& operands) {
  std::vector<std::vector<double>> tuples = {{}};
  for (const OperandFormat& operand : operands) {
    std::vector<std::vector<double>> longer;
    const FixedFormat& format = *operand.fixed();
    for (const std::vector<double>& tuple : tuples) {
      for (mpz_class n = format.smallest(); n <= format.largest(); ++n) {
        longer.push_back(tuple);
        longer.back().push_back(mpq_class(n * format.unit()).get_d());
      }
    }
    tuples = std::move(longer);
  }
  return tuples;
}

std::vector<Bits> encoded(const std::vector<double>& operands) {
  std::vector<Bits> bits;
  for (const double operand : operands) bits.push_back(from_double(format_of(53, 11), operand));
  return bits;
}

Decision decision_of(const golden::LaneResult& result) {
  return result.decided ? mixcmp::decision_of(result.verdict) : Decision::undecided;
}

/// The decisions of the emulator, and those of its integers of 128 bits, on one tuple.
std::vector<Decision> emulated(const FixedLane& lane, const std::vector<double>& operands) {
  std::vector<const double*> columns;
  for (const double& operand : operands) columns.push_back(&operand);
  std::vector<Decision> decisions(2, Decision::undecided);
  emulator::Emulator(lane).decide(columns, 1, std::span(decisions).first(1));
  const auto wide = emulator::WideLane::make(lane);
  if (!wide) return {decisions.front()};
  wide->decide(columns, std::span(decisions).last(1));
  return decisions;
}

class FixedOperands : public testing::TestWithParam<BoundedComparison> {};

TEST_P(FixedOperands, AreDecidedAsTheRealNumbersAre) {
  const Graph graph = GetParam().graph();
  const std::vector<OperandFormat> operands = small_formats(graph);
  std::uint64_t decided = 0;
  for (const int bits : {1, 2, 3, 5, 8}) {
    const Result<FixedLane> lane = lane_of(graph, operands, bits);
    if (!lane.ok()) continue;  // a root of what may be negative
    for (const std::vector<double>& tuple : every_tuple(operands)) {
      const std::vector<Bits> inputs = encoded(tuple);
      const golden::LaneResult result = golden::evaluate_lane(*lane, inputs);
      for (const Decision got : emulated(*lane, tuple)) ASSERT_EQ(got, decision_of(result));
      ASSERT_TRUE(result.decided || !fixed::is_exact(*lane)) << testing::PrintToString(tuple);
      if (!result.decided) continue;
      ++decided;
      ASSERT_EQ(result.verdict, golden::true_verdict(graph, format_of(53, 11), inputs))
          << bits << " bits: " << testing::PrintToString(tuple);
    }
  }
  EXPECT_TRUE(decided > 0 || !lane_of(graph, operands, 8).ok());
}

INSTANTIATE_TEST_SUITE_P(Comparisons, FixedOperands, testing::ValuesIn(bounded_comparisons()),
                         [](const auto& parameter) { return parameter.param.name; });

const char* const orientation_f = "(bx - ax) * (cy - ay)";
const char* const orientation_g = "(by - ay) * (cx - ax)";

/// No operand arrives in floating point.
Result<int> exact_bits(const Graph& graph, const std::vector<OperandFormat>& operands,
                       std::optional<BoundKind> bound = {}, int most_bits = 48) {
  return fixed::exact_bits(graph, format_of(53, 11),
                           {.bound = bound, .ranges = {}, .operand_formats = operands}, most_bits);
}

TEST(ExactBits, HasTheFewestBits) {
  const Graph graph = graph_of(orientation_f, orientation_g);
  const std::vector<OperandFormat> operands(6, *OperandFormat::parse("uint10"));
  const auto bits = exact_bits(graph, operands);
  ASSERT_TRUE(bits.ok());
  EXPECT_EQ(*bits, 10);
  EXPECT_TRUE(fixed::is_exact(*lane_of(graph, operands, 10)));
  EXPECT_FALSE(fixed::is_exact(*lane_of(graph, operands, 9)));
  const std::vector<OperandFormat> with_signs(6, *OperandFormat::parse("int10"));
  EXPECT_EQ(*exact_bits(graph, with_signs), 9) << "of a magnitude";
}

/// A sum of eighth powers has more bits than 2 W + 16 of its operands' W.
TEST(ExactBits, HasMoreBitsWhereResultsNeedThem) {
  const Graph graph = graph_of("a^8", "b^8");
  const auto bits = exact_bits(graph, formats({"uint6", "uint6"}));
  ASSERT_TRUE(bits.ok());
  EXPECT_EQ(*bits, 17);  // f - g has 49 bits
}

TEST(ExactBits, SaysWhyThereIsNone) {
  const auto reason = [](const char* f, const char* g, const char* format) {
    const std::vector<OperandFormat> operands(2, *OperandFormat::parse(format));
    const auto bits = exact_bits(graph_of(f, g), operands, std::nullopt, 24);
    return bits.ok() ? "" : bits.error().message;
  };
  EXPECT_EQ(reason("0.1 * a", "b", "uint8"), "a constant is no multiple of a power of two");
  EXPECT_EQ(reason("sqrt(a)", "b", "uint8"), "square roots are rounded");
  EXPECT_EQ(reason("within(a, 0, 7)", "b", "uint8"), "limits leave comparisons undecided");
  EXPECT_EQ(reason("a^4", "b", "uint20"), "it takes more than 24 bits");
  EXPECT_EQ(reason("a", "b + 0x1.000001p30", "uint8"), "it takes more than 24 bits");
  EXPECT_EQ(reason("a", "b", "s24e8"), "an input has neither a format in fixed point nor a grid");
  EXPECT_EQ(reason("a", "b", "uint24"), "");
}

/// (8193 x)^2 has a root with few digits, which a lane with constants does not use.
TEST(ExactBits, DependOnTheBound) {
  const Graph graph = graph_of("67125249 * a^2", "b");
  const std::vector<OperandFormat> operands = formats({"uint4", "uint4"});
  EXPECT_EQ(*exact_bits(graph, operands), 14);
  EXPECT_EQ(*exact_bits(graph, operands, BoundKind::constant), 27);
  EXPECT_FALSE(exact_bits(graph, operands, BoundKind::norm).ok());
}

/// The message about a lane on grids of 1, of inputs in [-8, 7].
std::string no_grid_lane(const char* f, const char* g, FixedPoint lane_format) {
  const Graph graph = graph_of(f, g);
  const std::size_t inputs = graph.inputs().size();
  const auto lane = fixed::fixed_lane(graph, format_of(24, 8),
                                      {.format = lane_format,
                                       .bound = BoundKind::grid,
                                       .ranges = {inputs, std::optional(Range{-8, 7})},
                                       .grids = std::vector(inputs, std::optional<mpq_class>(1))});
  return lane.ok() ? "" : lane.error().message;
}

TEST(GridLanes, AreRefusedWhereSomethingIsRounded) {
  EXPECT_EQ(no_grid_lane("a * b", "a + 3", {4}), "");
  EXPECT_EQ(no_grid_lane("0.1 * a", "b", {4}), "q4 rounds a constant or a result of f or g");
  EXPECT_EQ(no_grid_lane("a * b", "a + 3", {3}),
            "q3 holds the multiples of no grid of an input in floating point");
  EXPECT_EQ(no_grid_lane("a * b", "a^2", {.bits = 4, .guard_digits = 2}),
            "lanes that rely on grids have neither guard digits nor blocks");
}

TEST(FixedOperands, BlocksDoNotTakeThem) {
  const auto lane = fixed::fixed_lane(graph_of("a", "b"), format_of(53, 11),
                                      {.format = {.bits = 8, .is_block = true},
                                       .bound = {},
                                       .ranges = {std::nullopt, std::nullopt},
                                       .operand_formats = formats({"uint8", "uint8"})});
  ASSERT_FALSE(lane.ok());
  EXPECT_EQ(lane.error().field, "reduced.format");
}

}  // namespace
}  // namespace mixcmp::test::fixed_operands_test
