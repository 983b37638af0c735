#include <gtest/gtest.h>

#include <fstream>

#include "generator/present/report/summary_report.hpp"
#include "model/base/number/exact.hpp"
#include "model/base/number/verdict.hpp"
#include "model/judge/golden/evaluate.hpp"
#include "tests/support/scratch_directory.hpp"

/// Tests [comparison] with several parts.
namespace mixcmp::test::parts_test {
namespace {

class PartsTest : public testing::Test {
protected:
  Result<scene::Scene> load(const std::string& comparison) {
    std::filesystem::remove(path_);
    std::ofstream(path_) << "[comparison]\nname = \"n\"\n"
                         << comparison
                         << "[let]\nD = \"3\"\nstep = \"k + 1\"\n"
                            "[reference]\nformat = \"binary32\"\n";
    return scene::load_scene(path_, {});
  }

  void expect_mistake(const std::string& comparison, const std::string& error) {
    const Result<scene::Scene> scene = load(comparison);
    ASSERT_FALSE(scene.ok()) << comparison;
    EXPECT_EQ(scene.error().to_string(), path_.string() + error);
  }

private:
  test::ScratchDirectory directory_;
  std::filesystem::path path_ = directory_.path() / "scene.toml";
};

TEST_F(PartsTest, ListsAreOnePartEach) {
  const auto scene = load("f = [\"a\", \"b - c\"]\ng = [\"b\", \"a\"]\ncombine = \"any\"\n");
  ASSERT_TRUE(scene.ok()) << scene.error().to_string();
  ASSERT_EQ(scene->graph.parts().size(), 2u);
  EXPECT_EQ(scene->graph.combination(), Combination::any);
  EXPECT_EQ(scene->graph.inputs(), (std::vector<std::string>{"a", "b", "c"}));
  EXPECT_EQ(scene->graph.part(1).g(), scene->graph.part(0).f()) << "one node, a";
  EXPECT_EQ(scene->f_text(), "a; b - c");
}

TEST_F(PartsTest, APartThatIsAnotherAgainIsLeftOut) {
  const auto scene =
      load("f = [\"a + b\", \"c\", \"b + a\"]\ng = [\"c\", \"a + b\", \"c\"]\ncombine = \"all\"\n");
  ASSERT_TRUE(scene.ok()) << scene.error().to_string();
  EXPECT_EQ(scene->graph.parts().size(), 2u);
  EXPECT_EQ(scene->f_text(), "a + b; c");
  ASSERT_FALSE(scene->notes.empty());
  EXPECT_EQ(scene->notes.front(), "the part \"b + a\" against \"c\" is part 0 again: left out");
}

TEST_F(PartsTest, AnIndexIsOnePartForEachOfItsValues) {
  const auto scene =
      load("for = \"k in 0..D-1\"\nf = \"p[k] + k\"\ng = \"q[k]\"\ncombine = \"all\"\n");
  ASSERT_TRUE(scene.ok()) << scene.error().to_string();
  ASSERT_EQ(scene->graph.parts().size(), 3u);
  EXPECT_EQ(scene->graph.combination(), Combination::all);
  EXPECT_EQ(scene->graph.inputs(),
            (std::vector<std::string>{"p_0", "q_0", "p_1", "q_1", "p_2", "q_2"}));
  EXPECT_EQ(scene->parts[2].f, "p[k] + k where k = 2");
  const std::string text = report::to_text(scene::summarise(*scene, nullptr));
  EXPECT_NE(text.find("3, combined by \"all\""), std::string::npos) << text;
  EXPECT_NE(text.find("g[2] negative"), std::string::npos) << text;
}

TEST_F(PartsTest, ListsHaveAllTheirPartsForEachValueOfAnIndex) {
  const auto scene = load(
      "for = \"k in 1..2\"\nf = [\"a[k]\", \"b[k]\"]\ng = [\"c[k]\", \"k\"]\ncombine = \"all\"\n");
  ASSERT_TRUE(scene.ok()) << scene.error().to_string();
  ASSERT_EQ(scene->parts.size(), 4u);
  EXPECT_EQ(scene->graph.inputs(),
            (std::vector<std::string>{"a_1", "c_1", "b_1", "a_2", "c_2", "b_2"}));
  EXPECT_EQ(scene->parts[3].f, "b[k] where k = 2");
  EXPECT_EQ(scene->parts[3].g, "k where k = 2");
}

TEST_F(PartsTest, AsManyPartsAsTheLimitAreTaken) {
  const auto indexed = load("for = \"k in 1..64\"\nf = \"a[k]\"\ng = \"1\"\ncombine = \"all\"\n");
  ASSERT_TRUE(indexed.ok()) << indexed.error().to_string();
  EXPECT_EQ(indexed->parts.size(), scene::max_parts);
}

TEST_F(PartsTest, AllTakesTheLastVerdictAndAnyTheFirst) {
  const auto scene = load("f = [\"a\", \"b\"]\ng = [\"1\", \"1\"]\ncombine = \"all\"\n");
  const auto bits = [&](int value) {
    return from_rational(scene->reference.format, mpq_class(value));
  };
  const auto verdict = [&](Bits a, Bits b) {
    return golden::true_verdict(scene->graph, scene->reference.format, std::vector{a, b});
  };
  EXPECT_EQ(verdict(bits(0), bits(0)), Verdict::less);
  EXPECT_EQ(verdict(bits(0), bits(1)), Verdict::equal);
  EXPECT_EQ(verdict(bits(2), scene->reference.format.quiet_nan()), Verdict::greater);
  EXPECT_EQ(verdict(bits(1), scene->reference.format.quiet_nan()), Verdict::unordered);
}

TEST_F(PartsTest, MistakesNameTheirPlace) {
  expect_mistake("f = [\"a\", \"b\"]\ng = [\"b\", \"a\"]\n",
                 ":1: comparison.combine: missing: it says what the verdicts of several parts make "
                 "together: received nothing; accepted \"all\" or \"any\"");
  expect_mistake("f = \"a\"\ng = \"b\"\ncombine = \"all\"\n",
                 ":5: comparison.combine: there is nothing to combine: received one f and one g; "
                 "accepted lists of f and g, or an index: for = \"k in 0..2\"");
  expect_mistake("f = [\"a\", \"b\"]\ng = [\"b\"]\ncombine = \"all\"\n",
                 ":4: comparison.g: f and g are the sides of the same parts: received a list of 1; "
                 "accepted a list of 2, as f is");
  expect_mistake("f = [\"a\", \"b\"]\ng = \"b\"\ncombine = \"all\"\n",
                 ":4: comparison.g: f and g are the sides of the same parts: received a string; "
                 "accepted a list of 2, as f is");
  expect_mistake("f = [\"a\", 3]\ng = [\"b\", \"c\"]\ncombine = \"all\"\n",
                 ":3: comparison.f: not an expression in the list: received 3 (an integer); "
                 "accepted a string, or a list of strings, one for each part");
  expect_mistake("f = []\ng = []\ncombine = \"all\"\n",
                 ":3: comparison.f: an empty list: received an array of 0 (an array); accepted a "
                 "string, or a list of strings, one for each part");
  expect_mistake("f = [\"a\"]\ng = [\"b\"]\ncombine = \"most\"\n",
                 ":5: comparison.combine: not a choice: received \"most\"; accepted all, any");
  expect_mistake(
      "for = \"k in 0..32\"\nf = [\"a[k]\", \"1\"]\ng = [\"1\", \"a[k]\"]\ncombine = \"all\"\n",
      ":3: comparison.for: too many parts: received \"k in 0..32\"; accepted at most 32 "
      "values");
  expect_mistake("for = \"k in 0..64\"\nf = \"a[k]\"\ng = \"1\"\ncombine = \"all\"\n",
                 ":3: comparison.for: too many parts: received \"k in 0..64\"; accepted at most 64 "
                 "values");
}

/// A let sees no index: the index's name inside a let would be an input.
TEST_F(PartsTest, AnIndexMayNotHaveAnInputsName) {
  expect_mistake(
      "for = \"k in 0..2\"\nf = \"a[k] + step\"\ng = \"k\"\ncombine = \"all\"\n",
      ":3: comparison.for: the index k has the name of an input: received \"k in 0..2\"; accepted "
      "a name of no let, function or input");
}

TEST_F(PartsTest, AnExpressionsErrorNamesItsColumnInTheList) {
  const auto scene = load(
      "f = [\"b * a\", \"b\", \"a b\"]\ng = [\"b\", \"1\", \"2\"]\n"
      "combine = \"all\"\n");
  ASSERT_FALSE(scene.ok());
  EXPECT_EQ(scene.error().line, 3);
  EXPECT_EQ(scene.error().column, 23);
  EXPECT_EQ(scene.error().field, "comparison.f");
}

}  // namespace
}  // namespace mixcmp::test::parts_test
