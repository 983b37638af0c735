#include <gtest/gtest.h>

#include <bit>
#include <fstream>

#include "model/base/number/verdict.hpp"
#include "model/plan/profile/variant_check.hpp"
#include "model/scene/scene.hpp"
#include "tests/support/scratch_directory.hpp"

namespace mixcmp::test::variant_test {
namespace {

class Variants : public testing::Test {
protected:
  Result<scene::Scene> load(const std::string& variants, const std::string& chosen = "") {
    std::filesystem::remove(path_);
    std::ofstream(path_) << "[comparison]\nname = \"reach\"\nf = \"x^2 + y^2\"\ng = \"r^2\"\n"
                         << variants
                         << "[let]\nfar = \"sqrt(x^2 + y^2)\"\n"
                            "[reference]\nformat = \"binary64\"\n[reduced]\nformat = \"s8e8\"\n"
                            "[system]\nlanes = 1\nreferences = 1\n";
    std::vector<std::string> overrides;
    if (!chosen.empty()) overrides.push_back("comparison.variant=" + chosen);
    return scene::load_scene(path_, overrides);
  }

  std::string error(const std::string& variants, const std::string& chosen = "") {
    const Result<scene::Scene> scene = load(variants, chosen);
    if (scene.ok()) return "";
    std::string text = scene.error().to_string();
    const std::string folder = directory_.path().string() + "/";
    while (text.find(folder) != std::string::npos) text.erase(text.find(folder), folder.size());
    return text;
  }

  static std::string variant(const std::string& name, const std::string& keys) {
    return "[[variant]]\nname = \"" + name + "\"\n" + keys;
  }

