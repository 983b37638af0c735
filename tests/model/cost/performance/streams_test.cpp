#include "model/cost/performance/streams.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <queue>
#include <random>
#include <tuple>

/// The model of the streams against itself and against queues simulated here; tests/system and
/// tests/rtl_templates/stream hold it against the hardware.
namespace mixcmp::test::streams_test {
namespace {

performance::LaneStreams streams(int slots, int lanes_served,
                                 scene::ResultOrder order = scene::ResultOrder::tagged) {
  return {.order = order,
          .lane_latency_cycles = 19,
          .reference_latency_cycles = 26,
          .slots = slots,
          .lanes_served = lanes_served};
}

TEST(Streams, TreeOfTheCrossbarGrowsByALevelAtPowersOfFour) {
  for (const int lanes : {1, 2, 4}) EXPECT_EQ(performance::crossbar_levels(lanes), 1) << lanes;
  for (const int lanes : {5, 16}) EXPECT_EQ(performance::crossbar_levels(lanes), 2) << lanes;
  for (const int lanes : {17, 64}) EXPECT_EQ(performance::crossbar_levels(lanes), 3) << lanes;
}

TEST(Streams, RequestsLimitAnEvenStream) {
  EXPECT_DOUBLE_EQ(performance::even_throughput(streams(64, 1), 0.5), 1);
  EXPECT_DOUBLE_EQ(performance::even_throughput(streams(64, 1), 1), 0.5);
  EXPECT_DOUBLE_EQ(performance::even_throughput(streams(64, 8), 0.125), 1);
  EXPECT_DOUBLE_EQ(performance::even_throughput(streams(64, 8), 0.5), 0.25);
  EXPECT_DOUBLE_EQ(performance::even_throughput(streams(64, 0), 1), 1);
}

TEST(Streams, RequestsOfSeveralBeatsTakeTwoCyclesABeat) {
  performance::LaneStreams one = streams(256, 1);
  one.request_beats = 8;
  EXPECT_EQ(performance::service_cycles(one), 16);
  EXPECT_DOUBLE_EQ(performance::even_throughput(one, 1), 1.0 / 16);
  performance::LaneStreams eight = streams(256, 8);
  eight.request_beats = 8;
  EXPECT_EQ(performance::service_cycles(eight), 15);
  EXPECT_DOUBLE_EQ(performance::even_throughput(eight, 1), 1.0 / 120);
  eight.initiation_interval_cycles = 16;
  EXPECT_EQ(performance::service_cycles(eight), 16);
  EXPECT_DOUBLE_EQ(performance::highest_lane_throughput(0.125, 8), 0.5);
  // Two levels of the crossbar, each with a cycle for the grant, seven beats behind the first, and
  // one cycle to join them.
  EXPECT_EQ(performance::undecided_slot_cycles(eight) -
                performance::undecided_slot_cycles(streams(256, 8)),
            2 + 14 + 1);
}

TEST(Streams, SlotsLimitAnEvenStream) {
  EXPECT_DOUBLE_EQ(performance::even_throughput(streams(10, 1), 0), 10.0 / 25);
  EXPECT_DOUBLE_EQ(performance::even_throughput(streams(10, 1), 1), 10.0 / 57);
  // In order, a lane with too few slots for one recomputation stalls at each.
  const performance::LaneStreams ordered = streams(24, 1, scene::ResultOrder::in_order);
  const double held = performance::undecided_slot_cycles(ordered);
  EXPECT_DOUBLE_EQ(performance::even_throughput(ordered, 1), 24 / held);
  EXPECT_LT(performance::even_throughput(ordered, 0.01), 1);
  EXPECT_DOUBLE_EQ(performance::even_throughput(streams(64, 1, scene::ResultOrder::in_order), 0.01),
                   1);
}

/// 19 cycles in the lane, 4 to ask, 1 in the crossbar, 26 in the reference, 2 back, 5 or 3 to
/// retire.
TEST(Streams, AnUndecidedComparisonHoldsItsSlotForItsWholeWay) {
  EXPECT_EQ(performance::undecided_slot_cycles(streams(64, 1)), 57);
  EXPECT_EQ(performance::undecided_slot_cycles(streams(64, 1, scene::ResultOrder::in_order)), 55);
}

TEST(Streams, AFoldedReferenceMakesTheSlotsWaitForItsNextStart) {
  std::vector<bool> one_in_57(57, false);
  one_in_57.front() = true;
  performance::LaneStreams folded = streams(57, 1, scene::ResultOrder::in_order);
  EXPECT_DOUBLE_EQ(performance::repeated_cycles(folded, one_in_57), 57);
  folded.initiation_interval_cycles = 16;
  EXPECT_GT(performance::repeated_cycles(folded, one_in_57), 60);
}

TEST(Streams, ChanceCostsNothingFarFromSaturationAndSomethingAtIt) {
  for (const scene::ResultOrder order :
       {scene::ResultOrder::tagged, scene::ResultOrder::in_order}) {
    for (const double rate : {0.0, 0.01, 0.1, 0.12, 0.125, 0.2, 0.5, 1.0}) {
      const double random = performance::random_throughput(streams(64, 8, order), rate);
      EXPECT_LE(random, performance::even_throughput(streams(64, 8, order), rate)) << rate;
      EXPECT_GT(random, 0.8 * performance::even_throughput(streams(64, 8, order), rate)) << rate;
    }
    EXPECT_NEAR(performance::random_throughput(streams(64, 8, order), 0.05), 1, 1e-9);
    EXPECT_LT(performance::random_throughput(streams(64, 8, order), 0.125), 0.999);
  }
}

TEST(Streams, ThroughputFallsWithTheRateAndRisesWithSlots) {
  for (const scene::ResultOrder order :
       {scene::ResultOrder::tagged, scene::ResultOrder::in_order}) {
    double before = 1;
    for (int percent = 0; percent <= 100; ++percent) {
      const double now = performance::random_throughput(streams(48, 4, order), percent / 100.0);
      EXPECT_LE(now, before + 1e-9) << percent;
      EXPECT_LE(now, performance::random_throughput(streams(64, 4, order), percent / 100.0) + 1e-9)
          << percent;
      before = now;
    }
  }
}

/// A queue in discrete time, by definition: every cycle each of `lanes` asks with the probability
/// `rate`; one request is served every `service` cycles.
double simulated_wait(int lanes, double rate, int service) {
  std::mt19937_64 engine(3);
  std::bernoulli_distribution asks(rate);
  long backlog = 0;  // cycles of work
  double waited = 0;
  long requests = 0;
  for (long cycle = 0; cycle < 500'000; ++cycle) {
    for (int lane = 0; lane < lanes; ++lane) {
      if (!asks(engine)) continue;
      waited += static_cast<double>(backlog);
      ++requests;
      backlog += service;
    }
    if (backlog > 0) --backlog;
  }
  return waited / static_cast<double>(requests);
}

TEST(Streams, MeanWaitIsThatOfTwoQueuesInTurn) {
  for (const auto& [lanes, rate] : {std::pair(1, 0.1), {1, 0.45}, {2, 0.3}, {8, 0.1}, {16, 0.05}}) {
    const double expected = simulated_wait(1, rate, 2) + simulated_wait(lanes, rate, 1);
    EXPECT_NEAR(performance::mean_wait_cycles(streams(64, lanes), rate), expected,
                0.05 * expected + 0.01)
        << lanes << " lanes, rate " << rate;
  }
  for (const auto& [lanes, rate] : {std::pair(1, 0.05), {2, 0.05}, {8, 0.01}, {29, 0.004}}) {
    performance::LaneStreams beats = streams(64, lanes);
    beats.request_beats = 4;
    const double expected = simulated_wait(lanes, rate, lanes > 1 ? 7 : 8);
    EXPECT_NEAR(performance::mean_wait_cycles(beats, rate), expected, 0.05 * expected + 0.01)
        << lanes << " lanes, rate " << rate << ", requests of four beats";
  }
  EXPECT_TRUE(std::isinf(performance::mean_wait_cycles(streams(64, 8), 0.125)));
  EXPECT_TRUE(std::isinf(performance::mean_wait_cycles(streams(64, 1), 0.5)));
}

/// A request of a folded reference waits for the next cycle of N in which the reference starts, and
/// behind those that came before.
double simulated_folded_wait(int lanes, double rate, int interval) {
  std::mt19937_64 engine(4);
  std::bernoulli_distribution asks(rate);
  std::queue<long> asked;
  double waited = 0;
  long served = 0;
  for (long cycle = 0; cycle < 2'000'000; ++cycle) {
    for (int lane = 0; lane < lanes; ++lane) {
      if (asks(engine)) asked.push(cycle);
    }
    if (cycle % interval != 0 || asked.empty()) continue;
    waited += static_cast<double>(cycle - asked.front());
    asked.pop();
    ++served;
  }
  return waited / static_cast<double>(served);
}

TEST(Streams, AFoldedReferenceLetsRequestsWaitForItsFirstPhase) {
  for (const auto& [lanes, interval, load] :
       {std::tuple(1, 4, 0.1), {1, 16, 0.7}, {8, 2, 0.5}, {8, 16, 0.01}, {24, 16, 0.8}}) {
    const double rate = load / (lanes * interval);
    performance::LaneStreams folded = streams(64, lanes);
    folded.initiation_interval_cycles = interval;
    const double expected =
        simulated_wait(1, rate, 2) + simulated_folded_wait(lanes, rate, interval);
    EXPECT_NEAR(performance::mean_wait_cycles(folded, rate), expected, 0.05 * expected + 0.05)
        << lanes << " lanes, interval " << interval << ", load " << load;
    EXPECT_TRUE(std::isinf(performance::mean_wait_cycles(folded, rate / load)));
    EXPECT_DOUBLE_EQ(performance::even_throughput(folded, 1), 1.0 / (lanes * interval));
  }
}

/// docs/theory.md: until answers come a burst fills the free slots; from then on its excess.
int absorbed_by_formula(const performance::LaneStreams& s) {
  const int decided = performance::decided_slot_cycles(s);
  const int undecided = performance::undecided_slot_cycles(s);
  if (s.slots <= undecided) return s.slots - decided;
  const double excess = 1 - 1.0 / performance::answer_interval_cycles(s);
  return undecided - decided + static_cast<int>((s.slots - undecided) / excess);
}

TEST(Streams, LongestBurstIsWhatTheFormulaSays) {
  for (const int slots : {32, 57, 58, 64, 128, 256}) {
    for (const int lanes : {1, 2, 3, 8, 16, 40}) {
      const performance::LaneStreams s = streams(slots, lanes);
      EXPECT_NEAR(performance::absorbed_burst(s), absorbed_by_formula(s), 2)
          << slots << " " << lanes;
    }
  }
}

TEST(Streams, LanesInOrderHoldNoBurstWithoutSlotsForARecomputation) {
  EXPECT_EQ(performance::absorbed_burst(streams(32, 2, scene::ResultOrder::in_order)), 0);
  EXPECT_GT(performance::absorbed_burst(streams(128, 2, scene::ResultOrder::in_order)), 0);
}

TEST(Streams, RepeatedPatternsTakeWhatTheirPartsSay) {
  const std::vector<bool> decided(100, false);
  const std::vector<bool> undecided(100, true);
  EXPECT_DOUBLE_EQ(performance::repeated_cycles(streams(64, 8), decided), 100);
  EXPECT_DOUBLE_EQ(performance::repeated_cycles(streams(64, 8), undecided), 800);
  EXPECT_DOUBLE_EQ(performance::repeated_cycles(streams(64, 1), undecided), 200);
  EXPECT_DOUBLE_EQ(performance::repeated_cycles(streams(20, 8), decided),
                   125);  // 20 slots, 25 cycles each
  std::vector<bool> even(80, false);
  for (std::size_t k = 0; k < even.size(); k += 16) even[k] = true;
  EXPECT_DOUBLE_EQ(performance::repeated_cycles(streams(64, 8), even), 80);
}

TEST(Streams, BurstThatIsNotAbsorbedTakesTheReferencesTime) {
  std::vector<bool> pattern(1000, false);
  std::fill_n(pattern.begin(), 110, true);
  const double cycles = performance::repeated_cycles(streams(64, 8), pattern);
  EXPECT_GT(cycles, 1000 * 1.2);
  EXPECT_LT(cycles, 110 * 8 + 890);
}

/// Eight first lanes share a second lane; four second lanes share a reference of N = 4.
TEST(TwoTiers, AreAsFastAsTheSlowerOfBoth) {
  performance::LaneStreams first = streams(64, 8);
  performance::LaneStreams second = streams(64, 4, scene::ResultOrder::in_order);
  second.initiation_interval_cycles = 4;
  // First nothing is undecided, then nothing is undecided a second time.
  EXPECT_DOUBLE_EQ(performance::two_tier_throughput(first, second, 0, 0), 1);
  EXPECT_NEAR(performance::two_tier_throughput(first, second, 0.05, 0), 1, 1e-9);
  // The second tier is asked twice as often as it can be: each lane may ask every 16th cycle.
  EXPECT_NEAR(performance::two_tier_throughput(first, second, 0.25, 0), 0.5, 1e-3);
  // Half of 8 x 0.05 is undecided again, and each of the four is answered every 16th cycle.
  EXPECT_NEAR(performance::two_tier_throughput(first, second, 0.05, 0.5), 1.0 / 16 / 0.2, 0.01);
  // Lanes that wait long for answers run out of slots.
  first.slots = second.slots = 32;
  EXPECT_LT(performance::two_tier_throughput(first, second, 0.1, 0.1), 0.99);
  // They wait longer if the second tier has to ask the references.
  second.initiation_interval_cycles = 1;
  first.slots = 16, second.slots = 1000;
  EXPECT_LT(performance::two_tier_throughput(first, second, 0.05, 0.2),
            performance::two_tier_throughput(first, second, 0.05, 0));
}

}  // namespace
}  // namespace mixcmp::test::streams_test
