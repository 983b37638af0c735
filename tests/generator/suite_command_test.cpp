#include <fmt/core.h>

#include <nlohmann/json.hpp>

#include "tests/support/program.hpp"

/// Regression suites, JUnit reports and counterexamples of `mixcmp verify`.
namespace mixcmp::test::suite_command_test {
namespace {

class SuiteCommand : public ProgramTest {
protected:
  SuiteCommand() {
    write("data.csv", "a,b,c\n1,2,3\n4,5,6\n9,8,7\n");
    write("scene.toml",
          "[comparison]\nname = \"scene\"\nf = \"a * c\"\ng = \"a * b\"\n"
          "[reference]\nformat = \"binary32\"\n[reduced]\nformat = \"s8e8\"\n"
          "[system]\nlanes = 1\nreferences = 1\n[data]\nfile = \"data.csv\"\n");
    write_suite("traffic = [\"full_rate\", \"stressed\"]\nsystem.lanes = [1, 2]\n");
  }

  void write_suite(const std::string& options, const std::string& head = "") {
    write("suite.toml",
          head + "[[run]]\nscenes = \"scene.toml\"\nsimulator = \"icarus\"\n" + options);
  }

  static std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
  }
};

TEST_F(SuiteCommand, RunsEveryCombination) {
  const Outcome run = mixcmp("verify --suite suite.toml --junit junit.xml");
  EXPECT_EQ(run.exit_code, 0) << run.output;
  EXPECT_EQ(count(run.output, "\npassed"), 4u) << run.output;
  for (const char* name :
       {"scene.toml --simulator=icarus --traffic=full_rate --set system.lanes=1\n",
        "scene.toml --simulator=icarus --traffic=stressed --set system.lanes=2\n"}) {
    EXPECT_NE(run.output.find(name), std::string::npos) << run.output;
  }
  const std::string junit = read("junit.xml");
  EXPECT_NE(junit.find("tests=\"4\" failures=\"0\" errors=\"0\" skipped=\"0\""), std::string::npos)
      << junit;
  EXPECT_EQ(count(junit, "<testcase "), 4u) << junit;
}

/// Without a simulator nothing can be run, but passed scenes are not run again.
TEST_F(SuiteCommand, DoesNotRepeatWhatPassed) {
  ASSERT_EQ(mixcmp("verify --suite suite.toml").exit_code, 0);
  const std::string broken = instead_of("vvp", "exit 1");
  const Outcome again = mixcmp("verify --suite suite.toml", broken);
  EXPECT_EQ(again.exit_code, 0) << again.output;
  EXPECT_EQ(count(again.output, "\npassed"), 4u) << again.output;
  write("data.csv", "a,b,c\n1,2,3\n4,5,6\n9,8,8\n");
  const Outcome changed = mixcmp("verify --suite suite.toml", broken);
  EXPECT_EQ(changed.exit_code, 1) << "the data are others\n" << changed.output;
  EXPECT_EQ(count(changed.output, "\nnot run"), 4u) << changed.output;
}

TEST_F(SuiteCommand, ARunThatFailsIsToldAndRepeated) {
  const Outcome wrong = mixcmp("verify --suite suite.toml --junit junit.xml", wrong_icarus());
  EXPECT_EQ(wrong.exit_code, 2) << wrong.output;
  EXPECT_EQ(count(wrong.output, "\nFAILED"), 4u) << wrong.output;
  EXPECT_NE(read("junit.xml").find("failures=\"4\""), std::string::npos);
  EXPECT_EQ(mixcmp("verify --suite suite.toml").exit_code, 0) << "by the right simulator";
}

TEST_F(SuiteCommand, ABudgetThatIsSpentLeavesRunsToTheNextCall) {
  write_suite("seed = [1, 2]\n", "[suite]\nminutes = 1e-9\n");
  const Outcome spent = mixcmp("verify --suite suite.toml");
  EXPECT_EQ(spent.exit_code, 3) << spent.output;
  EXPECT_NE(spent.output.find("2 of 2 runs had no time"), std::string::npos) << spent.output;
  EXPECT_EQ(mixcmp("verify --suite suite.toml --minutes 10").exit_code, 0);
}

/// A scene that cannot be run stops no other scene; a scene that fails counts for more.
TEST_F(SuiteCommand, TellsTheGravestOutcome) {
  write("suite.toml",
        "[[run]]\nscenes = [\"nowhere.toml\", \"scene.toml\"]\nsimulator = \"icarus\"\n");
  const Outcome missing = mixcmp("verify --suite suite.toml --work w --json");
  EXPECT_EQ(missing.exit_code, 1) << missing.output;
  const auto runs = nlohmann::json::parse(missing.output)["runs"];
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_EQ(runs[0]["result"], "not run");
  EXPECT_EQ(runs[1]["result"], "passed");
  EXPECT_EQ(runs[1]["report"]["comparisons"], 3);
  write("data.csv", "a,b,c\n1,2,3\n");
  EXPECT_EQ(mixcmp("verify --suite suite.toml --work w", wrong_icarus()).exit_code, 2);
}

TEST_F(SuiteCommand, ARunThatNeedsMoreThanTheBudgetIsEnded) {
  const Outcome run =
      mixcmp("verify --suite suite.toml --minutes 0.01", instead_of("vvp", "sleep 60"));
  EXPECT_EQ(run.exit_code, 3) << run.output;
  EXPECT_EQ(count(run.output, "\nno time"), 4u) << run.output;
}

TEST_F(SuiteCommand, AReportThatIsCutShortIsNotBelieved) {
  ASSERT_EQ(mixcmp("verify --suite suite.toml").exit_code, 0);
  shell(fmt::format("truncate -s 20 {}/suite_suite/suite/*.json", directory_.path().string()));
  EXPECT_EQ(mixcmp("verify --suite suite.toml", instead_of("vvp", "exit 1")).exit_code, 1);
}

TEST_F(SuiteCommand, AMistakeNamesItsPlace) {
  const auto refused = [this](const std::string& text, const std::string& part) {
    write("suite.toml", text);
    const Outcome run = mixcmp("verify --suite suite.toml");
    EXPECT_EQ(run.exit_code, 1) << text << "\n" << run.output;
    EXPECT_NE(run.output.find(part), std::string::npos) << run.output;
  };
  refused("[suite]\nminutes = 1\n", "a suite without a run");
  refused("[[run]]\nfirst = 3\n", "a run without a scene");
  refused("[[run]]\nscenes = \"scene.toml\"\nlanes = 3\n",
          "suite.toml:3: run.lanes: no such option");
  refused("[[run]]\nscenes = \"scene.toml\"\nseed = []\n", "an empty list");
  refused("[[run]]\nscenes = \"scene.toml\"\nseed = [[1]]\n", "cannot be the value of an option");
  refused("[[run]]\nscenes = \"scene.toml\"\n[extra]\na = 1\n", "no such section of a suite");
  EXPECT_EQ(mixcmp("verify scene.toml --suite suite.toml").exit_code, 1);
  EXPECT_EQ(mixcmp("verify --suite suite.toml --first 3").exit_code, 1);
  EXPECT_EQ(mixcmp("verify").exit_code, 1);
}

TEST_F(SuiteCommand, AFailedRunEndsWithItsLeastCounterexample) {
  const std::string simulator = wrong_icarus();
  const Outcome wrong = mixcmp("verify scene.toml --simulator icarus --json", simulator);
  ASSERT_EQ(wrong.exit_code, 2) << wrong.output;
  const auto report = nlohmann::json::parse(wrong.output);
  EXPECT_EQ(report["mismatch_count"], 2);
  const auto least = report["counterexample"];
  EXPECT_EQ(least["comparisons"], "only comparison 0") << "1, 2 and 3 have the fewest digits";
  EXPECT_EQ(least["mismatch"]["got"], "less, decided by the lane");
  EXPECT_EQ(least["waves"],
            "mixcmp verify scene.toml --simulator icarus --only 0 --trace counterexample.fst");
  const Outcome text = mixcmp("verify scene.toml --simulator icarus --junit junit.xml", simulator);
  EXPECT_NE(text.output.find("least counterexample"), std::string::npos) << text.output;
  EXPECT_NE(read("junit.xml").find("<failure message=\"2 mismatches\">"), std::string::npos)
      << read("junit.xml");
}

/// The run that the report shows is the short one, not the one that failed first.
TEST_F(SuiteCommand, TheLeastCounterexampleIsARunOfItsOwn) {
  write("data.csv", "a,b,c\n9.5,7.25,8.25\n1,2,3\n");
  const Outcome wrong = mixcmp("verify scene.toml --simulator icarus --json", wrong_icarus());
  ASSERT_EQ(wrong.exit_code, 2) << wrong.output;
  const auto report = nlohmann::json::parse(wrong.output);
  EXPECT_EQ(report["mismatches"][0]["index"], 0);
  EXPECT_EQ(report["counterexample"]["comparisons"], "only comparison 1");
  EXPECT_EQ(report["counterexample"]["mismatch"]["index"], 1);
}

}  // namespace
}  // namespace mixcmp::test::suite_command_test
