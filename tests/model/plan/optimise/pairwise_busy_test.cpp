#include "model/plan/optimise/pairwise_busy.hpp"

#include <gtest/gtest.h>

namespace mixcmp::test::pairwise_busy_test {
namespace {

using optimise::Allocation;
using optimise::PrecisionPlan;

/// Two kinds of lanes at 200 and 100 MHz, and two of references at 300 MHz.
PrecisionPlan plan_of_two_kinds(optimise::ClockDomains clocks) {
  PrecisionPlan plan;
  plan.problem.clocks = clocks;
  for (const auto& [mhz, rate, latency] : {std::tuple{200, 0.01, 9}, {100, 0.03, 7}}) {
    optimise::LaneImplementation lane{};
    lane.measured.latency_cycles = latency;
    lane.kind = {.clock_hz = mhz * 1e6, .recomputation_rate = rate};
    plan.problem.lanes.push_back(lane.kind);
    plan.lanes.push_back(lane);
  }
  plan.problem.references = {{.clock_hz = 300e6, .initiation_interval = 16, .latency_cycles = 40},
                             {.clock_hz = 300e6, .initiation_interval = 4, .latency_cycles = 30}};
  return plan;
}

scene::SystemSpec pairwise_system() {
  scene::SystemSpec system;
  system.engine = {.kind = scene::EngineKind::pairwise, .report_streams = 2};
  return system;
}

TEST(EngineOfAPlan, HasTheLanesThatLeaveMostAndTheSlowestOfThoseChosen) {
  const PrecisionPlan plan = plan_of_two_kinds(optimise::ClockDomains::single);
  const Allocation both{.lanes = {8, 16}, .references = {2, 1}};
  const auto engine = optimise::engine_of(plan, pairwise_system(), both);
  EXPECT_EQ(engine.lanes, 24);
  EXPECT_EQ(engine.streams, 2);
  EXPECT_EQ(engine.undecided, 0.03);
  EXPECT_EQ(engine.lane_latency_cycles, 9);
  EXPECT_EQ(engine.reference_latency_cycles, 40);
  const Allocation first{.lanes = {8, 0}, .references = {0, 1}};
  const auto of_first = optimise::engine_of(plan, pairwise_system(), first);
  EXPECT_EQ(of_first.undecided, 0.01);
  EXPECT_EQ(of_first.reference_latency_cycles, 30);
}

TEST(EngineOfAPlan, StartsAsManyRecomputationsAsItsReferences) {
  const auto started = [](optimise::ClockDomains clocks, const Allocation& chosen) {
    return optimise::engine_of(plan_of_two_kinds(clocks), pairwise_system(), chosen)
        .recomputations_per_cycle;
  };
  constexpr auto single = optimise::ClockDomains::single;
  EXPECT_DOUBLE_EQ(started(single, {.lanes = {8, 0}, .references = {2, 1}}), 2.0 / 16 + 1.0 / 4);
  EXPECT_EQ(started(single, {.lanes = {8, 0}, .references = {0, 5}}), 1) << "of the items' memory";
  EXPECT_DOUBLE_EQ(
      started(optimise::ClockDomains::separate, {.lanes = {8, 8}, .references = {2, 0}}),
      3 * 2.0 / 16)
      << "references run three times as fast as the slower lanes";
}

}  // namespace
}  // namespace mixcmp::test::pairwise_busy_test
