#include "model/plan/optimise/throughput_bound.hpp"

#include <gtest/gtest.h>

#include "tests/model/plan/optimise/planning_case.hpp"
#include "tests/model/plan/optimise/random_problems.hpp"

/// The bound against the best of all plans, and a search that skips by it against one that does
/// not.
namespace mixcmp::test::throughput_bound_test {
namespace {

double best_of(const optimise::AllocationProblem& problem) {
  const optimise::AllocationResult result = allocate_exhaustively(problem);
  const auto* plan = std::get_if<optimise::Allocation>(&result);
  return plan == nullptr ? 0 : plan->throughput_per_s;
}

TEST(ThroughputBound, NoPlanOfARandomProblemExceedsIt) {
  RandomProblems problems(31);
  int near = 0;
  for (int number = 0; number < 900; ++number) {
    const optimise::AllocationProblem problem = number % 3 == 0 ? problems.next()
                                                : number % 3 == 1
                                                    ? problems.next_of_groups_with_ports()
                                                    : problems.next_of_groups();
    const double best = best_of(problem);
    const double bound = throughput_bound(problem);
    ASSERT_GE(bound, best) << "problem " << number << "\n" << to_lp(problem);
    if (best > 0 && bound < 1.5 * best) ++near;
  }
  EXPECT_GT(near, 200) << "a bound that is never near skips nothing";
}

/// 10,000 LUTs and 100 DSPs: 50 lanes with two DSPs each, and 28 of logic in what they leave.
TEST(ThroughputBound, PricesAllResourcesTogether) {
  optimise::AllocationProblem problem;
  problem.slack = 0;
  problem.available = {.luts = 10'000, .registers = 1'000'000, .dsps = 100};
  problem.lanes = {{.name = "embedded", .clock_hz = 1e8, .area = {.luts = 60, .dsps = 2}},
                   {.name = "logic", .clock_hz = 1e8, .area = {.luts = 250}}};
  EXPECT_GE(throughput_bound(problem), 78e8);
  EXPECT_LT(throughput_bound(problem), 86e8);
  problem.max_lanes = 7;
  EXPECT_NEAR(throughput_bound(problem), 7e8, 1);
}

/// A plan may lack what was allowed, and more only where it says that its programs were not solved.
TEST(Effort, LosesNoMoreThanItSays) {
  RandomProblems problems(37);
  int cut_short = 0;
  for (int number = 0; number < 400; ++number) {
    optimise::AllocationProblem problem =
        number % 2 == 0 ? problems.next() : problems.next_of_groups_with_ports();
    problem.effort = {.may_lose = 0.2, .nodes = number % 3 == 0 ? 1 : 1000};
    const optimise::AllocationResult result = allocate(problem);
    const auto* plan = std::get_if<optimise::Allocation>(&result);
    if (plan == nullptr) continue;
    const double best = best_of(problem);
    ASSERT_LE(plan->throughput_per_s, best * (1 + 1e-9)) << to_lp(problem);
    if (plan->is_proven) {
      ASSERT_GE(plan->throughput_per_s * 1.2, best * (1 - 1e-9)) << to_lp(problem);
    }
    cut_short += plan->is_proven ? 0 : 1;
  }
  EXPECT_GT(cut_short, 3);
}

class Search : public PlanningTest {};

TEST_F(Search, SkipsOnlyPrecisionsThatAreNoFaster) {
  table_.rows.push_back(lane_row("s16e8", "exact", "relative", "logic", 1500));
  rates_ = rates_of({{8, 5000}, {10, 200}, {12, 10}, {16, 5}});
  const optimise::Optimisation all = optimise_now();
  const double best = all.best()->throughput_per_s();
  options_.at_least_per_s = best;
  const optimise::Optimisation wanted = optimise_now();
  ASSERT_NE(wanted.best(), nullptr);
  EXPECT_EQ(wanted.best()->throughput_per_s(), best);
  EXPECT_EQ(wanted.best()->precision, all.best()->precision);
  EXPECT_GE(wanted.bound_per_s(), best);
  EXPECT_NE(all.plans.back().allocation(), nullptr);
  EXPECT_EQ(wanted.plans.back().allocation(), nullptr) << "16 digits are much slower: skipped";
  options_.at_least_per_s = 2 * wanted.bound_per_s();
  EXPECT_EQ(optimise_now().best(), nullptr);
}

}  // namespace
}  // namespace mixcmp::test::throughput_bound_test
