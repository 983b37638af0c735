#include <fmt/core.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/generator/planning_fixture.hpp"
#include "tests/support/fake_yosys.hpp"

/// `mixcmp optimise` on two tiers, and with areas that synthesis confirms.
namespace mixcmp::test::optimise_confirmed_command_test {
namespace {

namespace fs = std::filesystem;

/// A pairwise engine whose lanes of seven bits have a second tier of fifteen.
class TwoTiers : public PlanningTest {
protected:
  TwoTiers() {
    std::ofstream(path("scene.toml"), std::ios::app)
        << "[engine]\nkind = \"pairwise\"\ncapacity = 512\nlanes_per_group = 12\n"
        << "[second_tier]\nformat = \"q15\"\nmultipliers = \"logic\"\n";
    write_engine_table("scene-virtex6-lx760.csv", "q7", 3000);
  }

  void write_engine_table(const std::string& name, const std::string& lane, int luts) {
    write_table(name, "virtex6-lx760");
    std::ofstream table(path("characterisation") / name, std::ios::app);
    const std::string fixed = ",," + lane + ",,fixed_norm,logic,0,";
    row(table, "segment" + fixed + "12", 9, luts, 0);
    row(table, "conversion" + fixed + "0", 2, 300, 0);
    row(table, "engine" + fixed + "4", 0, 500, 0);
    row(table, "engine" + fixed + "16", 0, 700, 0);
    row(table, "reference_port,,s53e8,,,embedded,1,0", 0, 100, 0);
  }

  /// The format and the second tier's of the best plan.
  std::pair<int, nlohmann::json> best(const std::string& options = " --table characterisation") {
    const Outcome found = mixcmp("optimise scene.toml --json -o plan.toml" + options);
    EXPECT_EQ(found.exit_code, 0) << found.output;
    const nlohmann::json report = json_of(found);
    return {report.at("best"), report.value("second_tier", nlohmann::json("not said"))};
  }
};

/// Pairs are only counted here: one stream of reports would limit both systems alike.
TEST_F(TwoTiers, TheyAreTakenWhereTheyPay) {
  const std::string one_tier = "scene-one-tier-virtex6-lx760.csv";
  const std::string counting = " --table characterisation --set engine.report_as=count";
  const Outcome without = mixcmp("optimise scene.toml" + counting);
  EXPECT_NE(without.output.find("[comparison], one tier left out"), std::string::npos)
      << without.output;
  EXPECT_NE(without.output.find("characterise scene.toml --set second_tier.format=none"),
            std::string::npos);
  write_engine_table(one_tier, "q15", 6000);
  EXPECT_EQ(best(counting), std::pair(7, nlohmann::json("q15")));
  EXPECT_NE(mixcmp("check plan.toml").output.find("second tier        q15"), std::string::npos);
  write_engine_table(one_tier, "q15", 1500);
  EXPECT_EQ(best(counting), std::pair(15, nlohmann::json(nullptr)));
  EXPECT_NE(read("plan.toml").find("[second_tier]\nformat = \"none\"\n"), std::string::npos);
  EXPECT_EQ(mixcmp("check plan.toml").output.find("second tier"), std::string::npos);
  const Outcome text = mixcmp("optimise scene.toml" + counting);
  EXPECT_NE(text.output.find("* [comparison], one tier"), std::string::npos) << text.output;
}

TEST_F(TwoTiers, ATierThatTheUserNamesIsKept) {
  write_engine_table("scene-one-tier-virtex6-lx760.csv", "q15", 1500);
  EXPECT_EQ(best(" --table characterisation --set second_tier.format=q15").first, 7);
  EXPECT_EQ(best(" --table characterisation --set second_tier.format=none").first, 15);
  EXPECT_EQ(best(" --table characterisation/scene-virtex6-lx760.csv").first, 7);
}

/// The areas of another engine's segments and merge would be added to parts of the scene's engine.
TEST_F(TwoTiers, ATableOfAnotherEngineIsRefused) {
  const std::string name = "characterisation/scene-virtex6-lx760.csv";
  const std::string engine =
      "pairwise, 512 items, segments of 12, less equal unordered as pairs by 1 stream, second tier "
      "q15 logic";
  write(name, "# engine: " + engine + "\n" + read(name));
  const Outcome fits = mixcmp("optimise scene.toml --table characterisation");
  EXPECT_EQ(fits.exit_code, 0) << fits.output;
  for (const std::string other :
       {"engine.capacity=256", "engine.lanes_per_group=8", "engine.report_as=count",
        "engine.report_streams=2", "second_tier.format=q13", "second_tier.multipliers=embedded"}) {
    expect_refused("optimise scene.toml --table characterisation --set " + other,
                   "the table is of another engine: received " + engine);
  }
  const std::string before = read(name);
  expect_refused("characterise scene.toml --bounds fixed_norm --set engine.capacity=256",
                 "its rows are of another engine: received " + engine);
  EXPECT_EQ(read(name), before);
}

TEST_F(TwoTiers, GenerateTellsOfBoth) {
  const Outcome run = mixcmp(
      "generate scene.toml -o rtl --set system.lanes=12 --set system.references=1 "
      "--set reduced.format=q7 --set reduced.multipliers=logic");
  ASSERT_EQ(run.exit_code, 0) << run.output;
  EXPECT_NE(run.output.find("\n  second tier behind each group: a lane in q15 ("),
            std::string::npos)
      << run.output;
  EXPECT_NE(run.output.find("\nerror bound of q7: "), std::string::npos);
  EXPECT_NE(run.output.find("\nerror bound of second_tier_q15: "), std::string::npos);
}

/// A Yosys that finds a reference nine times as large as anything else.
class Confirmed : public PlanningTest {
protected:
  Confirmed() { fs::remove(path("characterisation/scene-virtex6-lx760.csv")); }

