#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

#include "model/base/number/double.hpp"
#include "model/base/number/dyadic.hpp"
#include "model/base/number/exact.hpp"
#include "model/judge/golden/fixed_evaluate.hpp"
#include "model/lane/fixed/encoded_range.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/function_comparisons.hpp"

/// Operands that functions read as their encodings.
namespace mixcmp::test::encodings_test {
namespace {

using fixed::EncodedRange;
using fixed::FixedLane;
using fixed::FixedNode;

FixedLane lane_of(const char* f, const Range& range, int bits, bool is_reference = false) {
  const FunctionComparison comparison = {"", {{f, "b"}}, {range, {-1024, 1024}}};
  return comparison.lane(format_of(24, 8), bits, is_reference).value();
}

bool reads_encodings(const FixedLane& lane) {
  return std::any_of(lane.nodes.begin(), lane.nodes.end(),
                     [](const FixedNode& node) { return node.is_encoding; });
}

const FixedNode& code_of(const FixedLane& lane) {
  return *std::find_if(lane.nodes.begin(), lane.nodes.end(), [&](const FixedNode& node) {
    return fixed::is_code_of_encoding(lane.nodes, node);
  });
}

/// Every range of a small format: codes hold all its numbers, in order, in as few bits as hold the
/// exponents.
TEST(EncodedRanges, HoldTheirNumbers) {
  const FloatFormat format = format_of(5, 4);
  constexpr int fraction_bits = 3, dropped = 1;
  const int last_field = format.max_biased_exponent() - 1;
  for (int first = 1; first <= last_field; ++first) {
    for (int last = first; last <= last_field; ++last) {
      const Bits least = format.pack(false, first, 6), greatest = format.pack(false, last, 13);
      const EncodedRange range =
          EncodedRange::of(format, fraction_bits, format.fraction_bits(),
                           {to_rational(format, least), to_rational(format, greatest)})
              .with_whole_binades();
      const function::FloatingEncoding encoding = range.encoding();
      EXPECT_EQ(range.first_code() >> fraction_bits, first - range.first_exponent());
      EXPECT_LT(range.last_code(), 1 << (fraction_bits + encoding.exponent_bits));
      EXPECT_GE(range.first_code(), 0);
      EXPECT_TRUE(encoding.exponent_bits == 0 || (last - first) >> (encoding.exponent_bits - 1));
      for (Bits bits = format.pack(false, first, 0); bits <= format.pack(false, last, 15); ++bits) {
        const mpz_class code =
            to_integer(bits >> dropped) - shifted_left(range.first_exponent(), 3);
        ASSERT_LE(range.first_code(), code);
        ASSERT_LE(code, range.last_code());
        ASSERT_EQ(encoding.number(code), to_rational(format, bits >> dropped << dropped));
      }
    }
  }
}

/// The code is made by wires if the exponents differ in low bits only.
TEST(EncodedRanges, BeginAtAMultipleOfTheHighestPowerOfTwo) {
  const auto first_exponent = [](const mpq_class& low, const mpq_class& high) {
    return EncodedRange::of(format_of(24, 8), 4, 23, {low, high}).first_exponent();
  };
  EXPECT_EQ(first_exponent(mpq_class(1, 8192), 1), 112);                // 114 to 127 in four bits
  EXPECT_EQ(first_exponent(mpq_class(1, 4), 9), 124);                   // 125 to 130 in three
  EXPECT_EQ(first_exponent(mpq_class(1, 2), 2), 126);                   // 126 to 128 in two
  EXPECT_EQ(first_exponent(1, mpq_class(3, 2)), 127);                   // one exponent
  EXPECT_EQ(first_exponent(mpq_class(1, 4096), mpq_class(1, 8)), 112);  // 115 to 124, not from 115
}

TEST(Encodings, AreReadWhereAnOperandNearZeroIsSteep) {
  const mpq_class small(1, 8192);
  EXPECT_TRUE(reads_encodings(lane_of("log(a)", {small, 1}, 14)));
  EXPECT_TRUE(reads_encodings(lane_of("log2(3 * a)", {0, 1}, 14)));
  EXPECT_TRUE(reads_encodings(lane_of("1 / a", {small, 1}, 14)));
  EXPECT_TRUE(reads_encodings(lane_of("a^-0.5", {small, 1}, 14)));
  EXPECT_FALSE(reads_encodings(lane_of("log(a)", {1, 2}, 14)));
  EXPECT_FALSE(reads_encodings(lane_of("log(a + 1)", {0, 1}, 14)));
  EXPECT_FALSE(reads_encodings(lane_of("exp(a)", {small, 1}, 14)));
  EXPECT_FALSE(reads_encodings(lane_of("log(a * b)", {small, 1}, 14)));
  EXPECT_TRUE(reads_encodings(lane_of("log(a) / 2 + 1", {small, 1}, 14)));
  EXPECT_FALSE(reads_encodings(lane_of("exp(a)", {1, 20}, 14)));  // steep far from 0
  EXPECT_FALSE(reads_encodings(lane_of("mod(a, 0.25)", {small, 1}, 14)));
  // Subnormal numbers have no encoding, all others of the range do.
  EXPECT_TRUE(reads_encodings(lane_of("log(a)", {power_of_two(-149), 1}, 14)));
  // The whole binade of the range's end holds a pole.
  EXPECT_TRUE(reads_encodings(lane_of("tan(1.57 - a)", {mpq_class(1, 512), mpq_class(3, 2)}, 14)));
}

/// In fixed point the operand's rounding moves log(a) by 2^-14 / a, 0.5 at the least a.
TEST(Encodings, MoveLogarithmsByFewUnitsOfTheLane) {
  const FixedLane lane = lane_of("log(a)", {mpq_class(1, 8192), 1}, 14);
  const auto value = std::find_if(lane.nodes.begin(), lane.nodes.end(), [](const FixedNode& node) {
    return node.conversion == fixed::Conversion::function_value;
  });
  ASSERT_NE(value, lane.nodes.end());
  EXPECT_LT(absolute(value->error).high, 3 * power_of_two(4 - 14));  // |log(a)| < 16
}

/// All digits of an operand of binary32 reach a reference, so that its results err as little as if
/// the operand were exact.
TEST(Encodings, OfReferencesAreExact) {
  const FixedLane reference = lane_of("log(a)", {mpq_class(1, 8192), 1}, 36, true);
  const FixedNode& code = code_of(reference);
  EXPECT_EQ(code.format.unit_exponent, -23);
  const FixedNode& difference = reference.nodes[reference.parts[0].difference];
  EXPECT_LT(absolute(difference.error).high, power_of_two(4 - 36) + power_of_two(11 - 36));
}

TEST(Encodings, AreTheLowBitsOrLessTheFirstExponent) {
  const FixedLane by_wires = lane_of("log(a)", {mpq_class(1, 8192), 1}, 14);
  EXPECT_EQ(code_of(by_wires).operation, Operation::convert);
  EXPECT_EQ(code_of(by_wires).format.width + code_of(by_wires).format.unit_exponent, 4);
  const FixedLane by_difference = lane_of("log(a)", {mpq_class(1, 64), 9}, 14);
  EXPECT_EQ(code_of(by_difference).operation, Operation::subtract);
}

/// A running bound watches factors, of which a divisor that is read as its encoding is none.
TEST(Encodings, AreNotWatched) {
  const FunctionComparison comparison = {
      "", {{"b * (c - 1) / a", "c * b"}}, {{mpq_class(1, 64), 4}, {0, 8}, {0, 8}}};
  const Graph graph = comparison.graph();
  const FixedLane lane =
      fixed::fixed_lane(graph, format_of(24, 8),
                        {.format = {.bits = 8},
                         .bound = BoundKind::running,
                         .ranges = {comparison.ranges.begin(), comparison.ranges.end()}})
          .value();
  ASSERT_TRUE(reads_encodings(lane));
  const auto& thresholds = std::get<fixed::RunningThresholds>(lane.parts[0].criterion);
  const std::set<NodeId> read = fixed::fan_in(lane, lane.parts[0].difference);
  for (const NodeId id : thresholds.watched) EXPECT_TRUE(read.contains(id)) << id;
}

/// Whole binades where values grow little beyond the range, otherwise the declared ends.
TEST(Encodings, LeaveOtherOperandsUndecided) {
  const FloatFormat format = format_of(24, 8);
  const double infinity = std::numeric_limits<double>::infinity();
  const auto takes = [&](const FixedLane& lane, Bits a) {
    const std::vector<Bits> operands = {a, from_double(format, 1000)};
    return golden::evaluate_lane(lane, operands).decided;
  };
  const auto decides = [&](const FixedLane& lane, double a) {
    return takes(lane, from_double(format, a));
  };
  const FixedLane logarithm = lane_of("log(a)", {0x1.8p-13, 1}, 14);
  for (const double a : {0x1p-13, 0x1.8p-13, 0.3125, 1.0, 1.5, 0x1.fffffep0}) {
    EXPECT_TRUE(decides(logarithm, a)) << a;
  }
  for (const double a :
       {0x1.fffffep-14, 0x1p-140, 0.0, -0.0, -0.5, -1.0, 2.0, infinity, -infinity}) {
    EXPECT_FALSE(decides(logarithm, a)) << a;
  }
  EXPECT_FALSE(takes(logarithm, format.quiet_nan()));
  const FixedLane squared = lane_of("a^-2.5", {0x1.ep-3, 1}, 14);
  EXPECT_TRUE(decides(squared, 0x1.ep-3));
  EXPECT_FALSE(decides(squared, 0x1p-3));
}

TEST(Encodings, AreOfOperandsInFloatingPoint) {
  const FunctionComparison in_fixed_point = {"", {{"log(a)", "b"}}, {{}, {}}, {"q0.13", "q6.8"}};
  const auto lane = in_fixed_point.lane(format_of(53, 11), 10);
  EXPECT_TRUE(lane.ok());
  EXPECT_FALSE(reads_encodings(*lane));
}

}  // namespace
}  // namespace mixcmp::test::encodings_test
