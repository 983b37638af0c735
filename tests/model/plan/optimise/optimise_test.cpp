#include "model/plan/optimise/optimise.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "model/cost/measured/component_cells.hpp"
#include "model/plan/optimise/exploration.hpp"
#include "model/plan/optimise/plan.hpp"
#include "tests/model/plan/optimise/planning_case.hpp"

namespace mixcmp::test::optimise_test {
namespace {

using optimise::Allocation;
using optimise::Optimisation;
using optimise::OptimiseOptions;
using optimise::PrecisionPlan;

class Optimise : public PlanningTest {
protected:
  static settings::Setting::Table overrides() {
    const std::vector<std::string> settings = {
        "system.order=in_order", "data.count=12", "reduced.rounding=toward_zero",
        "system.target_mhz=7", "inputs.*={ range = [-1, 2.5] }"};
    settings::Settings scene;
    EXPECT_TRUE(apply_overrides(scene, settings).ok());
    return overridden_entries(scene.root, settings);
  }

  const optimise::PlanSource source_ = {.scene_file = "../scene.toml",
                                        .overrides = overrides(),
                                        .device = "small",
                                        .command = "mixcmp optimise"};
};

bool notes_say(const Optimisation& found, const std::string& text) {
  return std::any_of(found.notes.begin(), found.notes.end(),
                     [&](const std::string& note) { return note.find(text) != std::string::npos; });
}

/// The best of all plans. No more lanes are tried than the device has room for: the smallest takes
/// 240 LUTs of 8000.
Allocation best_by_trying(const PrecisionPlan& plan) {
  optimise::AllocationProblem problem = plan.problem;
  problem.max_lanes = 36;
  return std::get<Allocation>(allocate_exhaustively(problem));
}

TEST_F(Optimise, FindsTheBestPlanOfEachPrecisionAndAmongThem) {
  const Optimisation found = optimise_now();
  ASSERT_EQ(found.plans.size(), 3u);
  for (const PrecisionPlan& plan : found.plans) {
    ASSERT_NE(plan.allocation(), nullptr) << plan.precision;
    EXPECT_DOUBLE_EQ(plan.throughput_per_s(), best_by_trying(plan).throughput_per_s);
    EXPECT_GE(found.best()->throughput_per_s(), plan.throughput_per_s());
  }
}

TEST_F(Optimise, ALaneCarriesTheScoreboardOfTheSlowestLane) {
  const Optimisation found = optimise_now();
  // Latency 20, 6 cycles around it, 16 slots for recomputations: 64 slots.
  const auto& lane = found.plans.front().lanes.front();
  EXPECT_EQ(lane.with_streams.luts, lane.measured.area.luts + fifo_64_luts);
}

TEST_F(Optimise, RegistersBehindThePortsTakeSlots) {
  // A lane of 20 cycles needs 20 + 6 + 16 slots: up to 22 registers it has the same scoreboard.
  const auto luts = [&](int registers) {
    scene_.system.input_registers = registers;
    return optimise_now().plans.front().lanes.front().with_streams.luts;
  };
  table_.rows.push_back(row_of(measured::Fifo{128}, 90));
  EXPECT_EQ(luts(22), luts(0));
  EXPECT_EQ(luts(23), luts(0) + 90 - fifo_64_luts);
}

TEST_F(Optimise, LanesInLockStepShareAScoreboardAndAPort) {
  scene_.system.lanes_per_group = 4;
  const Optimisation found = optimise_now();
  const PrecisionPlan& plan = *found.best();
  const auto& lane = plan.lanes.front();
  EXPECT_EQ(lane.with_streams.luts, lane.measured.area.luts + fifo_64_luts / 4);
  EXPECT_EQ(lane.kind.area.luts, 4 * lane.measured.area.luts + fifo_64_luts);
  EXPECT_EQ(plan.allocation()->lane_count() % 4, 0);
  EXPECT_EQ(plan.problem.max_lanes, 4 * 512);
  EXPECT_DOUBLE_EQ(plan.throughput_per_s(), best_by_trying(plan).throughput_per_s);
}

/// A share 1 - (1 - 0.005)^4 of the words of four comparisons asks, and each of these takes one
/// more cycle.
TEST_F(Optimise, RefetchedTagsAreReadOnceMoreForEachWordThatAsks) {
  scene_.system.operands = scene::OperandStore::refetched;
  scene_.system.lanes_per_group = 4;
  const PrecisionPlan plan = optimise_now().plans.front();
  EXPECT_DOUBLE_EQ(plan.lanes.front().kind.initiation_interval, 2 - std::pow(0.995, 4));
  EXPECT_DOUBLE_EQ(plan.throughput_per_s(), best_by_trying(plan).throughput_per_s);
  scene_.system.operands = scene::OperandStore::carried;
  EXPECT_EQ(optimise_now().plans.front().lanes.front().kind.initiation_interval, 1);
}

TEST_F(Optimise, AGroupThatAsksInMoreThanHalfOfTheCyclesIsLeftOut) {
  rates_ = rates_of({{8, 130'000}, {10, 130'000}, {12, 100'000}});
  scene_.system.lanes_per_group = 4;
  for (const PrecisionPlan& plan : optimise_now().plans) {
    EXPECT_EQ(plan.lanes.empty(), plan.precision < 12) << plan.precision;
  }
}

TEST_F(Optimise, SlotsAreThoseOfAPrecisionsOwnLanes) {
  rates_ = rates_of({{8, 5000}, {10, 200}, {12, 10}, {14, 10}});
  table_.rows.push_back(lane_row("s14e8", "exact", "relative", "embedded", 700, 2));
  table_.rows.back().latency_cycles = 50;
  table_.rows.push_back(row_of(measured::Fifo{128}, 2 * fifo_64_luts));
  const Optimisation found = optimise_now();
  ASSERT_EQ(found.plans.size(), 4u);
  for (const PrecisionPlan& plan : found.plans) {
    const auto& lane = plan.lanes.front();
    const int fifo = plan.precision == 14 ? 2 * fifo_64_luts : fifo_64_luts;
    EXPECT_EQ(lane.with_streams.luts, lane.measured.area.luts + fifo) << plan.precision;
  }
}

/// A larger scoreboard that costs less, as block memories or a wrong prediction may make it: lanes
/// that have the smaller one count that.
TEST_F(Optimise, AScoreboardThatTheSystemHasNotIsNotCounted) {
  table_.rows.push_back(lane_row("s12e8", "rounded", "relative", "embedded", 6000, 2));
  table_.rows.back().latency_cycles = 50;
  table_.rows.push_back(row_of(measured::Fifo{128}, 1));
  const measured::Fifo small{64};
  for (measured::Measurement& row : table_.rows) {
    if (row.key == measured::ComponentKey(small)) row.area.luts = 400;
  }
  rates_ = rates_of({{12, 10}});
  options_.first_precision = options_.last_precision = 12;
  const Optimisation found = optimise_now();
  const PrecisionPlan* best = found.best();
  ASSERT_NE(best, nullptr);
  for (std::size_t k = 0; k < best->lanes.size(); ++k) {
    if (best->allocation()->lanes[k] == 0) continue;
    const auto& lane = best->lanes[k];
    EXPECT_EQ(lane.with_streams.luts, lane.measured.area.luts + 400) << lane.kind.name;
  }
}

TEST_F(Optimise, TheCrossbarsClockLimitsSystemsAndNotReferencesAlone) {
  table_.rows.back().clock->mhz = 100;
  const Optimisation found = optimise_now();
  EXPECT_DOUBLE_EQ(found.best()->clock_mhz(), 100);
  EXPECT_DOUBLE_EQ(std::get<Allocation>(found.reference_only).throughput_per_s, 2 * 150e6);
  EXPECT_TRUE(notes_say(found, "limited by the slowest crossbar"));
}

/// The area at the first measured port count serves smaller counts. Sums stay in range above it.
TEST_F(Optimise, CrossbarSharesAreNeverTooSmall) {
  std::erase_if(table_.rows, [](const auto& row) {
    return row.key == measured::ComponentKey(measured::Crossbar{1});
  });
  table_.rows.push_back(row_of(measured::Crossbar{64}, 1'000'000'000));
  const auto shares = optimise_now().plans.front().problem.communication.crossbar;
  for (int k = 1; k <= 8; ++k) EXPECT_EQ(shares[static_cast<std::size_t>(k)].luts, 111) << k;
  for (std::size_t k = 9; k < shares.size(); ++k) EXPECT_GT(shares[k].luts, shares[k - 1].luts);
}

TEST_F(Optimise, ASmallCrossbarIsToldWhereItLimits) {
  device_.available = {.luts = 1'000'000, .registers = 1'000'000, .dsps = 10'000};
  EXPECT_TRUE(notes_say(optimise_now(), "a reference serves 8 lanes"));
}

TEST_F(Optimise, CrossbarSharesBetweenMeasuredPortCountsAreInterpolatedUpward) {
  const Optimisation found = optimise_now();
  const auto& shares = found.plans.front().problem.communication.crossbar;
  ASSERT_EQ(shares.size(), 9u);
  EXPECT_EQ(shares[0].luts, 0);
  EXPECT_EQ(shares[1].luts, 10);
  EXPECT_EQ(shares[2].luts, 25);  // 10 + 101 / 7, rounded up
  EXPECT_EQ(shares[8].luts, 111);
}

TEST_F(Optimise, ProfiledLanesAreOnlyForScenesThatAskForThem) {
  const auto has_profiled = [](const Optimisation& found) {
    return std::any_of(found.plans.begin(), found.plans.end(), [](const PrecisionPlan& plan) {
      return std::any_of(plan.lanes.begin(), plan.lanes.end(),
                         [](const auto& lane) { return lane.lane().bound.is_profiled(); });
    });
  };
  EXPECT_FALSE(has_profiled(optimise_now()));
  scene_.reduced.is_profiled = true;
  EXPECT_TRUE(has_profiled(optimise_now()));
}

TEST_F(Optimise, ALaneWithoutARateIsLeftOutAndNamed) {
  table_.rows.push_back(lane_row("s8e8", "rounded", "constant", "embedded", 50));
  const Optimisation found = optimise_now();
  ASSERT_EQ(found.plans.front().lanes.size(), 2u);
  const auto& notes = found.notes;
  EXPECT_TRUE(std::any_of(notes.begin(), notes.end(), [](const std::string& note) {
    return note.find("rounded constant: no recomputation rate") != std::string::npos;
  }));
}

/// Even a lane with a reference of its own would be slower than that reference: the crossbar's
/// requests limit it.
TEST_F(Optimise, ALaneThatLeavesMoreThanHalfUndecidedIsLeftOut) {
  rates_ = rates_of({{8, 500'001}, {10, 500'000}, {12, 10}});
  const Optimisation found = optimise_now();
  ASSERT_EQ(found.plans.size(), 3u);
  const auto* infeasible = std::get_if<optimise::Infeasible>(&found.plans[0].result);
  ASSERT_NE(infeasible, nullptr);
  EXPECT_NE(infeasible->message.find("more than half undecided"), std::string::npos);
  EXPECT_NE(found.plans[1].allocation(), nullptr);
}

/// One comparison that is decided says little: its rate may be anything.
TEST_F(Optimise, TooFewComparisonsForARateAreNamed) {
  profile::RateProfile profile{.comparisons = 1};
  profile.schemes.push_back({.name = "relative",
                             .bound = settings::parse_bound("relative").value(),
                             .kind = profile::SchemeKind::certified,
                             .counts = std::vector<profile::SchemeCounts>(13, {.exists = true}),
                             .reason = {}});
  rates_ = optimise::Rates::of({profile});
  const optimise::Optimisation found = optimise_now();
  ASSERT_EQ(found.best(), nullptr);
  for (const optimise::PrecisionPlan& plan : found.plans) {
    const auto* infeasible = std::get_if<optimise::Infeasible>(&plan.result);
    ASSERT_NE(infeasible, nullptr);
    EXPECT_EQ(infeasible->message,
              "too few comparisons for a rate: none of 1 is undecided, so that the rate may be up "
              "to 100 % (rule of three)");
  }
}

/// Lanes with a target of 400 MHz would win against lanes measured at 300 MHz.
TEST_F(Optimise, WhereSomeClocksAreMeasuredLanesWithoutAreLeftOut) {
  scene_.system.target_mhz = 400;
  for (measured::Measurement& row : table_.rows) {
    const measured::KeyCells cells = cells_of(row.key);
    const bool timed = cells.format != "s8e8" && cells.multipliers != "logic";
    if (!timed) row.clock.reset();
  }
  const Optimisation found = optimise_now();
  EXPECT_EQ(found.basis, optimise::ClockBasis::estimate_before_routing);
  EXPECT_EQ(found.references.size(), 1u);
  for (const PrecisionPlan& plan : found.plans) EXPECT_EQ(plan.lanes.size(), 1u);
  EXPECT_EQ(found.plans.front().precision, 10);
  EXPECT_TRUE(notes_say(found, "lanes without a clock are left out"));
  options_.clocks = {400, 150, optimise::ClockDomains::separate};
  EXPECT_EQ(optimise_now().plans.size(), 3u);
  EXPECT_EQ(optimise_now().references.size(), 2u);
}

TEST_F(Optimise, WithoutAnyClockTheTargetIsTakenAsMet) {
  scene_.system.target_mhz = 400;
  for (measured::Measurement& row : table_.rows) row.clock.reset();
  const Optimisation found = optimise_now();
  EXPECT_EQ(found.basis, optimise::ClockBasis::target);
  EXPECT_DOUBLE_EQ(found.best()->clock_mhz(), 400);
}

TEST_F(Optimise, FewerExponentBitsThanTheRatesHaveAreTold) {
  table_.rows.push_back(lane_row("s8e6", "exact", "relative", "embedded", 50));
  EXPECT_TRUE(notes_say(optimise_now(), "s8e6: left out, recomputation rates were counted with 8"));
}

TEST_F(Optimise, WhatTheOptionsExcludeIsNotUsed) {
  options_.multipliers = {scene::Multipliers::logic};
  for (const PrecisionPlan& plan : optimise_now().plans) {
    for (const auto& lane : plan.lanes)
      EXPECT_EQ(lane.lane().multipliers, scene::Multipliers::logic);
  }
  options_.first_precision = 10;
  EXPECT_EQ(optimise_now().plans.size(), 2u);
}

TEST_F(Optimise, ATableWithoutAReferenceIsRefused) {
  std::erase_if(table_.rows, [](const auto& row) {
    return std::holds_alternative<measured::Reference>(row.key);
  });
  const auto found = optimise::optimise(scene_, device_, table_, rates_, options_);
  ASSERT_FALSE(found.ok());
  EXPECT_NE(found.error().to_string().find("no reference"), std::string::npos);
}

TEST_F(Optimise, ReferencesRoundSumsAsTheSceneDoes) {
  measured::Measurement fused = reference_row("embedded", 10, 1);
  measured::reference_of(fused.key)->sums = Sums::fused;
  table_.rows.push_back(fused);
  const auto kinds = [&] {
    std::vector<std::string> names;
    for (const auto& reference : optimise_now().references) names.push_back(reference.kind.name);
    return names;
  };
  for (const std::string& name : kinds()) EXPECT_EQ(name.find("fused"), std::string::npos) << name;
  scene_.reference.sums = Sums::fused;
  EXPECT_EQ(kinds(), std::vector<std::string>{"s53e8 embedded fused"});
}

TEST_F(Optimise, OneClockDomainRunsAtTheSlowestOfWhatIsUsed) {
  const Optimisation one = optimise_now();
  options_.clocks.domains = optimise::ClockDomains::separate;
  const Optimisation two = optimise_now();
  // References are measured at 150 MHz, lanes at 300.
  EXPECT_DOUBLE_EQ(one.best()->clock_mhz(), 150);
  EXPECT_DOUBLE_EQ(two.best()->clock_mhz(), 300);
}

TEST_F(Optimise, AReferenceSetsTheClockOnlyWhereNoneWithMoreRegistersWasMeasured) {
  EXPECT_TRUE(notes_say(optimise_now(), "a reference sets the clock: 150 MHz"));
  table_.rows.push_back(reference_row("embedded", 3100, 20));
  measured::reference_of(table_.rows.back().key)->target_mhz = 400;
  table_.rows.back().clock->mhz = 301;
  const Optimisation found = optimise_now();
  EXPECT_DOUBLE_EQ(found.best()->clock_mhz(), 300);
  EXPECT_FALSE(notes_say(found, "a reference sets the clock"));
  EXPECT_NE(plan_toml(found, *found.best(), source_).find("\ntarget_mhz = 400\n"),
            std::string::npos);
  scene_.reference_structure.target_mhz = 400;
  EXPECT_EQ(optimise_now().references.size(), 1u);
  scene_.reference_structure.target_mhz = static_cast<int>(scene_.system.target_mhz);
  EXPECT_EQ(optimise_now().references.size(), 2u) << "those without a target of their own";
}

TEST_F(Optimise, GivenClocksReplaceMeasuredOnes) {
  options_.clocks = {408, 285, optimise::ClockDomains::separate};
  const Optimisation found = optimise_now();
  EXPECT_EQ(found.basis, optimise::ClockBasis::given);
  EXPECT_DOUBLE_EQ(found.best()->clock_mhz(), 408);
}

TEST_F(Optimise, TheBaselineIsAsManyReferencesAsFit) {
  const Optimisation found = optimise_now();
  const auto& alone = std::get<Allocation>(found.reference_only);
  // 10000 LUT, slack 0.2: two of 3000 LUT with DSPs; 40 of 50 DSPs.
  EXPECT_EQ(alone.lane_count(), 2);
  EXPECT_DOUBLE_EQ(alone.throughput_per_s, 2 * 150e6);
}

TEST_F(Optimise, ThePlanFileSaysWhatTheBestPlanIs) {
  const Optimisation found = optimise_now();
  const std::string text = plan_toml(found, *found.best(), source_);
  EXPECT_NE(text.find("scene = \"../scene.toml\"\n"), std::string::npos);
  int lanes = 0;
  for (std::size_t at = text.find("[[lanes]]"); at != std::string::npos;
       at = text.find("[[lanes]]", at + 1)) {
    lanes += std::stoi(text.substr(text.find("count = ", at) + 8));
  }
  EXPECT_EQ(lanes, found.best()->allocation()->lane_count());
  EXPECT_NE(text.find("error_bound = \"relative\"\n"), std::string::npos);
  // The plan has the command's settings, but for those that the plan chooses.
  EXPECT_NE(text.find("order = \"in_order\"\n"), std::string::npos);
  EXPECT_NE(text.find("\n[data]\ncount = 12\n"), std::string::npos);
  EXPECT_NE(text.find("\n[reduced]\nrounding = \"toward_zero\"\n"), std::string::npos);
  EXPECT_NE(text.find("\n[inputs]\n\"*\" = { range = [-1, 2.5] }\n"), std::string::npos) << text;
  EXPECT_EQ(text.find("target_mhz = 7"), std::string::npos);
}

/// A lane without a product has no kind of multipliers. A plan without references says so, because
/// the scene may have some.
TEST_F(Optimise, ThePlanFileLeavesOutWhatItDoesNotHave) {
  Optimisation found = optimise_now();
  PrecisionPlan plan = *found.best();
  for (auto& lane : plan.lanes) measured::lane_of(lane.measured.key)->multipliers.reset();
  Allocation none = *plan.allocation();
  for (int& count : none.references) count = 0;
  plan.result = none;
  const std::string text = plan_toml(found, plan, source_);
  EXPECT_EQ(text.find("multipliers"), std::string::npos);
  EXPECT_NE(text.find("\nreferences = 0\n"), std::string::npos);
  EXPECT_EQ(text.find("[[references]]"), std::string::npos);
}

TEST_F(Optimise, ScenarioTwoPlansForTheWorstRateOfEachKind) {
  optimise::Rates bad = rates_of({{8, 90000}, {10, 20}, {12, 5}});
  const auto found = explore(scene_, device_, table_, {{"easy", rates_}, {"hard", bad}},
                             {{"ours", options_.clocks}}, options_);
  ASSERT_TRUE(found.ok()) << found.error().to_string();
  const optimise::ResultsAtClocks& column = found->columns.front();
  ASSERT_EQ(column.scenario_1.size(), 2u);
  const double worst = summary_of(column.worst).throughput_per_s;
  for (const auto& own : column.scenario_1) EXPECT_LE(worst, own.throughput_per_s);
  // At 8 digits the hard set counts, at 12 the easy one, which has the higher rate there.
  EXPECT_DOUBLE_EQ(column.worst.plans[0].lanes[0].kind.recomputation_rate, 0.09);
  EXPECT_DOUBLE_EQ(column.worst.plans[2].lanes[0].kind.recomputation_rate, 10 / 1e6);
}

TEST_F(Optimise, APlanIsSlowerOnDataThatItsReferencesCannotServe) {
  expect_plans_at_rates(rates_of({{8, 400'000}, {10, 300'000}, {12, 300'000}}));
}

/// A plan with refetched operands is slower at any higher rate: tags are read twice.
TEST_F(Optimise, APlanThatRefetchesReadsTheTagsOfMoreComparisonsTwice) {
  scene_.system.operands = scene::OperandStore::refetched;
  const Optimisation found = optimise_now();
  const optimise::PrecisionPlan& plan = *found.best();
  const auto none = at_rates(plan, scene_, rates_of({{8, 10}, {10, 10}, {12, 10}}));
  const auto some = at_rates(plan, scene_, rates_of({{8, 1010}, {10, 1010}, {12, 1010}}));
  ASSERT_TRUE(none && some);
  EXPECT_NEAR(some->throughput_per_s / none->throughput_per_s, 0.999, 1e-4);
}

TEST_F(Optimise, APlanHasNoThroughputAtRatesThatAreNotKnown) {
  EXPECT_FALSE(at_rates(*optimise_now().best(), scene_, rates_of({{4, 10}})));
}

}  // namespace
}  // namespace mixcmp::test::optimise_test
