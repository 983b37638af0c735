#include "model/plan/optimise/allocation.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "model/cost/performance/performance.hpp"
#include "model/plan/optimise/feasibility.hpp"
#include "tests/model/plan/optimise/random_problems.hpp"

/// The integer program against everything that small problems allow, and against plans known by
/// hand.
namespace mixcmp::test::allocation_test {
namespace {

optimise::LaneKind lane(double mhz, double rate, devices::Area area) {
  return {.name = "lane", .clock_hz = mhz * 1e6, .recomputation_rate = rate, .area = area};
}
optimise::ReferenceKind reference(double mhz, devices::Area area) {
  return {.name = "reference", .clock_hz = mhz * 1e6, .area = area};
}

optimise::AllocationProblem problem_of(std::vector<optimise::LaneKind> lanes,
                                       std::vector<optimise::ReferenceKind> references,
                                       devices::Area available) {
  optimise::AllocationProblem problem;
  problem.lanes = std::move(lanes);
  problem.references = std::move(references);
  problem.available = available;
  problem.slack = 0;
  return problem;
}

optimise::Allocation plan_of(const optimise::AllocationProblem& problem) {
  const optimise::AllocationResult result = allocate(problem);
  if (const auto* plan = std::get_if<optimise::Allocation>(&result)) return *plan;
  ADD_FAILURE() << std::get<optimise::Infeasible>(result).message;
  return {};
}

optimise::Infeasible shortage_of(const optimise::AllocationProblem& problem) {
  const optimise::AllocationResult result = allocate(problem);
  if (const auto* infeasible = std::get_if<optimise::Infeasible>(&result)) return *infeasible;
  ADD_FAILURE() << "there is a plan";
  return {};
}

TEST(PlanOf, KeepsTheMostLanesAndReferences) {
  optimise::AllocationProblem problem =
      problem_of({lane(100, 0.01, {.luts = 1})}, {reference(100, {.luts = 1})}, {.luts = 1000});
  problem.max_lanes = 4;
  problem.max_references = 2;
  EXPECT_TRUE(optimise::plan_of(problem, {.lanes = {4}, .references = {2}}).has_value());
  EXPECT_FALSE(optimise::plan_of(problem, {.lanes = {5}, .references = {2}}).has_value());
  EXPECT_FALSE(optimise::plan_of(problem, {.lanes = {4}, .references = {3}}).has_value());
  EXPECT_FALSE(optimise::plan_of(problem, {.lanes = {0}, .references = {1}}).has_value());
}

/// Lanes of different throughput may reach the same sum in two ways. With one clock only their
/// initiation intervals differ.
bool one_way(const optimise::AllocationProblem& problem) {
  const bool one_clock = problem.clocks == optimise::ClockDomains::single;
  const auto throughput = [&](const optimise::LaneKind& kind) {
    return throughput_per_s(kind, one_clock ? 1 : optimise::any_clock);
  };
  return std::all_of(problem.lanes.begin(), problem.lanes.end(), [&](const auto& kind) {
    return throughput(kind) == throughput(problem.lanes.front());
  });
}

/// Whether there is a plan.
bool expect_same(const optimise::AllocationProblem& problem, int number) {
  const optimise::AllocationResult solved = allocate(problem);
  const optimise::AllocationResult tried = allocate_exhaustively(problem);
  EXPECT_EQ(solved.index(), tried.index()) << "problem " << number << "\n" << to_lp(problem);
  const auto* best = std::get_if<optimise::Allocation>(&tried);
  if (best == nullptr || solved.index() != tried.index()) return false;
  const optimise::Allocation& plan = std::get<optimise::Allocation>(solved);
  EXPECT_EQ(plan.throughput_per_s, best->throughput_per_s) << "problem " << number << "\n"
                                                           << to_lp(problem);
  if (!one_way(problem)) return true;
  EXPECT_EQ(plan.reference_count(), best->reference_count()) << "problem " << number;
  EXPECT_EQ(plan.lane_count(), best->lane_count()) << "problem " << number;
  EXPECT_EQ(plan.used, best->used) << "problem " << number;
  return true;
}

TEST(Allocation, IsTheBestOfEverythingInRandomProblems) {
  RandomProblems problems(11);
  int feasible = 0;
  for (int number = 0; number < 500; ++number) {
    feasible += expect_same(problems.next(), number) ? 1 : 0;
  }
  EXPECT_GT(feasible, 200);
  EXPECT_LT(feasible, 400);
}

TEST(Allocation, OfGroupsIsTheBestOfEverythingInRandomProblems) {
  RandomProblems problems(17);
  int feasible = 0;
  for (int number = 0; number < 300; ++number) {
    feasible += expect_same(problems.next_of_groups(), number) ? 1 : 0;
  }
  EXPECT_GT(feasible, 100);
}

TEST(Allocation, OfGroupsWithPortsIsTheBestOfEverythingInRandomProblems) {
  RandomProblems problems(23);
  int feasible = 0;
  for (int number = 0; number < 300; ++number) {
    feasible += expect_same(problems.next_of_groups_with_ports(), number) ? 1 : 0;
  }
  EXPECT_GT(feasible, 100);
}

/// A group of four lanes asks for 0.8 recomputations a cycle, so that a reference serves one group.
TEST(Allocation, DealsWholeGroupsToReferences) {
  optimise::AllocationProblem problem = {.lanes = {{.name = "lane",
                                                    .clock_hz = 1e8,
                                                    .recomputation_rate = 0.2,
                                                    .area = {.luts = 10},
                                                    .group = 4}},
                                         .references = {{"reference", 1e8, 1, {.luts = 10}}},
                                         .communication = {},
                                         .available = {.luts = 50},
                                         .slack = 0};
  const auto plan = std::get<optimise::Allocation>(allocate(problem));
  EXPECT_EQ(plan.lanes,
            std::vector{8});  // 3 groups would leave one reference with two: 1.6 a cycle
  EXPECT_EQ(plan.references, std::vector{2});
  EXPECT_EQ(plan.used.luts, 40);
  problem.communication.crossbar = {{.luts = 0}, {.luts = 1}, {.luts = 3}, {.luts = 7}};
  const auto with_crossbar = optimise::plan_of(problem, {.lanes = {8}, .references = {2}});
  ASSERT_TRUE(with_crossbar.has_value()) << "a group has one port";
  EXPECT_EQ(with_crossbar->used.luts, 42);
  problem.lanes[0].recomputation_rate = 0.3;  // a group asks for more than a reference does
  EXPECT_TRUE(std::holds_alternative<optimise::Infeasible>(allocate(problem)));
}

TEST(Allocation, OfALeastNumberOfLanesIsTheBestOfEverythingInRandomProblems) {
  RandomProblems problems(19);
  int feasible = 0;
  for (int number = 0; number < 300; ++number) {
    feasible += expect_same(problems.next_with_least_lanes(), number) ? 1 : 0;
  }
  EXPECT_GT(feasible, 60);
  EXPECT_LT(feasible, 240);
}

TEST(Allocation, IsTheSameEveryTime) {
  RandomProblems problems(12);
  for (int number = 0; number < 40; ++number) {
    const optimise::AllocationProblem problem = problems.next();
    const optimise::AllocationResult first = allocate(problem);
    const optimise::AllocationResult second = allocate(problem);
    ASSERT_EQ(first.index(), second.index());
    if (first.index() != 0) continue;
    EXPECT_EQ(std::get<optimise::Allocation>(first).lanes,
              std::get<optimise::Allocation>(second).lanes);
    EXPECT_EQ(std::get<optimise::Allocation>(first).references,
              std::get<optimise::Allocation>(second).references);
  }
}

TEST(Allocation, MixesKindsWhereOneResourceRunsOut) {
  // Ten DSP lanes use up the DSPs, twenty of logic the rest of the LUTs.
  optimise::AllocationProblem problem =
      problem_of({lane(100, 0, {.luts = 10, .dsps = 4}), lane(100, 0, {.luts = 20})}, {},
                 {.luts = 500, .registers = 0, .dsps = 40});
  EXPECT_EQ(plan_of(problem).lanes, (std::vector<int>{10, 20}));
  problem.available.dsps = 0;
  EXPECT_EQ(plan_of(problem).lanes, (std::vector<int>{0, 25}));
}

TEST(Allocation, SlowerKindsAreLeftOutWhereTheyWouldSlowTheSystem) {
  const std::vector<optimise::LaneKind> kinds{lane(400, 0, {.luts = 10, .dsps = 4}),
                                              lane(300, 0, {.luts = 20})};
  optimise::AllocationProblem problem = problem_of(kinds, {}, {.luts = 200, .dsps = 40});
  // At one clock ten at 400 MHz make 4 G; with five of the others, all at 300 MHz, 4.5 G.
  EXPECT_EQ(plan_of(problem).lanes, (std::vector<int>{10, 5}));
  EXPECT_DOUBLE_EQ(plan_of(problem).throughput_per_s, 15 * 300e6);
  problem.available.luts = 150;  // twelve at 300 MHz: less than ten at 400 MHz
  EXPECT_EQ(plan_of(problem).lanes, (std::vector<int>{10, 0}));
  problem.clocks = optimise::ClockDomains::separate;
  EXPECT_EQ(plan_of(problem).lanes, (std::vector<int>{10, 2}));
  EXPECT_DOUBLE_EQ(plan_of(problem).throughput_per_s, 10 * 400e6 + 2 * 300e6);
}

TEST(Allocation, ASlowReferenceSlowsASingleClockAndLimitsSeparateOnes) {
  optimise::AllocationProblem problem =
      problem_of({lane(400, 0.1, {.luts = 10})}, {reference(200, {.luts = 100})}, {.luts = 1000});
  problem.max_references = 1;
  // At 200 MHz the reference serves ten lanes; with a clock of its own only five at 400 MHz.
  EXPECT_DOUBLE_EQ(plan_of(problem).throughput_per_s, 10 * 200e6);
  problem.clocks = optimise::ClockDomains::separate;
  EXPECT_DOUBLE_EQ(plan_of(problem).throughput_per_s, 5 * 400e6);
}

TEST(Allocation, AFoldedReferenceServesFewerLanesAtTheSameClock) {
  optimise::LaneKind one = lane(100, 0.01, {.luts = 10});
  optimise::ReferenceKind whole = reference(100, {.luts = 500});
  optimise::ReferenceKind folded = reference(100, {.luts = 100});
  folded.initiation_interval = 16;
  optimise::AllocationProblem problem = problem_of({one}, {whole, folded}, {.luts = 160});
  // Six lanes ask for 0.06 of a comparison per cycle, and the folded reference does 0.0625.
  EXPECT_EQ(plan_of(problem).references, (std::vector<int>{0, 1}));
  EXPECT_DOUBLE_EQ(plan_of(problem).throughput_per_s, 6 * 100e6);
  problem.available.luts = 330;  // a seventh lane needs a second one, which serves six as well
  EXPECT_EQ(plan_of(problem).references, (std::vector<int>{0, 2}));
  EXPECT_EQ(plan_of(problem).lanes, std::vector<int>{12});
  problem.available.luts = 1500;
  EXPECT_EQ(plan_of(problem).references, (std::vector<int>{1, 0}));
  EXPECT_EQ(plan_of(problem).lanes, std::vector<int>{100});
}

TEST(Allocation, EachReferenceMustServeTheLanesDealtToIt) {
  // 0.4 of a reference each: two references could serve five lanes only if they shared them.
  optimise::AllocationProblem problem =
      problem_of({lane(100, 0.4, {.luts = 10})}, {reference(100, {.luts = 10})}, {.luts = 75});
  problem.max_references = 2;
  EXPECT_EQ(plan_of(problem).lane_count(), 4);
  problem.sharing = optimise::ReferenceSharing::pooled;
  EXPECT_EQ(plan_of(problem).lane_count(), 5);
}

TEST(Allocation, KindsOfAPlanAreListedAsTheirLanesAreDealt) {
  optimise::AllocationProblem problem =
      problem_of({lane(300, 0.1, {.luts = 10}), lane(100, 0.25, {.luts = 10})},
                 {reference(100, {.luts = 10}), reference(200, {.luts = 10})}, {.luts = 75});
  // At one clock the second kind asks for more of a reference, with clocks of its own the first.
  EXPECT_EQ(lane_order(problem), (std::vector<int>{1, 0}));
  EXPECT_EQ(reference_order(problem), (std::vector<int>{0, 1}));
  problem.clocks = optimise::ClockDomains::separate;
  EXPECT_EQ(lane_order(problem), (std::vector<int>{0, 1}));
  EXPECT_EQ(reference_order(problem), (std::vector<int>{1, 0}));
}

TEST(Allocation, DecimalRatesThatJustFillAReferenceFillIt) {
  for (const int lanes : {3, 7, 9, 10, 11, 49, 100, 333}) {
    optimise::AllocationProblem problem = problem_of({lane(337, 1.0 / lanes, {.luts = 1})},
                                                     {reference(337, {.luts = 1})}, {.luts = 1000});
    problem.max_references = 1;
    EXPECT_EQ(plan_of(problem).lane_count(), lanes);
    // CBC's tolerance does not let in one lane more than there is room for.
    problem.lanes[0].recomputation_rate *= 1 + 1e-9;
    EXPECT_EQ(plan_of(problem).lane_count(), lanes - 1);
  }
}

TEST(Allocation, TinyRatesNeedAReferenceAndNoneNeedsNone) {
  optimise::AllocationProblem problem =
      problem_of({lane(408, 1e-9, {.luts = 10})}, {reference(285, {.luts = 100})}, {.luts = 500});
  EXPECT_EQ(plan_of(problem).lane_count(), 40);
  EXPECT_EQ(plan_of(problem).reference_count(), 1);
  problem.lanes[0].recomputation_rate = 0;
  EXPECT_EQ(plan_of(problem).lane_count(), 50);
  EXPECT_EQ(plan_of(problem).reference_count(), 0);
}

TEST(Allocation, TheCrossbarCostsWhatItsReferencesServe) {
  optimise::AllocationProblem problem =
      problem_of({lane(100, 0.25, {.luts = 10})}, {reference(100, {.luts = 0})}, {.luts = 100});
  problem.max_references = 2;
  // Shares of 0, 1, 4, 9 and 16 LUTs: four lanes each would be 80 + 32, seven 70 + 16 + 9.
  problem.communication.crossbar = {{}, {.luts = 1}, {.luts = 4}, {.luts = 9}, {.luts = 16}};
  const optimise::Allocation plan = plan_of(problem);
  EXPECT_EQ(plan.lane_count(), 7);
  EXPECT_EQ(plan.used.luts, 70 + 16 + 9);
  problem.communication.crossbar.resize(3);  // two ports a reference
  EXPECT_EQ(plan_of(problem).lane_count(), 4);
}

TEST(Allocation, OfEqualPlansTheOneWithFewestReferencesThenLutsIsTaken) {
  optimise::AllocationProblem problem =
      problem_of({lane(100, 0.5, {.luts = 10}), lane(100, 0.5, {.luts = 8, .registers = 9}),
                  lane(100, 0.1, {.luts = 30})},
                 {reference(100, {.luts = 5}), reference(100, {.luts = 4, .dsps = 1})},
                 {.luts = 1000, .registers = 1000, .dsps = 10});
  problem.max_lanes = 2;
  const optimise::Allocation plan = plan_of(problem);
  EXPECT_EQ(plan.lanes, (std::vector<int>{0, 2, 0}));
  EXPECT_EQ(plan.references, (std::vector<int>{0, 1}));
}

TEST(Allocation, OfKindsThatAreTheSameTheFirstIsTaken) {
  const optimise::AllocationProblem problem =
      problem_of({lane(100, 0.1, {.luts = 10}), lane(100, 0.1, {.luts = 10})},
                 {reference(100, {.luts = 10}), reference(100, {.luts = 10})}, {.luts = 60});
  EXPECT_EQ(plan_of(problem).lanes, (std::vector<int>{5, 0}));
  EXPECT_EQ(plan_of(problem).references, (std::vector<int>{1, 0}));
}

TEST(Allocation, InfeasibleProblemsNameTheResourceAndByHowMuch) {
  const auto kinds = std::vector{lane(100, 0.1, {.luts = 100, .dsps = 2})};
  const auto reference_kinds = std::vector{reference(100, {.luts = 900, .dsps = 40})};
  optimise::AllocationProblem problem =
      problem_of(kinds, reference_kinds, {.luts = 800, .dsps = 50});
  problem.communication.fixed.luts = 10;
  optimise::Infeasible infeasible = shortage_of(problem);
  ASSERT_EQ(infeasible.shortages.size(), 1u);
  EXPECT_EQ(infeasible.shortages[0].resource, "lut");
  EXPECT_EQ(infeasible.shortages[0].usable, 800);
  EXPECT_EQ(infeasible.shortages[0].needed, 1010);
  EXPECT_NE(infeasible.message.find("lut: 1010 needed, 800 usable, 210 short"), std::string::npos)
      << infeasible.message;
  problem.available.dsps = 41;
  ASSERT_EQ(shortage_of(problem).shortages.size(), 2u);
  EXPECT_EQ(shortage_of(problem).shortages[1].resource, "dsp");
}

TEST(Allocation, WhereKindsFailForDifferentReasonsTheNearestIsNamed) {
  const optimise::AllocationProblem problem =
      problem_of({lane(100, 0, {.luts = 1000}), lane(100, 0, {.luts = 10, .dsps = 11})}, {},
                 {.luts = 100, .dsps = 10});
  const optimise::Infeasible infeasible = shortage_of(problem);
  ASSERT_EQ(infeasible.shortages.size(), 1u);
  EXPECT_EQ(infeasible.shortages[0].resource, "dsp");
  EXPECT_EQ(infeasible.shortages[0].needed, 11);
}

TEST(Allocation, WhatFailsEquation10HasNoShortage) {
  optimise::AllocationProblem problem =
      problem_of({lane(400, 1, {.luts = 1})}, {reference(100, {.luts = 1})}, {.luts = 100});
  problem.clocks = optimise::ClockDomains::separate;
  EXPECT_TRUE(shortage_of(problem).shortages.empty());
  EXPECT_NE(shortage_of(problem).message.find("no reference is fast enough"), std::string::npos);
  problem.references.clear();
  EXPECT_NE(shortage_of(problem).message.find("there is none to build"), std::string::npos);
  problem.lanes.clear();
  EXPECT_NE(shortage_of(problem).message.find("no lane"), std::string::npos);
}

TEST(Allocation, FixedCommunicationAloneMayBeTooMuch) {
  optimise::AllocationProblem problem = problem_of({lane(100, 0, {.luts = 1})}, {}, {.luts = 100});
  problem.communication.fixed.luts = 101;
  ASSERT_EQ(shortage_of(problem).shortages.size(), 1u);
  EXPECT_EQ(shortage_of(problem).shortages[0].needed, 102);
}

}  // namespace
}  // namespace mixcmp::test::allocation_test
