#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "model/base/settings/bound_name.hpp"
#include "model/plan/optimise/engine_area.hpp"
#include "model/plan/optimise/footprint.hpp"
#include "tests/model/plan/optimise/planning_case.hpp"

namespace mixcmp::test::engine_plan_test {
namespace {

using measured::ComponentKind;
using optimise::Allocation;
using optimise::Optimisation;

/// The small device with a pairwise engine: segments of eight lanes, engines of 4 and 16 segments.
class EnginePlan : public PlanningTest {
protected:
  static constexpr int lanes = 8;

  EnginePlan() {
    scene_.system.engine.kind = scene::EngineKind::pairwise;
    scene_.system.engine.lanes_per_group = lanes;
    std::erase_if(table_.rows,
                  [](const auto& row) { return measured::reference_of(row.key) == nullptr; });
    for (const auto& [precision, luts] : {std::pair(8, 801), std::pair(10, 1000)}) {
      const measured::Lane each =
          lane("s" + std::to_string(precision) + "e8", "exact", "relative", "embedded");
      table_.rows.push_back(row_of(measured::Segment{each, lanes}, luts, 2 * lanes));
      table_.rows.push_back(row_of(measured::Engine{each, 4}, 500));
      table_.rows.push_back(row_of(measured::Engine{each, 16}, 500 + 12 * 20));
    }
    for (const char* multipliers : {"embedded", "logic"}) {
      table_.rows.push_back(row_of(measured::ReferencePort{reference(multipliers)}, 70));
    }
    sort();
  }

  void give_second_tier() {
    scene_.ranges.assign(8, Range{0, 100});
    scene_.second_tier = scene::ReducedSpec{.fixed_point = FixedPoint{.bits = 13}};
  }

  /// Undecided of a million: by lanes of 8 and 10 digits, and by the second tier of 13.
  static optimise::Rates rates_of_tiers(const std::map<int, std::uint64_t>& undecided) {
    optimise::Rates rates = rates_of(undecided);
    profile::RateProfile tier{.comparisons = 1'000'000};
    tier.schemes.push_back({.name = "fixed_norm",
                            .bound = settings::parse_bound("fixed_norm").value(),
                            .kind = profile::SchemeKind::certified,
                            .counts = {},
                            .reason = {}});
    for (int precision = 4; precision <= 16; ++precision) {
      tier.schemes.back().counts.push_back(
          {.exists = precision == 13, .undecided = undecided.at(13)});
    }
    rates.raise_to(optimise::Rates::of({tier}));
    return rates;
  }

  /// Lanes of 8 digits leave 5000 of a million undecided, those of 10 digits 200.
  static optimise::Rates rates_without_pairs() {
    return optimise::Rates::of({profile_of({{8, 5000}, {10, 200}})});
  }

