#include <fmt/core.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/support/program.hpp"

/// The program as a user calls it: what it refuses, what it says, what it leaves behind.
namespace mixcmp::test {
namespace {

namespace fs = std::filesystem;

class CommandLine : public ProgramTest {
protected:
  CommandLine() {
    std::ofstream(directory_.path() / "data.csv") << "a,b,c\n1,2,3\n4,5,6\n";
    write_scene("scene.toml", "a * b");
  }

  void write_scene(const std::string& name, const std::string& g) {
    std::ofstream(directory_.path() / name)
        << "[comparison]\nname = \"scene\"\nf = \"a * c\"\ng = \"" << g << "\"\n"
        << "[reference]\nformat = \"binary32\"\n[reduced]\nformat = \"s8e8\"\n"
        << "[system]\nlanes = 1\nreferences = 1\n[data]\nfile = \"data.csv\"\n";
  }
};

TEST_F(CommandLine, NamesAWordThatIsNoVerb) {
  expect_refused("chek scene.toml", "chek");
  expect_refused("", "check, generate, verify, profile, doctor");
}

TEST_F(CommandLine, CheckTellsWhatGenerateWillDo) {
  const Outcome run = mixcmp("check scene.toml --json");
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const auto report = nlohmann::json::parse(run.output).at("generate");
  EXPECT_EQ(report.at("top"), "scene_s8e8_1x1");
  EXPECT_EQ(mixcmp("generate scene.toml -o rtl").exit_code, 0);
  EXPECT_TRUE(fs::exists(directory_.path() / "rtl" / "scene_s8e8_1x1.v"));
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

TEST_F(CommandLine, EveryVerbRefusesAnUnknownDevice) {
  for (const char* verb : {"check", "generate", "verify"}) {
    expect_refused(fmt::format("{} scene.toml --device virtex7", verb),
                   "scene.toml: system.device: unknown device: received \"virtex7\"");
  }
}

TEST_F(CommandLine, NumbersOutOfRangeAreRefused) {
  expect_refused("verify scene.toml --only -1", "received -1");
  expect_refused("verify scene.toml --first 0", "an integer of at least 1");
  expect_refused("verify scene.toml --sample 0", "an integer of at least 1");
  expect_refused("verify scene.toml --resets -1", "received -1");
  expect_refused("verify scene.toml --only 2", "an index below 2");
}

TEST_F(CommandLine, ChoicesAreNames) {
  expect_refused("verify scene.toml --simulator 1", "{icarus,verilator}");
  expect_refused("verify scene.toml --traffic slow", "{full_rate,stressed}");
}

TEST_F(CommandLine, FilesThatCannotBeWrittenAreRefusedBeforeAnythingRuns) {
  expect_refused("verify scene.toml --trace waves.vcd", "ends in .fst");
  expect_refused("verify scene.toml --trace nowhere/waves.fst", "nowhere/waves.fst");
  expect_refused("verify scene.toml --csv nowhere/t.csv", "nowhere/t.csv");
  expect_refused("verify scene.toml --csv-verdict less", "--csv");
  expect_refused("verify scene.toml --work 'two words'", "the path has blanks");
}

TEST_F(CommandLine, NothingIsLeftOfATableThatWasNotFinished) {
  expect_refused("verify scene.toml --csv t.csv --only 2", "an index below 2");
  EXPECT_FALSE(fs::exists(directory_.path() / "t.csv"));
  EXPECT_FALSE(fs::exists(directory_.path() / "t.csv.part"));
}

}  // namespace
}  // namespace mixcmp::test
