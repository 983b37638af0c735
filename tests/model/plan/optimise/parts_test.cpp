#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "model/plan/optimise/crossover.hpp"
#include "model/plan/optimise/integer_program.hpp"
#include "model/plan/optimise/tangents.hpp"

/// The parts of an allocation.
namespace mixcmp::test::parts_test {
namespace {

double at(const optimise::Tangent& line, double x) {
  return line.slope * x + line.offset;
}

TEST(LinesBelow, LieBelowEveryPointAndTouchTheHull) {
  std::mt19937 engine(1);
  std::uniform_int_distribution number(0, 100);
  for (int round = 0; round < 200; ++round) {
    std::vector<double> values(1 + round % 40);
    for (double& value : values) value = number(engine);
    for (const optimise::Tangent& line : optimise::lower_tangents(values)) {
      double nearest = std::numeric_limits<double>::infinity();
      for (std::size_t k = 0; k < values.size(); ++k) {
        nearest = std::min(nearest, values[k] - at(line, static_cast<double>(k)));
      }
      EXPECT_NEAR(nearest, 0, 1e-9);
    }
  }
}

TEST(LinesBelow, AreFewAndExactWhereThePointsAreALine) {
  std::vector<double> line, parabola;
  for (int k = 0; k <= 512; ++k) {
    line.push_back(3.0 * k + 7);
    parabola.push_back(static_cast<double>(k) * k);
  }
  ASSERT_EQ(optimise::lower_tangents(line).size(), 1u);
  EXPECT_DOUBLE_EQ(at(optimise::lower_tangents(line)[0], 100), 307);
  EXPECT_LE(optimise::lower_tangents(parabola).size(), 11u);
  EXPECT_DOUBLE_EQ(at(optimise::lower_tangents({})[0], 5), 0);
  EXPECT_DOUBLE_EQ(at(optimise::lower_tangents({4})[0], 9), 4);
}

TEST(IntegerProgram, IsSolvedInIntegers) {
  optimise::IntegerProgram knapsack;
  for (const char* name : {"a", "b", "c"}) knapsack.add_column(name, 0, 10);
  knapsack.objective = {{0, 5}, {1, 4}, {2, 3}};
  knapsack.add_row("weight", {{0, 2}, {1, 3}, {2, 1}}, optimise::IntegerProgram::Relation::at_most,
                   5);
  knapsack.add_row("size", {{0, 4}, {1, 1}, {2, 2}}, optimise::IntegerProgram::Relation::at_most,
                   11);
  knapsack.add_row("volume", {{0, 3}, {1, 4}, {2, 2}}, optimise::IntegerProgram::Relation::at_most,
                   8);
  EXPECT_EQ(optimise::solve(knapsack).point, (std::vector<int>{2, 0, 1}));  // 13, by hand
  knapsack.add_row("more", {{0, 1}, {1, 1}, {2, 1}}, optimise::IntegerProgram::Relation::at_least,
                   9);
  EXPECT_EQ(optimise::solve(knapsack).point, std::nullopt);
}

TEST(Crossover, IsWhereEveryLaneCostsMoreThanAReference) {
  const devices::Area usable{.luts = 1000, .registers = 0, .dsps = 100};
  const std::vector<devices::Area> reference{{.luts = 100}};
  std::map<int, std::vector<devices::Area>> lanes;
  for (int precision = 4; precision <= 52; ++precision) {
    lanes[precision] = {{.luts = 60 + precision}};
  }
  EXPECT_EQ(optimise::crossover_precision(lanes, reference, usable),
            41);  // 100 is not dearer than 100
  lanes[50] = {{.luts = 10}};
  EXPECT_EQ(optimise::crossover_precision(lanes, reference, usable), 51);
  lanes[52].push_back({.luts = 80});  // another kind that is cheaper
  EXPECT_EQ(optimise::crossover_precision(lanes, reference, usable), std::nullopt);
}

TEST(Crossover, CountsWhateverADeviceRunsOutOfFirst) {
  const devices::Area usable{.luts = 1000, .registers = 0, .dsps = 100};
  // The reference takes a tenth of the LUTs and two tenths of the DSPs.
  const std::vector<devices::Area> reference{{.luts = 100, .dsps = 20}};
  EXPECT_DOUBLE_EQ(optimise::device_share(reference[0], usable), 0.2);
  EXPECT_EQ(optimise::crossover_precision({{8, {{.luts = 150}}}}, reference, usable), std::nullopt);
  EXPECT_EQ(optimise::crossover_precision({{8, {{.luts = 10, .dsps = 21}}}}, reference, usable), 8);
  const devices::Area no_dsps{.luts = 1000, .registers = 0, .dsps = 0};
  EXPECT_EQ(optimise::crossover_precision({{8, {{.luts = 150}}}},
                                          {{.luts = 100}, {.luts = 9, .dsps = 1}}, no_dsps),
            8);
}

TEST(Crossover, NeedsSomethingToCompare) {
  const devices::Area usable{.luts = 1000};
  EXPECT_EQ(optimise::crossover_precision({}, {{.luts = 100}}, usable), std::nullopt);
  EXPECT_EQ(optimise::crossover_precision({{8, {{.luts = 150}}}}, {}, usable), std::nullopt);
}

}  // namespace
}  // namespace mixcmp::test::parts_test
