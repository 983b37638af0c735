#include "model/lane/error/constant_bound.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <random>
#include <vector>

#include "model/base/number/decimal.hpp"
#include "model/base/number/dyadic.hpp"
#include "model/base/number/exact.hpp"
#include "model/base/number/verdict.hpp"
#include "model/judge/golden/bound_arithmetic.hpp"
#include "model/judge/golden/evaluate.hpp"
#include "model/lane/error/certified_lane.hpp"
#include "model/lane/error/hazards.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/graphs.hpp"

/// Tests lanes whose bound is a constant, on operands that are aimed at that bound. c is placed
/// close to the real number f that the other operands give, so that a lane with a bound below f's
/// error decides wrongly. Real numbers are rationals here, computed by each comparison's own
/// formula.
namespace mixcmp::test::constant_bound_test {
namespace {

using error::Lane;
using golden::evaluate_lane;

using Rationals = std::vector<mpq_class>;

/// A comparison of f, a function of the first inputs, with c, the last input. f or its square is a
/// rational number.
struct Aimed {
  const char* name;
  const char* f;
  FloatFormat lane;
  Rounding rounding;
  std::vector<Range> ranges;
  std::function<mpq_class(const Rationals&)> exact;
  bool is_square = false;
  LaneInputs inputs = LaneInputs::exact;
};

void PrintTo(const Aimed& aimed, std::ostream* stream) {
  *stream << aimed.f << " against c";
}

const FloatFormat reference = format_of(24, 8);

Result<Lane> lane_of(const Aimed& aimed) {
  const Arithmetic arithmetic = {aimed.lane, aimed.rounding, Subnormals::gradual};
  const Graph graph = graph_of(aimed.f, "c");
  return error::certified_lane(
      lane_graph(graph, reference, arithmetic, aimed.inputs),
      {.kind = BoundKind::constant, .ranges = {aimed.ranges.begin(), aimed.ranges.end()}});
}

mpq_class& constant_of(Lane& lane) {
  return std::get<error::AbsoluteBoundCriterion>(lane.criterion()).bound.nodes.back().constant;
}

Verdict order(const Aimed& aimed, const Rationals& operands, const mpq_class& c) {
  const mpq_class f = aimed.exact(operands), g = aimed.is_square ? mpq_class(c * c) : c;
  if (f == g) return Verdict::equal;
  return f < g ? Verdict::less : Verdict::greater;
}

/// The real number f, or near enough to a root to aim with.
mpq_class f_of(const Aimed& aimed, const Rationals& operands) {
  const mpq_class f = aimed.exact(operands);
  return aimed.is_square ? mpq_class(std::sqrt(f.get_d())) : f;
}

struct Decisions {
  int wrong = 0;
  mpq_class largest_error = 0;  ///< |f - c| as computed, for c next to f
  std::string example;
};

/// Walks through the ranges towards large errors. The lane decides close to every point.
class Walk {
public:
  Walk(const Aimed& aimed, const Lane& lane) : aimed_(aimed), lane_(lane) {}

  Decisions run() {
    constexpr int walks = 30, steps = 300;
    for (int walk = 0; walk < walks; ++walk) {
      Rationals operands;
      for (std::size_t k = 0; k + 1 < aimed_.ranges.size(); ++k) operands.push_back(anywhere(k));
      mpq_class error = aim(operands);
      for (int step = 0; step < steps; ++step) {
        Rationals next = operands;
        const std::size_t k = random_() % next.size();
        next[k] = random_() % 4 == 0 ? anywhere(k) : near(k, next[k]);
        const mpq_class found = aim(next);
        if (found < error) continue;
        error = found;
        operands = next;
      }
    }
    return decisions_;
  }

private:
  mpq_class anywhere(std::size_t k) {
    const Range& range = aimed_.ranges[k];
    const mpq_class part(static_cast<unsigned long>(random_() >> 40), 1UL << 24);
    return representable(range.low + part * (range.high - range.low));
  }

  /// An operand up to an eighth of the range away, or closer by a random number of halvings.
  mpq_class near(std::size_t k, const mpq_class& operand) {
    const Range& range = aimed_.ranges[k];
    mpq_class step = (range.high - range.low) / (8UL << random_() % 16);
    if (random_() % 2 == 0) step = -step;
    return representable(std::clamp<mpq_class>(operand + step, range.low, range.high));
  }

  static mpq_class representable(const mpq_class& value) {
    return to_rational(reference, from_rational(reference, value));
  }

  /// Has the lane decide with c close to f. Returns the distance of f and c that the lane computes
  /// for the nearest c.
  mpq_class aim(const Rationals& operands) {
    std::vector<Bits> inputs;
    for (const mpq_class& operand : operands) inputs.push_back(from_rational(reference, operand));
    const mpq_class f = f_of(aimed_, operands);
    const Bits center = from_rational(reference, f);
    inputs.push_back(center);
    for (const Bits c : {center - 1, center + 1, center}) {
      inputs.back() = c;
      hold(operands, inputs);
    }
    const auto values = golden::evaluate(lane_.graph, inputs);
    const auto side = [&](NodeId id) { return to_rational(aimed_.lane, values[id].bits); };
    const mpq_class error = abs(side(lane_.graph.f()) - side(lane_.graph.g()));
    decisions_.largest_error = std::max(decisions_.largest_error, error);
    return error;
  }

