#include <fmt/core.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/support/fake_yosys.hpp"
#include "tests/support/program.hpp"

/// The program as a user calls it: its refusals, its messages, and the files that it leaves behind.
namespace mixcmp::test::command_line_test {
namespace {

namespace fs = std::filesystem;

class CommandLine : public ProgramTest {
protected:
  CommandLine() {
    write("data.csv", "a,b,c\n1,2,3\n4,5,6\n");
    write_scene("scene.toml", "a * b");
  }

  void write_scene(const std::string& name, const std::string& g) {
    std::ofstream(path(name))
        << "[comparison]\nname = \"scene\"\nf = \"a * c\"\ng = \"" << g << "\"\n"
        << "[reference]\nformat = \"binary32\"\n[reduced]\nformat = \"s8e8\"\n"
        << "[system]\nlanes = 1\nreferences = 1\n[data]\nfile = \"data.csv\"\n";
  }
};

TEST_F(CommandLine, NamesAWordThatIsNoVerb) {
  expect_refused("chek scene.toml",
                 "mixcmp: unknown verb: received chek; accepted check (the nearest), ");
  expect_refused("", "check, generate, verify, profile, ");
}

TEST_F(CommandLine, NamesAnOptionThatTheVerbDoesNotHave) {
  expect_refused(
      "check --formt s9 scene.toml --lnes 3",
      "mixcmp: check: unknown option: received --formt; accepted --format (the nearest)");
  expect_refused("--josn", "mixcmp: unknown option: received --josn; accepted ");
  expect_refused("check scene.toml other.toml",
                 "mixcmp: check: an argument too many: received other.toml");
}

TEST_F(CommandLine, AMistakeNamesTheLineOrTheOption) {
  std::ofstream(path("device.toml"))
      << "scene = \"scene.toml\"\n\n[system]\ndevice = \"virtex7\"\n";
  expect_refused("check device.toml", "device.toml:4: system.device: unknown device");
  expect_refused("generate scene.toml --set system.lanes=auto", "mixcmp: --set: system.lanes: ");
  expect_refused("generate scene.toml --lanes auto", "mixcmp: --lanes: system.lanes: is not");
  expect_refused("check scene.toml --variant root", "mixcmp: --variant: comparison.variant: ");
  expect_refused("generate scene.toml --format s8e8 --set reduced.bound=certain",
                 "mixcmp: --set: reduced.bound: ");
  std::ofstream(path("undecided.toml"))
      << "scene = \"scene.toml\"\n[reduced]\n\nformat = \"auto\"\n";
  expect_refused("generate undecided.toml", "undecided.toml:4: reduced.format: is not chosen yet");
}

TEST_F(CommandLine, AKeyHasOneValue) {
  expect_refused("check scene.toml --set system.lanes=3 --lanes 2",
                 "mixcmp: --lanes: system.lanes: given twice: received \"system.lanes=3\" and "
                 "\"system.lanes=2\"");
  expect_refused("check scene.toml --set system.lanes=3 --set system.lanes=4", "given twice");
  EXPECT_EQ(mixcmp("check scene.toml --set system.lanes=3 --lanes 3").exit_code, 0);
}

TEST_F(CommandLine, NumbersThatTheFormatDoesNotKeepAreNoted) {
  const std::string note = "of the data's numbers are not kept";
  EXPECT_EQ(mixcmp("check scene.toml").output.find(note), std::string::npos);
  write("data.csv", "a,b,c\n16777216,1e-60,3\n4,-16777217,6\n");
  const auto checked = mixcmp("check scene.toml");
  EXPECT_EQ(checked.exit_code, 0);
  EXPECT_NE(checked.output.find("2 " + note), std::string::npos) << checked.output;
  EXPECT_NE(checked.output.find("The first is 1e-60 in data.csv, line 2, b"), std::string::npos)
      << checked.output;
  EXPECT_NE(checked.output.find("not kept           2 numbers"), std::string::npos)
      << checked.output;
}

TEST_F(CommandLine, AnOptionThatBreaksAnotherKeyIsNamed) {
  expect_refused("check scene.toml --set reference.format=s60e8 --format s53e8",
                 "mixcmp: --format: reduced.format: precision out of range");
  expect_refused("check scene.toml --lanes 2 --set data.pairs=all",
                 "mixcmp: --set: data.pairs: with pairs, inputs are columns of item i or item j");
  write_scene("pairs.toml", "ai");
  std::ofstream(path("pairs.toml"), std::ios::app) << "pairs = \"all\"\n";
  expect_refused("check pairs.toml --lanes 2 --set comparison.f=aj --set comparison.g=b",
                 "mixcmp: --set comparison.g: data.pairs: with pairs, inputs are columns of item i "
                 "or item j (at pairs.toml:14): received b");
  write_scene("variant.toml",
              "a * b\"\n[[variant]]\nname = \"few\"\nf = [\"a\", \"b * c\"]\n"
              "g = [\"b\", \"a * c\"]\ncombine = \"all");
  expect_refused("generate variant.toml --variant few --set engine.kind=pairwise",
                 "mixcmp: --set: engine.kind");
}

TEST_F(CommandLine, CheckTellsTheColumnOfEveryInput) {
  EXPECT_NE(mixcmp("check scene.toml")
                .output.find("\ncolumns of the data\n"
                             "  a                  <- column 0 \"a\" of "
                             "data.csv\n"),
            std::string::npos);
  const Outcome run = mixcmp("check scene.toml --json --set data.columns.b=2");
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const auto inputs = nlohmann::json::parse(run.output).at("data").at("inputs");
  ASSERT_EQ(inputs.size(), 3U);
  EXPECT_EQ(inputs[2].at("input"), "b");
  EXPECT_EQ(inputs[2].at("column"), 2);
  EXPECT_EQ(inputs[2].at("name"), "c");
  EXPECT_EQ(inputs[2].at("source"), "data.csv");
}

TEST_F(CommandLine, CheckTellsWhatGenerateWillDo) {
  const Outcome run = mixcmp("check scene.toml --json");
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const auto report = nlohmann::json::parse(run.output).at("generate");
  EXPECT_EQ(report.at("top"), "scene_s8e8_1x1");
  EXPECT_EQ(report.at("request_beats"), 1);
  EXPECT_EQ(mixcmp("generate scene.toml -o rtl").exit_code, 0);
  EXPECT_TRUE(fs::exists(path("rtl") / "scene_s8e8_1x1.v"));
}

TEST_F(CommandLine, GenerateSaysWhatWasSimulatedOfTheDesign) {
  const std::string own_cache = fmt::format("XDG_CACHE_HOME='{}'", path("cache").string());
  const auto generate = [&](const std::string& options) {
    const Outcome run = mixcmp("generate scene.toml --no-prove -o rtl" + options, own_cache);
    EXPECT_EQ(run.exit_code, 0) << run.output;
    return run.output;
  };
  const auto verify = [&](const std::string& options) {
    return mixcmp("verify scene.toml --simulator icarus --no-counterexample" + options, own_cache);
  };
  const auto in_signature = [&] {
    return nlohmann::json::parse(read("rtl/scene_s8e8_1x1.json")).at("simulations");
  };
  EXPECT_NE(generate(" --set system.counters=none")
                .find("\nnot simulated yet: mixcmp verify scene.toml --set system.counters=none\n"),
            std::string::npos);
  EXPECT_EQ(in_signature(), nlohmann::json::array());

  const std::string passed = "\nsimulated: Icarus Verilog, 2 comparisons, 0 recomputed, passed\n";
  EXPECT_EQ(verify("").exit_code, 0);
  EXPECT_NE(generate("").find(passed), std::string::npos) << generate("");
  EXPECT_EQ(in_signature().at(0).at("comparisons"), 2);
  EXPECT_EQ(verify(" --first 1").exit_code, 0);
  EXPECT_NE(generate("").find(passed), std::string::npos) << "more comparisons are on record";
  EXPECT_NE(generate(" --format s9e8").find("\nnot simulated yet: "), std::string::npos);

  // A simulator that answers nothing.
  EXPECT_EQ(mixcmp("verify scene.toml --simulator icarus --no-counterexample --first 1",
                   own_cache + " " + instead_of("vvp", "exit 1"))
                .exit_code,
            1);
  EXPECT_NE(generate("").find(passed), std::string::npos) << "nothing was simulated";
}

TEST_F(CommandLine, CheckTellsHowOperandsTravel) {
  const std::string system =
      "  operands           carried\n"
      "  operand_memory     block\n"
      "  request_beats      2\n"
      "  input_registers    1\n";
  const std::string carried =
      "check scene.toml --set system.operand_memory=block --set system.request_beats=2 "
      "--set reference.initiation_interval=4 --set system.input_registers=1";
  const Outcome run = mixcmp(carried);
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_NE(run.output.find(system), std::string::npos) << run.output;
  EXPECT_NE(run.output.find("what generate writes\n"), std::string::npos) << run.output;
  EXPECT_NE(run.output.rfind("  request_beats      2\n"), run.output.find("  request_beats"))
      << "once as asked for, once as built";
  const Outcome refetched = mixcmp("check scene.toml --set system.operands=refetched");
  EXPECT_EQ(refetched.output.find("request_beats"), std::string::npos) << refetched.output;
  EXPECT_EQ(refetched.output.find("operand_memory"), std::string::npos) << refetched.output;
}

TEST_F(CommandLine, CheckTellsTheErrorsOfFunctions) {
  write("functions.toml",
        "[comparison]\nname = \"functions\"\nf = \"a * exp(b)\"\ng = \"1\"\n"
        "[inputs]\na = { range = [0, 1], format = \"binary32\" }\n"
        "b = { range = [-1, 1], format = \"binary32\" }\n"
        "[reference]\nformat = \"q24\"\n[reduced]\nformat = \"q12\"\n"
        "[system]\nlanes = 1\nreferences = 1\n");
  const Outcome json = mixcmp("check functions.toml --json");
  EXPECT_EQ(json.exit_code, 0) << json.output;
  const auto report = nlohmann::json::parse(json.output).at("generate");
  double greatest = 1;
  for (const char* const groups : {"lane_groups", "reference_groups"}) {
    const auto& functions = report.at(groups).at(0).at("functions");
    ASSERT_EQ(functions.size(), 1U) << functions;
    EXPECT_EQ(functions[0].at("function"), "exp(b)");
    const double low = functions[0].at("error")[0], high = functions[0].at("error")[1];
    EXPECT_LT(low, functions[0].at("own_error")[0].get<double>());
    EXPECT_GE(high, functions[0].at("own_error")[1].get<double>());
    EXPECT_LT(high - low, greatest / 50);
    EXPECT_GE(functions[0].at("pieces"), 2);
    EXPECT_LE(functions[0].at("degree"), 4);
    greatest = high - low;
  }
  const Outcome text = mixcmp("check functions.toml");
  EXPECT_NE(text.output.find("  exp(b) errs by -"), std::string::npos) << text.output;
}

/// A reference reads numbers of a range that includes 0 in fixed point, and log(a) errs widely
/// there.
TEST_F(CommandLine, CheckNotesReferencesThatErrMoreThanLanes) {
  const auto notes = [&](const char* range) {
    write("logarithm.toml",
          "[comparison]\nname = \"l\"\nf = \"log(a)\"\ng = \"b\"\n[inputs]\na = { range = [" +
              std::string(range) +
              ", 1], format = \"binary32\" }\nb = { range = [-64, 0], format = \"binary32\" }\n"
              "[reference]\nformat = \"q36\"\n[reduced]\nformat = \"q13\"\n"
              "[system]\nlanes = 1\nreferences = 1\n");
    const Outcome json = mixcmp("check logarithm.toml --json");
    EXPECT_EQ(json.exit_code, 0) << json.output;
    return nlohmann::json::parse(json.output).at("generate").at("notes");
  };
  EXPECT_EQ(notes("1e-20").size(), 0U);
  const auto rough = notes("0");
  ASSERT_EQ(rough.size(), 1U) << rough;
  EXPECT_EQ(rough[0].get<std::string>().find("references in q36 err more than lanes in q13 do"),
            0U);
}

TEST_F(CommandLine, CheckHoldsVariantsAgainstTheComparison) {
  write_scene("alike.toml",
              "a * b\"\n[[variant]]\nname = \"turned\"\nf = \"-a * b\"\ng = \"-a * c");
  const Outcome alike = mixcmp("check alike.toml");
  EXPECT_EQ(alike.exit_code, 0) << alike.output;
  EXPECT_NE(alike.output.find("2 comparisons: decides all of them alike"), std::string::npos);
  write_scene("wrong.toml", "a * b\"\n[[variant]]\nname = \"wrong\"\ng = \"5 * a * b");
  const Outcome wrong = mixcmp("check wrong.toml --json");
  EXPECT_EQ(wrong.exit_code, 2) << wrong.output;
  const auto report = nlohmann::json::parse(wrong.output).at("variants")[0];
  EXPECT_EQ(report.at("differences"), 2);
  EXPECT_EQ(report.at("first_difference").at("given"), "greater");
  EXPECT_EQ(report.at("first_difference").at("variant"), "less");
}

TEST_F(CommandLine, CheckTellsWhichOperationHasNoBound) {
  write_scene("cancels.toml", "a - a * b");
  const Outcome text = mixcmp("check cancels.toml --set reduced.error_bound=relative");
  EXPECT_EQ(text.exit_code, 0);
  EXPECT_NE(text.output.find("the difference a - a * b"), std::string::npos) << text.output;
  const Outcome json = mixcmp("check cancels.toml --set reduced.error_bound=relative --json");
  const auto error = nlohmann::json::parse(json.output).at("generate").at("error");
  EXPECT_EQ(error.at("field"), "reduced.error_bound");
}

TEST_F(CommandLine, EveryVerbTakesAPlanInPlaceOfAScene) {
  std::ofstream(path("plan.toml"))
      << "scene = \"scene.toml\"\n[plan]\nclock_mhz = 200\n"
      << "[[lanes]]\ncount = 2\n[[lanes]]\ncount = 1\ninputs = \"rounded\"\n"
      << "[[references]]\ncount = 1\n";
  const Outcome check = mixcmp("check plan.toml --json");
  ASSERT_EQ(check.exit_code, 0) << check.output;
  const auto checked = nlohmann::json::parse(check.output);
  EXPECT_EQ(checked["generate"]["lane_groups"][1]["inputs"], "rounded");
  EXPECT_EQ(checked["plan"]["clock_mhz"], "200");
  const Outcome generate = mixcmp("generate plan.toml -o rtl");
  ASSERT_EQ(generate.exit_code, 0) << generate.output;
  EXPECT_NE(generate.output.find("\n  2 lanes in s8e8: "), std::string::npos) << generate.output;
  EXPECT_NE(generate.output.find("\nerror bound of s8e8_rounded"), std::string::npos);
  std::ifstream top(path("rtl") / "scene_s8e8_3x1.v");
  const std::string text{std::istreambuf_iterator<char>(top), {}};
  EXPECT_NE(text.find("mixcmp generate plan.toml\n"), std::string::npos) << text;
  const Outcome verify = mixcmp("verify plan.toml --simulator icarus --json");
  ASSERT_EQ(verify.exit_code, 0) << verify.output;
  const auto verified = nlohmann::json::parse(verify.output);
  EXPECT_EQ(verified["lane_groups"].size(), 2u);
  EXPECT_EQ(verified["comparisons"], 2);
  expect_refused("verify plan.toml --lanes 4", "given beside [[lanes]]");
}

TEST_F(CommandLine, WhatIsNotChosenNamesWhoChooses) {
  for (const char* verb : {"generate", "verify"}) {
    expect_refused(fmt::format("{} scene.toml --format auto", verb),
                   "a plan, made by: mixcmp optimise scene.toml --set reduced.format=auto "
                   "-o plan.toml");
  }
}

/// A chain of lanes; its candidates decide how many.
TEST_F(CommandLine, AChainHasALaneForEachCandidateButTheFirst) {
  write("points.csv", "p\n1\n2\n");
  write("centres.csv", "c\n1\n2\n5\n");
  std::ofstream(path("chain.toml"))
      << "[comparison]\nname = \"chain\"\nf = \"(p - ci)^2\"\ng = \"(p - cj)^2\"\n"
      << "[reference]\nformat = \"binary32\"\n[reduced]\nformat = \"s8e8\"\n"
      << "[system]\nreferences = 1\n[engine]\nkind = \"arg_min\"\n"
      << "[data]\nfile = \"points.csv\"\nwith = \"centres.csv\"\npairs = \"arg_min\"\n";
  const Outcome check = mixcmp("check chain.toml --json");
  ASSERT_EQ(check.exit_code, 0) << check.output;
  EXPECT_EQ(nlohmann::json::parse(check.output)["generate"]["top"], "chain_s8e8_2x1_arg_min");
  for (const char* options : {"", " --set engine.kind=none"}) {
    expect_refused(fmt::format("optimise chain.toml --table .{}", options),
                   "mixcmp characterise chain.toml");
  }
  expect_refused("optimise chain.toml --table . --set system.lanes=1",
                 "system.lanes: the data have more candidates than the engine: received 3 "
                 "candidates, 1 lanes");
  for (const char* verb : {"generate", "verify"}) {
    expect_refused(fmt::format("{} chain.toml --lanes 1", verb),
                   "--lanes: system.lanes: the data have more candidates than the engine: received "
                   "3 candidates, 1 lanes");
  }
  EXPECT_FALSE(fs::exists(path("chain_s8e8_1x1_simulation")));
  EXPECT_NE(mixcmp("check chain.toml --lanes 1").output.find("more candidates than the engine"),
            std::string::npos);
  EXPECT_FALSE(fs::exists(path("chain_s8e8_2x1_simulation")));
}

TEST_F(CommandLine, EveryVerbRefusesAnUnknownDevice) {
  for (const char* verb : {"check", "generate", "verify"}) {
    expect_refused(fmt::format("{} scene.toml --device virtex7", verb),
                   "--device: system.device: unknown device: received \"virtex7\"");
  }
}

TEST_F(CommandLine, DevicesAreListedByAnyOfTheirNames) {
  const Outcome run = mixcmp("devices Nexys --json");
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const auto list = nlohmann::json::parse(run.output).at("devices");
  ASSERT_EQ(list.size(), 3u) << run.output;
  EXPECT_EQ(list[1], nlohmann::json::parse(R"({"device": "xc7a100t", "family": "artix7",
      "luts": 63400, "registers": 126800, "dsps": 240, "memories": 270, "clock": "yosys_sta",
      "other_names": ["alchitry-au-plus", "alinx-ax7101", "arty-a7-100", "nexys-a7-100"]})"));
  const Outcome text = mixcmp("devices gatemate");
  EXPECT_NE(text.output.find("40960      40960     0       64  nextpnr_gatemate  gatemate-evb"),
            std::string::npos)
      << text.output;
  expect_refused("devices xc7a15t",
                 "PATTERN: no device has this in its names: received "
                 "\"xc7a15t\"; accepted xc7a25t, ");
}

TEST_F(CommandLine, NumbersOutOfRangeAreRefused) {
  expect_refused("verify scene.toml --only -1", "received -1");
  expect_refused("verify scene.toml --first 0", "an integer of at least 1");
  expect_refused("verify scene.toml --sample 0", "an integer of at least 1");
  expect_refused("verify scene.toml --resets -1", "received -1");
  expect_refused("verify scene.toml --only 2", "an index below 2");
}

TEST_F(CommandLine, EveryVerbStatesTheSameLimits) {
  expect_refused("profile scene.toml --first 3", "--first: received 3; accepted 4..52");
  expect_refused("optimise scene.toml --last 53", "--last: received 53; accepted 4..52");
  expect_refused("explore scene.toml --first 3", "--first: received 3; accepted 4..52");
  expect_refused("check scene.toml --prove --precisions 4,53",
                 "--precisions: received 53; accepted 4..52");
  expect_refused("check scene.toml --format s53e8", "P 4..24 and E 2..15");
  expect_refused("characterise scene.toml --precisions 25", "accepted numbers 4..24");
  expect_refused("characterise scene.toml --ports 129", "accepted numbers 1..128");
  expect_refused("verify scene.toml --lanes 513", "accepted \"auto\" or an integer 1..512");
  expect_refused("generate scene.toml --references 17", "accepted \"auto\" or an integer 0..16");
  const Outcome help = mixcmp("generate --help");
  EXPECT_NE(help.output.find("p_L, 1..512, in groups or a pairwise engine 1..4096 "),
            std::string::npos)
      << help.output;
  EXPECT_NE(help.output.find("p_H, 0..16 "), std::string::npos) << help.output;
}

class Fit : public CommandLine {
protected:
  static constexpr const char* small = "--device ice40-up5k --set reduced.multipliers=logic";

