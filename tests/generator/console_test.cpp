#include <fmt/core.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/support/program.hpp"

/// A run's messages beside its results: errors as JSON, notes, progress and colors.
namespace mixcmp::test::console_test {
namespace {

class Console : public ProgramTest {
protected:
  Console() {
    write("data.csv", "a,b,c\n1,2,3\n4,5,6\n9,8,7\n");
    write("scene.toml",
          "[comparison]\nname = \"scene\"\nf = \"a * c\"\ng = \"a * b\"\n"
          "[reference]\nformat = \"binary32\"\n[reduced]\nformat = \"s8e8\"\n"
          "[system]\nlanes = 1\nreferences = 1\n[data]\nfile = \"data.csv\"\n");
  }

  /// The one JSON object on standard output; discarded where there is none, or more than that.
  nlohmann::json output_of(const std::string& arguments, int exit_code) {
    const Outcome run = mixcmp(arguments + " 2>/dev/null");
    EXPECT_EQ(run.exit_code, exit_code) << arguments << "\n" << run.output;
    auto json = nlohmann::json::parse(run.output, nullptr, false);
    EXPECT_FALSE(json.is_discarded()) << arguments << "\n" << run.output;
    return json;
  }

  Outcome on_terminal(const std::string& arguments, const std::string& environment) {
    return shell(fmt::format("cd '{}' && {} script -qec \"'{}' {}\" /dev/null </dev/null",
                             directory_.path().string(), environment, MIXCMP_PROGRAM, arguments));
  }
};

TEST_F(Console, AnErrorIsOneObjectUnderJson) {
  const auto unknown = output_of("check scene.toml --json --set system.lnes=3", 1).at("error");
  EXPECT_EQ(unknown.at("file"), "--set");
  EXPECT_EQ(unknown.at("field"), "system.lnes");
  EXPECT_EQ(unknown.at("message"), "unknown key");
  EXPECT_EQ(unknown.at("received"), "lnes");
  EXPECT_EQ(unknown.at("accepted").get<std::string>().rfind("lanes (the nearest)", 0), 0u);
  EXPECT_EQ(unknown.at("text").get<std::string>().rfind("--set: system.lnes: unknown key", 0), 0u);
  write("wrong.toml", "[comparison]\nname = \"n\"\nf = \"a +\"\ng = \"b\"\n");
  const auto placed = output_of("generate wrong.toml -o rtl --json", 1).at("error");
  EXPECT_EQ(placed.at("line"), 3);
  EXPECT_EQ(placed.at("column"), 9);
  EXPECT_EQ(output_of("check --json", 1).at("error").at("field"), "check");
  EXPECT_EQ(output_of("chek --json", 1).at("error").at("message"), "unknown verb");
}

/// A run that fails after its result was printed adds no second object.
TEST_F(Console, ThereIsOneObjectThoughARunFails) {
  write("fails.toml",
        read("scene.toml") + "[[variant]]\nname = \"other\"\nf = \"a * b\"\ng = \"a * c\"\n");
  const auto differs = output_of("check fails.toml --json", 2);
  EXPECT_TRUE(differs.contains("variants"));
  EXPECT_FALSE(differs.contains("error"));
  const auto junit = output_of("verify scene.toml --json --simulator icarus --junit /dev/full", 1);
  EXPECT_TRUE(junit.contains("error")) << "the result is printed when all files are written";
  EXPECT_EQ(mixcmp("check none.toml 2>/dev/null").output, "") << "without --json";
}

TEST_F(Console, QuietLeavesOutNotesAndProgressButNoErrors) {
  const std::string slow =
      instead_of("iverilog", "[ \"$1\" != -V ] || { echo 1.0; exit; }\nsleep 4; exit 1");
  const std::string verify = "verify scene.toml --simulator icarus";
  const Outcome told = mixcmp(verify + " 2>&1 >/dev/null", slow);
  EXPECT_EQ(told.progress.rfind("mixcmp: progress: ", 0), 0u)
      << "a log gets a line of progress after two seconds\n"
      << told.output;
  const Outcome quiet = mixcmp(verify + " --quiet 2>&1 >/dev/null", slow);
  EXPECT_EQ(quiet.exit_code, told.exit_code);
  EXPECT_EQ(quiet.progress, "");
  EXPECT_NE(quiet.output.find("mixcmp: "), std::string::npos) << "the error stays";
}

TEST_F(Console, ColorsAreForTerminalsThatWantThem) {
  if (shell("command -v script").exit_code != 0) GTEST_SKIP() << "no script(1), of bsdutils";
  const std::string red = "\x1b[1;31mmixcmp:\x1b[0m none.toml: ";
  const auto has_red = [&](const Outcome& run) {
    EXPECT_NE(run.output.find("none.toml: cannot read the file"), std::string::npos) << run.output;
    return run.output.find(red) != std::string::npos;
  };
  EXPECT_TRUE(has_red(on_terminal("check none.toml", "TERM=xterm NO_COLOR=")));
  EXPECT_FALSE(has_red(on_terminal("check none.toml", "TERM=xterm NO_COLOR=1")));
  EXPECT_FALSE(has_red(on_terminal("check none.toml", "TERM=dumb")));
  EXPECT_FALSE(has_red(mixcmp("check none.toml", "TERM=xterm")));
  EXPECT_EQ(on_terminal("check none.toml", "TERM=dumb").output.find('\x1b'), std::string::npos);
}

TEST_F(Console, HintsNameWhatWasMeant) {
  expect_refused("optimize scene.toml", "accepted optimise (the nearest)");
  expect_refused("verify scene.toml --simulator verilater", "accepted verilator (the nearest), ");
  expect_refused("profile scene.toml --bounds fixednorm", "accepted fixed_norm (the nearest); ");
  expect_refused("check scene.toml --device xc7a15t",
                 "received \"xc7a15t\"; accepted xc7a25t, xc7a35t, ");
}

}  // namespace
}  // namespace mixcmp::test::console_test
