#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "tests/support/scratch_directory.hpp"
#include "tests/support/simulated_system.hpp"

/// The examples of functions through the program itself: every comparison of their data by lanes of
/// 16 bits and by the reference, against MPFR.
namespace mixcmp::test::functions_example_test {
namespace {

namespace fs = std::filesystem;

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

class FunctionsExample : public testing::TestWithParam<const char*> {};

TEST_P(FunctionsExample, NoVerdictIsWrong) {
  const fs::path work = test_work_dir(std::string("functions_") + GetParam());
  fs::create_directories(work);
  const fs::path scene =
      fs::path(MIXCMP_SOURCE_DIR) / "examples/functions" / (std::string(GetParam()) + ".toml");
  const fs::path report = work / "profile.json";
  const std::string command = std::string(MIXCMP_PROGRAM) + " profile " + scene.string() +
                              " --first 16 --last 16 --brute-force --quiet --json > " +
                              report.string();
  ASSERT_EQ(std::system(command.c_str()), 0);
  std::ifstream stream(report);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  EXPECT_GE(count_of(text, "\"wrong\": "), 1U) << text;
  EXPECT_EQ(count_of(text, "\"wrong\": "), count_of(text, "\"wrong\": 0")) << text;
  EXPECT_EQ(count_of(text, "\"reference_wrong\": 0"), 1U) << text;
  EXPECT_EQ(count_of(text, "\"truth_undetermined\": 0"), 1U) << text;
  EXPECT_EQ(count_of(text, "\"undecided\": 0,"), 0U) << "lanes of 16 bits leave some undecided";
}

INSTANTIATE_TEST_SUITE_P(Scenes, FunctionsExample,
                         testing::Values("metropolis", "em", "trigger", "haversine", "decay"),
                         [](const auto& scene) { return std::string(scene.param); });

}  // namespace
}  // namespace mixcmp::test::functions_example_test
