#include <gtest/gtest.h>

#include "model/base/number/dyadic.hpp"
#include "model/base/number/exact.hpp"
#include "model/base/number/verdict.hpp"
#include "model/judge/golden/evaluate.hpp"
#include "model/lane/error/certified_lane.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/graphs.hpp"

/// Tests operands just beside the midpoints of the digits that a lane takes, at either end of the
/// exponents. The lane's difference of them is off by as much as its bound says.
namespace mixcmp::test::input_digits_test {
namespace {

using error::Lane;

const FloatFormat reference = format_of(53, 8);
constexpr int lane_digits = 17, input_digits = 20;

Lane lane_of(Rounding rounding, int bound_digits) {
  const Arithmetic reduced{format_of(lane_digits, 8), rounding, Subnormals::flush};
  const TypedGraph graph =
      lane_graph(graph_of("a - b", "c"), reference, reduced, LaneInputs::of_digits(input_digits));
  return error::certified_lane(graph, {.kind = BoundKind::running, .bound_digits = bound_digits})
      .value();
}

/// a, b and c times 2^exponent, such that a - b rounds to 0 and c to 2^-19, while a - b is the
/// larger by 2^-51 or so: both operands are misread by nearly their largest error, which adds up.
std::vector<Bits> misread(Rounding rounding, int exponent) {
  const mpq_class hair = power_of_two(-52), place = power_of_two(1 - input_digits);
  const bool nearest = rounding == Rounding::nearest_even;
  const mpq_class a = 1 + (nearest ? mpq_class(place / 2) : place) - hair;
  const mpq_class b = nearest ? mpq_class(1 - place / 4 + hair) : mpq_class(1);
  const mpq_class c = a - b - hair;
  std::vector<Bits> operands;
  for (const mpq_class& operand : {a, b, c}) {
    const mpq_class scaled = operand * power_of_two(exponent);
    operands.push_back(from_rational(reference, scaled));
    EXPECT_EQ(to_rational(reference, operands.back()), scaled);
  }
  return operands;
}

mpq_class bound_of(const Lane& lane, const std::vector<Bits>& operands) {
  const auto& bound = std::get<error::AbsoluteBoundCriterion>(lane.criterion()).bound;
  const auto values = golden::evaluate(lane.graph, operands);
  return bound_value(bound.format, golden::evaluate_bound(bound, lane.graph, values).back());
}

TEST(InputDigits, OperandsBesideMidpointsAreNotDecidedWrongly) {
  const Graph graph = graph_of("a - b", "c");
  for (const Rounding rounding : {Rounding::nearest_even, Rounding::toward_zero}) {
    for (const int bound_digits : {1, 4}) {
      const Lane lane = lane_of(rounding, bound_digits);
      for (int exponent = reference.min_exponent() + 22; exponent <= reference.max_exponent();
           ++exponent) {
        const std::vector<Bits> operands = misread(rounding, exponent);
        const Verdict truth = golden::true_verdict(graph, reference, operands).value();
        const golden::LaneResult result = golden::evaluate_lane(lane, operands);
        ASSERT_EQ(truth, Verdict::greater);
        ASSERT_TRUE(!result.decided || result.verdict == truth)
            << to_string(rounding) << ", bound of " << bound_digits << " digits, 2^" << exponent;
      }
    }
  }
}

/// A bound of half the size would decide these operands, and wrongly.
TEST(InputDigits, OperandsBesideMidpointsAttainTheBound) {
  for (const Rounding rounding : {Rounding::nearest_even, Rounding::toward_zero}) {
    const Lane lane = lane_of(rounding, 4);
    const std::vector<Bits> operands = misread(rounding, 0);
    const auto values = golden::evaluate(lane.graph, operands);
    const auto& criterion = std::get<error::AbsoluteBoundCriterion>(lane.criterion());
    const mpq_class difference =
        to_rational(lane.graph.arithmetic.format, values[criterion.difference].bits);
    EXPECT_LT(difference, 0) << "the lane has them the wrong way round";
    EXPECT_LT(bound_of(lane, operands) / 2, abs(difference));
  }
}

}  // namespace
}  // namespace mixcmp::test::input_digits_test
