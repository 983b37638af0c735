#include "tests/model/scene/scene_fixture.hpp"

namespace mixcmp::test::override_test {
namespace {

/// Loads scenes, and gives errors with "scene.toml" in place of the scene's path.
class OverrideTest : public SceneTest {
protected:
  std::string error(const std::vector<std::string>& overrides,
                    const std::string& text = sphere_scene) {
    const Result<scene::Scene> scene = load(text, overrides);
    EXPECT_FALSE(scene.ok());
    std::string told = scene.ok() ? "" : scene.error().to_string();
    const std::string path = path_.string();
    for (std::size_t at = told.find(path); at != std::string::npos; at = told.find(path)) {
      told.replace(at, path.size(), "scene.toml");
    }
    return told;
  }
};

TEST_F(OverrideTest, WinAndTakeBareWords) {
  const Result<scene::Scene> scene =
      load(sphere_scene, {"data.radius_max=5", "reduced.format=s24e8", "system.order = \"tagged\"",
                          "inputs.r*={ range = [0, 5] }", "comparison.g=(ri + rj)^2 * 1"});
  ASSERT_FALSE(scene.ok());  // "order " with its space is another key
  EXPECT_EQ(scene.error().file, "--set");
  EXPECT_EQ(scene.error().message, "unknown key");
  const Result<scene::Scene> good =
      load(sphere_scene,
           {"data.radius_max=5", "reduced.format=s24e8", "system.order=\"tagged\"",
            "system.lanes=auto", "inputs.r*={ range = [0, 5] }", "comparison.g=(ri + rj)^2 + ri"});
  ASSERT_TRUE(good.ok()) << good.error().to_string();
  EXPECT_EQ(good->data->radius_max, 5);
  EXPECT_EQ(good->reduced.format->name(), "s24e8");
  EXPECT_EQ(good->system.order, scene::ResultOrder::tagged);
  EXPECT_FALSE(good->system.lanes.has_value());
  EXPECT_EQ(good->ranges.at(7)->high, 5);
  EXPECT_EQ(good->g_text(), "(ri + rj)^2 + ri");
}

TEST_F(OverrideTest, MayMakeSections) {
  const std::string small =
      "[comparison]\nname = \"n\"\nf = \"x\"\ng = \"y\"\n[reference]\nformat = \"binary64\"\n";
  const Result<scene::Scene> scene = load(small, {"data.file=atoms.pdb", "data.pairs=all"});
  ASSERT_TRUE(scene.ok()) << scene.error().to_string();
  EXPECT_EQ(scene->data->file, directory_.path() / "atoms.pdb");
}

TEST_F(OverrideTest, AMistakeThatAnOverrideBringsAboutIsItsOwn) {
  EXPECT_EQ(error({"system.lanes=3", "comparison.f=[\"cxi\", \"cxj\"]"}),
            "--set comparison.f: comparison.g: f and g are the sides of the same parts (at "
            "scene.toml:4): received a string; accepted a list of 2, as f is");
  EXPECT_EQ(
      error({"reference.format=binary16"}),
      "--set reference.format: reduced.format: precision out of range (at scene.toml:14): "
      "received \"s17e8\"; accepted \"auto\", \"exact\", sP or sPeE with P 4..11 and E 2..15, or "
      "binary16, "
      "bfloat16; P at most the reference's; qW or blockW with W 2..11, likewise W + G of qWgG and "
      "blockWgG");
  EXPECT_EQ(error({"comparison.f=cxi", "comparison.g=cxj"}),
            "--set comparison.g: inputs.r*: matches no input of f and g (at scene.toml:8): "
            "received \"r*\"; accepted cxi, cxj");
  EXPECT_EQ(
      error({"data.file=a.csv"}),
      "--set: data.file: two sources of data: received items and file; accepted items = "
      "\"uniform\", \"uniform_spheres\" or \"sphere_family\", or file = a .pdb, .csv or .npy file");
}

TEST_F(OverrideTest, AMistakeOfTheSceneStaysTheScenes) {
  std::string text = sphere_scene;
  text.replace(text.find("slack = 0.25"), 12, "slack = 2.25");
  EXPECT_EQ(error({"system.lanes=3", "comparison.name=n"}, text),
            "scene.toml:23: system.slack: out of range: received 2.25; accepted a number from 0 to "
            "0.95");
}

TEST_F(OverrideTest, KeysBelowWhatHasNoneAreRefused) {
  EXPECT_EQ(error({"reduced.format.x=1"}),
            "--set: reduced.format: a string, which has no keys: received "
            "\"reduced.format.x=1\"; accepted reduced.format=VALUE");
  EXPECT_EQ(error({"comparison.f.g=1"}),
            "--set: comparison.f: a string, which has no keys: received \"comparison.f.g=1\"; "
            "accepted comparison.f=VALUE");
  EXPECT_EQ(error({"inputs.c*.range.x=1"}).substr(0, 50),
            "--set: inputs.c*.range: a list: its entries have n");
  EXPECT_EQ(error({"reduced.error_bound.x=1"}),
            "--set: reduced.error_bound: wrong type: received a table with the key \"x\" (a "
            "table); accepted a string");
  EXPECT_EQ(error({"data.columns.p.q=1"}),
            "--set: data.columns.p: not a column: received a table with the key \"q\"; accepted "
            "the name of a column, its number counted from 0, or a list of these");
  EXPECT_EQ(error({"inputs.cxi.rnge=[0, 1]"}),
            "--set: inputs.cxi.rnge: unknown key: received rnge; accepted range (the nearest), "
            "format, grid");
  for (const char* text : {"reduced..format=s8e8", ".reduced.format=s8e8", "reduced.=1", ".=1"}) {
    EXPECT_EQ(error({text}), std::string("--set: not an override: received \"") + text +
                                 "\"; accepted section.key=value");
  }
}

TEST_F(OverrideTest, MistakesNameTheOption) {
  EXPECT_EQ(error({"data.count"}),
            "--set: not an override: received \"data.count\"; accepted section.key=value");
  EXPECT_EQ(error({"count=3"}),
            "--set: not an override: received \"count=3\"; accepted section.key=value");
  EXPECT_EQ(error({"data.count=many"}),
            "--set: data.count: wrong type: received \"many\" (a string); accepted an integer "
            "1..16777216");
  EXPECT_EQ(
      error({"data.cuont=3"}),
      "--set: data.cuont: unknown key: received cuont; accepted count (the nearest), columns, "
      "family, file, items, pairs, radius_max, seed, side, with, with_columns, with_count");
  EXPECT_EQ(error({"dato.count=3"}).substr(0, 28), "--set: dato: unknown section");
  EXPECT_EQ(error({"comparison.f=cxi +* 2"}),
            "--set: comparison.f: unexpected character at character 6 of the text: received '*'; "
            "accepted a number, a name, a function call, '(' or '-'");
  EXPECT_EQ(error({"system.slack=1\n[foo]"}).substr(0, 32), "--set: system.slack: wrong type:");
}

}  // namespace
}  // namespace mixcmp::test::override_test
