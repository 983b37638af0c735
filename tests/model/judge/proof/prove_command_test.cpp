#include <fmt/core.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "model/judge/proof/gappa.hpp"
#include "tests/support/program.hpp"

/// Tests check --prove, generate's quick proof and doctor as a user calls them.
namespace mixcmp::test::prove_command_test {
namespace {

namespace fs = std::filesystem;

const std::string examples = MIXCMP_EXAMPLES;

class ProveCommand : public ProgramTest {
protected:
  std::string with_gappa(const std::string& commands) const {
    return instead_of("gappa",
                      "if [ \"$1\" = --version ]; then echo Gappa 9.9; exit 0; fi\n" + commands);
  }

  std::string without_gappa() const { return fmt::format("PATH='{}'", directory_.path().string()); }

  std::string refusing_gappa() {
    return with_gappa("echo 'Error: some properties were not satisfied: BND(x)' >&2; exit 1");
  }
};

std::string scene(const char* example) {
  return fmt::format("'{}/{}/scene.toml'", examples, example);
}

class ProvenExample : public ProveCommand, public testing::WithParamInterface<std::string> {};

TEST_P(ProvenExample, IsProvenInEveryPrecision) {
  if (!proof::gappa_version()) GTEST_SKIP() << "gappa is not installed";
  const Outcome run = mixcmp(
      fmt::format("check {} --prove --precisions 4,8,17,24,52 --json", scene(GetParam().c_str())));
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const auto proof = nlohmann::json::parse(run.output).at("proof");
  ASSERT_EQ(proof.size(), 5U);
  for (const auto& lane : proof) {
    EXPECT_TRUE(lane.at("machine_checked")) << lane.dump(2);
    const fs::path kept = directory_.path() / lane.at("directory").get<std::string>();
    EXPECT_EQ(kept.filename().string(),
              fmt::format("{}_{}_proof", GetParam(), lane.at("format").get<std::string>()));
    for (const auto& finding : lane.at("findings")) {
      for (const auto& script : finding.at("scripts")) {
        EXPECT_TRUE(fs::exists(kept / script.get<std::string>()));
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Examples, ProvenExample,
                         testing::Values("sphere_collision", "protein_clash"),
                         [](const auto& tested) { return tested.param; });

TEST_F(ProveCommand, ALaneInFixedPointIsProvenInItsOwnPrecisions) {
  if (!proof::gappa_version()) GTEST_SKIP() << "gappa is not installed";
  const std::string arguments =
      "check " + scene("sphere_collision") + " --format q13 --prove --json";
  const Outcome run = mixcmp(arguments + " --precisions 7,12");
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const auto proof = nlohmann::json::parse(run.output).at("proof");
  ASSERT_EQ(proof.size(), 2U);
  EXPECT_EQ(proof[0].at("format"), "q7");
  EXPECT_EQ(proof[1].at("format"), "q12");
  EXPECT_EQ(mixcmp(arguments + " --precisions 50").exit_code, 1);
}

class ProvenFunctions : public ProveCommand, public testing::WithParamInterface<const char*> {};

/// Each function is proven as a whole, by the words of its tables.
TEST_P(ProvenFunctions, AreProvenInEveryPrecision) {
  if (!proof::gappa_version()) GTEST_SKIP() << "gappa is not installed";
  const Outcome run = mixcmp(fmt::format(
      "check '{}/functions/{}.toml' --prove --precisions 8,13,17,24 --json", examples, GetParam()));
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const auto proof = nlohmann::json::parse(run.output).at("proof");
  ASSERT_EQ(proof.size(), 4U);
  for (const auto& lane : proof) {
    EXPECT_TRUE(lane.at("machine_checked")) << lane.dump(2);
    int functions = 0;
    for (const auto& finding : lane.at("findings")) {
      const std::string what = finding.at("what");
      EXPECT_EQ(what.find("look_up"), std::string::npos) << what;
      if (finding.at("detail").get<std::string>().starts_with("by theorem 10")) ++functions;
    }
    EXPECT_GE(functions, 1) << lane.dump(2);
  }
}

INSTANTIATE_TEST_SUITE_P(Examples, ProvenFunctions, testing::Values("metropolis", "trigger"));

TEST_F(ProveCommand, AGappaThatIsKilledIsNoMissingTool) {
  const Outcome run =
      mixcmp("check " + scene("sphere_collision") + " --prove",
             with_gappa("case \"$*\" in *coq*) kill -9 $$;; esac\n"
                        "echo 'Error: some properties were not satisfied' >&2; exit 1"));
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.output.find("gappa was ended by signal 9"), std::string::npos) << run.output;
}

TEST_F(ProveCommand, AGappaThatFailsIsAMistakeToldOnce) {
  const Outcome run = mixcmp("check " + scene("sphere_collision") + " --prove",
                             with_gappa("echo oops >&2; exit 3"));
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.output, "mixcmp: gappa does not work: received oops\n");
}

TEST_F(ProveCommand, KeepsEverythingInTheDirectoryAsked) {
  if (!proof::gappa_version()) GTEST_SKIP() << "gappa is not installed";
  const std::string arguments =
      "check " + scene("sphere_collision") + " --prove --proof-dir kept --precisions 8,17";
  const Outcome first = mixcmp(arguments);
  ASSERT_EQ(first.exit_code, 0) << first.output;
  EXPECT_TRUE(fs::exists(directory_.path() / "kept" / "sphere_collision_s8e8.json"));
  EXPECT_TRUE(fs::exists(directory_.path() / "kept" / "sphere_collision_s17e8.json"));
  const Outcome again = mixcmp(arguments);
  EXPECT_NE(again.output.find("16 proven before"), std::string::npos) << again.output;
}

/// Gappa's own threshold would forget that a maximum is at least its small constant.
TEST_F(ProveCommand, ProvesAGuardAgainstZero) {
  if (!proof::gappa_version()) GTEST_SKIP() << "gappa is not installed";
  write("guard.toml",
        "[comparison]\nname = \"guard\"\nf = \"max((a - b)^2, 1e-30)\"\ng = \"c - d\"\n"
        "[reference]\nformat = \"binary64\"\n[reduced]\nformat = \"s12e11\"\n"
        "[system]\nlanes = 1\nreferences = 1\n");
  const Outcome run = mixcmp("generate guard.toml -o rtl");
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_NE(run.output.find("error bound: machine-checked"), std::string::npos) << run.output;
}

TEST_F(ProveCommand, SaysWithoutGappaThatNothingIsChecked) {
  const Outcome check = mixcmp("check " + scene("sphere_collision") + " --prove", without_gappa());
  EXPECT_EQ(check.exit_code, 3) << check.output;
  EXPECT_NE(check.output.find("not machine-checked: gappa does not run"), std::string::npos)
      << check.output;
  const Outcome generate =
      mixcmp("generate " + scene("sphere_collision") + " -o rtl", without_gappa());
  EXPECT_EQ(generate.exit_code, 0) << generate.output;
  EXPECT_NE(generate.output.find("not machine-checked: gappa does not run"), std::string::npos)
      << generate.output;
}

TEST_F(ProveCommand, RefusesWhatGappaDoesNotProve) {
  const Outcome check = mixcmp("check " + scene("sphere_collision") + " --prove", refusing_gappa());
  EXPECT_EQ(check.exit_code, 2) << check.output;
  EXPECT_NE(check.output.find("refused: no proof of"), std::string::npos) << check.output;
  const Outcome generate =
      mixcmp("generate " + scene("sphere_collision") + " -o rtl", refusing_gappa());
  EXPECT_EQ(generate.exit_code, 2) << generate.output;
  EXPECT_NE(generate.output.find("scene.toml: reduced.bound: refused"), std::string::npos)
      << generate.output;
  EXPECT_FALSE(fs::exists(directory_.path() / "rtl"));
}

TEST_F(ProveCommand, GeneratesWithoutAProofWhereAskedTo) {
  const Outcome run =
      mixcmp("generate " + scene("sphere_collision") + " -o rtl --no-prove", refusing_gappa());
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_EQ(run.output.find("machine-checked"), std::string::npos) << run.output;
}

TEST_F(ProveCommand, GeneratedFilesDoNotDependOnGappa) {
  EXPECT_EQ(mixcmp("generate " + scene("protein_clash") + " -o with").exit_code, 0);
  EXPECT_EQ(mixcmp("generate " + scene("protein_clash") + " -o without", without_gappa()).exit_code,
            0);
  EXPECT_EQ(mixcmp("generate " + scene("protein_clash") + " -o none --no-prove").exit_code, 0);
  const std::string root = directory_.path().string();
  for (const char* other : {"without", "none"}) {
    const std::string compare = fmt::format("diff -r '{0}/with' '{0}/{1}'", root, other);
    EXPECT_EQ(std::system(compare.c_str()), 0) << other;
  }
}

TEST_F(ProveCommand, AProfiledBoundHasNothingToProve) {
  const Outcome run = mixcmp("check " + scene("sphere_collision") +
                             " --prove --bound profiled --set reduced.relative_error_f=0.001 "
                             "--set reduced.relative_error_g=0.001");
  EXPECT_EQ(run.exit_code, 3) << run.output;
  EXPECT_NE(run.output.find("not done: --prove, s17e8: the bound: it is measured, not derived"),
            std::string::npos)
      << run.output;
}

TEST_F(ProveCommand, OptionsOfTheProofNeedIt) {
  for (const char* option : {"--proof-dir x", "--precisions 8", "--proof-seconds 1"}) {
    const Outcome run = mixcmp(fmt::format("check {} {}", scene("sphere_collision"), option));
    EXPECT_EQ(run.exit_code, 1) << run.output;
    EXPECT_NE(run.output.find("--prove"), std::string::npos) << run.output;
  }
  for (const char* wrong : {"1", "114", "8,x", "8,30 --set reference.format=binary32"}) {
    const Outcome run =
        mixcmp(fmt::format("check {} --prove --precisions {}", scene("sphere_collision"), wrong));
    EXPECT_EQ(run.exit_code, 1) << run.output;
    EXPECT_NE(run.output.find("--precisions"), std::string::npos) << run.output;
  }
}

TEST_F(ProveCommand, DoctorSaysWhatIsMissingWithoutGappa) {
  const Outcome run = mixcmp("doctor --json", without_gappa());
  for (const auto& tool : nlohmann::json::parse(run.output.substr(0, run.output.rfind("]") + 1))) {
    if (tool.at("tool") != "gappa") continue;
    EXPECT_FALSE(tool.at("found"));
    EXPECT_NE(tool.at("disables").get<std::string>().find("check --prove"), std::string::npos);
    return;
  }
  FAIL() << run.output;
}

}  // namespace
}  // namespace mixcmp::test::prove_command_test
