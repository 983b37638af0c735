#include <gtest/gtest.h>

#include <fstream>

#include "model/judge/workload/load_comparisons.hpp"
#include "model/scene/scene.hpp"
#include "tests/support/scratch_directory.hpp"

/// Tests plans, which lay other sections over those of a scene.
namespace mixcmp::test::plan_test {
namespace {

namespace fs = std::filesystem;

const std::string scene_text = R"([comparison]
name = "n"
f = "a * b"
g = "a + 1"

[inputs]
a = { range = [1, 2] }

[reference]
format = "s53e8"

[reduced]
format = "auto"
inputs = "rounded"

[system]
lanes = 8
references = 1
slack = 0.25

[data]
file = "data.csv"
)";

class Plans : public testing::Test {
protected:
  Plans() {
    fs::create_directories(directory_.path() / "plans");
    write("scene.toml", scene_text);
    write("data.csv", "a,b\n1,2\n");
  }

  void write(const std::string& name, const std::string& text) {
    std::ofstream(directory_.path() / name, std::ios::binary) << text;
  }

  Result<scene::Scene> load(const std::string& plan,
                            const std::vector<std::string>& overrides = {}) {
    write("plans/plan.toml", plan);
    return scene::load_scene(directory_.path() / "plans/plan.toml", overrides);
  }

  /// The error's text with the folder's name left out.
  std::string error(const std::string& plan) {
    const Result<scene::Scene> scene = load(plan);
    EXPECT_FALSE(scene.ok()) << plan;
    std::string text = scene.ok() ? "" : scene.error().to_string();
    const std::string folder = directory_.path().string() + "/";
    if (text.starts_with(folder)) text.erase(0, folder.size());
    return text;
  }

