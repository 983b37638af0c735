#include <fmt/core.h>

#include <string>

#include "tests/support/program.hpp"

/// Scenes whose modules would have names that not every tool takes.
namespace mixcmp::test::long_names_test {
namespace {

namespace fs = std::filesystem;

class LongNames : public ProgramTest {
protected:
  /// One lane of each format. `sections`: further ones.
  void write_kinds(const std::string& name, int first, int last,
                   const std::string& sections = "") const {
    std::string text = scene("s", sections);
    for (int bits = first; bits <= last; ++bits) {
      text += fmt::format("[[lanes]]\ncount = 1\nformat = \"q{}\"\n", bits);
    }
    write(name, text);
  }

  static std::string scene(const std::string& name, const std::string& system) {
    return fmt::format(
        "[comparison]\nname = \"{}\"\nf = \"abs(a_i - a_j)\"\ng = \"abs(b_i - b_j)\"\n"
        "[inputs]\n\"*\" = {{ range = [0, 1] }}\n[reference]\nformat = \"binary64\"\n"
        "[system]\nreferences = 1\n{}",
        name, system);
  }

  /// The longest name of a module in the folder.
  std::size_t longest_module(const std::string& folder) const {
    std::size_t longest = 0;
    for (const auto& entry : fs::recursive_directory_iterator(path(folder))) {
      if (entry.path().extension() != ".v") continue;
      longest = std::max(longest, entry.path().stem().string().size());
    }
    return longest;
  }
};

TEST_F(LongNames, ManyKindsOfLanesAreCountedInTheTop) {
  write_kinds("many.toml", 8, 31);
  const Outcome run = mixcmp("generate many.toml -o many --no-prove --project vivado");
  ASSERT_EQ(run.exit_code, 0) << run.output;
  EXPECT_TRUE(fs::exists(path("many/s_24kinds_5f93df3dx1.v")));
  EXPECT_LE(longest_module("many"), 127u);
  // Newer Verilators report on themselves in lines that start with a dash.
  const Outcome lint =
      shell(fmt::format("cd '{}' && verilator --lint-only -Wall --top-module s_24kinds_5f93df3dx1 "
                        "-F many/s_24kinds_5f93df3dx1.f 2>&1 | sed '/^- /d'",
                        path("").string()));
  EXPECT_EQ(lint.output, "");
}

TEST_F(LongNames, OtherKindsHaveAnotherTop) {
  write_kinds("many.toml", 9, 32);
  ASSERT_EQ(mixcmp("generate many.toml -o many --no-prove").exit_code, 0);
  EXPECT_FALSE(fs::exists(path("many/s_24kinds_5f93df3dx1.v")));
}

TEST_F(LongNames, AListThatEveryToolTakesIsTheTopsName) {
  write_kinds("twenty.toml", 8, 27);
  const Outcome run = mixcmp("generate twenty.toml -o twenty --no-prove --project vivado");
  ASSERT_EQ(run.exit_code, 0) << run.output;
  const std::string top =
      "s_q8_1_q9_1_q10_1_q11_1_q12_1_q13_1_q14_1_q15_1_q16_1_q17_1_q18_1_q19_1_q20_1_q21_1_q22_1_"
      "q23_1_q24_1_q25_1_q26_1_q27_1x1";
  EXPECT_TRUE(fs::exists(path("twenty/" + top + ".v")));
  EXPECT_TRUE(fs::exists(path("twenty/integration/" + top + "_io.v")));
  EXPECT_LE(longest_module("twenty"), 127u);
}

TEST_F(LongNames, AnEnginesNameCounts) {
  write_kinds("pairs.toml", 8, 27, "[engine]\nkind = \"pairwise\"\ncapacity = 64\n");
  const Outcome run = mixcmp("generate pairs.toml -o pairs --no-prove");
  ASSERT_EQ(run.exit_code, 0) << run.output;
  EXPECT_LE(longest_module("pairs"), 127u);
}

TEST_F(LongNames, ANameIsRefusedByEveryVerb) {
  write("long.toml", scene(std::string(200, 's'), "lanes = 1\n[reduced]\nformat = \"q8\"\n"));
  for (const char* verb : {"check", "generate", "verify"}) {
    expect_refused(fmt::format("{} long.toml", verb), "comparison.name: the name is too long");
  }
}

TEST_F(LongNames, AModulesNameIsRefusedByEveryVerbThatWritesIt) {
  write("data.csv", "a_i,a_j,b_i,b_j\n0.5,0.25,0.75,0.125\n");
  write("long.toml", scene(std::string(64, 's'), "prefix = \"" + std::string(32, 'p') + "\"\n") +
                         "[[lanes]]\ncount = 1\nformat = \"s12e11\"\nmultipliers = \"logic\"\n"
                         "[[lanes]]\ncount = 1\nformat = \"s12e11\"\nmultipliers = \"embedded\"\n"
                         "[data]\nfile = \"data.csv\"\n");
  const std::string error = "comparison.name: with system.prefix and the lanes' formats";
  expect_refused("generate long.toml", error);
  expect_refused("verify long.toml --simulator icarus", error);
  const Outcome check = mixcmp("check long.toml");
  EXPECT_NE(check.output.find(error), std::string::npos) << check.output;
  EXPECT_NE(check.output.find("characters; accepted a shorter name or prefix: 127 characters"),
            std::string::npos)
      << check.output;
}

}  // namespace
}  // namespace mixcmp::test::long_names_test
