#include "generator/project/switching_files.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "model/base/common/file.hpp"
#include "model/base/common/output_file.hpp"
#include "model/base/common/process.hpp"
#include "tests/support/scratch_directory.hpp"

/// The rule in C and in Python against optimise::SwitchingRule.
namespace mixcmp::test::switching_files_test {
namespace {

using optimise::RatePoint;
using optimise::SwitchingRule;

constexpr const char* c_program = R"c(
#include <inttypes.h>
#include <stdio.h>
#include "switching.h"
int main(void) {
  struct two_spheres_switching state = TWO_SPHERES_SWITCHING_START;
  uint64_t comparisons, recomputations;
  while (scanf("%" SCNu64 " %" SCNu64, &comparisons, &recomputations) == 2) {
    printf("%d\n", two_spheres_next_plan(&state, comparisons, recomputations));
  }
  return 0;
}
)c";

constexpr const char* python_program = R"py(
import sys
import switching
rule = switching.Switching()
for line in sys.stdin:
    print(rule.next_plan(*map(int, line.split())))
)py";

/// Rules whose points are in no order and may share a rate, and readings of their counters.
class RandomRule {
public:
  explicit RandomRule(unsigned seed) : engine_(seed), plans_(1 + seed % 4) {}

  SwitchingRule rule() {
    std::vector<std::vector<RatePoint>> points(plans_);
    const int sets = number(1, 6);
    for (auto& own : points) {
      for (int s = 0; s < sets; ++s) {
        own.push_back({.rate = number(0, 12) * 1e-3 / 7, .seconds = {}});
        for (int k = 0; k < plans_; ++k) own.back().seconds.push_back(1e-9 / number(1, 97));
      }
    }
    return {std::move(points), 1e-3 * number(1, 30) / 7};
  }

  std::vector<std::pair<std::uint64_t, std::uint64_t>> readings() {
    std::vector<std::pair<std::uint64_t, std::uint64_t>> all = {{0, 0}, {1, 1}, {7, 0}};
    for (int k = 0; k < 3000; ++k) {
      const double words = std::pow(10, number(0, 900) / 100.0);
      all.emplace_back(std::llround(words), std::llround(words * number(0, 140) / 7e4));
    }
    return all;
  }

private:
  int number(int least, int most) {
    return std::uniform_int_distribution<int>(least, most)(engine_);
  }

  std::mt19937 engine_;
  int plans_;
};

std::string output_of(const Command& words, const std::string& input) {
  const auto run = capture(words, {.input = input});
  EXPECT_TRUE(run.ok() && run->succeeded()) << (run.ok() ? run->errors : run.error().to_string());
  return run.ok() ? run->output + run->errors : "";
}

TEST(SwitchingFiles, LoadThePlansOfTheRule) {
  for (unsigned seed = 0; seed < 4; ++seed) {
    RandomRule random(seed);
    SwitchingRule rule = random.rule();
    std::vector<int> words;
    std::vector<std::string> about;
    for (std::size_t k = 0; k < rule.points().size(); ++k) {
      words.push_back(1 << k);
      about.push_back("made up");
    }
    const ScratchDirectory scratch;
    for (const emit::GeneratedFile& file :
         project::switching_files({rule, "two-spheres", "mixcmp", about, words})) {
      ASSERT_TRUE(write_file(scratch.path() / file.name, file.text).ok());
    }
    ASSERT_TRUE(write_file(scratch.path() / "run.c", c_program).ok());
    ASSERT_TRUE(write_file(scratch.path() / "run.py", python_program).ok());
    std::string input, expected;
    std::size_t switches = 0;
    for (const auto& [counted, recomputed] : random.readings()) {
      const std::size_t before = rule.loaded();
      input += fmt::format("{} {}\n", counted, recomputed);
      expected += fmt::format("{}\n", rule.next(counted * words[before], recomputed) + 1);
      if (rule.loaded() != before) ++switches;
    }
    EXPECT_EQ(switches > 10, words.size() > 1) << "seed " << seed;
    const std::string program = (scratch.path() / "run").string();
    const std::string source = program + ".c";
    for (const char* language : {"-std=c99", "-xc++"}) {
      EXPECT_EQ(output_of({"gcc", language, "-Wall", "-Wextra", "-Wpedantic", "-Wconversion",
                           "-Werror", "-O1", "-o", program, source},
                          ""),
                "");
      EXPECT_EQ(output_of({program}, input), expected) << "seed " << seed << ", " << language;
    }
    EXPECT_EQ(output_of({"python3", "-B", program + ".py"}, input), expected) << "seed " << seed;
  }
}

}  // namespace
}  // namespace mixcmp::test::switching_files_test