  test::ScratchDirectory directory_;
  std::filesystem::path path_ = directory_.path() / "scene.toml";
  std::string root_ = variant("root", "f = \"far\"\ng = \"r\"\n");
};

data::Table points(std::initializer_list<double> values) {
  data::Table table{.format = FloatFormat::make(53, 11).value(),
                    .columns = {"x", "y", "r"},
                    .values = {},
                    .labels = {}};
  for (const double value : values) {
    table.values.push_back(std::bit_cast<std::uint64_t>(value));
  }
  return table;
}

TEST_F(Variants, WithoutAChoiceTheComparisonIsAsWritten) {
  const Result<scene::Scene> scene = load(root_);
  ASSERT_TRUE(scene.ok()) << scene.error().to_string();
  EXPECT_EQ(scene->name, "reach");
  EXPECT_EQ(scene->variant, "");
  EXPECT_EQ(scene->variants, std::vector<std::string>{"root"});
  EXPECT_EQ(scene->f_text(), "x^2 + y^2");
  EXPECT_TRUE(scene->lets.empty());
  EXPECT_TRUE(scene->notes.empty()) << scene->notes[0];  // `far` is used by a variant
}

TEST_F(Variants, TheChosenOneTakesTheComparisonsPlace) {
  const Result<scene::Scene> scene = load(root_, "root");
  ASSERT_TRUE(scene.ok()) << scene.error().to_string();
  EXPECT_EQ(scene->name, "reach_root");
  EXPECT_EQ(scene->variant, "root");
  EXPECT_EQ(scene->f_text(), "far");
  ASSERT_EQ(scene->lets.size(), 1u);
  EXPECT_EQ(scene->lets[0].name, "far");
  EXPECT_EQ(scene->lets[0].text, "sqrt(x^2 + y^2)");
  EXPECT_EQ(scene->g_text(), "r");
}

TEST_F(Variants, WhatAVariantDoesNotSayStays) {
  const Result<scene::Scene> scene = load(variant("sum", "f = \"y^2 + x^2\"\n"), "sum");
  ASSERT_TRUE(scene.ok()) << scene.error().to_string();
  EXPECT_EQ(scene->g_text(), "r^2");
}

TEST_F(Variants, TextsAreOnOneLineEach) {
  const Result<scene::Scene> scene =
      load(variant("lines", "f = \"\"\"\n  far\n  + 1\n\"\"\"\ng = \"r + 1\"\n"), "lines");
  ASSERT_TRUE(scene.ok()) << scene.error().to_string();
  EXPECT_EQ(scene->f_text(), "far + 1");
}

TEST_F(Variants, InputsKeepTheirOrder) {
  const Result<scene::Scene> scene =
      load(variant("swapped", "f = \"-r^2\"\ng = \"-(y^2 + x^2)\"\n"), "swapped");
  ASSERT_TRUE(scene.ok()) << scene.error().to_string();
  EXPECT_EQ(scene->graph.inputs(), (std::vector<std::string>{"x", "y", "r"}));
}

TEST_F(Variants, MistakesAreFoundInThoseNotChosenToo) {
  EXPECT_EQ(
      error(variant("bad", "f = \"x +\"\n")),
      "scene.toml:7:9: variant bad, f: unexpected end: received the end; accepted a number, a "
      "name, a function call, '(' or '-'");
  EXPECT_EQ(error(variant("bad", "f = \"x^2 + z\"\n")),
            "scene.toml:7: variant bad, f: f and g have other inputs than those at scene.toml:3: z "
            "is none of them, y is missing: received r, x, z; accepted x, y, r");
  EXPECT_EQ(error(root_ + root_),
            "scene.toml:10: variant.name: two variants have it: received \"root\"; accepted a name "
            "of its own");
  EXPECT_EQ(
      error(variant("empty", "")),
      "scene.toml:5: variant: says nothing of its own: received \"empty\"; accepted f, g or both");
  EXPECT_EQ(error(variant(std::string(64, 'a'), "f = \"x^2 + y^2\"\n")).substr(0, 28),
            "scene.toml:5: variant.name: ");
  EXPECT_EQ(error("[[variant]]\nf = \"x\"\n").substr(0, 36),
            "scene.toml:5: variant.name: missing:");
  EXPECT_EQ(error(variant("bad", "h = \"x\"\n")).substr(0, 43),
            "scene.toml:7: variant bad, h: unknown key: ");
  EXPECT_EQ(error("[variant]\nname = \"x\"\n").substr(0, 46),
            "scene.toml:5: variant: not a list of tables: r");
  EXPECT_EQ(error(variant("none", "f = \"x^2\"\n")).substr(0, 27), "scene.toml:6: variant.name:");
  EXPECT_EQ(error(variant("module", "f = \"x\"\n")).substr(0, 27), "scene.toml:6: variant.name:");
}

TEST_F(Variants, AChoiceMustBeThere) {
  EXPECT_EQ(error(root_, "rot"),
            "--set: comparison.variant: no such variant: received \"rot\"; accepted root (the "
            "nearest), none");
  EXPECT_EQ(error("", "root"),
            "--set: comparison.variant: the scene has no [[variant]], and mixcmp finds no other "
            "formulation: received \"root\"; accepted none");
}

TEST_F(Variants, TheSquareAndTheRootDecideAlikeOnTiesToo) {
  const scene::Scene given = load(root_).value(), root = load(root_, "root").value();
  const auto data = data::Comparisons::rows(
                        points({3, 4, 5, 1, 1, 1.4142135623730951, 0, 0, 0, 1e-200, 0, 2e-200}),
                        given.graph.inputs())
                        .value();
  const profile::VariantCheck check = profile::check_variant(given, root, data);
  EXPECT_EQ(check.comparisons, 4u);
  EXPECT_EQ(check.differences, 0u);
  // In binary64 all squares of the last row underflow, to a tie; its radius does not. And the
  // second row's root rounds to its radius.
  EXPECT_EQ(check.reference_differences, 2u);
}

TEST_F(Variants, ATieOfRootsIsTold) {
  const std::string twice = variant("twice", "f = \"far + sqrt(2)\"\ng = \"r + sqrt(2)\"\n");
  const scene::Scene given = load(twice).value(), roots = load(twice, "twice").value();
  const auto data =
      data::Comparisons::rows(points({3, 4, 5, 1, 0, 2}), given.graph.inputs()).value();
  const profile::VariantCheck check = profile::check_variant(given, roots, data);
  EXPECT_EQ(check.differences, 0u);
  EXPECT_EQ(check.undetermined, 0u);
}

TEST_F(Variants, ATieOfManyRootsIsNotTold) {
  // In two orders: equal terms of equal sums would be told to be equal.
  std::string roots, reversed;
  for (int k = 2; k < 9; ++k) {
    const std::string root = " + sqrt(r + sqrt(" + std::to_string(k) + "))";
    roots += root;
    reversed.insert(0, root);
  }
  const std::string many = variant("many", "f = \"far" + roots + "\"\ng = \"r" + reversed + "\"\n");
  const scene::Scene given = load(many).value(), variant = load(many, "many").value();
  const auto data =
      data::Comparisons::rows(points({3, 4, 5, 1, 0, 2}), given.graph.inputs()).value();
  const profile::VariantCheck check = profile::check_variant(given, variant, data);
  EXPECT_EQ(check.differences, 0u);
  EXPECT_EQ(check.undetermined, 1u);
}

TEST_F(Variants, ANegativeRadiusConvictsTheRoot) {
  const scene::Scene given = load(root_).value(), root = load(root_, "root").value();
  const auto data =
      data::Comparisons::rows(points({1, 0, 2, 1, 0, -2, 3, 0, -2}), given.graph.inputs()).value();
  const profile::VariantCheck check = profile::check_variant(given, root, data);
  EXPECT_EQ(check.differences, 1u);
  ASSERT_TRUE(check.first_difference);
  EXPECT_EQ(check.first_difference->index, 1u);
  EXPECT_EQ(check.first_difference->given, Verdict::less);
  EXPECT_EQ(check.first_difference->variant, Verdict::greater);
}

TEST_F(Variants, ASampleIsSpreadOverAll) {
  const scene::Scene given = load(root_).value(), root = load(root_, "root").value();
  const auto data =
      data::Comparisons::rows(points({1, 0, 2, 1, 0, 2, 1, 0, 2, 1, 0, -2}), given.graph.inputs())
          .value();
  EXPECT_EQ(profile::check_variant(given, root, data, 3).differences, 0u);
  EXPECT_EQ(profile::check_variant(given, root, data, 3).comparisons, 3u);
  EXPECT_EQ(profile::check_variant(given, root, data, 4).differences, 1u);
}

}  // namespace
}  // namespace mixcmp::test::variant_test
