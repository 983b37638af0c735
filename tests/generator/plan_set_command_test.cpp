#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/generator/planning_fixture.hpp"

/// `mixcmp optimise --plans` as a user calls it, on a made-up table.
namespace mixcmp::test::plan_set_command_test {
namespace {

namespace fs = std::filesystem;

class PlanSetCommand : public PlanningTest {
protected:
  static constexpr const char* small = "optimise scene.toml --table characterisation --last 14 ";
};

TEST_F(PlanSetCommand, ItsPlansAreScenesAndItsRuleIsBesideThem) {
  const Outcome found = mixcmp(std::string(small) +
                               "--plans 3 --over data.radius_max=1,100 --stream "
                               "data.radius_max=1,100,1 -o set");
  ASSERT_EQ(found.exit_code, 0) << found.output;
  EXPECT_NE(found.output.find("a stream of 3 blocks"), std::string::npos) << found.output;
  for (const char* plan : {"set/plan_1.toml", "set/plan_2.toml"}) {
    EXPECT_EQ(mixcmp(std::string("check ") + plan).exit_code, 0) << plan;
    EXPECT_EQ(read(plan).find("radius_max"), read(plan).find("radius_max=1,100"))
        << "no data set is in a plan, only in its command";
  }
  EXPECT_FALSE(fs::exists(path("set/plan_3.toml"))) << "two data sets need no third plan";
  EXPECT_NE(read("set/switching.h").find("int spheres_next_plan("), std::string::npos);
  EXPECT_NE(read("set/switching.py").find("class Switching:"), std::string::npos);
  // A later run with fewer plans leaves none of them behind.
  ASSERT_EQ(mixcmp(std::string(small) + "--plans 1 --over data.radius_max=1,100 -o set").exit_code,
            0);
  EXPECT_TRUE(fs::exists(path("set/plan_1.toml")));
  EXPECT_FALSE(fs::exists(path("set/plan_2.toml")));
}

TEST_F(PlanSetCommand, JsonHasThePlansTheirRatesAndLosses) {
  const Outcome found =
      mixcmp(std::string(small) +
             "--plans 2 --over data.radius_max=1,100 --reconfiguration-seconds 0.5 --json");
  ASSERT_EQ(found.exit_code, 0) << found.output;
  const auto set = json_of(found);
  EXPECT_EQ(set.at("reconfiguration_seconds"), 0.5);
  ASSERT_EQ(set.at("plans").size(), 2U);
  ASSERT_EQ(set.at("losses").size(), 2U);
  EXPECT_GT(set.at("losses")[0], 0.0);
  EXPECT_NEAR(set.at("losses")[1], 0.0, 1e-12);
  ASSERT_EQ(set.at("data_sets").size(), 2U);
  for (const auto& each : set.at("data_sets")) {
    const double best = each.at("best_per_s");
    const double first = each.at("plan_1_per_s"), second = each.at("plan_2_per_s");
    EXPECT_EQ(best, std::max(first, second));
  }
  for (const auto& plan : set.at("plans")) {
    EXPECT_EQ(plan.at("counted_rates").size(), 2U);
    EXPECT_EQ(plan.at("best_rates").size(), 1U);
  }
}

TEST_F(PlanSetCommand, MistakesAreNamed) {
  const std::string two = std::string(small) + "--plans 2 ";
  expect_refused(two, "--over");
  expect_refused(std::string(small) + "--over data.radius_max=1,2", "--plans");
  expect_refused(two + "--over radius_max=1,2", "--over: names no data sets");
  expect_refused(two + "--over data.radius_max=1,-2", "--over");
  expect_refused(two + "--over data.radius_max=1,2 --stream data.seed", "--stream");
  expect_refused(two + "--over data.radius_max=1,2 --csv figure.csv", "--csv");
  expect_refused(two + "--over data.radius_max=1,2 --reconfiguration-seconds 0",
                 "--reconfiguration-seconds: received 0; accepted 1e-06");
  expect_refused(std::string(small) + "--plans 9 --over data.radius_max=1,2", "1..8");
  expect_refused(two + "--over data.radius_max=1,2 --set system.counter_bits=0",
                 "system.counters: plans are switched by what a system counts");
  expect_refused(two + R"(--over data.radius_max=1,2 --set 'inputs.ri.range="data"')",
                 "the range of an input would be another one in each data set");
}

}  // namespace
}  // namespace mixcmp::test::plan_set_command_test
