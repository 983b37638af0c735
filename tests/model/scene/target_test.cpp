#include "tests/model/scene/scene_fixture.hpp"

/// Tests the clock that a scene's registers are placed for.
namespace mixcmp::test::target_test {
namespace {

TEST_F(SceneTest, TheTargetIsTheDevicesUnlessItIsGiven) {
  const std::string no_device =
      "[comparison]\nname = \"a\"\nf = \"x\"\ng = \"y\"\n[reference]\n"
      "format = \"s24e8\"\n[system]\n";
  EXPECT_EQ(load(no_device)->system.target_mhz, 200);
  const auto on = [&](const std::string& keys, const std::vector<std::string>& settings = {}) {
    const auto scene = load(no_device + keys, settings);
    EXPECT_TRUE(scene.ok()) << scene.error().to_string();
    return scene->system;
  };
  EXPECT_EQ(on("device = \"artix7-200t\"\n").target_mhz, 200);
  EXPECT_EQ(on("device = \"lfe5u-25f\"\n").target_mhz, 100);
  EXPECT_EQ(on("", {"system.device=ecp5-85k"}).target_mhz, 100);
  EXPECT_EQ(on("device = \"ecp5-85k\"\ntarget_mhz = 170\n").target_mhz, 170);
  EXPECT_EQ(on("device = \"no device\"\n").target_mhz, 200) << "which is reported where it is used";
  scene::SystemSpec moved = on("device = \"ecp5-85k\"\n");
  use_device(moved, "xc7a100t");
  EXPECT_EQ(moved.device, "xc7a100t");
  EXPECT_EQ(moved.target_mhz, 200);
  moved = on("device = \"ecp5-85k\"\ntarget_mhz = 170\n");
  use_device(moved, "xc7a100t");
  EXPECT_EQ(moved.target_mhz, 170);
}

}  // namespace
}  // namespace mixcmp::test::target_test
