#include "model/plan/optimise/plan_set.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

namespace mixcmp::test::plan_set_test {
namespace {

using optimise::choose_plans;
using optimise::choose_plans_exhaustively;
using optimise::PlanChoice;
using optimise::PlanSeconds;

/// Up to nine plans on up to five data sets. Small whole seconds make ties; some plans do not serve
/// some sets.
class RandomPlans {
public:
  PlanSeconds next() {
    const int plans = number(1, 9), sets = number(1, 5), most = number(1, 12);
    PlanSeconds seconds(plans, std::vector<double>(sets));
    for (std::vector<double>& plan : seconds) {
      for (double& each : plan) {
        each = number(0, 9) == 0 ? std::numeric_limits<double>::infinity() : number(1, most);
      }
    }
    for (double& each : seconds.back()) each = std::min(each, 100.0);
    return seconds;
  }

private:
  int number(int least, int most) {
    return std::uniform_int_distribution<int>(least, most)(engine_);
  }

  std::mt19937 engine_{20261128};
};

double seconds_of(const PlanSeconds& plans, const std::vector<std::size_t>& chosen) {
  double sum = 0;
  for (std::size_t s = 0; s < plans.front().size(); ++s) {
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t plan : chosen) least = std::min(least, plans[plan][s]);
    sum += least;
  }
  return sum;
}

TEST(PlanSet, IsThatOfAnExhaustiveSearch) {
  RandomPlans random;
  for (int k = 0; k < 400; ++k) {
    const PlanSeconds plans = random.next();
    const int most = 1 + k % 5;
    const auto found = choose_plans(plans, most);
    const auto best = choose_plans_exhaustively(plans, most);
    ASSERT_EQ(found.size(), static_cast<std::size_t>(most));
    for (int j = 0; j < most; ++j) {
      EXPECT_EQ(found[j].seconds, best[j].seconds) << "problem " << k << ", plans " << j + 1;
      EXPECT_EQ(found[j].plans.size(), best[j].plans.size()) << "problem " << k;
      EXPECT_EQ(seconds_of(plans, found[j].plans), found[j].seconds) << "problem " << k;
    }
  }
}

TEST(PlanSet, OfOneIsTheBestSinglePlan) {
  RandomPlans random;
  for (int k = 0; k < 100; ++k) {
    const PlanSeconds plans = random.next();
    const PlanChoice one = choose_plans(plans, 1).front();
    ASSERT_EQ(one.plans.size(), 1U);
    for (std::size_t plan = 0; plan < plans.size(); ++plan) {
      EXPECT_LE(one.seconds, seconds_of(plans, {plan})) << "problem " << k;
    }
  }
}

TEST(PlanSet, WithAPlanForEachDataSetLosesNothing) {
  RandomPlans random;
  for (int k = 0; k < 100; ++k) {
    const PlanSeconds plans = random.next();
    double least = 0;
    for (std::size_t s = 0; s < plans.front().size(); ++s) {
      double fastest = std::numeric_limits<double>::infinity();
      for (const auto& plan : plans) fastest = std::min(fastest, plan[s]);
      least += fastest;
    }
    EXPECT_EQ(choose_plans(plans, static_cast<int>(plans.front().size())).back().seconds, least);
  }
}

TEST(PlanSet, HasNoPlanThatGainsNothingAndBeginsWithTheBestByItself) {
  const PlanSeconds plans = {{1, 9}, {4, 4}, {9, 1}, {9, 2}};
  const auto found = choose_plans(plans, 4);
  EXPECT_EQ(found[0].plans, std::vector<std::size_t>({1}));
  EXPECT_EQ(found[1].plans, std::vector<std::size_t>({0, 2})) << "10 seconds each: in their order";
  EXPECT_EQ(found[3].plans, found[1].plans);
}

}  // namespace
}  // namespace mixcmp::test::plan_set_test
