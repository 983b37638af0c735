#include <fmt/core.h>
#include <gtest/gtest.h>
#include <stdio.h>
#include <sys/wait.h>

#include <array>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/support/scratch_directory.hpp"

/// The program as a user calls it: what it refuses, what it says, what it leaves behind.
namespace mixcmp::test {
namespace {

namespace fs = std::filesystem;

struct Outcome {
  int exit_code;
  std::string output;  ///< stdout and stderr
};

class CommandLine : public testing::Test {
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

  /// In the scratch directory, which holds scene.toml.
  Outcome mixcmp(const std::string& arguments) {
    const std::string command = fmt::format("cd '{}' && '{}' {} 2>&1", directory_.path().string(),
                                            MIXCMP_PROGRAM, arguments);
    FILE* pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) throw std::runtime_error("no shell");
    Outcome run{0, ""};
    std::array<char, 4096> block;
    for (std::size_t read = 0; (read = fread(block.data(), 1, block.size(), pipe)) > 0;) {
      run.output.append(block.data(), read);
    }
    run.exit_code = WEXITSTATUS(pclose(pipe));
    return run;
  }

  void expect_refused(const std::string& arguments, const std::string& words) {
    const Outcome run = mixcmp(arguments);
    EXPECT_EQ(run.exit_code, 1) << arguments << "\n" << run.output;
    EXPECT_NE(run.output.find(words), std::string::npos) << arguments << "\n" << run.output;
  }

  ScratchDirectory directory_;
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