  test::ScratchDirectory directory_;
};

const std::string of_scene = "scene = \"../scene.toml\"\n";

TEST_F(Plans, LayTheirSectionsOverTheScene) {
  const Result<scene::Scene> scene = load(of_scene +
                                          "[reduced]\nformat = \"s12e8\"\n"
                                          "[system]\ntarget_mhz = 300\n");
  ASSERT_TRUE(scene.ok()) << scene.error().to_string();
  EXPECT_EQ(scene->name, "n");
  EXPECT_EQ(scene->reduced.format->name(), "s12e8");
  EXPECT_EQ(scene->reduced.inputs, LaneInputs::rounded) << "what the plan does not say stays";
  EXPECT_EQ(scene->system.target_mhz, 300);
  EXPECT_EQ(scene->system.slack, 0.25);
  EXPECT_EQ(scene->lane_count(), 8);
}

TEST_F(Plans, GroupsTakeThePlaceOfTheScenesCounts) {
  const Result<scene::Scene> scene = load(of_scene +
                                          "[[lanes]]\ncount = 3\nformat = \"s8e8\"\n"
                                          "[[lanes]]\ncount = 2\nformat = \"s9e8\"\n"
                                          "[[references]]\ncount = 2\n");
  ASSERT_TRUE(scene.ok()) << scene.error().to_string();
  EXPECT_EQ(scene->lane_count(), 5);
  EXPECT_EQ(scene->reference_count(), 2);
  EXPECT_EQ(scene->lanes[1].reduced.inputs, LaneInputs::rounded);
}

TEST_F(Plans, CountsTakeThePlaceOfTheScenesGroups) {
  write("scene.toml", scene_text.substr(0, scene_text.find("[system]")) +
                          "[[lanes]]\ncount = 3\nformat = \"s8e8\"\n");
  const Result<scene::Scene> scene =
      load(of_scene + "[reduced]\nformat = \"s9e8\"\n[system]\nlanes = 2\n");
  ASSERT_TRUE(scene.ok()) << scene.error().to_string();
  EXPECT_EQ(scene->lane_count(), 2);
  EXPECT_EQ(scene->lane_groups()[0].reduced.format->name(), "s9e8");
  const Result<scene::Scene> replaced =
      load(of_scene + "[[lanes]]\ncount = 4\nformat = \"s10e8\"\n");
  ASSERT_TRUE(replaced.ok()) << replaced.error().to_string();
  EXPECT_EQ(replaced->lane_count(), 4);
}

TEST_F(Plans, OverridesComeLast) {
  const Result<scene::Scene> scene =
      load(of_scene + "[reduced]\nformat = \"s12e8\"\n", {"reduced.format=s13e8"});
  ASSERT_TRUE(scene.ok()) << scene.error().to_string();
  EXPECT_EQ(scene->reduced.format->name(), "s13e8");
}

TEST_F(Plans, DataStayBesideTheScene) {
  const Result<scene::Scene> scene = load(of_scene);
  ASSERT_TRUE(scene.ok()) << scene.error().to_string();
  const auto data = workload::load_comparisons(*scene);
  ASSERT_TRUE(data.ok()) << data.error().to_string();
  EXPECT_EQ(data->size(), 1U);
}

TEST_F(Plans, ReportValuesAreKeptAsTheyAre) {
  const Result<scene::Scene> scene = load(of_scene +
                                          "[plan]\nthroughput_per_s = 1.5e9\nluts = 70000\n"
                                          "device = \"d\"\n");
  ASSERT_TRUE(scene.ok()) << scene.error().to_string();
  ASSERT_TRUE(scene->plan.has_value());
  EXPECT_EQ(scene->plan->path.filename(), "plan.toml");
  const std::vector<std::pair<std::string, std::string>> expected = {
      {"throughput_per_s", "1500000000"}, {"luts", "70000"}, {"device", "\"d\""}};
  EXPECT_EQ(scene->plan->values, expected);
  EXPECT_FALSE(scene::load_scene(directory_.path() / "scene.toml", {})->plan.has_value());
}

TEST_F(Plans, ReportValuesHaveTheirTypes) {
  EXPECT_EQ(error(of_scene + "[plan]\nclock_mhz = \"fast\"\n"),
            "plans/plan.toml:3: plan.clock_mhz: wrong type: received \"fast\" (a string); accepted "
            "a number");
  EXPECT_EQ(error(of_scene + "[plan]\ndevice = 3\n"),
            "plans/plan.toml:3: plan.device: wrong type: received 3 (an integer); accepted a "
            "string");
  EXPECT_EQ(error(of_scene + "[plan]\nnotes = [1]\n"),
            "plans/plan.toml:3: plan.notes: wrong type: received an array of 1 (an array); "
            "accepted a string, a number, true or false");
  EXPECT_EQ(error("plan = 3\n" + of_scene),
            "plans/plan.toml:1: plan: not a section: received 3; accepted a table [plan]");
}

TEST_F(Plans, MistakesAreToldInTheFileTheyStandIn) {
  EXPECT_EQ(error(of_scene + "\n[system]\nslack = 3\n"),
            "plans/plan.toml:4: system.slack: out of range: received 3; accepted a number from 0 "
            "to 0.95");
  EXPECT_EQ(error(of_scene + "[[lanes]]\ncount = 1\nformat = \"s1e8\"\n").substr(0, 30),
            "plans/plan.toml:4: lanes.forma");
  EXPECT_EQ(error(of_scene + "[sistem]\nlanes = 3\n").substr(0, 25), "plans/plan.toml:2: sistem");
  EXPECT_EQ(error(of_scene + "[comparison]\nf = \"a +\"\n").substr(0, 36),
            "plans/plan.toml:3:9: comparison.f: u");
  write("scene.toml", scene_text + "bad = 1\n");
  EXPECT_EQ(error(of_scene).substr(0, 51), "scene.toml:23: data.bad: unknown key: received bad;");
}

TEST_F(Plans, APlanThatSaysBothCountsIsRefused) {
  EXPECT_EQ(error(of_scene + "[system]\nlanes = 3\n[[lanes]]\ncount = 1\n"),
            "plans/plan.toml:3: system.lanes: given beside [[lanes]]: received 3; accepted one of "
            "the two");
}

TEST_F(Plans, TheSceneMustBeAScene) {
  const std::string accepted = "; accepted the path of a scene file, as seen from the plan";
  EXPECT_EQ(
      error("scene = \"nowhere.toml\"\n"),
      "plans/plan.toml:1: scene: there is no such file: received \"nowhere.toml\"" + accepted);
  EXPECT_EQ(error("scene = \"\"\n"),
            "plans/plan.toml:1: scene: not a path: received \"\"" + accepted);
  EXPECT_EQ(error("scene = 3\n"), "plans/plan.toml:1: scene: not a path: received 3" + accepted);
  EXPECT_EQ(error("scene = \"../plans\"\n"),
            "plans/plan.toml:1: scene: there is no such file: received \"../plans\"" + accepted);
  EXPECT_EQ(error("\nscene = \"../plans/plan.toml\"\n"),
            "plans/plan.toml:2: scene: a plan cannot be its own scene: received "
            "\"../plans/plan.toml\"" +
                accepted);
}

TEST_F(Plans, APlanMayBeLaidOverAPlan) {
  write("plans/other.toml", of_scene + "[system]\ntag_bits = 5\nslack = 0.1\n[plan]\nx = 1\n");
  const Result<scene::Scene> loaded =
      load("scene = \"other.toml\"\n[system]\nslack = 0.3\n[plan]\ny = 2\n");
  ASSERT_TRUE(loaded.ok()) << loaded.error().to_string();
  const scene::Scene& scene = *loaded;
  EXPECT_EQ(scene.system.tag_bits, 5);
  EXPECT_EQ(scene.system.slack, 0.3);
  ASSERT_EQ(scene.plan->values.size(), 1u);
  EXPECT_EQ(scene.plan->values[0].first, "y");
}

TEST_F(Plans, PlansInACircleAreRefused) {
  write("plans/other.toml", "scene = \"plan.toml\"\n");
  EXPECT_EQ(error("scene = \"other.toml\"\n"),
            "plans/other.toml:1: scene: a plan cannot be its own scene: received \"plan.toml\"; "
            "accepted the path of a scene file, as seen from the plan");
}

TEST_F(Plans, ASceneHasNoPlanSection) {
  write("scene.toml", scene_text + "[plan]\nx = 1\n");
  const Result<scene::Scene> scene = scene::load_scene(directory_.path() / "scene.toml", {});
  ASSERT_FALSE(scene.ok());
  EXPECT_EQ(scene.error().field, "plan");
  EXPECT_EQ(scene.error().message, "unknown section");
}

}  // namespace
}  // namespace mixcmp::test::plan_test
