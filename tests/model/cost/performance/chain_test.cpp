#include "model/cost/performance/chain.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <random>

namespace mixcmp::test::chain_test {
namespace {

using performance::Chain;
using performance::Undecided;

/// A chain of lanes as the examples have them.
Chain chain_of(int lanes) {
  return {.lanes = lanes,
          .streams = {.order = scene::ResultOrder::in_order,
                      .lane_latency_cycles = 16,
                      .reference_latency_cycles = 21,
                      .slots = 64,
                      .lanes_served = lanes},
          .references = 1};
}

const Undecided nothing = [](std::uint64_t, int) { return false; };

/// Each comparison is undecided independently, with this rate.
Undecided at_random(double rate, unsigned seed) {
  auto engine = std::make_shared<std::mt19937>(seed);
  return [=](std::uint64_t, int) { return std::bernoulli_distribution(rate)(*engine); };
}

/// examples/kmeans/iris_chain.toml: a row takes 44 cycles; with centres_1.csv the one that is
/// recomputed, and those behind it, take 74.
TEST(Chain, TakesWhatTheExampleTakes) {
  const Chain iris = chain_of(2);
  EXPECT_EQ(performance::way_cycles(iris), 44);
  EXPECT_EQ(performance::recomputation_delay_cycles(iris), 74 - 44);
  EXPECT_EQ(performance::chain_cycles(iris, 150, nothing), 150 + 44);
  const auto one = [](std::uint64_t row, int lane) { return row == 90 && lane == 1; };
  EXPECT_EQ(performance::chain_cycles(iris, 150, one), 150 + 74);
}

TEST(Chain, ALaneHoldsUpTheRowsBehindOneRecomputationOnly) {
  const Chain chain = chain_of(8);
  const int delay = performance::recomputation_delay_cycles(chain);
  const double undisturbed = performance::chain_cycles(chain, 500, nothing);
  const auto many_in_one_lane = [](std::uint64_t row, int lane) {
    return row % 9 == 0 && lane == 3;
  };
  EXPECT_EQ(performance::chain_cycles(chain, 500, many_in_one_lane), undisturbed + delay);
  const auto one_in_each = [](std::uint64_t row, int lane) {
    return row == 50 * static_cast<std::uint64_t>(lane);
  };
  EXPECT_EQ(performance::chain_cycles(chain, 500, one_in_each), undisturbed + 8 * delay);
}

/// A recomputation in a later lane of an earlier row falls into the gap that the first left.
TEST(Chain, OnlyRecomputationsInTurnAddUp) {
  const Chain chain = chain_of(8);
  const int delay = performance::recomputation_delay_cycles(chain);
  const double undisturbed = performance::chain_cycles(chain, 500, nothing);
  const auto against_the_order = [](std::uint64_t row, int lane) {
    return row == 400 - 50 * static_cast<std::uint64_t>(lane);
  };
  EXPECT_EQ(performance::chain_cycles(chain, 500, against_the_order), undisturbed + delay);
}

TEST(Chain, FewSlotsHoldUpTheLanesBefore) {
  Chain chain = chain_of(3);
  chain.streams.slots = 32;  // a recomputation takes 58 cycles
  const auto many = [](std::uint64_t row, int) { return row % 100 == 0; };
  EXPECT_GT(performance::chain_cycles(chain, 5000, many), 5000 * 1.1);
  chain.streams.slots = 64;
  EXPECT_LT(performance::chain_cycles(chain, 5000, many), 5000 * 1.05);
}

TEST(Chain, ReferencesThatAreAskedTooOftenSetThePace) {
  Chain chain = chain_of(10);
  chain.streams.initiation_interval_cycles = 16;
  const auto some = [](std::uint64_t row, int) { return row % 50 == 0; };
  const int recomputations = 10 * 2000 / 50;
  EXPECT_EQ(performance::chain_cycles(chain, 2000, some),
            16 * recomputations + performance::way_cycles(chain));
  chain.references = 4;  // the first serves three lanes
  EXPECT_LT(performance::chain_cycles(chain, 2000, some), 16 * recomputations * 0.5);
}

TEST(Chain, RandomRecomputationsTakeWhatTheirRateSays) {
  for (const auto& [lanes, rows, rate] :
       {std::tuple(69, 644u, 3.7e-3), std::tuple(69, 5000u, 3.7e-3), std::tuple(15, 700u, 0.01),
        std::tuple(15, 700u, 0.05), std::tuple(8, 300u, 0.02)}) {
    const Chain chain = chain_of(lanes);
    double mean = 0;
    constexpr int runs = 20;
    for (unsigned seed = 0; seed < runs; ++seed) {
      mean += performance::chain_cycles(chain, rows, at_random(rate, seed)) / runs;
    }
    const double expected = performance::random_chain_cycles(chain, rows, rate);
    EXPECT_NEAR(mean, expected, 0.05 * expected) << lanes << " lanes, " << rows << " rows";
  }
}

TEST(Chain, HasNoMoreRecomputationsInTurnThanLanes) {
  EXPECT_EQ(performance::recomputations_in_turn(69, 100'000, 0.01), 69);
  EXPECT_EQ(performance::recomputations_in_turn(69, 1, 0), 0);
}

}  // namespace
}  // namespace mixcmp::test::chain_test
