#include <gtest/gtest.h>

#include <algorithm>

#include "model/base/number/decimal.hpp"
#include "model/judge/golden/fixed_evaluate.hpp"
#include "tests/model/lane/fixed/lanes.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/graphs.hpp"

/// Tests lanes that decide by the norm of the errors.
namespace mixcmp::test::norms_test {
namespace {

using fixed::FixedLane;
using fixed::FixedNode;
using fixed::NormThresholds;

TEST(Norms, ASphereIsDecidedByTheNormOfItsErrors) {
  const FixedLane lane = lane_of(graph_of(spheres, "(ri + rj)^2"), 13, {0, 100});
  const auto& norm = std::get<NormThresholds>(lane.parts.front().criterion);
  // Differences are off by less than a unit, their norm by sqrt(3); the radii's sum by two units,
  // downward only: 2 (sqrt(3) + 2) = 7.46 and 2 sqrt(3) = 3.46.
  EXPECT_EQ(norm.shift_above, 3) << "8 >= 2 (sqrt(3) + 2)";
  EXPECT_EQ(norm.shift_below, 2);
  EXPECT_EQ(norm.offset_above, 14) << "floor((sqrt(3) + 2)^2) + 1";
  EXPECT_EQ(lane.nodes[norm.radius].format.name(), "ufix14_En6");
}

TEST(Norms, ARadiusMayErrUpward) {
  const FixedLane lane = lane_of(graph_of("a^2 + d^2", "abs(b - c)^2"), 13, {0, 100});
  const auto& norm = std::get<NormThresholds>(lane.parts.front().criterion);
  EXPECT_EQ(norm.shift_above, 3) << "2 (sqrt(2) + 1) <= 8: a unit of each square";
  EXPECT_EQ(norm.shift_below, 3);
}

/// The result is the same whichever side is f. A radius that is an operand errs less than a
/// difference, and only squares other than that of the radius have a reach.
TEST(Norms, TheRadiusIsTheSquareThatGivesTheSmallerSlopes) {
  for (const bool swapped : {false, true}) {
    const char *near = "(a / 8)^2", *far = "(b - c)^2";
    const Graph graph = swapped ? graph_of(near, far) : graph_of(far, near);
    const FixedLane lane = lane_of(graph, 13, {0, 100});
    const fixed::FixedPart& part = lane.parts.front();
    const auto& norm = std::get<NormThresholds>(part.criterion);
    const FixedNode& radius = lane.nodes[norm.radius];
    EXPECT_EQ(part.swapped, swapped);
    EXPECT_FALSE(radius.format.is_signed);
    EXPECT_EQ(norm.shift_below, 1);
    EXPECT_EQ(std::count_if(lane.nodes.begin(), lane.nodes.end(), fixed::is_reach), 1);
  }
}

/// In units of 2^-10 radii are below 2^11 units as computed; 2^12 squared is beyond all thresholds
/// of these, and 2^11 squared is not.
TEST(Norms, NeedNoBitsBeyondReach) {
  const Graph graph = graph_of("(a - b)^2", "(c + d)^2");
  const fixed::FixedOptions options{
      .format = {.bits = 13},
      .ranges = {Range{0, 100}, Range{0, 100}, Range{0, mpq_class(1, 2)}, Range{0, 1}}};
  const FixedLane lane = fixed::fixed_lane(graph, format_of(53, 8), options).value();
  const auto reach = std::find_if(lane.nodes.begin(), lane.nodes.end(), fixed::is_reach);
  ASSERT_NE(reach, lane.nodes.end());
  const auto& norm = std::get<NormThresholds>(lane.parts.front().criterion);
  const mpq_class most = lane.nodes[norm.radius].value.high;
  EXPECT_LT(most, 4);
  EXPECT_EQ(reach->value, (Range{-4, 4 - reach->format.unit()})) << most.get_d();
}

TEST(Norms, AreWholeWhereRadiiReachAsFar) {
  const FixedLane lane = lane_of(graph_of(spheres, "(ri + rj)^2"), 13, {0, 100});
  EXPECT_TRUE(std::none_of(lane.nodes.begin(), lane.nodes.end(), fixed::is_reach));
}

/// The golden model computes numbers beyond reach and finds them greater as well.
TEST(Norms, BeyondReachAreGreaterAsComputed) {
  const Graph graph = graph_of("(a - b)^2", "c^2");
  const fixed::FixedOptions options{.format = {.bits = 6},
                                    .ranges = {Range{0, 31}, Range{0, 31}, Range{0, 3}}};
  const FixedLane lane = fixed::fixed_lane(graph, format_of(24, 8), options).value();
  const auto reach = std::find_if(lane.nodes.begin(), lane.nodes.end(), fixed::is_reach);
  ASSERT_NE(reach, lane.nodes.end());
  const auto decided = [&](const mpq_class& a) {
    std::vector<Bits> inputs;
    for (const mpq_class& operand : {a, mpq_class(0), mpq_class(63, 16)}) {
      inputs.push_back(golden::from_rational(lane.input_format, operand));
    }
    return golden::evaluate_lane(lane, inputs);
  };
  const mpq_class beyond = reach->value.high + reach->format.unit();
  EXPECT_TRUE(decided(beyond).decided);
  EXPECT_EQ(decided(beyond).verdict, Verdict::greater);
  EXPECT_FALSE(decided(beyond / 2).decided) << "with half the reach it would not be";
}

/// The least element beyond reach, with the largest norm on the other side, is greater in the
/// golden model, which computes the whole difference.
TEST(Norms, BeyondReachOfANormAreGreaterAsComputed) {
  const Graph graph = graph_of("a^2 + b^2", "c^2 + d^2 + e^2");
  const mpq_class tops[] = {mpq_class(1, 2), 1, 2, 4};
  int lanes_with_reach = 0;
  for (const mpq_class& c : tops) {
    for (const mpq_class& d : tops) {
      const mpq_class short_of_c = c * mpq_class(255, 256), short_of_d = d * mpq_class(255, 256);
      const fixed::FixedOptions options{.format = {.bits = 5},
                                        .ranges = {Range{0, 31}, Range{0, 31}, Range{0, short_of_c},
                                                   Range{0, short_of_d}, Range{0, short_of_d}}};
      const FixedLane lane = fixed::fixed_lane(graph, format_of(24, 8), options).value();
      const auto reach = std::find_if(lane.nodes.begin(), lane.nodes.end(), fixed::is_reach);
      if (reach == lane.nodes.end()) continue;
      ++lanes_with_reach;
      const mpq_class beyond = reach->value.high + reach->format.unit();
      std::vector<Bits> inputs;
      for (const mpq_class& operand : {beyond, mpq_class(0), short_of_c, short_of_d, short_of_d}) {
        inputs.push_back(golden::from_rational(lane.input_format, operand));
      }
      const golden::LaneResult result = golden::evaluate_lane(lane, inputs);
      EXPECT_TRUE(result.decided && result.verdict == Verdict::greater)
          << beyond << " beside " << c << ", " << d;
    }
  }
  EXPECT_GT(lanes_with_reach, 0);
}

/// In units of 2^18 a and c are 1, b and d are 0, though they are less than a unit apart. Within
/// reach the difference drops fewer bits than without: thresholds in its units are larger.
TEST(Norms, HaveThresholdsOfTheDifferenceWithinReach) {
  const Graph graph = graph_of("(a - b)^2 + (c - d)^2", "s^2");
  const fixed::FixedOptions options{.format = {.bits = 2},
                                    .ranges = {Range{0, 1000000}, Range{0, 1000000},
                                               Range{0, 1000000}, Range{0, 1000000}, Range{0, 1}}};
  const FixedLane lane = fixed::fixed_lane(graph, format_of(24, 8), options).value();
  std::vector<Bits> inputs;
  for (const char* operand : {"262144", "262143.984375", "262144", "262143.984375", "0.9"}) {
    inputs.push_back(from_text(lane.input_format, operand).value());
  }
  EXPECT_FALSE(golden::evaluate_lane(lane, inputs).decided) << "less, in truth";
}

/// Every possible a + 30 and a - 30 is beyond the reach of 2^m. The radius is c, as the other side
/// has two squares.
TEST(Norms, HaveNoReachThatNothingIsWithin) {
  for (const char* f : {"(a + 30)^2 + b^2", "(a - 30)^2 + b^2"}) {
    for (const Range& range : {Range{0, 3}, Range{-3, 0}}) {
      const fixed::FixedOptions options{.format = {.bits = 6},
                                        .ranges = {range, Range{0, 1}, Range{0, 1}}};
      const FixedLane lane =
          fixed::fixed_lane(graph_of(f, "c^2"), format_of(24, 8), options).value();
      EXPECT_TRUE(std::none_of(lane.nodes.begin(), lane.nodes.end(), fixed::is_reach)) << f;
    }
  }
}

/// Every unit exceeds a radius of zero.
TEST(Norms, HaveReachesOfABitOrMore) {
  const Graph graph = graph_of("4 * (a - a)^2 + b^2 + (a - b)^2", "(c - c)^2");
  const FixedLane lane = lane_of(graph, 9, {0, 3}, BoundKind::norm);
  for (const FixedNode& node : lane.nodes) {
    if (!fixed::is_reach(node)) continue;
    EXPECT_LT(node.format.magnitude_bits(), lane.nodes[node.operands[0]].format.magnitude_bits());
  }
}

/// A radius counts 2^-11, differences 2^-6: 2 sqrt(3) leaves room below the slope 4 for errors of a
/// quarter of their unit, not for one of half.
TEST(Norms, KeepNoDigitsThatTheirSlopesDoNotNeed) {
  const Graph graph = graph_of(spheres, "(ri + rj)^2");
  std::vector<std::optional<Range>> ranges(graph.inputs().size(), Range{-100, 100});
  for (std::size_t input = 0; input < ranges.size(); ++input) {
    if (graph.inputs()[input].front() == 'r') ranges[input] = Range{0, 3};
  }
  const FixedLane lane =
      fixed::fixed_lane(graph, format_of(53, 8), {.format = {.bits = 13}, .ranges = ranges})
          .value();
  const auto& norm = std::get<NormThresholds>(lane.parts.front().criterion);
  EXPECT_EQ(lane.nodes[norm.radius].format.unit_exponent, -9);
}

}  // namespace
}  // namespace mixcmp::test::norms_test
