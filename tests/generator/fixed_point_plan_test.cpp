#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/generator/planning_fixture.hpp"

/// Plans of lanes in fixed point.
namespace mixcmp::test::fixed_point_plan_test {
namespace {

class FixedPointPlan : public PlanningTest {
protected:
  /// Adds a component to the table.
  void add_row(const std::string& key, int luts, int dsps) {
    std::ofstream table(path("characterisation/scene-virtex6-lx760.csv"), std::ios::app);
    row(table, key, 7, luts, dsps);
  }

  /// The format of the plan's first lanes, as `check` reads it.
  std::string format_in_plan() {
    const Outcome checked = mixcmp("check plan.toml --json");
    EXPECT_EQ(checked.exit_code, 0) << checked.output;
    return checked.exit_code == 0 ? json_of(checked).at("lane_groups")[0].at("format") : "";
  }
};

/// Neither the table nor the plan has inputs for them.
TEST_F(FixedPointPlan, IsWhatCheckTakes) {
  add_row("lane,,q11,,fixed_norm,embedded,0,0", 380, 4);
  add_row("lane,,q11,,fixed_norm,logic,0,0", 640, 0);
  add_row("fifo,,,,,,0,32", 200, 0);
  const Outcome found =
      mixcmp("optimise scene.toml --table characterisation --last 14 --json -o plan.toml");
  ASSERT_EQ(found.exit_code, 0) << found.output;
  EXPECT_EQ(json_of(found).at("best"), 11) << found.output;
  const std::string plan = read("plan.toml");
  EXPECT_NE(plan.find("format = \"q11\"\nbound = \"certified\"\nerror_bound = \"norm\"\n"),
            std::string::npos)
      << plan;
  EXPECT_EQ(format_in_plan(), "q11");
}

/// Guard digits are no digits of a running bound, of which there are at most eight.
TEST_F(FixedPointPlan, MayHaveManyGuardDigits) {
  add_row("lane,,q11g9,,fixed_norm_g9,embedded,0,0", 380, 4);
  add_row("fifo,,,,,,0,32", 200, 0);
  const Outcome found = mixcmp(
      "optimise scene.toml --table characterisation --first 11 --last 11 --use-bounds "
      "fixed_norm_g9 "
      "--set reduced.format=q11g9 -o plan.toml");
  ASSERT_EQ(found.exit_code, 0) << found.output;
  EXPECT_EQ(format_in_plan(), "q11g9");
}

}  // namespace
}  // namespace mixcmp::test::fixed_point_plan_test