  void hold(const Rationals& operands, const std::vector<Bits>& inputs) {
    const auto result = evaluate_lane(lane_, inputs);
    if (!result.decided) return;
    const Verdict truth = order(aimed_, operands, to_rational(reference, inputs.back()));
    if (result.verdict == truth) return;
    decisions_.wrong += 1;
    decisions_.example = fmt::format("{} for {}:", to_string(result.verdict), to_string(truth));
    for (const Bits input : inputs) decisions_.example += " " + to_text(reference, input);
  }

  const Aimed& aimed_;
  const Lane& lane_;
  std::mt19937_64 random_{1};
  Decisions decisions_;
};

Decisions decide(const Aimed& aimed, const Lane& lane) {
  return Walk(aimed, lane).run();
}

class ConstantBound : public testing::TestWithParam<Aimed> {};

TEST_P(ConstantBound, IsNeverTooSmall) {
  const auto lane = lane_of(GetParam());
  ASSERT_TRUE(lane.ok()) << lane.error().to_string();
  const Decisions decisions = decide(GetParam(), *lane);
  EXPECT_EQ(decisions.wrong, 0) << describe_criterion(*lane) << "; " << decisions.example;
}

/// The operands above are those that matter: they refute half the constant.
TEST_P(ConstantBound, HalvedDecidesWrongly) {
  Lane lane = lane_of(GetParam()).value();
  constant_of(lane) /= 2;
  const Decisions decisions = decide(GetParam(), lane);
  EXPECT_GT(decisions.wrong, 0) << describe_criterion(lane) << "; the largest error is "
                                << decisions.largest_error.get_d();
}

const Range just_above_one = {1, mpq_class(9, 8) - mpq_class(1, 256)};
const Range up_to_two = {1, mpq_class(15, 8) - mpq_class(1, 256)};
const Range short_of_two = {mpq_class(3, 2), mpq_class(13, 8) - mpq_class(1, 256)};
const Range about_root_of_two = {mpq_class(11, 8), mpq_class(3, 2) - mpq_class(1, 256)};

/// 2051 / 2048 lies between two numbers of 11 digits, so all six errors have the same direction.
constexpr const char* scaled_text =
    "a * 1.00146484375 * 1.00146484375 * 1.00146484375 * 1.00146484375 * 1.00146484375 * "
    "1.00146484375";

/// Ranges end at the limits of checks. Roundings err most beside numbers just above a power of two.
/// f is just below the next power of two, so that its magnitude is nearly twice its binade.
INSTANTIATE_TEST_SUITE_P(
    Aimed, ConstantBound,
    testing::Values(
        Aimed{"product",
              "a * b * d",
              format_of(8, 8),
              Rounding::nearest_even,
              {just_above_one, just_above_one, {mpq_class(5, 4), mpq_class(350, 256)}, up_to_two},
              [](const Rationals& x) { return mpq_class(x[0] * x[1] * x[2]); }},
        Aimed{"product_toward_zero",
              "a * b * d",
              format_of(9, 8),
              Rounding::toward_zero,
              {just_above_one, just_above_one, {mpq_class(5, 4), mpq_class(350, 256)}, up_to_two},
              [](const Rationals& x) { return mpq_class(x[0] * x[1] * x[2]); }},
        Aimed{"product_of_a_negative_factor",
              "a * b * d",
              format_of(8, 8),
              Rounding::nearest_even,
              {just_above_one,
               just_above_one,
               {mpq_class(-350, 256), mpq_class(-1, 8)},
               {mpq_class(-15, 8) + mpq_class(1, 256), mpq_class(-1, 8)}},
              [](const Rationals& x) { return mpq_class(x[0] * x[1] * x[2]); }},
        Aimed{"root",
              "sqrt(a * b) * d",
              format_of(8, 8),
              Rounding::nearest_even,
              {just_above_one, just_above_one, short_of_two, up_to_two},
              [](const Rationals& x) { return mpq_class(x[0] * x[1] * x[2] * x[2]); },
              true},
        Aimed{"constants_beside_the_middle",
              scaled_text,
              format_of(11, 8),
              Rounding::nearest_even,
              {{mpq_class(13, 8), mpq_class(447, 256)}, up_to_two},
              [](const Rationals& x) {
                mpq_class f = x[0];
                for (int k = 0; k < 6; ++k) f *= mpq_class(2051, 2048);
                return f;
              }},
        Aimed{"quotient",
              "(a * b - d) / e",
              format_of(8, 8),
              Rounding::nearest_even,
              {about_root_of_two,
               about_root_of_two,
               {2, mpq_class(9, 4) - mpq_class(1, 256)},
               just_above_one,
               {-1, 1}},
              [](const Rationals& x) { return mpq_class((x[0] * x[1] - x[2]) / x[3]); }},
        Aimed{"quotient_of_a_wide_divisor",
              "(a * b - d) / e",
              format_of(8, 8),
              Rounding::nearest_even,
              {about_root_of_two,
               about_root_of_two,
               {2, mpq_class(9, 4) - mpq_class(1, 256)},
               {mpq_class(1, 8), mpq_class(15, 8) - mpq_class(1, 256)},
               {-2, 2}},
              [](const Rationals& x) { return mpq_class((x[0] * x[1] - x[2]) / x[3]); }}),
    [](const auto& tested) { return tested.param.name; });

/// The divisor's error is a sixth of it, more than the 1/32 that theorem 7 asks for.
TEST(ConstantBoundOfAQuotient, NeedsADivisorWellAwayFromZero) {
  const auto against = [](const Range& d) {
    return lane_of({"",
                    "e / (a * b - d)",
                    format_of(8, 8),
                    Rounding::nearest_even,
                    {just_above_one, just_above_one, just_above_one, d, {-64, 64}},
                    {}});
  };
  EXPECT_TRUE(against({4, 8}).ok());
  const auto lane = against({mpq_class(11, 8), 8});
  ASSERT_FALSE(lane.ok());
  EXPECT_NE(lane.error().to_string().find("may be closer to zero than its own error"),
            std::string::npos)
      << lane.error().to_string();
}

/// A lane is described with the constant of its hardware, which is rounded up to the lane's digits.
TEST(ConstantBound, IsToldAsTheHardwareHasIt) {
  const auto told = [](const char* f, const char* g, FloatFormat arrives, FloatFormat lane,
                       const Range& range) {
    const Graph graph = graph_of(f, g);
    const std::vector<std::optional<Range>> ranges(graph.inputs().size(), range);
    const auto typed = lane_graph(graph, arrives, {lane}, LaneInputs::rounded);
    return describe_criterion(
        error::certified_lane(typed, {.kind = BoundKind::constant, .ranges = ranges}).value());
  };
  EXPECT_EQ(told("a * a", "b", format_of(24, 8), format_of(4, 8), {0, 1}),
            "certified: where |f - g| exceeds 0.3438, a constant");
  const mpq_class tiny = power_of_two(-126);
  EXPECT_EQ(told("a", "b", format_of(24, 8), format_of(8, 8), {tiny, 2 * tiny}),
            "certified: where |f - g| exceeds 1.175e-38, a constant");
  const std::string extreme =
      told("a * b", "c", format_of(24, 15), format_of(8, 15), {power_of_two(-1200), 1});
  EXPECT_EQ(extreme.find("exceeds 0,"), std::string::npos) << extreme;
  const std::string huge =
      told("a * b", "c", format_of(24, 15), format_of(8, 15), {1, power_of_two(6000)});
  EXPECT_NE(huge.find("e+3"), std::string::npos) << huge;
}

/// x is 0, and 1/8 in 4 digits: a and b lie on either side of the middle of two numbers that the
/// lane holds. The bound of x is 17/128. The lane has 32 x for f = 28 x, since four sums round up,
/// so that f is off by more than 28 times the bound of x.
TEST(ConstantBound, CoversSumsThatRoundUp) {
  const auto twice = [](const std::string& of) { return "(" + of + " + " + of + ")"; };
  const std::string x = "max(a - b - c, 0)";
  std::string f = twice(twice(twice(twice(x))));
  for (int k = 0; k < 4; ++k) f += " + " + twice(x) + " + " + x;
  const Graph graph = graph_of(f, "0");
  const mpq_class hair = power_of_two(-12), middle = mpq_class(17, 16);
  const std::vector<std::optional<Range>> ranges = {just_above_one, just_above_one, Range{0, hair}};
  const Lane lane =
      error::certified_lane(lane_graph(graph, reference, {format_of(4, 8)}, LaneInputs::rounded),
                            {.kind = BoundKind::constant, .ranges = ranges})
          .value();
  std::vector<Bits> inputs;
  for (const mpq_class& input :
       {mpq_class(middle + hair / 2), mpq_class(middle - hair / 2), hair}) {
    inputs.push_back(from_rational(reference, input));
  }
  EXPECT_EQ(golden::true_verdict(graph, reference, inputs), Verdict::equal);
  EXPECT_FALSE(evaluate_lane(lane, inputs).decided) << describe_criterion(lane);
}

TEST(ConstantBound, IsMultipliedByTheInflation) {
  const TypedGraph graph = lane_graph(graph_of("a * b - c", "0"), format_of(24, 8),
                                      {format_of(8, 8)}, LaneInputs::exact);
  const std::vector<error::RangeCheck> checks =
      error::full_range_checks(graph, std::vector<std::optional<Range>>(3, Range{1, 2}));
  const auto analysis = error::analyse_errors(graph, std::vector<bool>(3, true));
  error::AbsoluteError bound = analysis.nodes[graph.f()].mixed->absolute;
  const auto constant = error::constant_bound(graph, analysis, bound, checks);
  bound.inflation *= 2;
  const auto twice = error::constant_bound(graph, analysis, bound, checks);
  EXPECT_GT(constant.value(), 0);
  EXPECT_EQ(twice.value(), 2 * constant.value());
}

}  // namespace
}  // namespace mixcmp::test::constant_bound_test