  std::string refusal() const {
    const auto found = optimise::optimise(scene_, device_, table_, rates_, options_);
    return found.ok() ? "nothing" : found.error().to_string();
  }
};

TEST_F(EnginePlan, ALaneTakesItsShareOfASegmentAndOfTheMergeBehindIt) {
  const Optimisation found = optimise_now();
  const auto& plan = found.plans.front();
  EXPECT_EQ(plan.lanes.front().kind.area.luts, 801 + 20) << "of a whole group";
  EXPECT_EQ(plan.lanes.front().with_streams.luts, (801 + 20 + lanes - 1) / lanes);
  EXPECT_EQ(plan.lanes.front().with_streams.dsps, 2);
}

TEST_F(EnginePlan, WhatTheEngineTakesByItselfIsCountedOnce) {
  const Optimisation found = optimise_now();
  const auto& plan = found.plans.front();
  EXPECT_EQ(plan.problem.communication.fixed.luts, 500 - 4 * 20);
  EXPECT_TRUE(plan.problem.communication.crossbar.empty());
  const Allocation& chosen = *plan.allocation();
  int sum = 500 - 4 * 20;
  for (std::size_t k = 0; k < plan.lanes.size(); ++k) {
    EXPECT_EQ(chosen.lanes[k] % lanes, 0) << "whole groups";
    sum += chosen.lanes[k] / lanes * plan.lanes[k].kind.area.luts;
  }
  for (std::size_t k = 0; k < chosen.references.size(); ++k) {
    sum += chosen.references[k] * plan.problem.references[k].area.luts;
  }
  EXPECT_EQ(chosen.used.luts, sum);
}

TEST_F(EnginePlan, TheLargestOfSeveralKindsOfLanesSizesTheEngine) {
  const measured::Lane other = lane("s8e8", "exact", "relative", "logic");
  table_.rows.push_back(row_of(measured::Segment{other, lanes}, 1600));
  table_.rows.push_back(row_of(measured::Engine{other, 4}, 700));
  table_.rows.push_back(row_of(measured::Engine{other, 16}, 700));
  sort();
  EXPECT_EQ(optimise_now().plans.front().problem.communication.fixed.luts, 700);
}

TEST_F(EnginePlan, ReferencesHaveTheirPortsAndAloneHaveNone) {
  const Optimisation found = optimise_now();
  for (const auto& reference : found.references) {
    EXPECT_EQ(reference.kind.area.luts, reference.measured.area.luts + 70);
  }
  EXPECT_EQ(std::get<Allocation>(found.reference_only).used.luts, 2 * 3000);
}

TEST_F(EnginePlan, LanesAskForNoMoreRecomputationsThanTheMemoryStarts) {
  rates_ = rates_of({{8, 40'000}, {10, 100}});
  device_.available = {.luts = 1'000'000, .registers = 1'000'000, .dsps = 10'000};
  const Optimisation found = optimise_now();
  const auto& plan = found.plans.front();
  ASSERT_NE(plan.allocation(), nullptr);
  EXPECT_EQ(plan.allocation()->lane_count(), 24) << "they ask for 0.96 a cycle";
  EXPECT_NEAR(plan.throughput_per_s() / (1e6 * plan.clock_mhz()), 24, 1.2);
}

TEST_F(EnginePlan, MayHaveMoreLanesThanASystemOfStreams) {
  device_.available = {.luts = 1'000'000, .registers = 1'000'000, .dsps = 10'000};
  EXPECT_GT(optimise_now().best()->allocation()->lane_count(), settings::limits::lanes.most);
}

TEST_F(EnginePlan, EachStreamOfReportsHasAGroupOfLanes) {
  device_.available.luts = 6000;  // a group and a reference, but not three groups
  EXPECT_NE(optimise_now().best(), nullptr);
  scene_.system.engine.report_streams = 3;
  EXPECT_EQ(optimise_now().best(), nullptr);
}

TEST_F(EnginePlan, AnEngineToBeGeneratedIsHeldAgainstTheSameAreas) {
  design::Design design = sphere_design(format_of(8, 8), format_of(53, 8), 17, 2);
  design.system.engine = scene_.system.engine;
  const optimise::Footprint footprint = optimise::footprint_of(design, &table_, device_);
  EXPECT_TRUE(footprint.measured);
  EXPECT_EQ(footprint.amounts[0], 3 * (801 + 20) + 500 - 4 * 20 + 2 * (3000 + 70))
      << "the third group has one lane, and is counted whole";
}

TEST_F(EnginePlan, SegmentsOfOtherSizesAreNotTaken) {
  scene_.system.engine.lanes_per_group = lanes / 2;
  EXPECT_NE(refusal().find("no lane"), std::string::npos) << refusal();
}

TEST_F(EnginePlan, ATableWithoutAPartIsRefused) {
  const auto all = table_.rows;
  for (const auto& [kind, words] :
       {std::pair(ComponentKind::engine, "engines of two sizes"),
        std::pair(ComponentKind::reference_port, "the port of a reference")}) {
    table_.rows = all;
    std::erase_if(table_.rows, [&](const auto& row) { return kind_of(row.key) == kind; });
    EXPECT_NE(refusal().find(words), std::string::npos) << refusal();
  }
}

/// The second tier asks references for one pair in a million, whatever its first lanes leave.
TEST_F(EnginePlan, ReferencesAreAskedAtTheRateOfTheSecondTier) {
  give_second_tier();
  rates_ = rates_of_tiers({{8, 20'000}, {10, 100}, {13, 1}});
  device_.available = {.luts = 1'000'000, .registers = 1'000'000, .dsps = 10'000};
  const Optimisation found = optimise_now();
  const optimise::PrecisionPlan& plan = *found.best();
  EXPECT_EQ(plan.precision, 8) << "its lanes are the smaller ones";
  EXPECT_DOUBLE_EQ(plan.recomputation_rate(), 1e-6);
  EXPECT_GT(plan.allocation()->lane_count(), 1000) << "50 would ask for a pair a cycle";
}

TEST_F(EnginePlan, AFirstTierThatLeavesTooMuchIsLeftOut) {
  give_second_tier();
  rates_ = rates_of_tiers({{8, 101'000}, {10, 99'000}, {13, 1}});
  const Optimisation found = optimise_now();
  EXPECT_EQ(found.best()->precision, 10) << "8 x 0.099 < 0.8 < 8 x 0.101";
}

TEST_F(EnginePlan, ASecondTierNeedsAKnownRate) {
  give_second_tier();
  rates_ = rates_of({{8, 20'000}, {10, 100}});
  EXPECT_NE(refusal(), "nothing");
}

TEST_F(EnginePlan, TheEnginesClockLimitsItsLanes) {
  for (auto& row : table_.rows) {
    const auto* engine = std::get_if<measured::Engine>(&row.key);
    if (engine != nullptr && engine->segments == 16) row.clock->mhz = 140;
  }
  EXPECT_DOUBLE_EQ(optimise_now().best()->clock_mhz(), 140);
}

TEST_F(EnginePlan, LanesInFixedPointNeedTheirConversion) {
  std::set<std::string> missing;
  const measured::Lane fixed = lane("q9", "", "fixed_norm", "embedded");
  const measured::Measurement segment = row_of(measured::Segment{fixed, lanes}, 800);
  table_.rows.push_back(segment);
  for (const int segments : {4, 16}) {
    table_.rows.push_back(row_of(measured::Engine{fixed, segments}, 800));
  }
  sort();
  const optimise::EngineUse floats = {.kind = scene::EngineKind::pairwise};
  optimise::EngineUse integers = floats;
  integers.arrives_in_fixed_point = true;
  ASSERT_TRUE(optimise::engine_area(table_, segment, floats, missing).has_value());
  EXPECT_EQ(missing, std::set<std::string>{"a conversion to q9"});
  missing.clear();
  EXPECT_TRUE(optimise::engine_area(table_, segment, integers, missing).has_value());
  EXPECT_TRUE(missing.empty()) << "items may be stored as they arrive";
  table_.rows.push_back(row_of(measured::Conversion{fixed}, 99));
  sort();
  missing.clear();
  EXPECT_EQ(optimise::engine_area(table_, segment, floats, missing)->own.luts, 800 + 99);
  EXPECT_TRUE(missing.empty());
}

TEST_F(EnginePlan, IsSlowerOnDataThatItLeavesUndecided) {
  expect_plans_at_rates(rates_of({{8, 400'000}, {10, 300'000}}));
}

/// Lanes of a segment have no stream of requests that they share, as groups of streams have.
TEST_F(EnginePlan, KeepsItsThroughputWhereSegmentsLeaveMuchUndecided) {
  rates_ = rates_of({{8, 80'000}, {10, 80'000}});
  expect_plans_at_rates(rates_of({{8, 400'000}, {10, 300'000}}));
}

/// The memory starts one recomputation a cycle, whatever the references could do.
TEST_F(EnginePlan, ServesNoMoreRecomputationsThanItsMemoryStarts) {
  options_.clocks.lane_mhz = 100;
  options_.clocks.reference_mhz = 1000;
  options_.clocks.domains = optimise::ClockDomains::separate;
  const Optimisation found = optimise_now();
  const optimise::PrecisionPlan& plan = *found.best();
  const auto more = at_rates(plan, scene_, rates_of({{8, 400'000}, {10, 400'000}}));
  ASSERT_TRUE(more);
  ASSERT_GT(plan.allocation()->lane_count() * 0.4, 1);
  EXPECT_NEAR(more->throughput_per_s, 100e6 / 0.4, 1);
}

/// Each stream takes a report a cycle: with 84 of 100 pairs reported, S streams carry S / 0.84
/// pairs a cycle, whatever the number of lanes.
TEST_F(EnginePlan, PairsThatAreReportedLeaveByStreams) {
  rates_ = rates_of({{8, 0}, {10, 0}}, 840'000);
  device_.available = {.luts = 1'000'000, .registers = 1'000'000, .dsps = 10'000};
  options_.clocks.lane_mhz = options_.clocks.reference_mhz = 100;
  options_.set = performance::ItemSet{.items = 1000};
  for (const int streams : {1, 4}) {
    scene_.system.engine.report_streams = streams;
    const Optimisation found = optimise_now();
    const optimise::PrecisionPlan& plan = *found.best();
    EXPECT_NEAR(plan.throughput_per_s() / (streams * 100e6 / 0.84), 1, 0.03);
    EXPECT_EQ(plan.allocation()->lane_count(), streams * lanes);
    const std::string reported =
        fmt::format("{:.3g} % of the pairs are reported", 100 * rates_.reported_share().value());
    EXPECT_EQ(std::count_if(found.notes.begin(), found.notes.end(),
                            [&](const std::string& note) {
                              return note.find(reported) != std::string::npos;
                            }),
              1);
  }
}

/// 8 lanes send 0.4 reports a cycle: a stream serves two groups, and a third makes it full.
TEST_F(EnginePlan, HasNoMoreGroupsThanItsStreamServes) {
  rates_ = rates_of({{8, 0}, {10, 0}}, 50'000);
  device_.available = {.luts = 1'000'000, .registers = 1'000'000, .dsps = 10'000};
  options_.clocks.lane_mhz = options_.clocks.reference_mhz = 100;
  options_.set = performance::ItemSet{.items = 1000};
  EXPECT_NEAR(optimise_now().best()->throughput_per_s() / (100e6 / 0.05), 1, 0.05);
  EXPECT_EQ(optimise_now().best()->allocation()->lane_count(), 3 * lanes);
  device_.available.luts = 3000 + 70 + 500 + 2 * 821 + 400;  // no third group
  scene_.system.slack = 0;
  EXPECT_NEAR(optimise_now().best()->throughput_per_s() / (16 * 100e6), 1, 0.02);
  expect_plans_at_rates(rates_of({{8, 10'000}, {10, 10'000}}, 100'000));
}

/// Without a set's size a plan counts waiting words, but not lanes without items.
TEST_F(EnginePlan, CountsWaitingWordsWithoutASetsSize) {
  device_.available = {.luts = 1'000'000, .registers = 1'000'000, .dsps = 10'000};
  options_.clocks.lane_mhz = options_.clocks.reference_mhz = 100;
  rates_ = rates_of({{8, 0}, {10, 0}}, 0);
  const optimise::PrecisionPlan plan = *optimise_now().best();
  EXPECT_NEAR(plan.throughput_per_s() / (plan.allocation()->lane_count() * 100e6), 1, 1e-9);
  const auto other = at_rates(plan, scene_, rates_of({{8, 0}, {10, 0}}, 50'000));
  EXPECT_LE(other->throughput_per_s, 1.01 * 100e6 / 0.05) << "a stream takes no more";
  EXPECT_GT(other->throughput_per_s, 0.9 * 100e6 / 0.05);
}

/// 20 items have use for three groups, and 32 streams need as many.
TEST_F(EnginePlan, EachStreamHasAGroupAlsoWhereItemsAreFew) {
  device_.available = {.luts = 1'000'000, .registers = 1'000'000, .dsps = 10'000};
  options_.set = performance::ItemSet{.items = 20};
  scene_.system.engine.report_streams = 32;
  for (const std::uint64_t reported : {0, 900'000}) {
    rates_ = rates_of({{8, 0}, {10, 0}}, reported);
    ASSERT_NE(optimise_now().best(), nullptr) << reported;
    EXPECT_EQ(optimise_now().best()->allocation()->lane_count(), 32 * lanes) << reported;
  }
}

/// A counting engine has no report of a pair; a bitmap is one report of all that a group found.
TEST_F(EnginePlan, ReportsAreCountedAsTheyLeave) {
  rates_ = rates_of({{8, 0}, {10, 0}}, 840'000);
  device_.available = {.luts = 1'000'000, .registers = 1'000'000, .dsps = 10'000};
  options_.clocks.lane_mhz = options_.clocks.reference_mhz = 100;
  options_.set = performance::ItemSet{.items = 1000};
  scene_.system.engine.report_as = scene::ReportForm::bitmap;
  EXPECT_NEAR(optimise_now().best()->throughput_per_s() / (lanes * 100e6), 1, 0.05)
      << "a group reports in nearly every cycle";
  scene_.system.engine.report_as = scene::ReportForm::count;
  EXPECT_GT(optimise_now().best()->throughput_per_s(), 40 * lanes * 100e6);
}

/// Of 400 items in one block, 79800 pairs meet in 400 cycles, whatever the number of lanes beyond
/// 400. Without pairs in the rates none counts as reported.
TEST_F(EnginePlan, LanesWithoutItemsDoNotCount) {
  rates_ = rates_without_pairs();
  device_.available = {.luts = 1'000'000, .registers = 1'000'000, .dsps = 10'000};
  options_.clocks.lane_mhz = options_.clocks.reference_mhz = 100;
  options_.set = performance::ItemSet{.items = 400};
  const Optimisation found = optimise_now();
  EXPECT_LE(found.best()->allocation()->lane_count(), 400);
  const double latency = 3 * 400 / lanes + 35;  // the chain and the closing beat
  EXPECT_NEAR(found.best()->throughput_per_s() / (100e6 * 79800 / (400 + latency)), 1, 0.03);
  EXPECT_EQ(std::count_if(found.notes.begin(), found.notes.end(),
                          [](const std::string& note) {
                            return note.find("streams of reports are taken to suffice") !=
                                   std::string::npos;
                          }),
            1);
}

/// A search that asks for more than a plan's lanes can do with their items has no plan, and the
/// bound is no lower than the plan.
TEST_F(EnginePlan, BoundsCountIdleLanes) {
  options_.clocks.lane_mhz = options_.clocks.reference_mhz = 100;
  for (const std::uint64_t items : {10, 33, 100, 1000}) {
    options_.set = performance::ItemSet{.items = items};
    rates_ = rates_without_pairs();
    options_.at_least_per_s = 0;
    std::map<int, double> found;
    for (const auto& plan : optimise_now().plans) found[plan.precision] = plan.throughput_per_s();
    options_.at_least_per_s = 1;
    for (const auto& plan : optimise_now().plans) {
      EXPECT_GE(plan.bound_per_s, (1 - 1e-9) * found.at(plan.precision)) << items;
      EXPECT_LE(plan.bound_per_s, 1.5 * found.at(plan.precision)) << items;
    }
  }
}

TEST_F(EnginePlan, IsSlowerWhereMorePairsAreReported) {
  rates_ = rates_of({{8, 5000}, {10, 200}}, 20'000);
  const optimise::PrecisionPlan plan = *optimise_now().best();
  const auto own = at_rates(plan, scene_, rates_);
  EXPECT_NEAR(own->throughput_per_s / plan.throughput_per_s(), 1, 1e-9);
  const auto other = at_rates(plan, scene_, rates_of({{8, 5000}, {10, 200}}, 500'000));
  EXPECT_NEAR(other->throughput_per_s / (1e6 * plan.clock_mhz() / 0.5), 1, 0.15);
}

TEST_F(EnginePlan, WithASecondTierIsSlowerWhereItsTierIsBusy) {
  give_second_tier();
  rates_ = rates_of_tiers({{8, 5000}, {10, 200}, {13, 10}});
  expect_plans_at_rates(rates_of_tiers({{8, 900'000}, {10, 800'000}, {13, 500'000}}));
}

}  // namespace
}  // namespace mixcmp::test::engine_plan_test