  std::string environment() const {
    const std::string store = "XDG_CACHE_HOME=\"$PWD/cache\" ";
    return store + instead_of("yosys", fake_yosys("$luts",
                                                  "luts=1000; ls | grep -q reference && "
                                                  "luts=9000\n"));
  }
  /// Lanes of one kind in one architecture: operands are carried in block memories.
  const std::string few =
      "optimise scene.toml --device artix7-200t --first 10 --last 10 --use-bounds constant "
      "--use-inputs exact --use-multipliers embedded --set system.operands=carried "
      "--set system.operand_memory=block --set system.request_beats=1 "
      "--set system.lanes_per_group=2 --set system.counters=none --set engine.kind=none "
      "--set reference.initiation_interval=1 -o plan.toml";
};

TEST_F(Confirmed, ThePlanIsMadeAgainWithTheAreasOfItsComponents) {
  const Outcome found = mixcmp(few, environment());
  ASSERT_EQ(found.exit_code, 0) << found.output;
  EXPECT_NE(found.output.find("note: predicted "), std::string::npos) << found.output;
  EXPECT_NE(found.output.find("areas: measured; predicted "), std::string::npos) << found.output;
  EXPECT_NE(read("plan.toml").find("\nareas = \"measured\"\n"), std::string::npos);
  EXPECT_EQ(mixcmp("check plan.toml").exit_code, 0);
  const Outcome again = mixcmp(few + " --json", environment());
  EXPECT_EQ(again.output.find("jobs, "), std::string::npos) << "the store has the results\n"
                                                            << again.output;
  EXPECT_EQ(json_of(again).at("areas"), "measured");
}

TEST_F(Confirmed, WithoutSynthesisAreasArePredicted) {
  for (const char* option : {" --predict-only", " --no-characterise"}) {
    const Outcome found = mixcmp(few + option, instead_of("yosys", "exit 1"));
    ASSERT_EQ(found.exit_code, 0) << found.output;
    EXPECT_NE(found.output.find("areas: predicted; predicted "), std::string::npos) << found.output;
  }
  EXPECT_NE(read("plan.toml").find("--predict-only\n"), std::string::npos) << read("plan.toml");
}

/// Rows of `characterise` replace predicted ones, but not once the RTL is another.
TEST_F(Confirmed, KeptRowsOfTodaysRtlTakeThePlaceOfPredictedOnes) {
  const std::string settings =
      " --device artix7-200t --set system.operand_memory=block --set system.request_beats=1 "
      "--set system.lanes_per_group=2 --set system.counters=none";
  const Outcome measured = mixcmp(
      "characterise scene.toml --precisions 10 --bounds constant --area-only --ports 1" + settings,
      environment());
  ASSERT_EQ(measured.exit_code, 0) << measured.output;
  const auto rows_used = [&](const std::string& more) {
    const std::string text = mixcmp(few + " --predict-only" + more).output;
    const std::string note = "note: scene-artix7-200t.csv: ";
    EXPECT_NE(text.find(note), std::string::npos) << text;
    return std::stoi(text.substr(text.find(note) + note.size()));
  };
  const int used = rows_used("");
  EXPECT_GE(used, 4) << "lane, reference, scoreboard, crossbar";
  EXPECT_LT(rows_used(" --set reduced.rounding=toward_zero"), used);
  EXPECT_LT(rows_used(" --set system.tag_bits=40"), used);
}

TEST_F(Confirmed, ComponentsThatCannotBeSynthesisedMakeNoPlan) {
  const std::string yosys =
      instead_of("yosys", "case \"$*\" in *-V*) echo 'Yosys 9.9 (fake)'; exit 0;; esac; exit 1");
  const Outcome failed = mixcmp(few, "XDG_CACHE_HOME=\"$PWD/cache\" " + yosys);
  EXPECT_EQ(failed.exit_code, 1) << failed.output;
  EXPECT_NE(failed.output.find("kept in "), std::string::npos) << failed.output;
  EXPECT_FALSE(fs::exists(path("plan.toml")));
  ASSERT_EQ(mixcmp(few + " --predict-only").exit_code, 0);
  const auto report = [&] {
    return mixcmp("report plan.toml --without profile front waves -o page.html",
                  "XDG_CACHE_HOME=\"$PWD/cache\" " + yosys);
  };
  const Outcome predicted = report();
  EXPECT_EQ(predicted.exit_code, 0) << "nothing is synthesised for a predicted plan\n"
                                    << predicted.output;
  EXPECT_NE(read("page.html").find("Note: areas are predicted;"), std::string::npos);
  std::string plan = read("plan.toml");
  const std::string areas = "areas = \"predicted\"\n";
  ASSERT_NE(plan.find(areas), std::string::npos) << plan;
  write("plan.toml", plan.replace(plan.find(areas), areas.size(), "areas = \"measured\"\n"));
  const Outcome page = report();
  EXPECT_NE(page.output.find("plan: "), std::string::npos) << page.output;
  EXPECT_TRUE(fs::exists(path("page.html"))) << "the page says what is missing";
}

}  // namespace
}  // namespace mixcmp::test::optimise_confirmed_command_test
