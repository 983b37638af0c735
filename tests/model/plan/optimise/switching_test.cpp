#include "model/plan/optimise/switching.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "model/plan/optimise/drift.hpp"

namespace mixcmp::test::switching_test {
namespace {

using optimise::BlockThroughPlan;
using optimise::RatePoint;
using optimise::StreamThroughPlans;
using optimise::StreamTime;
using optimise::SwitchingRule;

/// Two plans. The first takes 1 ns up to a rate of 10 %, and more above; the second always 2 ns,
/// and leaves a tenth as much undecided.
std::vector<std::vector<RatePoint>> two_plans() {
  const std::vector<double> few = {1e-9, 2e-9}, many = {4e-9, 2e-9};
  return {{{0.4, many}, {0.1, few}}, {{0.01, few}, {0.04, many}}};
}

TEST(Switching, KnowsTheRatesAtWhichAPlanIsTheFastest) {
  const SwitchingRule rule(two_plans(), 1);
  ASSERT_EQ(rule.best_rates(0).size(), 1U);
  EXPECT_EQ(rule.best_rates(0)[0].first, 0);
  EXPECT_NEAR(rule.best_rates(0)[0].second, 0.2, 1e-12);
  ASSERT_EQ(rule.best_rates(1).size(), 1U);
  EXPECT_NEAR(rule.best_rates(1)[0].first, 0.02, 1e-12);
  EXPECT_EQ(rule.best_rates(1)[0].second, 1);
}

/// At 40 % plan 1 loses 2 ns a comparison: a second in 5e8 comparisons.
TEST(Switching, LoadsAnotherPlanWhenItHasLostAReconfiguration) {
  SwitchingRule rule(two_plans(), 1);
  EXPECT_EQ(rule.next(0, 0), 0U) << "nothing was counted";
  EXPECT_EQ(rule.next(499'000'000, 199'600'000), 0U);
  EXPECT_EQ(rule.next(2'000'000, 800'000), 1U);
  // Back: 1 ns a comparison.
  EXPECT_EQ(rule.next(999'000'000, 9'990'000), 1U);
  EXPECT_EQ(rule.next(2'000'000, 20'000), 0U);
}

/// A plan that was slower for a long time does not have to catch up.
TEST(Switching, ForgetsWhatAPlanWouldHaveLost) {
  SwitchingRule rule(two_plans(), 1);
  for (int k = 0; k < 1000; ++k) EXPECT_EQ(rule.next(1'000'000'000, 0), 0U);
  EXPECT_EQ(rule.next(501'000'000, 501'000'000), 1U);
}

TEST(Switching, TakesTheMeanOfPointsWithTheSameRate) {
  const SwitchingRule rule({{{0.1, {1, 5}}, {0.1, {3, 1}}}, {{0.2, {1, 2}}}}, 1);
  ASSERT_EQ(rule.points()[0].size(), 1U);
  EXPECT_EQ(rule.points()[0][0].seconds, std::vector<double>({2, 3}));
}

/// Plans whose seconds and rates have nothing to do with each other, and a stream of blocks.
class RandomStream {
public:
  explicit RandomStream(unsigned seed) : engine_(seed) {
    plans = number(1, 4);
    const int sets = number(1, 5), blocks = number(1, 5);
    std::vector<std::vector<RatePoint>> points(plans);
    for (auto& own : points) {
      for (int s = 0; s < sets; ++s) own.push_back({number(0, 20) / 20.0, some_seconds()});
    }
    rule = SwitchingRule(points, 1e-3 * number(1, 50));
    for (int b = 0; b < blocks; ++b) {
      std::vector<BlockThroughPlan> block;
      for (const double each : some_seconds()) block.push_back({each, number(0, 100) / 100.0});
      stream.push_back(block);
    }
  }

  int number(int least, int most) {
    return std::uniform_int_distribution<int>(least, most)(engine_);
  }

  int plans = 1;
  SwitchingRule rule{{{{0, {1}}}}, 1};
  StreamThroughPlans stream;

private:
  std::vector<double> some_seconds() {
    std::vector<double> seconds;
    for (int k = 0; k < plans; ++k) seconds.push_back(1e-9 * number(1, 40));
    return seconds;
  }

  std::mt19937 engine_;
};

/// The rule's promise, by seconds that the test draws: with points of a single rate they do not
/// depend on the counters.
TEST(Switching, NoPlanGetsFurtherAheadThanAReconfigurationAndAReading) {
  std::mt19937 engine(7);
  const auto number = [&](int least, int most) {
    return std::uniform_int_distribution<int>(least, most)(engine);
  };
  int switches = 0;
  for (int k = 0; k < 200; ++k) {
    const std::vector<double> few = {2e-9, 3e-9, 5e-9}, many = {9e-9, 4e-9, 5e-9};
    const std::vector<RatePoint> points = {{0, few}, {1, many}};
    SwitchingRule rule({points, points, points}, 0.02);
    std::vector<double> since_switch(3, 0);
    for (int reading = 0; reading < 100; ++reading) {
      const int comparisons = number(1, 5'000'000);
      const int recomputed = number(0, comparisons);
      const double rate = static_cast<double>(recomputed) / comparisons;
      const std::size_t loaded = rule.loaded();
      double most = 0, lost = 0;
      for (std::size_t j = 0; j < 3; ++j) {
        const double own = few[loaded] + rate * (many[loaded] - few[loaded]);
        const double other = few[j] + rate * (many[j] - few[j]);
        const double ahead = comparisons * (own - other);
        since_switch[j] += ahead;
        most = std::max(most, since_switch[j]);
        lost = std::max(lost, ahead);
      }
      EXPECT_LE(most, 0.02 + lost + 1e-12);
      if (rule.next(comparisons, recomputed) == loaded) continue;
      ++switches;
      std::fill(since_switch.begin(), since_switch.end(), 0.0);
    }
  }
  EXPECT_GT(switches, 100);
}

/// The least time over all ways through the plans, block by block.
double least_seconds(const StreamThroughPlans& stream, double comparisons, double reconfiguration,
                     std::size_t block, std::size_t loaded) {
  if (block == stream.size()) return 0;
  double least = INFINITY;
  for (std::size_t plan = 0; plan < stream[block].size(); ++plan) {
    const double rest = least_seconds(stream, comparisons, reconfiguration, block + 1, plan);
    const double switched = plan == loaded ? 0 : reconfiguration;
    least = std::min(least, switched + comparisons * stream[block][plan].seconds + rest);
  }
  return least;
}

TEST(Drift, ForesightIsTheBestOfAllWays) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    const RandomStream random(seed);
    const double pay = random.rule.reconfiguration_seconds();
    const StreamTime found = least_time(random.stream, 1'000'000, pay);
    EXPECT_NEAR(found.seconds, least_seconds(random.stream, 1e6, pay, 0, 0), 1e-12) << seed;
  }
}

/// Two blocks of 1e9 comparisons. Read every 0.3 s, plan 1 has lost a second in the fourth reading
/// of the second block, and is left then.
TEST(Drift, TheRuleReadsEachComparisonOnce) {
  const StreamThroughPlans stream = {{{1e-9, 0.1}, {2e-9, 0.01}}, {{4e-9, 0.4}, {2e-9, 0.04}}};
  const SwitchingRule rule(two_plans(), 0.5);
  const StreamTime found = time_by_rule(rule, stream, 1'000'000'000, 0.3);
  EXPECT_EQ(found.switches, 1);
  const double before = 4 * 0.075;  // comparisons of a reading, in 1e9
  EXPECT_NEAR(found.seconds, 1 + before * 4 + 0.5 + (1 - before) * 2, 1e-9);
}

/// Nor than the fastest plan for each block, nor slower than the slowest one.
TEST(Drift, NoRuleIsFasterThanForesight) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    const RandomStream random(seed);
    const double pay = random.rule.reconfiguration_seconds();
    const StreamTime found = time_by_rule(random.rule, random.stream, 1'000'000, 1e-3);
    double least = 0, most = found.switches * pay;
    for (const auto& block : random.stream) {
      const auto [fast, slow] =
          std::minmax_element(block.begin(), block.end(),
                              [](const auto& a, const auto& b) { return a.seconds < b.seconds; });
      least += 1e6 * fast->seconds;
      most += 1e6 * slow->seconds;
    }
    EXPECT_GE(found.seconds, least_time(random.stream, 1'000'000, pay).seconds - 1e-12) << seed;
    EXPECT_GE(found.seconds, least + found.switches * pay - 1e-12) << seed;
    EXPECT_LE(found.seconds, most + 1e-12) << seed;
  }
}

}  // namespace
}  // namespace mixcmp::test::switching_test
