#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

#include "model/comparison/data/sphere_family.hpp"
#include "model/judge/workload/load_comparisons.hpp"

/// A scene names a family; mistakes are told with their place.
namespace mixcmp::test::scene_data_test {
namespace {

const std::string scene_path = MIXCMP_SOURCE_DIR "/examples/extremes/scene.toml";

std::string error_of(const std::vector<std::string>& overrides) {
  const auto scene = scene::load_scene(scene_path, overrides);
  if (!scene.ok()) return scene.error().to_string();
  const auto data = workload::load_comparisons(*scene);
  return data.ok() ? "" : data.error().to_string();
}

TEST(SceneData, IsTheFamilyThatTheSceneNames) {
  for (const char* family : {"tangent", "near_tie_17"}) {
    const std::vector<std::string> overrides = {std::string("data.family=") + family,
                                                "data.count=50", "data.seed=3"};
    const auto scene = scene::load_scene(scene_path, overrides);
    ASSERT_TRUE(scene.ok()) << scene.error().to_string();
    const auto data = workload::load_comparisons(*scene);
    ASSERT_TRUE(data.ok()) << data.error().to_string();
    EXPECT_EQ(data->pairing(), data::Pairing::rows);
    const auto expected =
        data::sphere_family({.name = family, .count = 50, .seed = 3}, scene->reference.format);
    EXPECT_EQ(data->table().values, expected->values);
  }
}

TEST(SceneData, UnknownFamiliesAreAnErrorOfTheScene) {
  const std::string error = error_of({"data.family=neted"});
  EXPECT_EQ(
      error.find("--set: data.family: not a family of sphere pairs: received \"neted\"; accepted "
                 "nested (the nearest), uniform, tangent, "),
      0u)
      << error;
}

TEST(SceneData, FamiliesAreMadeOfPairs) {
  EXPECT_EQ(
      error_of({"data.pairs=all"}),
      "--set: data.pairs: the rows of a family are pairs already: received \"all\"; accepted no "
      "pairs here");
}

TEST(SceneData, OnlyFamiliesHaveAFamily) {
  EXPECT_EQ(error_of({"data.items=uniform_spheres", "data.pairs=all"}),
            "--set data.items: data.family: only of items = \"sphere_family\" (at " + scene_path +
                ":24): received \"tangent\"; accepted no family here");
}

TEST(SceneData, SpheresBeyondTheReferenceAreRefused) {
  const std::vector<std::string> overrides = {"reference.format=s24e5", "reduced.format=s8e5",
                                              "data.side=1e6"};
  const auto scene =
      scene::load_scene(MIXCMP_SOURCE_DIR "/examples/sphere_collision/scene.toml", overrides);
  ASSERT_TRUE(scene.ok()) << scene.error().to_string();
  const auto data = workload::load_comparisons(*scene);
  ASSERT_FALSE(data.ok());
  EXPECT_EQ(data.error().message, "beyond the largest number of s24e5");
}

TEST(SceneData, FamiliesThatDoNotFitTheReferenceAreAnErrorOfItsData) {
  EXPECT_EQ(
      error_of({"data.family=near_tie_17", "reference.format=binary16", "reduced.format=s8e5"}),
      "--set: data.family: near_tie_17 needs operands of 17 digits: received s11e5, a reference of "
      "11; accepted a reference of 17 digits or more");
}

TEST(SceneData, SizesOfACubeAreRefused) {
  EXPECT_EQ(error_of({"data.side=5"}),
            "--set: data.side: not used: a family has its own sizes: received 5; accepted no such "
            "key here, or items = \"uniform_spheres\" beside it");
}

}  // namespace
}  // namespace mixcmp::test::scene_data_test
