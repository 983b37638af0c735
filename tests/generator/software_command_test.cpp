#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/program.hpp"

/// `mixcmp baseline` as a user calls it.
namespace mixcmp::test::software_command_test {
namespace {

class BaselineCommand : public ProgramTest {
protected:
  BaselineCommand() {
    std::ofstream data(path("data.csv"));
    data << "x,r\n";
    for (int k = 0; k < 40; ++k) data << k * 0.37 << ',' << 0.1 * (k % 7) << '\n';
    std::ofstream(path("scene.toml"))
        << "[comparison]\nname = \"line\"\nf = \"(xi - xj)^2\"\ng = \"(ri + rj)^2\"\n"
        << "[inputs]\n\"x*\" = { range = [0, 16] }\n\"r*\" = { range = [0, 1] }\n"
        << "[reference]\nformat = \"s53e8\"\n[data]\nfile = \"data.csv\"\npairs = \"all\"\n";
  }
};

const std::string quick = " --rounds 1 --seconds 0.002 --threads 2";

TEST_F(BaselineCommand, TellsEveryKernelsRate) {
  const Outcome run = mixcmp("baseline scene.toml --json" + quick);
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const auto report = nlohmann::json::parse(run.output);
  EXPECT_EQ(report.at("comparisons"), 780);
  EXPECT_EQ(report.at("check").at("comparisons"), 780);
  EXPECT_EQ(report.at("check").at("unlike_reference"), 0);
  ASSERT_EQ(report.at("kernels").size(), 3u);
  for (const auto& kernel : report.at("kernels")) {
    EXPECT_GT(kernel.at("one_core").at("best_per_s"), 0);
    EXPECT_EQ(kernel.at("all_cores").at("threads"), 2);
    EXPECT_EQ(kernel.at("less"), report.at("kernels")[0].at("less"));
  }
}

TEST_F(BaselineCommand, PrintsCsvAndKeepsTheSource) {
  const Outcome run = mixcmp("baseline scene.toml --csv --work kept" + quick);
  ASSERT_EQ(run.exit_code, 0) << run.output;
  EXPECT_EQ(run.output.rfind("filter,threads,best_per_s", 0), 0u) << run.output;
  EXPECT_TRUE(std::filesystem::exists(path("kept") / "comparison.cpp"));
}

TEST_F(BaselineCommand, WhatTheProgramDidNotPrintIsMissed) {
  const auto run_with = [&](const std::string& program) {
    const std::string written =
        program.empty() ? "" : "printf '#!/bin/sh\\n" + program + "' >comparison; ";
    return mixcmp("baseline scene.toml" + quick,
                  instead_of("g++", "[ \"$1\" = --version ] && { echo g++ 1.0; exit; }\n" +
                                        written + "chmod +x comparison 2>/dev/null; exit 0"));
  };
  const std::pair<std::string, std::string> programs[] = {
      {"", "g++ ended well and wrote no program"},
      {"exit 0", "did not print all"},
      {"echo end", "did not print all: received 0 kernels"},
      {"echo tally double 1 2 3 4 5", "did not print all"},
      {"echo tally double 1 2 3 4 5; echo end", "received 0 verdicts of 780"},
      {"echo verdicts double u; echo end", "received 1 verdicts of 780"},
      {"echo nonsense; echo end", "printed what it should not"},
      {"echo tally double 1 2; echo end", "printed what it should not"}};
  for (const auto& [program, words] : programs) {
    const Outcome run = run_with(program);
    EXPECT_EQ(run.exit_code, 1) << program << "\n" << run.output;
    EXPECT_NE(run.output.find(words), std::string::npos) << program << "\n" << run.output;
  }
}

/// A long operand has its node called after its role, which must not hide a function.
TEST_F(BaselineCommand, NamesOfNodesHideNoFunction) {
  write("long.csv", "alpha,beta,gamma,delta\n1,2,0.3,0.5\n");
  write("long.toml",
        "[comparison]\nname = \"long\"\nf = \"abs(alpha - beta) + min(alpha - beta * gamma, "
        "delta) + sqrt(abs(alpha - delta * gamma))\"\ng = \"delta\"\n[reference]\n"
        "format = \"binary64\"\n[data]\nfile = \"long.csv\"\n");
  const Outcome run = mixcmp("baseline long.toml --rounds 1 --seconds 0.01");
  EXPECT_EQ(run.exit_code, 0) << run.output;
}

TEST_F(BaselineCommand, AFailureLeavesTheLogThatItNames) {
  const Outcome run = mixcmp(
      "baseline scene.toml" + quick,
      instead_of("g++", "[ \"$1\" = --version ] && { echo g++ 1.0; exit; }\necho broken; exit 1"));
  EXPECT_EQ(run.exit_code, 1) << run.output;
  const std::size_t begin = run.output.find("/"), end = run.output.find(".log");
  ASSERT_LT(begin, end) << run.output;
  EXPECT_EQ(read(run.output.substr(begin, end + 4 - begin)), "broken\n") << run.output;
}

TEST_F(BaselineCommand, AsksForWhatItCannotDoWithout) {
  expect_refused("baseline scene.toml --set reference.format=binary128",
                 "reference.format: software computes in double");
  expect_refused("baseline scene.toml --rounds 0", "--rounds");
  const Outcome run = mixcmp("baseline scene.toml", "PATH=/nowhere");
  EXPECT_EQ(run.exit_code, 3);
  EXPECT_NE(run.output.find("apt-get install g++"), std::string::npos) << run.output;
}

}  // namespace
}  // namespace mixcmp::test::software_command_test
