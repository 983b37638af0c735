#include <gtest/gtest.h>

#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/program.hpp"

/// `mixcmp route` as a user calls it, on the smallest systems that there are.
namespace mixcmp::test::route_command_test {
namespace {

namespace fs = std::filesystem;

class RouteCommand : public ProgramTest {
protected:
  RouteCommand() {
    std::ofstream(path("scene.toml"))
        << "[comparison]\nname = \"order\"\nf = \"a\"\ng = \"b\"\n"
        << "[reference]\nformat = \"s11e5\"\n[reduced]\nformat = \"s4e5\"\n"
        << "[system]\ndevice = \"ice40-hx8k\"\nlanes = 1\nreferences = 1\ntag_bits = 2\n"
        << "counter_bits = 0\noperands = \"refetched\"\ntarget_mhz = 50\n";
  }

  /// The beginning of each fake Yosys here: it answers the question for its version.
  static std::string answers_version() {
    return "case \"$*\" in *-V*) echo Yosys 9.9; exit;; esac\n";
  }

  nlohmann::json routed(const std::string& arguments) {
    const Outcome run = mixcmp("route scene.toml --json --seeds 1 " + arguments);
    EXPECT_EQ(run.exit_code, 0) << run.output;
    return nlohmann::json::parse(run.output);
  }
};

TEST_F(RouteCommand, ReferencesAloneAreSmallerThanTheSystemAroundOne) {
  const auto alone = routed("--references-alone 2"), system = routed("");
  EXPECT_GT(system["lut"]["used"], alone["lut"]["used"]);
  EXPECT_GT(alone["lut"]["used"], 20);
  EXPECT_EQ(alone["memory"]["used"], 0);
  EXPECT_EQ(system.at("top"), "order_s4e5_1x1");
  for (const auto& report : {alone, system}) {
    EXPECT_EQ(report.at("clock").at("source"), "routed") << report;
    EXPECT_GT(report.at("clock").at("mhz"), 10) << report;
  }
}

TEST_F(RouteCommand, AFailureSaysWhereTheToolsLogIs) {
  const std::string broken = instead_of(
      "yosys", "case \"$*\" in *-V*) echo Yosys 9.9; exit;; esac\necho something broke; exit 1");
  for (const char* option : {"", " --work kept", " --work kept --target-mhz 300"}) {
    const Outcome run = mixcmp(fmt::format("route scene.toml{}", option), broken);
    EXPECT_EQ(run.exit_code, 1) << run.output;
    const std::size_t begin = run.output.find('/'), end = run.output.find("/map.log");
    ASSERT_LT(begin, end) << run.output;
    ASSERT_NE(end, std::string::npos) << run.output;
    EXPECT_EQ(read(run.output.substr(begin, end - begin) + "/map.log"), "something broke\n");
  }
  using Entries = std::filesystem::directory_iterator;
  EXPECT_EQ(std::distance(Entries(path("kept")), Entries()), 2) << "each job has its own folder";
}

TEST_F(RouteCommand, AnInterruptedRunLeavesWhatIsKept) {
  mixcmp("route scene.toml --work kept",
         instead_of("yosys", answers_version() + "echo first; exit 1"));
  ASSERT_NE(shell("cat " + path("kept").string() + "/*/map.log").output.find("first"),
            std::string::npos);
  const std::string slow = instead_of(
      "yosys", answers_version() + "echo second; touch '" + path("asked").string() + "'; sleep 60");
  const std::string run = fmt::format(
      "cd '{0}' && {{ {1} '{2}' route scene.toml --work kept & }}; "
      "while ! test -e asked; do sleep 0.1; done; kill -TERM $!; wait $!",
      directory_.path().string(), slow, MIXCMP_PROGRAM);
  EXPECT_EQ(shell(run).exit_code, 128 + SIGTERM);
  EXPECT_EQ(shell("cat " + path("kept").string() + "/*/map.log").output, "first\n");
}

TEST_F(RouteCommand, WhatIsKeptReplacesNoInput) {
  mixcmp("route scene.toml --work kept", instead_of("yosys", answers_version() + "exit 1"));
  const fs::path folder = *fs::directory_iterator(path("kept"));
  fs::copy_file(path("scene.toml"), folder / "scene.toml");
  const Outcome run = mixcmp("route --work kept " + (folder / "scene.toml").string(),
                             instead_of("yosys", answers_version() + "exit 1"));
  EXPECT_EQ(run.exit_code, 1) << run.output;
  EXPECT_NE(run.output.find("holds an input"), std::string::npos) << run.output;
  EXPECT_TRUE(fs::exists(folder / "scene.toml"));
}

/// A router that is installed but once fails to print its version is an error. It is not a missing
/// router: measurements without it would be kept.
TEST_F(RouteCommand, ARouterThatBreaksOnceIsNotMissing) {
  const std::string broken =
      instead_of("nextpnr-ice40", "case \"$*\" in *--version*) exit 1;; esac");
  const Outcome run = mixcmp("route scene.toml", broken);
  EXPECT_EQ(run.exit_code, 1) << run.output;
  EXPECT_NE(run.output.find("nextpnr-ice40 --version"), std::string::npos) << run.output;
}

TEST_F(RouteCommand, ANumberOfReferencesIsAskedFor) {
  expect_refused("route scene.toml --references-alone 0", "--references-alone");
}

}  // namespace
}  // namespace mixcmp::test::route_command_test
