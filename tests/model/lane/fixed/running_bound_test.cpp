#include "model/lane/fixed/running_bound.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/model/lane/fixed/lanes.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/graphs.hpp"

/// Tests lanes whose thresholds follow the magnitudes of the factors.
namespace mixcmp::test::running_bound_test {
namespace {

using fixed::FixedLane;
using fixed::RunningThresholds;

FixedLane running(const char* f, const char* g, int bits, const Range& range) {
  return lane_of(graph_of(f, g), bits, range, BoundKind::running);
}

/// Operands below 8 in q10 count 2^-7. Both factors of a product below 8 (1024 units, in step 7),
/// or below 1/16 (8 units, in step 0), are off by less than a unit each: a b' + b a' - a' b' is at
/// least -2 1024 + 1 units of the product, or -2 8 + 1.
TEST(RunningBound, AProductErrsByItsFactors) {
  const FixedLane lane = running("a * b", "c", 10, {0, mpq_class(15, 2)});
  const auto& thresholds = std::get<RunningThresholds>(lane.parts.front().criterion).of_steps;
  ASSERT_EQ(thresholds.size(), 8U);
  EXPECT_EQ(lane.nodes[lane.parts.front().difference].format.unit_exponent, -14);
  // c is off by up to 128 units of the product. If factors have n units, the difference is off by
  // -(2 n - 1) to 128 of these units.
  EXPECT_EQ(thresholds[0], 129);
  EXPECT_EQ(thresholds[7], 2 * 1023 + 1);
  for (std::size_t step = 1; step < thresholds.size(); ++step) {
    EXPECT_LE(thresholds[step - 1], thresholds[step]);
  }
}

/// d enters no product, so it is not watched.
TEST(RunningBound, WatchesWhatIsMultiplied) {
  const FixedLane lane = running("(a - b)^2 + d", "a * c", 6, {0, 1});
  const auto& watched = std::get<RunningThresholds>(lane.parts.front().criterion).watched;
  std::vector<std::string> names;
  for (const NodeId id : watched) {
    const fixed::FixedNode& node = lane.nodes[id];
    const bool is_input = node.operation == Operation::input;
    names.push_back(is_input ? lane.input_names[node.input]
                             : std::string(to_string(node.operation)));
  }
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names, (std::vector<std::string>{"a", "c", "subtract"}));
}

/// In step 0 magnitudes are below 8 / 2^7.
TEST(RunningBound, SmallOperandsAreDecidedNearer) {
  const FixedLane lane = running("a * b", "c * d", 10, {0, mpq_class(15, 2)});
  const auto decided = [&](const std::vector<mpq_class>& operands) {
    std::vector<Bits> inputs;
    for (const mpq_class& operand : operands) {
      inputs.push_back(golden::from_rational(lane.input_format, operand));
    }
    return golden::evaluate_lane(lane, inputs).decided;
  };
  const mpq_class unit(1, 128), small = 7 * unit, large = 1000 * unit;
  EXPECT_TRUE(decided({small, small, unit, unit})) << "48 units of the product apart";
  EXPECT_FALSE(decided({large, small, large, 6 * unit})) << "1000 units apart";
}

/// A quotient errs by its reciprocal's rounding, in proportion to a; The limits leave one bit of d,
/// which is therefore not watched.
TEST(RunningBound, WatchesQuotientsAndNothingOfOneBit) {
  const FixedLane quotient = running("a / 3", "b / 7", 9, {0, 8});
  EXPECT_EQ(std::get<RunningThresholds>(quotient.parts.front().criterion).watched.size(), 2U);
  const FixedLane narrow = running("a * within(d, 0, 1/128)", "b * c", 9, {0, 3});
  EXPECT_EQ(std::get<RunningThresholds>(narrow.parts.front().criterion).watched.size(), 3U);
}

/// An error above all differences needs no wider threshold than these.
TEST(RunningBound, ThresholdsAreNoWiderThanDifferences) {
  const FixedLane lane =
      running("within(a * b, 0, 1/64)^3", "within(c * b, 0, 1/64)^3", 12, {0, 8});
  const auto& thresholds = std::get<RunningThresholds>(lane.parts.front().criterion).of_steps;
  const mpz_class most = lane.nodes[lane.parts.front().difference].format.largest() + 1;
  EXPECT_EQ(*std::max_element(thresholds.begin(), thresholds.end()), most);
}

TEST(RunningBound, IsRefusedWhereNothingIsMultiplied) {
  const Graph graph = graph_of("a - b", "c");
  const auto lane = fixed::fixed_lane(
      graph, format_of(24, 8),
      {.format = {9}, .bound = BoundKind::running, .ranges = {graph.inputs().size(), Range{0, 1}}});
  ASSERT_FALSE(lane.ok());
  EXPECT_EQ(lane.error().field, "reduced.error_bound");
  EXPECT_EQ(lane.error().received, "running");
}

}  // namespace
}  // namespace mixcmp::test::running_bound_test
