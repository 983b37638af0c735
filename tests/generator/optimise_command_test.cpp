#include <fmt/core.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "tests/generator/planning_fixture.hpp"

/// `mixcmp optimise` as a user calls it, on a made-up table.
namespace mixcmp::test::optimise_command_test {
namespace {

namespace fs = std::filesystem;

class OptimiseCommand : public PlanningTest {};

TEST_F(OptimiseCommand, ItsPlanIsWhatCheckTakes) {
  const Outcome found =
      mixcmp("optimise scene.toml --table characterisation --last 14 -o plan.toml");
  ASSERT_EQ(found.exit_code, 0) << found.output;
  EXPECT_NE(found.output.find("target, not measured"), std::string::npos) << found.output;
  const Outcome checked = mixcmp("check plan.toml --json");
  ASSERT_EQ(checked.exit_code, 0) << checked.output;
  EXPECT_NE(read("plan.toml").find("target_mhz = 250\n"), std::string::npos);
}

/// A lane of memory is cheaper in LUTs, and of 1440 blocks 80 % hold 288 lanes of four.
TEST_F(OptimiseCommand, APlanHasNoMoreMemoriesThanTheDevice) {
  std::ofstream table(path("characterisation/scene-virtex6-lx760.csv"), std::ios::app);
  row(table, "lane,,q11,,fixed_norm,memory,0,0", 8, 300, 0, 4);
  row(table, "fifo,,,,,,0,32", 0, 200, 0);
  table.close();
  const Outcome found = mixcmp(
      "optimise scene.toml --table characterisation --first 11 --last 11 --use-multipliers "
      "memory,embedded "
      "-o plan.toml");
  ASSERT_EQ(found.exit_code, 0) << found.output;
  const std::string plan = read("plan.toml");
  EXPECT_NE(plan.find("multipliers = \"memory\""), std::string::npos) << plan;
  EXPECT_NE(plan.find("288"), std::string::npos) << plan;
  const Outcome checked = mixcmp("check plan.toml --json");
  ASSERT_EQ(checked.exit_code, 0) << checked.output;
  expect_refused("optimise scene.toml --table characterisation --use-multipliers wood", "memory");
}

/// A folded reference of 700 LUTs takes 24 cycles for a comparison: 24 of them are larger than a
/// lane.
TEST_F(OptimiseCommand, ASmallFoldedReferenceIsNoCheapDatapath) {
  std::ofstream table(path("characterisation/scene-virtex6-lx760.csv"), std::ios::app);
  row(table, "reference,,s53e8,,,embedded,24,0", 200, 700, 2);
  table.close();
  const auto plan =
      json_of(mixcmp("optimise scene.toml --table characterisation --json --set "
                     "reference.initiation_interval=auto"));
  ASSERT_TRUE(plan.contains("crossover_precision")) << plan;
  EXPECT_EQ(plan["crossover_precision"], nullptr) << plan;
}

TEST_F(OptimiseCommand, ATableHasNoSmallestSystem) {
  expect_refused("optimise scene.toml --table characterisation --at-least 5", "no table");
  expect_refused("optimise scene.toml --at-least 0", "--at-least");
}

/// 40 DSPs of a reference are 5.8 % of the room, a lane's 30,000 LUTs 7.9 %, 19,000 LUTs 5.0 %.
TEST_F(OptimiseCommand, ReferencesThatAreBetterAloneAreTold) {
  const std::string embedded =
      "optimise scene.toml --table characterisation --last 8 --use-multipliers embedded";
  write_table("scene-virtex6-lx760.csv", "virtex6-lx760", "spheres", 30000);
  const Outcome none = mixcmp(embedded);
  EXPECT_EQ(none.exit_code, 2) << none.output;
  EXPECT_NE(none.output.find("no plan: lanes of these precisions cost more"), std::string::npos)
      << none.output;
  for (const char* written : {" --json", " --json -o plan.toml", " -o plan.toml"}) {
    EXPECT_EQ(mixcmp(embedded + written).exit_code, 2) << written;
    EXPECT_FALSE(fs::exists(path("plan.toml"))) << written;
  }
  write_table("scene-virtex6-lx760.csv", "virtex6-lx760", "spheres", 19000);
  const std::string note = "note: references alone are faster than this plan";
  EXPECT_EQ(mixcmp(embedded).output.find(note), std::string::npos);
  write("rates.csv",
        "inputs,precision,scheme,comparisons,undecided,rate,wrong,wrong_by_lane\n"
        "exact,8,relative,1000,450,0.45,0,0\n");
  const Outcome slow = mixcmp(embedded + " --rates rates.csv");
  EXPECT_NE(slow.output.find(note), std::string::npos) << slow.output;
}

/// Without the streams around a lane a plan would promise lanes that have no room.
TEST_F(OptimiseCommand, TablesWithoutStreamsAreRefused) {
  const std::string name = "characterisation/scene-virtex6-lx760.csv";
  const std::string whole = read(name);
  for (const std::string kind : {"fifo", "crossbar"}) {
    std::istringstream lines(whole);
    std::string kept, line;
    while (std::getline(lines, line)) {
      if (!line.starts_with(kind)) kept += line + "\n";
    }
    write(name, kept);
    expect_refused("optimise scene.toml --table characterisation --first 8 --last 14 -o plan.toml",
                   "a " + kind);
    EXPECT_FALSE(fs::exists(path("plan.toml")));
    write(name, whole);
  }
}

TEST_F(OptimiseCommand, RowsOfFixedPointWithInputsAreRefused) {
  for (const char* wrong : {"lane,,q11,exact,fixed_norm,embedded,0", "lane,,q11,,relative,logic,0",
                            "lane,,s11e8,exact,fixed_norm,logic,0", "reference,,q11,,,logic,0"}) {
    write_table("scene-virtex6-lx760.csv", "virtex6-lx760");
    std::ofstream table(path("characterisation/scene-virtex6-lx760.csv"), std::ios::app);
    row(table, wrong, 7, 380, 4);
    table.close();
    expect_refused("optimise scene.toml --table characterisation --last 14",
                   "scene-virtex6-lx760.csv:13");
  }
}

TEST_F(OptimiseCommand, JsonTellsEveryPrecision) {
  const Outcome found = mixcmp("optimise scene.toml --table characterisation --last 14 --json");
  ASSERT_EQ(found.exit_code, 0) << found.output;
  const auto report = json_of(found);
  ASSERT_EQ(report.at("plans").size(), 2u);
  EXPECT_EQ(report.at("plans")[0].at("precision"), 8);
  EXPECT_GT(report.at("plans")[0].at("lanes"), 10);
  const int best = report.at("best");
  EXPECT_TRUE(best == 8 || best == 12);
}

TEST_F(OptimiseCommand, OldRtlIsTold) {
  const Outcome found = mixcmp("optimise scene.toml --table characterisation --last 14");
  EXPECT_NE(found.output.find("7 of 7 rows"), std::string::npos) << found.output;
}

TEST_F(OptimiseCommand, ReferencesHaveTheInitiationIntervalOfTheScene) {
  expect_refused(
      "optimise scene.toml --table characterisation --set reference.initiation_interval=16 -o "
      "plan.toml",
      "the characterisation has no reference in s53e8");
  EXPECT_FALSE(fs::exists(path("plan.toml")));
}

TEST_F(OptimiseCommand, ThePlanSaysWhatItsReferencesArePlacedFor) {
  const std::string command = "optimise scene.toml --table characterisation --last 14 ";
  std::ofstream table(path("characterisation") / "scene-virtex6-lx760.csv", std::ios::app);
  row(table, "reference,at_400_mhz,s53e8,,,embedded,1,0", 60, 3000, 6);
  table.close();
  const Outcome found = mixcmp(command + "-o plan.toml");
  ASSERT_EQ(found.exit_code, 0) << found.output;
  EXPECT_NE(found.output.find("x s53e8 embedded for 400 MHz"), std::string::npos) << found.output;
  EXPECT_NE(read("plan.toml").find("target_mhz = 400\n"), std::string::npos);
  const auto constraint_in = [this](const std::string& folder) {
    return shell(fmt::format("cat {}/*.sdc", path(folder).string())).output;
  };
  const std::string planned = "# The plan expects 250 MHz (target, not measured).\n";
  ASSERT_EQ(mixcmp("generate plan.toml --no-prove -o rtl").exit_code, 0);
  ASSERT_EQ(mixcmp("generate scene.toml --format s8e8 --lanes 1 --references 1 -o plain "
                   "--no-prove")
                .exit_code,
            0);
  EXPECT_NE(constraint_in("rtl").find(planned), std::string::npos) << constraint_in("rtl");
  EXPECT_EQ(constraint_in("plain").find("The plan"), std::string::npos);
  EXPECT_EQ(mixcmp("check plan.toml").exit_code, 0);
  expect_refused(command + "--set reference.target_mhz=300", "has no reference in s53e8");
}

TEST_F(OptimiseCommand, AnInitiationIntervalThatIsLeftOpenIsNotGenerated) {
  const std::string open = " --set 'reference.initiation_interval=\"auto\"'";
  expect_refused("generate ./scene.toml --format s8e8 --lanes 2 --references 1 -o rtl" + open,
                 "reference.initiation_interval: is not chosen yet");
  EXPECT_FALSE(fs::exists(path("rtl")));
  // The suggested command works as it is.
  const std::string refused = mixcmp("generate ./scene.toml -o rtl" + open).output;
  const std::string suggested = "optimise ./scene.toml" + open;
  EXPECT_NE(refused.find("mixcmp " + suggested + " -o plan.toml"), std::string::npos) << refused;
  EXPECT_EQ(mixcmp(suggested + " --first 12 --last 12 --predict-only -o plan.toml").exit_code, 0);
}

TEST_F(OptimiseCommand, ChoosesTheInitiationIntervalThatTheSceneLeavesOpen) {
  const std::string open =
      "optimise scene.toml --table characterisation --first 12 --last 14 --set "
      "'reference.initiation_interval=\"auto\"'";
  const std::string note =
      "reference.initiation_interval is \"auto\", but the table has references of only "
      "interval 1; "
      "`mixcmp characterise --initiation-intervals";
  EXPECT_NE(mixcmp(open).output.find(note), std::string::npos);
  EXPECT_EQ(mixcmp("optimise scene.toml --table characterisation --last 14").output.find(note),
            std::string::npos);
  std::ofstream table(path("characterisation") / "scene-virtex6-lx760.csv", std::ios::app);
  row(table, "reference,,s53e8,,,embedded,2,0", 60, 3000, 6);
  table.close();
  const Outcome found = mixcmp(open + " -o plan.toml");
  ASSERT_EQ(found.exit_code, 0) << found.output;
  EXPECT_EQ(found.output.find(note), std::string::npos) << found.output;
  EXPECT_NE(found.output.find("x s53e8 embedded ii2"), std::string::npos) << found.output;
  EXPECT_NE(read("plan.toml").find("initiation_interval = 2"), std::string::npos);
  const Outcome checked = mixcmp("check plan.toml");
  EXPECT_EQ(checked.exit_code, 0) << checked.output;
  EXPECT_NE(checked.output.find("initiation interval 2"), std::string::npos) << checked.output;
  const auto throughput = [&](const std::string& command) {
    const auto report = json_of(mixcmp(command + " --json"));
    return report.at("plans")[0].at("throughput_per_s").get<double>();
  };
  EXPECT_GT(throughput(open),
            throughput("optimise scene.toml --table characterisation --first 12 --last 14"));
}

TEST_F(OptimiseCommand, GlpkWouldReadItsProgram) {
  ASSERT_EQ(mixcmp("optimise scene.toml --table characterisation --last 14 --lp best.lp").exit_code,
            0);
  const std::string program = read("best.lp");
  EXPECT_NE(program.find("Maximize"), std::string::npos);
  EXPECT_NE(program.find("lut"), std::string::npos);
}

TEST_F(OptimiseCommand, RatesMayHaveTheLineEndsOfASpreadsheet) {
  write("rates.csv",
        "inputs,precision,scheme,comparisons,undecided,rate,wrong,wrong_by_lane\r\n"
        "exact,8,relative,1000,10,0.01,0,0\r\n");
  const Outcome found =
      mixcmp("optimise scene.toml --table characterisation --last 8 --rates rates.csv --json");
  ASSERT_EQ(found.exit_code, 0) << found.output;
  EXPECT_DOUBLE_EQ(json_of(found).at("plans")[0].at("recomputation_rate"), 0.01);
}

TEST_F(OptimiseCommand, RatesMayComeFromAProfile) {
  std::ofstream(path("rates.csv"))
      << "inputs,precision,scheme,comparisons,undecided,rate,wrong,wrong_by_lane\n"
      << "exact,12,relative,1000000,100,1e-4,0,0\n";
  const Outcome found =
      mixcmp("optimise scene.toml --table characterisation --rates rates.csv --json");
  ASSERT_EQ(found.exit_code, 0) << found.output;
  const auto report = json_of(found);
  EXPECT_EQ(report.at("best"), 12);
  EXPECT_DOUBLE_EQ(report.at("plans")[0].at("recomputation_rate"), 1e-4);
}

TEST_F(OptimiseCommand, RatesOfAnotherReferenceAreRefusedAndOfOtherDataTold) {
  const std::string header =
      "inputs,precision,scheme,comparisons,undecided,rate,wrong,wrong_by_lane\n";
  const std::string rate = "exact,8,relative,77,10,0.13,0,0\n";
  write("other.csv", header + "exact,24,reference,77,0,0,0,0\n" + rate);
  expect_refused("optimise scene.toml --table characterisation --last 8 --rates other.csv",
                 "a reference of 24 digits");
  write("more.csv", header + "exact,53,reference,77,0,0,0,0\n" + rate);
  const Outcome told =
      mixcmp("optimise scene.toml --table characterisation --last 8 --rates more.csv");
  EXPECT_EQ(told.exit_code, 0) << told.output;
  EXPECT_NE(told.output.find("note: more.csv: counted on 77 comparisons; the scene's data have"),
            std::string::npos)
      << told.output;
}

TEST_F(OptimiseCommand, ADeviceTooSmallIsToldWithWhatIsShort) {
  write_table("scene-ice40-up5k.csv", "ice40-up5k");
  const Outcome found = mixcmp(
      "optimise scene.toml --table characterisation --device ice40-up5k --last 14 -o plan.toml");
  EXPECT_EQ(found.exit_code, 2) << found.output;
  EXPECT_NE(found.output.find("lut"), std::string::npos) << found.output;
  EXPECT_FALSE(fs::exists(path("plan.toml")));
}

TEST_F(OptimiseCommand, AnOlderPlanThatStaysIsTold) {
  write_table("scene-ice40-up5k.csv", "ice40-up5k");
  write("plan.toml", "old\n");
  const Outcome found = mixcmp(
      "optimise scene.toml --table characterisation --device ice40-up5k --last 14 -o plan.toml");
  EXPECT_EQ(found.exit_code, 2) << found.output;
  EXPECT_NE(found.output.find("plan.toml: not written"), std::string::npos) << found.output;
  EXPECT_EQ(read("plan.toml"), "old\n");
}

TEST_F(OptimiseCommand, ItsFilesAreOfOneRun) {
  ASSERT_EQ(
      mixcmp("optimise scene.toml --table characterisation --csv f9.csv -o plan.toml").exit_code,
      0);
  const std::string table = read("f9.csv"), plan = read("plan.toml");
  const std::string other =
      "optimise scene.toml --table characterisation --first 12 --csv f9.csv -o plan.toml --lp ";
  EXPECT_EQ(mixcmp(other + "/dev/full").exit_code, 1);
  EXPECT_EQ(read("f9.csv"), table);
  EXPECT_EQ(read("plan.toml"), plan);
  ASSERT_EQ(mixcmp(other + "p.lp").exit_code, 0);
  EXPECT_NE(read("f9.csv"), table);
}

TEST_F(OptimiseCommand, TheBestVariantIsChosenAndThePlanNamesIt) {
  std::ofstream(path("scene.toml"), std::ios::app)
      << "[[variant]]\nname = \"root\"\ng = \"ri + rj\"\n"
      << "f = \"sqrt((cxi - cxj)^2 + (cyi - cyj)^2 + (czi - czj)^2)\"\n";
  const Outcome without = mixcmp("optimise scene.toml --table characterisation --last 8 --json");
  EXPECT_NE(without.output.find("variant root left out"), std::string::npos) << without.output;
  EXPECT_NE(without.output.find("characterise scene.toml --variant root"), std::string::npos);
  write_table("scene-root-virtex6-lx760.csv", "virtex6-lx760", "spheres_root", 500);
  const Outcome found =
      mixcmp("optimise scene.toml --table characterisation --last 8 --json -o plan.toml");
  ASSERT_EQ(found.exit_code, 0) << found.output;
  const auto report = json_of(found);
  EXPECT_EQ(report.at("variant"), "root");
  EXPECT_GT(report.at("formulations")[1].at("throughput_per_s"),
            report.at("formulations")[0].at("throughput_per_s"));
  const Outcome text = mixcmp("optimise scene.toml --table characterisation --last 8");
  EXPECT_NE(text.output.find("* variant root"), std::string::npos) << text.output;
  const Outcome checked = mixcmp("check plan.toml --json");
  ASSERT_EQ(checked.exit_code, 0) << checked.output;
  EXPECT_EQ(nlohmann::json::parse(checked.output).at("name"), "spheres_root");
  EXPECT_EQ(json_of(mixcmp("optimise scene.toml --table characterisation --last 8 --json --set "
                           "comparison.variant=root"))
                .at("best"),
            8);
}

TEST_F(OptimiseCommand, AVariantThatCannotBePlannedIsLeftOutUnlessItIsAsked) {
  std::ofstream(path("scene.toml"), std::ios::app)
      << "[[variant]]\nname = \"root\"\ng = \"ri + rj\"\n"
      << "f = \"sqrt((cxi - cxj)^2 + (cyi - cyj)^2 + (czi - czj)^2)\"\n";
  expect_refused("optimise scene.toml --table characterisation --variant root",
                 "characterise scene.toml --variant root");
  // A table without a lane of the precisions asked for.
  write_table("scene-root-virtex6-lx760.csv", "virtex6-lx760", "spheres_root");
  expect_refused("optimise scene.toml --table characterisation --variant root --first 20 --last 30",
                 "no lane");
  // Only the variant has a table.
  fs::remove(path("characterisation") / "scene-virtex6-lx760.csv");
  const Outcome found = mixcmp("optimise scene.toml --table characterisation --last 8");
  EXPECT_EQ(found.exit_code, 0) << found.output;
  EXPECT_NE(found.output.find("[comparison] left out"), std::string::npos) << found.output;
  EXPECT_NE(found.output.find("spheres_root on"), std::string::npos) << found.output;
}

TEST_F(OptimiseCommand, MistakesAreTold) {
  expect_refused("optimise scene.toml --table characterisation --device artix7-200t",
                 "mixcmp characterise scene.toml");
  expect_refused("optimise scene.toml --table characterisation/none.csv", "no such file");
  expect_refused("optimise scene.toml --table " + std::string(300, 'n'), "no such file");
  expect_refused("optimise scene.toml --table characterisation --use-inputs wrong", "--use-inputs");
  expect_refused("optimise scene.toml --table characterisation --use-bounds running_4", "no lane");
  for (const char* clock : {"0", "-5", "nan", "inf"}) {
    expect_refused(fmt::format("optimise scene.toml --table characterisation --lane-mhz {}", clock),
                   "--lane-mhz");
  }
  write_table("scene-artix7-200t.csv", "virtex6-lx760");
  expect_refused("optimise scene.toml --table characterisation --device artix7-200t",
                 "of another device");
  expect_refused("explore scene.toml --over radius", "names no data sets");
  expect_refused("explore scene.toml --over system.slack=0.1,0.3", "names no data sets");
  expect_refused(
      "explore scene.toml --over data.radius_max=10,25 --set 'inputs.r*={ range = \"data\" }'",
      "accepted [low, high], a range that all data sets keep");
  for (const char* out :
       {"-o scene.toml", "--csv characterisation/scene-virtex6-lx760.csv", "-o x --lp x"}) {
    expect_refused(fmt::format("optimise scene.toml --table characterisation --last 14 {}", out),
                   "would be written over");
  }
  fs::create_directory(path("plan.toml"));
  for (const char* out : {"plan.toml", "/dev/full", "nowhere/plan.toml"}) {
    expect_refused(fmt::format("optimise scene.toml --table characterisation --last 14 -o {}", out),
                   fmt::format("mixcmp: {}: cannot be written: ", out));
  }
  EXPECT_TRUE(fs::is_empty(path("plan.toml")));
  expect_refused("optimise scene.toml --table characterisation --first 3", "--first");
  expect_refused("optimise scene.toml --table characterisation --lanes 4", "--lanes");
}

TEST_F(OptimiseCommand, ThePlanKeepsTheCommandsSettings) {
  const Outcome found = mixcmp(
      "optimise scene.toml --table characterisation --last 14 --set system.order=in_order --set "
      "data.count=200 "
      "--set reduced.rounding=toward_zero --use-multipliers embedded -o plan.toml");
  ASSERT_EQ(found.exit_code, 0) << found.output;
  const Outcome checked = mixcmp("check plan.toml --json");
  ASSERT_EQ(checked.exit_code, 0) << checked.output;
  const auto summary = json_of(checked);
  EXPECT_EQ(summary.at("system").at("order"), "in_order");
  EXPECT_EQ(summary.at("lane_groups")[0].at("rounding"), "toward_zero");
  EXPECT_EQ(summary.at("data").at("rows"), 200);
  EXPECT_NE(read("plan.toml").find("--last 14 --use-multipliers embedded\n"), std::string::npos);
}

TEST_F(OptimiseCommand, APlanForADeviceFileNamesTheFile) {
  std::ofstream(path("mine.toml"))
      << "[device]\nname = \"mine\"\nluts = 90000\nregisters = 90000\ndsps = 200\nmemories = 10\n"
      << "multiplier_a_bits = 24\nmultiplier_b_bits = 17\n[synthesis]\ncommand = \"synth_xilinx\"\n"
      << "[timing]\ntool = \"none\"\n[delays]\nlut_ns = 1\ncarry_start_ns = 1\n"
      << "carry_ns_per_bit = 0.1\nmultiplier_ns = 3\nmultiplier_add_ns = 1\nregister_ns = 1\n";
  write_table("scene-mine.csv", "mine");
  const Outcome found = mixcmp(
      "optimise scene.toml --table characterisation --device mine.toml --last 14 -o plan.toml");
  ASSERT_EQ(found.exit_code, 0) << found.output;
  const Outcome checked = mixcmp("check plan.toml");
  EXPECT_EQ(checked.exit_code, 0) << checked.output;
}

TEST_F(OptimiseCommand, ATableOfAnotherSceneIsRefused) {
  std::string table = read("characterisation/scene-virtex6-lx760.csv");
  table.replace(table.find("spheres"), 7, "circles");
  std::ofstream(path("other.csv")) << table;
  expect_refused("optimise scene.toml --table other.csv", "of another scene");
}

TEST_F(OptimiseCommand, RatesOfProfiledLanesAreThoseOfTheScenesConstants) {
  std::ofstream table(path("characterisation") / "scene-virtex6-lx760.csv", std::ios::app);
  row(table, "lane,,s8e8,exact,profiled,embedded,0,0", 20, 1500, 4);
  table.close();
  const auto rate_with = [&](const char* constant) {
    const Outcome run = mixcmp(fmt::format(
        "optimise scene.toml --table characterisation --first 8 --last 8 --json --bound profiled "
        "--set reduced.relative_error_f={0} --set reduced.relative_error_g={0}",
        constant));
    EXPECT_EQ(run.exit_code, 0) << run.output;
    return json_of(run).at("plans")[0].at("recomputation_rate").get<double>();
  };
  EXPECT_GT(rate_with("0.02"), 2 * rate_with("0.001"));
}

/// The table's rows are of other RTL, and measurements that only another machine's store has would
/// be lost.
TEST_F(OptimiseCommand, CharacteriseDoesNotDropATableOfAnotherTarget) {
  const std::string before = read("characterisation/scene-virtex6-lx760.csv");
  expect_refused(
      "characterise scene.toml --precisions 8 --components crossbar --ports 1 --area-only",
      "--target-mhz 250");
  EXPECT_EQ(read("characterisation/scene-virtex6-lx760.csv"), before);
}

TEST_F(OptimiseCommand, ALinksTargetIsWritten) {
  write("real.csv", "old");
  fs::create_symlink("real.csv", path("link.csv"));
  ASSERT_EQ(
      mixcmp("optimise scene.toml --table characterisation --last 14 --csv link.csv").exit_code, 0);
  EXPECT_TRUE(fs::is_symlink(path("link.csv")));
  EXPECT_NE(read("real.csv").find("precision,"), std::string::npos);
}

/// The plan has whole lists and tables of the command's settings, and keys in quotes.
TEST_F(OptimiseCommand, APlanHasTheSettingsOfItsCommand) {
  const std::string ranges = "--set 'inputs.r*={ range = [0, 200] }'";
  const Outcome found =
      mixcmp("optimise scene.toml --table characterisation --last 14 -o plan.toml " + ranges);
  ASSERT_EQ(found.exit_code, 0) << found.output;
  EXPECT_NE(read("plan.toml").find("\n[inputs]\n\"r*\" = { range = [0, 200] }\n"),
            std::string::npos)
      << read("plan.toml");
  EXPECT_EQ(mixcmp("check plan.toml").exit_code, 0);
  expect_refused("optimise scene.toml --table characterisation --last 14 --use-bounds bogus",
                 "--use-bounds: not a bound");
  write("second.toml", "scene = \"plan.toml\"\n");
  const std::string table = " --table characterisation/scene-virtex6-lx760.csv";
  expect_refused("optimise second.toml --last 14 -o plan.toml" + table, "would be written over");
}

TEST_F(OptimiseCommand, AClockThatIsGivenIsNoEstimate) {
  const Outcome found =
      mixcmp("optimise scene.toml --table characterisation --last 14 --lane-mhz 50 -o plan.toml");
  ASSERT_EQ(found.exit_code, 0) << found.output;
  const std::string basis = "given for lanes; for references: target, not measured";
  EXPECT_NE(found.output.find(basis), std::string::npos) << found.output;
  EXPECT_NE(read("plan.toml").find("clock_basis = \"" + basis), std::string::npos);
  EXPECT_EQ(mixcmp("check plan.toml").exit_code, 0);
}

TEST_F(OptimiseCommand, APlanNamesNoPathThatItCannotHold) {
  const fs::path folder = path("caf\xe9");
  fs::create_directory(folder);
  fs::copy_file(path("scene.toml"), folder / "scene.toml");
  const Outcome run =
      shell(fmt::format("cd '{}' && '{}' optimise scene.toml --last 14 -o ../plan.toml --table "
                        "../characterisation/scene-virtex6-lx760.csv",
                        folder.string(), MIXCMP_PROGRAM));
  EXPECT_EQ(run.exit_code, 1) << run.output;
  EXPECT_NE(run.output.find("not one line of UTF-8"), std::string::npos) << run.output;
  EXPECT_FALSE(fs::exists(path("plan.toml")));
}

TEST_F(OptimiseCommand, APlanNamesItsSceneFromWhereALinkLeads) {
  fs::create_directories(path("far/away"));
  fs::create_directory_symlink("far/away", path("link"));
  ASSERT_EQ(
      mixcmp("optimise scene.toml --table characterisation --last 14 -o link/plan.toml").exit_code,
      0);
  EXPECT_NE(read("far/away/plan.toml").find("scene = \"../../scene.toml\"\n"), std::string::npos);
  EXPECT_EQ(mixcmp("check far/away/plan.toml").exit_code, 0);
}

/// "link/.." is not the folder that holds the link.
TEST_F(OptimiseCommand, APlanReadThroughALinkTakesTheSameScene) {
  fs::create_directories(path("far/away"));
  fs::create_directories(path("near/by"));
  fs::create_directory_symlink("../../far/away", path("near/by/link"));
  write("near/scene.toml", "a decoy");
  ASSERT_EQ(
      mixcmp("optimise scene.toml --table characterisation --last 14 -o near/by/link/plan.toml")
          .exit_code,
      0);
  const Outcome run = mixcmp("check near/by/link/plan.toml");
  EXPECT_EQ(run.exit_code, 0) << run.output;
}

TEST_F(OptimiseCommand, ALinkedPlanIsReadAsItWasWritten) {
  fs::create_directories(path("far/away"));
  fs::create_symlink("far/away/plan.toml", path("plan.toml"));
  for (int run = 0; run < 2; ++run) {
    ASSERT_EQ(
        mixcmp("optimise scene.toml --table characterisation --last 14 -o plan.toml").exit_code, 0);
    EXPECT_EQ(mixcmp("check plan.toml").exit_code, 0) << "run " << run;
    EXPECT_EQ(mixcmp("check far/away/plan.toml").exit_code, 0) << "run " << run;
  }
}

/// A scene that is a link has its data beside the link, and so has its plan.
TEST_F(OptimiseCommand, ThePlanOfALinkedSceneNamesTheLink) {
  fs::create_directories(path("other"));
  fs::create_symlink("../scene.toml", path("other/scene.toml"));
  const std::string table = " --table characterisation/scene-virtex6-lx760.csv";
  ASSERT_EQ(mixcmp("optimise other/scene.toml --last 14 -o plan.toml" + table).exit_code, 0);
  EXPECT_NE(read("plan.toml").find("scene = \"other/scene.toml\"\n"), std::string::npos);
}

}  // namespace
}  // namespace mixcmp::test::optimise_command_test
