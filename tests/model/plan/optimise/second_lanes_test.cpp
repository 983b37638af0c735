#include <gtest/gtest.h>

#include <algorithm>

#include "model/base/settings/bound_name.hpp"
#include "model/plan/optimise/footprint.hpp"
#include "model/plan/optimise/plan.hpp"
#include "tests/model/plan/optimise/planning_case.hpp"

/// Plans of systems of streams with a second tier.
namespace mixcmp::test::second_lanes_test {
namespace {

using optimise::Allocation;
using optimise::Optimisation;

/// Lanes in q7 and q10 before a second tier in q13, on a device that has room for many.
class SecondLanes : public PlanningTest {
protected:
  static constexpr int second_luts = 700;

  SecondLanes() {
    scene_.ranges.assign(8, Range{0, 100});
    scene_.second_tier = scene::ReducedSpec{.fixed_point = FixedPoint{.bits = 13}};
    device_.available = {.luts = 100'000, .registers = 200'000, .dsps = 5000};
    std::erase_if(table_.rows,
                  [](const auto& row) { return std::holds_alternative<measured::Lane>(row.key); });
    for (const int bits : {7, 10, 13}) table_.rows.push_back(row_of(fixed(bits), 20 * bits, 4));
    table_.rows.push_back(row_of(measured::SecondLane{fixed(13), 64}, second_luts, 4));
    table_.rows.push_back(row_of(measured::Crossbar{64}, 800));
    sort();
    rates_ = rates_of_bits({{7, 40'000}, {10, 2000}, {13, 100}});
  }

  static measured::Lane fixed(int bits) {
    return lane("q" + std::to_string(bits), "", "fixed_norm", "embedded");
  }

  /// Undecided of a million.
  static optimise::Rates rates_of_bits(const std::map<int, std::uint64_t>& undecided) {
    profile::RateProfile rates{.comparisons = 1'000'000};
    rates.schemes.push_back({.name = "fixed_norm",
                             .bound = settings::parse_bound("fixed_norm").value(),
                             .kind = profile::SchemeKind::certified,
                             .counts = {},
                             .reason = {}});
    for (int bits = 4; bits <= 16; ++bits) {
      const auto found = undecided.find(bits);
      const bool exists = found != undecided.end();
      rates.schemes.back().counts.push_back(
          {.exists = exists, .undecided = exists ? found->second : 0});
    }
    return optimise::Rates::of({rates});
  }

  std::string refusal() const {
    const auto found = optimise::optimise(scene_, device_, table_, rates_, options_);
    return found.ok() ? "nothing" : found.error().to_string();
  }
};

TEST_F(SecondLanes, TakeWhatTheFirstLanesLeaveUndecided) {
  const Optimisation found = optimise_now();
  const optimise::PrecisionPlan& plan = *found.best();
  EXPECT_EQ(plan.precision, 7);
  const int lanes = plan.allocation()->lane_count();
  EXPECT_EQ(plan.second_lanes->groups_served, 20) << "20 x 0.04 = 0.8";
  EXPECT_EQ(plan.second_lanes->count, (lanes + 19) / 20);
  EXPECT_DOUBLE_EQ(plan.recomputation_rate(), 1e-4) << "of the second tier";
  EXPECT_EQ(plan.allocation()->reference_count(), 1);
}

TEST_F(SecondLanes, AreCountedWholeWithTheirPortsAtBothCrossbars) {
  const Optimisation found = optimise_now();
  const optimise::PrecisionPlan& plan = *found.best();
  const Allocation& chosen = *plan.allocation();
  const int dearest_port = 14;                              // 111 for 8, rounded up
  const int share_of_20 = 111 + (800 - 111) * 12 / 56 + 1;  // between 8 and 64 ports
  int luts = chosen.lane_count() * (20 * 7 + fifo_64_luts);
  luts += plan.second_lanes->count * (second_luts + dearest_port + share_of_20);
  for (std::size_t k = 0; k < chosen.references.size(); ++k) {
    luts += chosen.references[k] * found.references[k].measured.area.luts;
  }
  EXPECT_EQ(chosen.used.luts, luts);
  EXPECT_LE(chosen.used.luts, 80'000);
}

TEST_F(SecondLanes, AreAsManyForEachReference) {
  EXPECT_EQ(optimise::second_lanes_for(100, 20, 1), 5);
  EXPECT_EQ(optimise::second_lanes_for(101, 20, 1), 6);
  EXPECT_EQ(optimise::second_lanes_for(101, 20, 4), 8);
  rates_ = rates_of_bits({{7, 40'000}, {10, 30'000}, {13, 5000}});
  const Optimisation found = optimise_now();
  const optimise::PrecisionPlan& plan = *found.best();
  EXPECT_GT(plan.allocation()->reference_count(), 1);
  EXPECT_EQ(plan.second_lanes->count % plan.allocation()->reference_count(), 0);
}

TEST_F(SecondLanes, HaveSlotsForTheirReference) {
  for (auto& row : table_.rows) {
    if (row.key == measured::ComponentKey(reference("embedded"))) row.latency_cycles = 200;
  }
  const Optimisation few = optimise_now();
  const Allocation* const plan = few.best()->allocation();
  EXPECT_EQ(plan->references, (std::vector<int>{0, 1})) << "64 slots are too few for 200 cycles";
  table_.rows.push_back(row_of(measured::SecondLane{fixed(13), 256}, second_luts + 10, 4));
  sort();
  const Optimisation found = optimise_now();
  const optimise::PrecisionPlan& more = *found.best();
  EXPECT_EQ(more.allocation()->references, (std::vector<int>{1, 0}));
  EXPECT_EQ(std::get<measured::SecondLane>(more.second_lanes->measured.key).slots, 256);
}

TEST_F(SecondLanes, HaveMoreDigitsThanTheFirst) {
  for (const optimise::PrecisionPlan& plan : optimise_now().plans) EXPECT_LT(plan.precision, 13);
}

TEST_F(SecondLanes, AreNotAskedByLanesThatLeaveTooMuch) {
  rates_ = rates_of_bits({{7, 810'000}, {10, 2000}, {13, 100}});
  EXPECT_EQ(optimise_now().best()->precision, 10);
}

TEST_F(SecondLanes, WithoutARowAreReportedMissing) {
  std::erase_if(table_.rows, [](const auto& row) {
    return std::holds_alternative<measured::SecondLane>(row.key);
  });
  EXPECT_NE(refusal().find("a second_lane in q13"), std::string::npos) << refusal();
}

TEST_F(SecondLanes, AreHeldAgainstTheSameAreas) {
  design::Design design = sphere_design(format_of(8, 8), format_of(53, 8), 8, 1);
  design.lanes.front().lane = fixed_spheres({.bits = 7}, format_of(53, 8));
  design.second_tier = {.lane = fixed_spheres({.bits = 13}, format_of(53, 8)), .count = 3};
  const optimise::Footprint footprint = optimise::footprint_of(design, &table_, device_);
  EXPECT_TRUE(footprint.measured);
  const int crossbars = 3 * 10 + 10;  // 3, 3 and 2 lanes at the second tier, it at the reference
  EXPECT_EQ(footprint.amounts[0], 8 * (20 * 7 + fifo_64_luts) + 3 * second_luts + crossbars + 3000);
  std::erase_if(table_.rows, [](const auto& row) {
    return std::holds_alternative<measured::SecondLane>(row.key);
  });
  EXPECT_FALSE(optimise::footprint_of(design, &table_, device_).measured);
}

TEST_F(SecondLanes, LimitTheClock) {
  for (auto& row : table_.rows) {
    if (std::holds_alternative<measured::SecondLane>(row.key)) row.clock->mhz = 140;
  }
  EXPECT_DOUBLE_EQ(optimise_now().best()->clock_mhz(), 140);
}

TEST_F(SecondLanes, AreWrittenIntoThePlan) {
  const Optimisation found = optimise_now();
  const std::string text = optimise::plan_toml(found, *found.best(), {});
  const std::string count = std::to_string(found.best()->second_lanes->count);
  EXPECT_NE(text.find("\n[second_tier]\ncount = " + count + "\n"), std::string::npos) << text;
}

TEST_F(SecondLanes, SlowDownWhereTheirLanesLeaveMoreUndecided) {
  expect_plans_at_rates(rates_of_bits({{7, 200'000}, {10, 100'000}, {13, 5000}}));
}

/// Second lanes take 0.8 requests a cycle each, whatever the references could do.
TEST_F(SecondLanes, LimitTheThroughput) {
  const Optimisation found = optimise_now();
  const optimise::PrecisionPlan& plan = *found.best();
  const auto more = at_rates(plan, scene_, rates_of_bits({{7, 400'000}, {13, 100}}));
  ASSERT_TRUE(more);
  EXPECT_DOUBLE_EQ(more->counted_rate, 0.4) << "requests to the second tier";
  EXPECT_DOUBLE_EQ(more->throughput_per_s, plan.second_lanes->count * 0.8 * 150e6 / 0.4);
}

}  // namespace
}  // namespace mixcmp::test::second_lanes_test
