#include "tests/support/sphere.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "model/base/number/decimal.hpp"
#include "model/base/number/exact.hpp"
#include "model/base/number/verdict.hpp"
#include "model/judge/golden/evaluate.hpp"
#include "model/lane/error/profiled_lane.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/graphs.hpp"

/// Tests the sphere comparison at every precision that matters, on inputs made to mislead it.
namespace mixcmp::test::sphere_test {
namespace {

using error::Lane;
using golden::evaluate_lane;
using golden::LaneResult;
using golden::true_verdict;

/// The operands cxi, cxj, cyi, cyj, czi, czj, ri, rj.
using Spheres = std::array<double, 8>;

/// Two spheres at this distance, the second at the origin with no radius.
Spheres apart(double x, double y, double z, double radius) {
  return {x, 0, y, 0, z, 0, radius, 0};
}

std::vector<Bits> encode(FloatFormat format, const Spheres& spheres) {
  std::vector<Bits> inputs;
  for (const double value : spheres) {
    if (std::isnan(value)) {
      inputs.push_back(format.quiet_nan());
    } else if (std::isinf(value)) {
      inputs.push_back(format.infinity(value < 0));
    } else {
      inputs.push_back(from_rational(format, mpq_class(value)));
    }
  }
  return inputs;
}

/// The certified lanes of one precision: both roundings, both ways with subnormals.
class Judge {
public:
  Judge(FloatFormat reference, int precision) : reference_(reference), graph_(sphere_graph()) {
    const std::vector<bool> any_sign(8, false);
    for (const Arithmetic& arithmetic : every_arithmetic(format_of(precision, 8))) {
      auto typed = lane_graph(graph_, reference, arithmetic, LaneInputs::exact);
      lanes_.push_back(relative_lane(std::move(typed), any_sign).value());
    }
  }

  void judge(const Spheres& spheres) {
    const std::vector<Bits> inputs = encode(reference_, spheres);
    const Verdict truth = true_verdict(graph_, reference_, inputs).value();
    for (const Lane& lane : lanes_) {
      const LaneResult result = evaluate_lane(lane, inputs);
      ++judged_;
      if (!result.decided) continue;
      ++decided_;
      if (result.verdict != truth) ADD_FAILURE() << describe(lane, inputs, result, truth);
    }
  }

  double decided_share() const {
    return static_cast<double>(decided_) / static_cast<double>(judged_);
  }

private:
  std::string describe(const Lane& lane, const std::vector<Bits>& inputs, const LaneResult& result,
                       Verdict truth) const {
    const Arithmetic& arithmetic = lane.graph.arithmetic;
    std::string text = fmt::format("{} {} {}: truth {}, decided {};", arithmetic.format.name(),
                                   to_string(arithmetic.rounding), to_string(arithmetic.subnormals),
                                   to_string(truth), to_string(result.verdict));
    for (size_t k = 0; k < inputs.size(); ++k) {
      text += fmt::format(" {}={} ({})", graph_.inputs()[k], to_hex(inputs[k], reference_.width()),
                          to_text(reference_, inputs[k]));
    }
    return text;
  }

  FloatFormat reference_;
  Graph graph_;
  std::vector<Lane> lanes_;
  std::uint64_t judged_ = 0;
  std::uint64_t decided_ = 0;
};

class Sphere : public testing::TestWithParam<int> {
protected:
  double unit() { return static_cast<double>(random_() >> 11) * 0x1p-53; }
  int whole(int end) { return static_cast<int>(random_() % static_cast<unsigned>(end)); }

  /// A coordinate whose roundings err in one direction. It lies just beside the midpoint of two
  /// numbers of the lane with few digits, so that products have large roundings as well.
  double misleading() {
    const int precision = GetParam();
    double significand = 1 + std::ldexp(whole(8), 1 - precision);
    if (whole(2) != 0) significand = 1 + std::ldexp(1, -1 - whole(precision));
    const double hair = std::ldexp(whole(5) - 2, -50);
    return std::ldexp(significand + std::ldexp(1, -precision) + hair, -whole(precision + 2));
  }

  /// `value` moved by a few of its own last places.
  double nearby(double value, int reach) {
    return value * (1 + std::ldexp(whole(2 * reach + 1) - reach, -52));
  }

  Judge wide_judge() const { return Judge(format_of(53, 8), GetParam()); }

