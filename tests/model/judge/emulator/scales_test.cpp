#include <gtest/gtest.h>

#include "model/judge/emulator/safe_operands.hpp"
#include "tests/model/judge/emulator/against_golden.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/graphs.hpp"
#include "tests/support/lane_inputs.hpp"
#include "tests/support/sphere.hpp"

/// Tests whole batches of one scale, from the scale at which results vanish to that at which they
/// overflow. A statement about all operands at once has to hold for their neighbours as well.
namespace mixcmp::test::scales_test {
namespace {

using error::Lane;

/// Pairs of operands within two steps of each other, at the ends of the binade `exponent` or at
/// random in it.
Operands neighbours(FloatFormat format, int exponent, std::mt19937_64& random) {
  Operands operands(2);
  for (int k = 0; k < 64; ++k) {
    const Bits fraction = k % 4 == 0 ? 0 : random_encoding(format, random);
    const Bits a = format.pack(false, exponent + format.bias(), format.fraction(fraction));
    operands[0].push_back(a);
    operands[1].push_back(a + 1 + random() % 2);
  }
  return operands;
}

class Scales : public testing::TestWithParam<const char*> {};

TEST_P(Scales, NeighboursAreEmulatedBitForBit) {
  const Graph graph = graph_of(GetParam(), "(a + b)^2");
  std::mt19937_64 random(1);
  for (const char* name : {"s53e8", "s24e8", "s53e9"}) {
    const FloatFormat reference = format(name);
    for (const LaneInputs inputs : all_inputs(17)) {
      const Arithmetic reduced = {format_of(17, reference.exponent_bits()), Rounding::nearest_even,
                                  Subnormals::flush};
      const Lane lane = error::one_part_lane(lane_graph(graph, reference, reduced, inputs),
                                             error::UlpDistanceCriterion{3, false});
      const int highest = reference.max_exponent() - 1;
      for (int exponent = reference.min_exponent(); exponent <= highest; ++exponent) {
        expect_golden(lane, neighbours(reference, exponent, random));
        if (HasFailure()) return;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Expressions, Scales,
                         testing::Values("(a - b)^2", "a / b", "sqrt(a * b)", "1 / (a * a)",
                                         "(a - b) * a", "max(a, b) / min(a, 1000 * b)",
                                         "abs(a - b) / (a * b)", "a * b * a * b"));

/// A change of sign does not look at its operand: a subnormal operand is not exceptional there.
TEST(FlushingLanes, DecideOnOperandsThatOnlyChangeSign) {
  const FloatFormat only = format("s9e4");
  const auto node = [&](Operation operation, int operand, int input) {
    return TypedNode{.operation = operation,
                     .operands = {operand, -1},
                     .operand_format = only,
                     .format = only,
                     .input = input,
                     .value = {}};
  };
  const TypedGraph graph = {
      .nodes = {node(Operation::input, -1, 0), node(Operation::negate, 0, -1),
                node(Operation::input, -1, 1), node(Operation::absolute, 2, -1)},
      .input_count = 2,
      .input_names = {"a", "b"},
      .input_format = only,
      .arithmetic = {only, Rounding::nearest_even, Subnormals::flush},
      .parts = {{1, 3}}};
  Operands operands(2);
  for (const Bits a : special_encodings(only)) {
    for (const Bits b : special_encodings(only)) {
      operands[0].push_back(only.is_nan(a) ? only.quiet_nan() : a);
      operands[1].push_back(only.is_nan(b) ? only.quiet_nan() : b);
    }
  }
  expect_golden(error::one_part_lane(graph, error::UlpDistanceCriterion{2, false}), operands);
}

/// Steps of the encoding below the smallest normal number are not those of a double.
TEST(SubnormalConstants, AreAsFarApartAsTheirEncodings) {
  const FloatFormat reduced = format("s9e2");
  const Graph graph = graph_of("max(a, 0.046875)", "-a");
  const TypedGraph typed =
      lane_graph(graph, format("s17e2"), {reduced, Rounding::nearest_even, Subnormals::gradual},
                 LaneInputs::rounded);
  std::mt19937_64 random(1);
  Operands operands(1);
  for (int k = 0; k < 500; ++k) operands[0].push_back(random_encoding(format("s17e2"), random));
  for (Bits guard = 1; guard < 1024; guard *= 2) {
    expect_golden(error::one_part_lane(typed, error::UlpDistanceCriterion{guard, false}), operands);
  }
}

TEST(SafeOperands, OfTheSphereComparisonAreLimitedBySquares) {
  const auto safe = emulator::safe_operands(
      lane_graph(sphere_graph(), format("s53e8"), {format("s17e8")}, LaneInputs::exact));
  ASSERT_TRUE(safe.has_value());
  // Differences are multiples of 2^(low - 52). That is 2^-63, whose square is the smallest normal
  // number.
  EXPECT_EQ(safe->low, -11);
  // The sum of three squares of differences is below 2^(2 (high + 1) + 2), which must be at most
  // 2^127.
  EXPECT_EQ(safe->high, 61);
}

TEST(SafeOperands, DoNotExistWhereADivisorMayBeZero) {
  EXPECT_FALSE(emulator::safe_operands(lane_graph(graph_of("1 / (a - b)", "a"), format("s53e8"),
                                                  {format("s17e8")}, LaneInputs::exact)));
}

TEST(SafeOperands, DoNotExistWhereARadicandMayBeNegative) {
  EXPECT_FALSE(emulator::safe_operands(
      lane_graph(graph_of("sqrt(a)", "b"), format("s53e8"), {format("s17e8")}, LaneInputs::exact)));
}

TEST(SafeOperands, DoNotExistWhereDifferencesMayVanishInASmallFormat) {
  EXPECT_FALSE(emulator::safe_operands(lane_graph(graph_of("(a - b)^2", "a"), format("s53e8"),
                                                  {format("s8e4")}, LaneInputs::exact)));
}

}  // namespace
}  // namespace mixcmp::test::scales_test