  /// The notes of generate and of check, which are the same.
  std::string notes(const std::string& arguments) {
    const Outcome check = mixcmp("check scene.toml --json " + arguments);
    const Outcome generate = mixcmp("generate scene.toml --no-prove --json " + arguments);
    EXPECT_EQ(check.exit_code, 0) << check.output;
    EXPECT_EQ(generate.exit_code, 0) << generate.output;
    const auto checked = nlohmann::json::parse(check.output)["generate"]["notes"];
    const auto generated = nlohmann::json::parse(generate.output)["notes"];
    EXPECT_EQ(checked, generated);
    return generated.dump();
  }
};

TEST_F(Fit, LanesThatPlainlyExceedTheDeviceAreNoted) {
  const std::string note = "400 lanes and 1 reference do not fit ice40-up5k: about ";
  const std::string many = notes(fmt::format("{} --lanes 400", small));
  EXPECT_NE(many.find(note), std::string::npos) << many;
  EXPECT_NE(many.find("lut of 5280; a rough estimate before synthesis"), std::string::npos) << many;
  EXPECT_EQ(notes(fmt::format("{} --lanes 1", small)).find("do not fit"), std::string::npos);
  const std::string wide = notes("--lanes 400");
  EXPECT_EQ(wide.find("do not fit"), std::string::npos) << wide;
  const Outcome text = mixcmp(fmt::format("generate scene.toml --no-prove {} --lanes 400", small));
  EXPECT_NE(text.output.find("\nnote: " + note), std::string::npos) << text.output;
}

TEST_F(Fit, APlanThatStatesItsAreaIsNotEstimatedAgain) {
  write("plan.toml", "scene = \"scene.toml\"\n[plan]\nlut = 5000\n");
  const std::string options = fmt::format(" --no-prove {} --lanes 400", small);
  const Outcome planned = mixcmp("generate plan.toml" + options);
  EXPECT_EQ(planned.exit_code, 0) << planned.output;
  EXPECT_EQ(planned.output.find("do not fit"), std::string::npos) << planned.output;
  write("larger.toml", "scene = \"scene.toml\"\n[plan]\nlut = 6000\n");
  const Outcome other = mixcmp("generate larger.toml -o larger" + options);
  EXPECT_NE(other.output.find("do not fit"), std::string::npos) << "a plan for a larger device";
}

TEST_F(Fit, ATableOfOtherRtlIsNoMeasurement) {
  fs::create_directory(path("characterisation"));
  std::ofstream(path("characterisation") / "scene-ice40-up5k.csv")
      << "# device: ice40-up5k\n# scene: scene\n"
      << "kind,name,format,inputs,bound,multipliers,initiation_interval,ports,latency_cycles,"
         "luts,registers,dsps,memories,carries,shift_luts,mhz,low_mhz,high_mhz,seeds,clock_source,"
         "timing_seeds,hash,"
         "tools\n"
      << "lane,,s8e8,exact,relative,logic,0,0,9,500,100,0,0,0,0,,,,,,0,a,t\n"
      << "reference,,s24e8,,,embedded,1,0,9,280,100,0,0,0,0,,,,,,0,b,t\n";
  const std::string eleven = notes(fmt::format("{} --lanes 11", small));
  EXPECT_EQ(eleven.find("areas measured"), std::string::npos) << "of other RTL: " << eleven;
}

TEST_F(Fit, MeasuredAreasAreALowerBound) {
  const std::string yosys = instead_of("yosys", fake_yosys("40000"));
  const Outcome measured = mixcmp(
      "characterise scene.toml --area-only --store s.sqlite --precisions 8 "
      "--components lane,reference --multipliers both",
      yosys);
  ASSERT_EQ(measured.exit_code, 0) << measured.output;
  EXPECT_EQ(notes("--lanes 10").find("do not fit"), std::string::npos);
  const std::string eleven = notes("--lanes 11");
  EXPECT_NE(eleven.find("11 lanes and 1 reference do not fit virtex6-lx760: at least 480000 lut of "
                        "474240; areas measured, "),
            std::string::npos)
      << eleven;
}

TEST_F(CommandLine, AnEmptyArgumentIsNone) {
  expect_refused("generate scene.toml -o ''", "-o: an empty argument");
  expect_refused("verify scene.toml --csv=", "--csv=: an empty argument");
  expect_refused("''", "an empty argument");
}

TEST_F(CommandLine, AWorkingDirectoryThatIsGoneIsNamed) {
  const Outcome run =
      shell(fmt::format("mkdir '{0}/gone' && cd '{0}/gone' && rmdir '{0}/gone' && "
                        "'{1}' check '{0}/scene.toml'",
                        directory_.path().string(), MIXCMP_PROGRAM));
  EXPECT_EQ(run.exit_code, 1) << run.output;
  EXPECT_NE(run.output.find("there is no working directory"), std::string::npos) << run.output;
}

TEST_F(CommandLine, ChoicesAreNames) {
  expect_refused("verify scene.toml --simulator 1", "received 1; accepted icarus, verilator");
  expect_refused("verify scene.toml --traffic slow", "received slow; accepted full_rate, stressed");
}

TEST_F(CommandLine, FilesThatCannotBeWrittenAreRefusedBeforeAnythingRuns) {
  expect_refused("verify scene.toml --trace waves.vcd", "ends in .fst");
  expect_refused("verify scene.toml --trace nowhere/waves.fst", "nowhere/waves.fst");
  expect_refused("verify scene.toml --csv nowhere/t.csv", "nowhere/t.csv");
  expect_refused("verify scene.toml --csv-verdict less", "--csv");
  expect_refused("verify scene.toml --work 'two words'", "the path has blanks");
  expect_refused("generate scene.toml -o data.csv",
                 "is not a directory: received a file; accepted ");
}

TEST_F(CommandLine, NothingIsLeftOfATableThatWasNotFinished) {
  expect_refused("verify scene.toml --csv t.csv --only 2", "an index below 2");
  EXPECT_FALSE(fs::exists(path("t.csv")));
  EXPECT_FALSE(fs::exists(path("scene_s8e8_1x1_simulation")));
}

}  // namespace
}  // namespace mixcmp::test::command_line_test
