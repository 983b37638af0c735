#include "model/lane/fixed/fixed_lane.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "model/base/number/decimal.hpp"
#include "model/base/number/dyadic.hpp"
#include "model/judge/golden/fixed_evaluate.hpp"
#include "tests/model/lane/fixed/lanes.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/graphs.hpp"

namespace mixcmp::test::fixed_lane_test {
namespace {

using fixed::ConstantThresholds;
using fixed::FixedLane;
using fixed::FixedNode;
using fixed::NormThresholds;

TEST(FixedFormat, HoldsNoMoreThanItMust) {
  EXPECT_EQ(FixedFormat::holding(0, 0, 3).name(), "ufix1_E3");
  EXPECT_EQ(FixedFormat::holding(0, 7, -2).name(), "ufix3_En2");
  EXPECT_EQ(FixedFormat::holding(0, 8, 0).name(), "ufix4_E0");
  EXPECT_EQ(FixedFormat::holding(-8, 7, 0).name(), "sfix4_E0");
  EXPECT_EQ(FixedFormat::holding(-9, 7, 0).name(), "sfix5_E0");
  EXPECT_EQ(FixedFormat::holding(-1, 8, 0).name(), "sfix5_E0");
  const FixedFormat format = FixedFormat::holding(-5, 3, 0);
  EXPECT_EQ(format.smallest(), -8);
  EXPECT_EQ(format.largest(), 7);
}

TEST(FixedLane, NodesAreAsWideAsTheirIntervals) {
  const FixedLane lane = lane_of(graph_of("(a - b)^2", "c"), 13, {0, 100});
  EXPECT_EQ(
      formats_of(lane),
      (std::vector<std::string>{"input ufix13_En6", "input ufix13_En6", "subtract sfix14_En6",
                                "square ufix26_En12", "input ufix13_En6", "subtract sfix27_En12"}));
}

TEST(FixedLane, TheRangesTopIsInside) {
  const FixedLane lane = lane_of(graph_of("a", "b"), 4, {0, 8});
  EXPECT_EQ(lane.nodes.front().format.name(), "ufix4_E0");
  const FloatFormat format = lane.input_format;
  const auto fits = [&](double value) {
    const std::vector<Bits> inputs(2, golden::from_rational(format, mpq_class(value)));
    return golden::evaluate(lane, inputs).front().has_value();
  };
  EXPECT_TRUE(fits(0));
  EXPECT_TRUE(fits(8));
  EXPECT_TRUE(fits(15.999));
  EXPECT_FALSE(fits(16));
  EXPECT_FALSE(fits(-1e-3));
}

TEST(FixedLane, TheTopIsAPowerOfTwoOfTheFormat) {
  const auto top_of = [](const Range& range) {
    const FixedLane lane = lane_of(graph_of("a", "b"), 10, range);
    return lane.nodes.front().format.unit_exponent + 10;
  };
  EXPECT_EQ(top_of({0, 100}), 7);
  EXPECT_EQ(top_of({0, 128}), 8);
  EXPECT_EQ(top_of({0, mpq_class(1, 100)}), -6);
  EXPECT_EQ(top_of({0, 0}), -125);
  EXPECT_EQ(top_of({0, mpq_class(1, mpz_class(1) << 140)}), -125);
  EXPECT_EQ(top_of({0, mpz_class(1) << 140}), 128);
}

TEST(FixedLane, WideResultsAreCut) {
  const FixedLane lane = lane_of(graph_of("a - b / 4096", "c"), 8, {0, 1});
  const FixedNode& sum = lane.nodes[4];
  ASSERT_EQ(sum.operation, Operation::subtract);
  // 1 < 2^8 2^-7, and b / 4096 counts 2^-19: 20 bits and a sign hold them, fewer than 2 * 8 + 16.
  EXPECT_EQ(sum.format.name(), "sfix21_En19");
  const FixedLane narrow = lane_of(graph_of("a - b / 1048576", "c"), 4, {0, 1});
  const FixedNode& cut = narrow.nodes[4];
  // a < 2 counts 2^-3 and is off by one unit; b / 2^20 counts 2^-23. One of 25 bits is dropped,
  // which is worth 2^-23.
  EXPECT_EQ(cut.format.name(), "sfix24_En22");
  EXPECT_EQ(cut.dropped_bits, 1);
  EXPECT_EQ(cut.error.low, mpq_class(-1, 8) - mpq_class(1, 1 << 23));
  EXPECT_EQ(cut.error.high, mpq_class(1, 1 << 23));
}

TEST(FixedLane, WhatIsCutHasNoNorm) {
  const std::vector<std::optional<Range>> ranges(3, Range{0, 1});
  const auto has_norm = [&](const char* f) {
    return fixed::fixed_lane(graph_of(f, "c^2"), format_of(53, 8),
                             {.format = {9}, .bound = BoundKind::norm, .ranges = ranges})
        .ok();
  };
  EXPECT_TRUE(has_norm("a^2 + (b / 128)^2")) << "32 bits";
  EXPECT_FALSE(has_norm("a^2 + (b / 512)^2")) << "36 bits, of which 2 * 9 + 16 stay";
}

TEST(FixedLane, FactorsHaveTheBitsThatTheirErrorsLeaveMeaning) {
  const FixedLane lane = lane_of(graph_of("(a^2)^2", "b"), 8, {0, 1});
  const FixedNode& factor = lane.nodes[2];
  ASSERT_EQ(factor.operation, Operation::convert);
  EXPECT_FALSE(is_limit(factor));
  // a < 2 is 255 at most, in units of 2^-7. The square of x + e, e >= -1, is off by 511. A 16th of
  // that is more than 2^4, and dropping four bits costs 2^4 - 1.
  EXPECT_EQ(factor.dropped_bits, 4);
  EXPECT_EQ(factor.format.name(), "ufix12_En10");
  EXPECT_EQ(factor.error, (Range{mpq_class(-(511 + 15) / 2, 1 << 13), 0}));
  EXPECT_EQ(lane.nodes[3].operation, Operation::square);
  EXPECT_EQ(lane.nodes[3].format.name(), "ufix24_En20");
}

Range in_eighths(int low, int high) {
  Range range = {{low, 8}, {high, 8}};
  range.low.canonicalize();
  range.high.canonicalize();
  return range;
}

/// A factor may consist of little besides its error. With one bit fewer it would have no bit
/// besides the sign.
TEST(FixedLane, ConversionsTakeBitsThatTheirOperandsHave) {
  for (const char* f : {"min(max(a - b, -1/4096), 1/4096) * c", "within(a - b, -1/4096, 1/4096)^2",
                        "within(a - b, -1/4096, 0) * c", "max(a - b, 0) * c"}) {
    const Graph graph = graph_of(f, "c");
    std::vector<std::optional<Range>> ranges(graph.inputs().size(), Range{-1, 1});
    ranges[1] = {mpq_class(-1, 64), mpq_class(1, 64)};
    for (int bits = 1; bits <= 16; ++bits) {
      const FixedLane lane =
          fixed::fixed_lane(graph, format_of(24, 8), {.format = {bits}, .ranges = ranges}).value();
      for (const FixedNode& node : lane.nodes) {
        if (node.operation != Operation::convert) continue;
        EXPECT_LE(node.dropped_bits + node.format.width, lane.nodes[node.operands[0]].format.width)
            << f << ", q" << bits;
      }
    }
  }
}

TEST(FixedLane, LimitsAreRoundedOutwardToUnits) {
  const auto limited = [](const char* f, const Range& range) {
    const FixedLane lane = lane_of(graph_of(f, "b"), 5, range);
    for (const FixedNode& node : lane.nodes) {
      if (is_limit(node)) return std::pair(node.value, node.format.name());
    }
    return std::pair(Range{0, 0}, std::string("none"));
  };
  using Limit = std::pair<Range, std::string>;
  const Range both = {-3, 3}, positive = {0, 3};  // units of 1/8
  EXPECT_EQ(limited("within(a, -1, 1.9)", both), Limit(in_eighths(-8, 16), "sfix6_En3"));
  EXPECT_EQ(limited("within(a, -1.9, 0)", both), Limit(in_eighths(-16, 0), "sfix5_En3"));
  EXPECT_EQ(limited("within(a, 0, 1)", both), Limit(in_eighths(0, 8), "ufix4_En3"));
  EXPECT_EQ(limited("within(a, 0.7, 0.8)", positive), Limit(in_eighths(5, 7), "ufix3_En3"));
  EXPECT_EQ(limited("within(a, 1, 1)", positive), Limit(in_eighths(8, 8), "ufix4_En3"));
  EXPECT_EQ(limited("within(a, 0, 0)", both), Limit(in_eighths(0, 0), "ufix1_En3"));
  EXPECT_EQ(limited("within(a, -4, 4)", both).second, "none") << "all that the operand can be";
  EXPECT_EQ(limited("within(a, -9, 9)", positive).second, "none");
}

TEST(FixedLane, ALimitLeavesOtherNumbersUndecided) {
  const FixedLane lane = lane_of(graph_of("within(a - b, 1, 2)", "-1"), 5, {0, 3});
  for (int difference = -4; difference <= 24; ++difference) {
    const std::vector<Bits> inputs = {
        golden::from_rational(lane.input_format, mpq_class(difference + 4, 8)),
        golden::from_rational(lane.input_format, mpq_class(4, 8))};
    EXPECT_EQ(golden::evaluate_lane(lane, inputs).decided, 8 <= difference && difference <= 16)
        << difference;
  }
}

TEST(FixedLane, ARootMayTakeWhatALimitKeepsFromZero) {
  const Graph graph = graph_of("sqrt(within(a - b, 0.5, 4))", "1");
  const std::vector<std::optional<Range>> ranges(2, Range{0, 3});
  const auto is_refused = [&](int bits) {
    return !fixed::fixed_lane(graph, format_of(53, 8), {.format = {bits}, .ranges = ranges}).ok();
  };
  EXPECT_TRUE(is_refused(2)) << "a unit of 1: 0 as computed may be below in truth";
  EXPECT_FALSE(is_refused(3)) << "a unit of 1/2, which the difference is off by at most";
}

TEST(FixedLane, AConstantIsNoFartherThanItsErrorSays) {
  const FixedLane lane = lane_of(graph_of("0.3 * a", "-2.5"), 5, {0, 1});
  const auto constant =
      std::find_if(lane.nodes.begin(), lane.nodes.end(),
                   [](const FixedNode& node) { return node.operation == Operation::constant; });
  ASSERT_NE(constant, lane.nodes.end());
  EXPECT_EQ(constant->format.name(), "ufix5_En6") << "19/64";
  EXPECT_EQ(constant->constant, 19);
  EXPECT_EQ(constant->error.low, mpq_class(19, 64) - mpq_class(3, 10));
  EXPECT_EQ(constant->error, (Range{constant->error.low, constant->error.low}));
}

FixedLane block_of(const Graph& graph, int bits, std::vector<std::optional<Range>> ranges = {}) {
  ranges.resize(graph.inputs().size());
  return fixed::fixed_lane(graph, format_of(24, 8),
                           {.format = {bits, true}, .ranges = std::move(ranges)})
      .value();
}

TEST(BlockLane, NeedsNoRangesAndTakesSignsFromThem) {
  const Graph graph = graph_of("a - b", "c");
  EXPECT_EQ(formats_of(block_of(graph, 9)).front(), "input sfix10_En9");
  const FixedLane lane = block_of(graph, 9, {Range{0, 1000}, Range{-1, 1}});
  EXPECT_EQ(lane.nodes[0].format.name(), "ufix9_En9");
  EXPECT_EQ(lane.nodes[1].format.name(), "sfix10_En9");
}

/// 5 is the largest magnitude, so all operands are counted in units of 8 / 2^4.
TEST(BlockLane, CountsInUnitsOfTheLargestOperand) {
  const FixedLane lane = block_of(graph_of("a - b", "c"), 4);
  const auto values = integers_of(lane, {"-5", "1.7", "0.4"});
  EXPECT_EQ(values[0], mpz_class(-11));  // one's complement
  EXPECT_EQ(values[1], mpz_class(3));
  EXPECT_EQ(integers_of(lane, {"-0x5p100", "0x1.bp100", "0.4"})[0], values[0]);
  EXPECT_EQ(integers_of(lane, {"8", "1.7", "0.4"})[0], mpz_class(8));
}

/// Below the least normal number the unit stays.
TEST(BlockLane, CountsSubnormalsInTheUnitOfNormals) {
  const FixedLane lane = block_of(graph_of("a", "b"), 4);
  EXPECT_EQ(integers_of(lane, {"0x1p-127", "0"})[0], mpz_class(4));
  EXPECT_EQ(integers_of(lane, {"0x1p-126", "0"})[0], mpz_class(8));
  EXPECT_EQ(integers_of(lane, {"0x1.8p-126", "0"})[0], mpz_class(12));
}

TEST(BlockLane, MistakesNameTheFormat) {
  const auto mixed = fixed::fixed_lane(graph_of("a^2", "b"), format_of(24, 8),
                                       {.format = {9, true}, .ranges = {{}, {}}});
  ASSERT_FALSE(mixed.ok());
  EXPECT_EQ(mixed.error().received, "block9");
}

TEST(FixedLane, DividesByConstants) {
  const FixedLane lane = lane_of(graph_of("a / 3", "b"), 6, {0, 4});
  const auto constant =
      std::find_if(lane.nodes.begin(), lane.nodes.end(),
                   [](const FixedNode& node) { return node.operation == Operation::constant; });
  ASSERT_NE(constant, lane.nodes.end());
  EXPECT_EQ(constant->constant, 43);  // in units of 2^-7
  EXPECT_EQ(constant->error.low, mpq_class(43, 128) - mpq_class(1, 3));
}

TEST(FixedLane, MistakesNameWhatIsMissing) {
  const Graph graph = graph_of("a", "b");
  const auto open =
      fixed::fixed_lane(graph, format_of(53, 8), {.ranges = {Range{0, 1}, std::nullopt}});
  ASSERT_FALSE(open.ok());
  EXPECT_EQ(open.error().field, "inputs.b.range");
  const Graph quotient = graph_of("a / b", "1");
  const auto of_both_signs =
      fixed::fixed_lane(quotient, format_of(53, 8), {.ranges = {Range{0, 1}, Range{-1, 2}}});
  ASSERT_FALSE(of_both_signs.ok());
  EXPECT_EQ(of_both_signs.error().message, "the divisor may be below 0 and above it: a / b");
  const auto in_blocks = fixed::fixed_lane(
      quotient, format_of(53, 8), {.format = {9, true}, .ranges = {Range{0, 1}, Range{1, 2}}});
  ASSERT_FALSE(in_blocks.ok());
  EXPECT_EQ(in_blocks.error().message,
            "lanes with guard digits or blocks divide only by constants: a / b");
  const auto negative = fixed::fixed_lane(graph_of("sqrt(a - b)", "1"), format_of(53, 8),
                                          {.ranges = {Range{0, 1}, Range{0, 1}}});
  ASSERT_FALSE(negative.ok());
  EXPECT_EQ(negative.error().message, "the radicand of a root may be negative: sqrt(a - b)");
  const auto beyond = fixed::fixed_lane(graph_of("within(a, 20, 30)", "1"), format_of(53, 8),
                                        {.ranges = {Range{0, 10}}});
  ASSERT_FALSE(beyond.ok());
  EXPECT_EQ(beyond.error().message, "the ranges allow no value that is within the limits: a");
  // 0.2 becomes 0.25, and the difference becomes 0 although in truth it is -0.05.
  const auto hidden = fixed::fixed_lane(graph_of("sqrt(a + 0.2 - 0.25)", "1"), format_of(53, 8),
                                        {.format = {1}, .ranges = {Range{0, 1}}});
  ASSERT_FALSE(hidden.ok());
  EXPECT_EQ(hidden.error().message, "the radicand of a root may be negative: sqrt(a + 0.2 - 0.25)");
}

}  // namespace
}  // namespace mixcmp::test::fixed_lane_test