  std::mt19937_64 random_{1};
};

TEST_P(Sphere, IsDecidedRightlyNearTies) {
  Judge judge = wide_judge();
  for (int trial = 0; trial < 20'000 && !HasFailure(); ++trial) {
    const double x = misleading(), y = misleading(), z = misleading();
    const double distance = std::sqrt(x * x + y * y + z * z);
    const double ulp = std::ldexp(distance, -GetParam());
    judge.judge(apart(x, y, z, nearby(distance, 3)));
    judge.judge(apart(x, y, z, distance + (whole(17) - 8) * ulp));
  }
}

TEST_P(Sphere, IsDecidedRightlyFarFromTheOrigin) {
  Judge judge = wide_judge();
  for (int trial = 0; trial < 1'000 && !HasFailure(); ++trial) {
    const double x = 1e6 + unit(), y = 1e6 - unit(), z = -1e6 + unit();
    const Spheres spheres = {x, 1e6, y, 1e6, z, -1e6, 0, 0};
    const double dx = x - 1e6, dy = y - 1e6, dz = z + 1e6;
    const double distance = std::sqrt(dx * dx + dy * dy + dz * dz);
    Spheres touching = spheres;
    touching[6] = nearby(distance, 2) * 0.75;
    touching[7] = distance - touching[6];
    judge.judge(touching);
  }
}

TEST_P(Sphere, IsDecidedRightlyWhereTheyTouch) {
  Judge judge = wide_judge();
  // Pythagorean quadruples: x^2 + y^2 + z^2 = r^2 exactly.
  for (int m = 0; m < 6; ++m) {
    for (int n = 0; n < 6; ++n) {
      for (int p = 0; p < 6; ++p) {
        const double x = m * m + n * n - p * p, y = 2 * m * p, z = 2 * n * p;
        const double radius = m * m + n * n + p * p;
        const double scale = std::ldexp(1, whole(80) - 40);
        for (const double r : {radius, nearby(radius, 1), radius / 2}) {
          judge.judge(apart(x * scale, y * scale, z * scale, r * scale));
          judge.judge({x + 7, 7, y - 3, -3, z, 0, r - 0.25, 0.25});
        }
      }
    }
  }
}

TEST_P(Sphere, IsDecidedRightlyWhereTheyCoincide) {
  Judge judge = wide_judge();
  for (const double centre : {0.0, 1.0, -3.7, 1e6, 1e30, 1e-38}) {
    for (const double radius : {0.0, 1e-38, 1e-20, 1e-3, 1.0, 1e18, 1e30}) {
      for (const double other : {0.0, radius, -radius, radius * 0.5}) {
        judge.judge({centre, centre, -centre, -centre, centre, centre, radius, other});
      }
    }
  }
}

TEST_P(Sphere, IsDecidedRightlyAtTheEndsOfTheExponentRange) {
  Judge judge = wide_judge();
  for (int exponent = -160; exponent <= 130; ++exponent) {
    const double scale = std::ldexp(1, exponent);
    for (int trial = 0; trial < 6 && !HasFailure(); ++trial) {
      const double x = misleading(), y = misleading() * std::ldexp(1, -whole(70)), z = misleading();
      const double distance = std::sqrt(x * x + y * y + z * z);
      judge.judge(apart(x * scale, y * scale, z * scale, nearby(distance, 2) * scale));
    }
  }
}

TEST_P(Sphere, IsNeverDecidedOnInfinitiesAndNans) {
  const double inf = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Judge judge = wide_judge();
  for (size_t k = 0; k < 8; ++k) {
    for (const double special : {inf, -inf, nan}) {
      Spheres spheres = {1, 2, 3, 4, 5, 6, 0.5, 0.25};
      spheres[k] = special;
      judge.judge(spheres);
      spheres[(k + 1) % 8] = -special;
      judge.judge(spheres);
    }
  }
  EXPECT_EQ(judge.decided_share(), 0);
}

TEST_P(Sphere, IsMostlyDecided) {
  Judge judge = wide_judge();
  for (int trial = 0; trial < 2'000 && !HasFailure(); ++trial) {
    Spheres spheres;
    for (double& value : spheres) value = 100 * unit();
    judge.judge(spheres);
  }
  // In a share of a few times 8 * 2^-L of random pairs, f and g lie within 8 ulp of each other.
  EXPECT_GT(judge.decided_share(), 1 - std::ldexp(20, -GetParam()));
  EXPECT_GT(judge.decided_share(), 0.2);
}

INSTANTIATE_TEST_SUITE_P(Precisions, Sphere, testing::Values(4, 8, 11, 17, 24, 32, 52),
                         testing::PrintToStringParamName());

/// A pair of spheres whose true verdict is less. A profiled lane of 24 digits decides greater, with
/// a bound that sampling would call generous.
class Counterexample : public testing::Test {
protected:
  const FloatFormat reference_ = format_of(53, 8);
  const Graph graph_ = sphere_graph();
  const std::vector<Bits> inputs_ =
      encode(reference_, {1.000244200230171, 0, 0.018906322899724187, 0, 0.00024414329029752815, 0,
                          1.000422894952754 / 2, 1.000422894952754 / 2});

  TypedGraph typed() const {
    const Arithmetic reduced{format_of(24, 8), Rounding::nearest_even, Subnormals::flush};
    return lane_graph(graph_, reference_, reduced, LaneInputs::exact);
  }
};

TEST_F(Counterexample, IsLessInTruth) {
  EXPECT_EQ(true_verdict(graph_, reference_, inputs_), Verdict::less);
}

TEST_F(Counterexample, IsDecidedWronglyByTheProfiledLane) {
  const mpq_class u(1, 1 << 24);
  const Lane lane = error::profiled_lane(typed(), mpq_class(45, 10) * u, mpq_class(28, 10) * u);
  const LaneResult result = evaluate_lane(lane, inputs_);
  EXPECT_TRUE(result.decided);
  EXPECT_EQ(result.verdict, Verdict::greater);
}

TEST_F(Counterexample, IsLeftOpenByTheCertifiedLane) {
  const Lane lane = relative_lane(typed(), std::vector<bool>(8, false)).value();
  EXPECT_FALSE(evaluate_lane(lane, inputs_).decided);
}

}  // namespace
}  // namespace mixcmp::test::sphere_test
