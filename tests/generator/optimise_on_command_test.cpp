#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "tests/support/program.hpp"

/// `mixcmp optimise --on` as a user calls it.
namespace mixcmp::test::optimise_on_command_test {
namespace {

class OptimiseOnCommand : public ProgramTest {
protected:
  /// An architecture that leaves little to search.
  OptimiseOnCommand() {
    write("data.csv",
          "a,b,c,d\n1,2,3,4\n5,6,7,8\n9,8,7,6\n80,90,33,7\n12,55,17,18\n3,99,21,12\n"
          "1.5,2.5,13,14\n71,3,44,4.5\n");
    write(
        "scene.toml",
        "[comparison]\nname = \"products\"\nf = \"a * b\"\ng = \"c * d\"\n"
        "[inputs]\n\"*\" = { range = [0, 100] }\n"
        "[reference]\nformat = \"s24e8\"\ninitiation_interval = 1\n"
        "[reduced]\nformat = \"auto\"\n[data]\nfile = \"data.csv\"\n"
        "[system]\ndevice = \"virtex6-lx760\"\noperands = \"carried\"\noperand_memory = \"logic\"\n"
        "request_beats = 1\nlanes_per_group = 1\ncounters = \"none\"\n[engine]\nkind = \"none\"\n");
  }

  const std::string optimise =
      "optimise scene.toml --first 11 --last 12 --use-bounds fixed_constant --use-multipliers "
      "embedded,logic ";
};

TEST_F(OptimiseOnCommand, TheSmallestDeviceIsChosenAndItsPlanIsAScene) {
  const Outcome all = mixcmp(optimise + "--on xc7a25t,XC7A100T,ice40lp384 --json");
  ASSERT_EQ(all.exit_code, 0) << all.output;
  const auto json = nlohmann::json::parse(all.output.substr(all.output.find('{')));
  ASSERT_EQ(json.at("devices").size(), 3U);
  EXPECT_EQ(json.at("devices")[0].at("device"), "ice40lp384");
  EXPECT_EQ(json.at("devices")[0].at("no_plan"), "nothing fits");
  EXPECT_EQ(json.at("devices")[1].at("device"), "xc7a25t");
  EXPECT_EQ(json.at("devices")[1].at("family"), "artix7");
  const double small = json.at("devices")[1].at("throughput_per_s");
  const double large = json.at("devices")[2].at("throughput_per_s");
  EXPECT_LT(small, large);
  EXPECT_FALSE(json.contains("plans")) << "no device is chosen";
  const std::string wanted = fmt::format("--at-least {:.3f} ", (small + large) / 2e9);
  const Outcome chosen = mixcmp(optimise + wanted + "--on xc7a25t,xc7a100t -o plan.toml");
  ASSERT_EQ(chosen.exit_code, 0) << chosen.output;
  EXPECT_NE(chosen.output.find("the smallest: xc7a100t"), std::string::npos) << chosen.output;
  EXPECT_NE(chosen.output.find("*         xc7a100t "), std::string::npos) << chosen.output;
  EXPECT_NE(read("plan.toml").find("device = \"xc7a100t\""), std::string::npos);
  EXPECT_NE(read("plan.toml").find("--on xc7a25t,xc7a100t"), std::string::npos);
  const Outcome checked = mixcmp("check plan.toml --json");
  EXPECT_EQ(checked.exit_code, 0) << checked.output;
}

TEST_F(OptimiseOnCommand, MistakesNameTheOptionAndTheNearestDevices) {
  expect_refused(optimise + "--on xc7a999t", "--on");
  expect_refused(optimise + "--on artix8", "artix7");
  expect_refused(optimise + "--on all --table some.csv", "--table");
  expect_refused(optimise + "--on xc7a25t -o plan.toml", "--at-least");
  expect_refused(optimise + "--on xc7a25t --csv plan.csv", "--csv");
  expect_refused(optimise + "--on xc7a25t --at-least 100000", "xc7a25t");
}

}  // namespace
}  // namespace mixcmp::test::optimise_on_command_test
