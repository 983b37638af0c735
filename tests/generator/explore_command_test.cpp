#include <fmt/core.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "tests/generator/planning_fixture.hpp"

/// `mixcmp explore` as a user calls it, on a made-up table.
namespace mixcmp::test::explore_command_test {
namespace {

namespace fs = std::filesystem;

class ExploreCommand : public PlanningTest {};

TEST_F(ExploreCommand, ExploreWritesFiguresTablesAndPlans) {
  const Outcome found =
      mixcmp("explore scene.toml --last 14 --over data.radius_max=10,25 --beside-paper -o out");
  ASSERT_EQ(found.exit_code, 0) << found.output;
  const std::string report = read("out/report.md");
  EXPECT_NE(report.find("| scenario II: T(equ), G/s | 35.5 |"), std::string::npos) << report;
  for (const char* name : {"figure3.svg", "figure7.svg", "figure8.svg", "figure9.svg",
                           "figure9.csv", "scenarios.csv", "plan_scenario_2.toml"}) {
    EXPECT_GT(read(std::string("out/virtex6-lx760/") + name).size(), 100u) << name;
  }
  EXPECT_EQ(mixcmp("check out/virtex6-lx760/plan_scenario_1.toml").exit_code, 0);
}

TEST_F(ExploreCommand, RatesOfOtherPrecisionsAreNotUsedAgain) {
  ASSERT_EQ(mixcmp("explore scene.toml --first 8 --last 8 -o out").exit_code, 0);
  const Outcome more = mixcmp("explore scene.toml --first 8 --last 12 -o out");
  ASSERT_EQ(more.exit_code, 0) << more.output;
  EXPECT_EQ(more.output.find("no recomputation rate is known"), std::string::npos) << more.output;
}

TEST_F(ExploreCommand, ThePageShowsTheWholeCommandAndWhatTheTableIsNot) {
  const Outcome found = mixcmp(
      "explore scene.toml --last 12 --over data.radius_max=10,25 --beside-paper -o out "
      "--page page.html");
  // The scene leaves the format open, so the page has no system to show.
  ASSERT_EQ(found.exit_code, 3) << found.output;
  const std::string page = read("page.html");
  for (const char* shown :
       {"--over data.radius_max=10,25 --beside-paper", "rows were measured on other RTL",
        "Table IV: systems", "Figure 9: the best plan at each precision"}) {
    EXPECT_NE(page.find(shown), std::string::npos) << shown;
  }
}

/// Settings that the rates depend on may be in a plan as well as in its scene.
TEST_F(ExploreCommand, RatesOfAnotherPlanAreNotUsedAgain) {
  const auto rates_with = [&](const std::string& side) {
    std::ofstream(path("plan.toml")) << "scene = \"scene.toml\"\n[data]\nside = " << side << "\n";
    const Outcome run = mixcmp(
        "explore plan.toml --table "
        "characterisation/scene-virtex6-lx760.csv --last 12 -o out");
    EXPECT_EQ(run.exit_code, 0) << run.output;
    return read("out/virtex6-lx760/scenarios.csv");
  };
  EXPECT_NE(rates_with("100"), rates_with("50"));
}

TEST_F(ExploreCommand, ExplorePlansForTheSetThatItNames) {
  const Outcome found = mixcmp(
      "explore scene.toml --last 14 --over data.radius_max=10,25 --on virtex6-lx760 "
      "--on virtex6-lx760 -o out --json");
  ASSERT_EQ(found.exit_code, 0) << found.output;
  const auto report = json_of(found.output.substr(found.output.find('[')));
  EXPECT_EQ(report.at("device"), "virtex6-lx760");
  EXPECT_NE(read("out/virtex6-lx760/plan_scenario_1.toml").find("radius_max = 10\n"),
            std::string::npos);
}

/// A missing table is found before minutes of counting, and no new table is left beside old ones.
TEST_F(ExploreCommand, ExploreMissesATableBeforeItCounts) {
  expect_refused("explore scene.toml --on nosuch -o out", "--on: unknown device");
  expect_refused("explore scene.toml --on virtex6-lx760 --on artix7-200t -o out", "no such file");
  EXPECT_FALSE(fs::exists(path("out")));
}

TEST_F(ExploreCommand, ExploreWhereNothingFitsFails) {
  write_table("scene-ice40-up5k.csv", "ice40-up5k");
  const Outcome found = mixcmp("explore scene.toml --on ice40-up5k --last 14 -o out");
  EXPECT_EQ(found.exit_code, 2) << found.output;
}

/// Whatever rates depend on is in the name of the file that keeps them.
TEST_F(ExploreCommand, ExploreCountsAnewWhereTheSceneIsAnother) {
  const auto kept_rates = [&] {
    int count = 0;
    for (const auto& entry : fs::directory_iterator(path("out"))) {
      count += entry.path().filename().string().starts_with("rates-") ? 1 : 0;
    }
    return count;
  };
  const std::string command = "explore scene.toml --first 8 --last 8 -o out ";
  ASSERT_EQ(mixcmp(command).exit_code, 0);
  EXPECT_EQ(kept_rates(), 1);
  ASSERT_EQ(mixcmp(command + "--set 'inputs.r*={ range = [0, 150] }'").exit_code, 0);
  EXPECT_EQ(kept_rates(), 2);
  std::string sum = "(ri + rj)^2";
  for (int k = 0; k < 10; ++k) sum += " + 0 * ri";
  for (const char* rest : {"", " + 1"}) {
    ASSERT_EQ(mixcmp(command + "--set 'comparison.g=" + sum + rest + "'").exit_code, 0);
  }
  EXPECT_EQ(kept_rates(), 4);
}

TEST_F(ExploreCommand, ExploreReplacesNoInput) {
  const std::string table = " --table characterisation/scene-virtex6-lx760.csv";
  ASSERT_EQ(mixcmp("explore scene.toml --first 8 --last 8 -o out").exit_code, 0);
  const std::string plan = read("out/virtex6-lx760/plan_scenario_2.toml");
  expect_refused("explore out/virtex6-lx760/plan_scenario_2.toml -o out" + table,
                 "would be written over");
  EXPECT_EQ(read("out/virtex6-lx760/plan_scenario_2.toml"), plan);
}

TEST_F(ExploreCommand, ExploreCountsWithTheClocksOfItsCommand) {
  const std::string clocks = " --last 14 --lane-mhz 777 --reference-mhz 333";
  for (const char* domains : {"", " --separate-clocks"}) {
    const Outcome explored = mixcmp("explore scene.toml --json -o out" + clocks + domains);
    const Outcome planned =
        mixcmp("optimise scene.toml --table characterisation --json" + clocks + domains);
    ASSERT_EQ(explored.exit_code, 0) << explored.output;
    const auto column =
        json_of(explored.output.substr(explored.output.find('['))).at("columns").at(0);
    const auto plans = json_of(planned).at("plans");
    double best = 0;
    for (const auto& plan : plans) best = std::max(best, plan.at("throughput_per_s").get<double>());
    EXPECT_EQ(column.at("scenario_2").at("throughput_per_s"), best) << domains;
    EXPECT_EQ(column.at("title"), "ours");
  }
}

TEST_F(ExploreCommand, ExploreTellsOfFoldersThatItLeaves) {
  write_table("scene-virtex5-lx330t.csv", "virtex5-lx330t");
  ASSERT_EQ(mixcmp("explore scene.toml --last 14 -o out").exit_code, 0);
  const Outcome other = mixcmp("explore scene.toml --last 14 -o out --on virtex5-lx330t");
  ASSERT_EQ(other.exit_code, 0) << other.output;
  EXPECT_NE(other.output.find("out/virtex6-lx760 is of an earlier run"), std::string::npos)
      << other.output;
}

TEST_F(ExploreCommand, ExploreTellsThatItLeavesVariantsOut) {
  std::ofstream(path("scene.toml"), std::ios::app)
      << "[[variant]]\nname = \"same\"\ng = \"(rj + ri)^2\"\n";
  const Outcome run = mixcmp("explore scene.toml --last 14 -o out");
  ASSERT_EQ(run.exit_code, 0) << run.output;
  EXPECT_NE(run.output.find("note: variants left out"), std::string::npos) << run.output;
}

TEST_F(ExploreCommand, ExploreHasAFolderForEachDevice) {
  fs::copy_file(fs::path(MIXCMP_DEVICES) / "virtex6-lx760.toml", path("same.toml"));
  expect_refused("explore scene.toml --on virtex6-lx760 --on same.toml -o out",
                 "two devices have one name");
  EXPECT_FALSE(fs::exists(path("out")));
}

/// The first data set is not measured before the second is found to be wrong.
TEST_F(ExploreCommand, AMistakeInAnyDataSetIsThatOfOver) {
  const Outcome run = mixcmp("explore scene.toml --over data.radius_max=10,nonsense -o out");
  EXPECT_EQ(run.exit_code, 1) << run.output;
  EXPECT_NE(run.output.find("--over"), std::string::npos) << run.output;
  EXPECT_FALSE(fs::exists(path("out")));
}

TEST_F(ExploreCommand, ExploreGoesOnWhereItWas) {
  const std::string command = "explore scene.toml --last 14 --over data.radius_max=10,25 -o out";
  ASSERT_EQ(mixcmp(command).exit_code, 0);
  const std::string before = read("out/report.md");
  // Rates that are found are used: made up ones show.
  for (const auto& entry : fs::directory_iterator(path("out"))) {
    if (entry.path().filename().string().find("rates-10-") != 0) continue;
    std::ofstream(entry.path())
        << "inputs,precision,scheme,comparisons,undecided,rate,wrong,wrong_by_lane\n"
        << "exact,8,relative,10,4,0.4,0,0\nexact,12,relative,10,4,0.4,0,0\n";
  }
  ASSERT_EQ(mixcmp(command).exit_code, 0);
  EXPECT_NE(read("out/report.md"), before);
}

}  // namespace
}  // namespace mixcmp::test::explore_command_test
