#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "model/plan/optimise/allocation.hpp"
#include "model/plan/optimise/allocation_program.hpp"
#include "tests/model/plan/optimise/random_problems.hpp"
#include "tests/support/scratch_directory.hpp"

/// The program in the LP format, solved by GLPK: a solver that shares nothing with CBC.
namespace mixcmp::test::lp_test {
namespace {

class LinearProgram : public testing::Test {
protected:
  void SetUp() override {
    if (std::system("glpsol --version > /dev/null 2>&1") != 0) {
      GTEST_SKIP() << "glpsol is not installed (package glpk-utils)";
    }
  }

  /// None: GLPK proves that there is no solution.
  std::optional<double> optimum_by_glpk(const std::string& lp) {
    const auto model = directory_.path() / "model.lp";
    const auto report = directory_.path() / "report.txt";
    std::ofstream(model) << lp;
    const std::string command = "glpsol --lp '" + model.string() + "' -o '" + report.string() +
                                "' > '" + (directory_.path() / "log.txt").string() + "' 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0) << lp;
    std::ifstream stream(report);
    std::string status, objective;
    for (std::string line; std::getline(stream, line);) {
      if (line.starts_with("Status:")) status = line.substr(12);
      if (line.starts_with("Objective:")) objective = line.substr(line.find('=') + 1);
    }
    if (status != "INTEGER OPTIMAL") return std::nullopt;
    return std::stod(objective);
  }

  ScratchDirectory directory_;
};

/// Comparisons a second that a unit of the objective stands for: as `to_lp` chose it.
double unit_of(const optimise::AllocationProblem& problem, const optimise::Allocation& plan) {
  double clock = 0;
  if (problem.clocks == optimise::ClockDomains::single) {
    clock = optimise::any_clock;
    for (std::size_t k = 0; k < problem.lanes.size(); ++k) {
      if (plan.lanes[k] > 0) clock = std::min(clock, problem.lanes[k].clock_hz);
    }
    for (std::size_t k = 0; k < problem.references.size(); ++k) {
      if (plan.references[k] > 0) clock = std::min(clock, problem.references[k].clock_hz);
    }
  }
  return exact_program(problem, {clock, plan.reference_count(), {}}).objective_per_s;
}

/// 5 * 66.48 MHz / 5 is above 66.48 MHz in double: the plan's own kind must stay in its program.
TEST_F(LinearProgram, ThePlansClockIsNotRounded) {
  const double mhz = 66.48e6;
  ASSERT_GT(5 * mhz / 5, mhz * (1 - 1e-9));
  const optimise::AllocationProblem problem = {.lanes = {{"lane", mhz, 1, 0.01, {.luts = 10}}},
                                               .references = {{"reference", mhz, 1, {.luts = 10}}},
                                               .communication = {},
                                               .available = {.luts = 60},
                                               .slack = 0};
  const auto plan = std::get<optimise::Allocation>(allocate(problem));
  ASSERT_EQ(plan.lane_count(), 5);
  EXPECT_TRUE(optimum_by_glpk(to_lp(problem)).has_value());
}

TEST_F(LinearProgram, HasTheSameOptimumForGlpk) {
  RandomProblems problems(13);
  int feasible = 0;
  for (int number = 0; number < 60; ++number) {
    const optimise::AllocationProblem problem = problems.next();
    const optimise::AllocationResult result = allocate(problem);
    const auto* plan = std::get_if<optimise::Allocation>(&result);
    if (plan == nullptr) continue;
    ++feasible;
    const auto optimum = optimum_by_glpk(to_lp(problem));
    ASSERT_TRUE(optimum) << "problem " << number << "\n" << to_lp(problem);
    EXPECT_NEAR(*optimum * unit_of(problem, *plan), plan->throughput_per_s,
                1e-6 * plan->throughput_per_s)
        << "problem " << number << "\n"
        << to_lp(problem);
  }
  EXPECT_GT(feasible, 20);
}

TEST_F(LinearProgram, NoOtherNumberOfReferencesIsBetterForGlpkEither) {
  RandomProblems problems(14);
  for (int number = 0; number < 25; ++number) {
    optimise::AllocationProblem problem = problems.next();
    problem.clocks = optimise::ClockDomains::separate;
    const optimise::AllocationResult result = allocate(problem);
    const auto* plan = std::get_if<optimise::Allocation>(&result);
    const double best = plan == nullptr ? 0 : plan->throughput_per_s;
    const int most = problem.references.empty() ? 0 : problem.max_references;
    for (int references = 0; references <= most; ++references) {
      const optimise::AllocationProgram program = exact_program(problem, {0, references, {}});
      const auto optimum = optimum_by_glpk(to_lp(program.program));
      if (!optimum) continue;
      EXPECT_LE(*optimum * program.objective_per_s, best * (1 + 1e-6))
          << "problem " << number << ", p_H = " << references << "\n"
          << to_lp(program.program);
    }
  }
}

TEST_F(LinearProgram, CountsTheCrossbarOfReferencesThatServeUnlikeNumbersOfLanes) {
  optimise::AllocationProblem problem;
  problem.lanes = {
      {.name = "s8e8", .clock_hz = 1e8, .recomputation_rate = 0.25, .area = {.luts = 10}}};
  problem.references = {{.name = "s53e8", .clock_hz = 1e8, .area = {}}};
  problem.communication.crossbar = {{}, {.luts = 1}, {.luts = 4}, {.luts = 9}, {.luts = 16}};
  problem.slack = 0;
  problem.max_references = 2;
  for (const auto& [luts, lanes] :
       {std::pair(95, 7), {94, 6}, {78, 6}, {77, 5}, {63, 5}, {62, 4}}) {
    problem.available.luts = luts;  // 10 a lane; 16 + 9, 9 + 9, 9 + 4 for two crossbar shares
    const optimise::AllocationProgram program = exact_program(problem, {1e8, 2, {}});
    EXPECT_EQ(optimum_by_glpk(to_lp(program.program)), lanes) << luts;
    EXPECT_EQ(solve(program.program).point.value().front(), lanes) << luts;
  }
}

TEST_F(LinearProgram, OfAProblemWithoutAPlanHasNoSolution) {
  optimise::AllocationProblem problem;
  problem.lanes = {
      {.name = "s8e8", .clock_hz = 4e8, .recomputation_rate = 0.1, .area = {.luts = 100}}};
  problem.references = {{.name = "s53e8", .clock_hz = 3e8, .area = {.luts = 900}}};
  problem.available = {.luts = 800};
  problem.slack = 0;
  ASSERT_TRUE(std::holds_alternative<optimise::Infeasible>(allocate(problem)));
  EXPECT_FALSE(optimum_by_glpk(to_lp(problem)));
}

TEST(LinearProgramText, NamesItsKindsAndEquations) {
  optimise::AllocationProblem problem;
  problem.lanes = {
      {.name = "s8e8 exact", .clock_hz = 4e8, .recomputation_rate = 0.1, .area = {.luts = 100}}};
  problem.references = {{.name = "s53e8", .clock_hz = 4e8, .area = {.luts = 900}}};
  problem.available = {.luts = 4000};
  const std::string lp = to_lp(problem);
  for (const char* words : {"\\ lanes_0: s8e8 exact", "\\ references_0: s53e8", "Maximize",
                            "equation_10:", "lut:", "100 lanes_0", "<= 3200", "General", "End"}) {
    EXPECT_NE(lp.find(words), std::string::npos) << words << "\n" << lp;
  }
}

}  // namespace
}  // namespace mixcmp::test::lp_test
