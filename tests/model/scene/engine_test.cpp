#include <gtest/gtest.h>

#include <fstream>

#include "model/scene/scene.hpp"
#include "tests/support/scratch_directory.hpp"

namespace mixcmp::test::engine_test {
namespace {

const std::string spheres = "f = \"(xi - xj)^2\"\ng = \"(ri + rj)^2\"\n";
const std::string data = "[data]\nitems = \"uniform_spheres\"\n";

class EngineSection : public testing::Test {
protected:
  /// Loads a scene in which `more` stands behind the comparison, from line 7 on.
  Result<scene::Scene> load(const std::string& more, const std::string& comparison = spheres) {
    std::filesystem::remove(path_);
    std::ofstream(path_, std::ios::binary) << "[comparison]\nname = \"spheres\"\n"
                                           << comparison << "[reference]\nformat = \"s53e8\"\n"
                                           << more;
    return scene::load_scene(path_, {});
  }
  std::string error(const std::string& more, const std::string& comparison = spheres) {
    const Result<scene::Scene> scene = load(more, comparison);
    EXPECT_FALSE(scene.ok()) << more;
    return scene.ok() ? "" : scene.error().to_string().substr(path_.string().size());
  }

private:
  test::ScratchDirectory scratch_;
  std::filesystem::path path_ = scratch_.path() / "scene.toml";
};

TEST_F(EngineSection, WithoutItComparisonsAreStreams) {
  const scene::Scene scene = load("").value();
  EXPECT_EQ(scene.system.engine.kind, scene::EngineKind::none);
  EXPECT_EQ(scene.system.operands, scene::OperandStore::carried);
  EXPECT_EQ(load("[engine]\nkind = \"none\"\n")->system.tag_bits, 32);
}

TEST_F(EngineSection, DecidesOperandsAndTag) {
  const scene::Scene scene = load("[engine]\nkind = \"pairwise\"\ncapacity = 1025\n").value();
  EXPECT_EQ(scene.system.engine.kind, scene::EngineKind::pairwise);
  EXPECT_EQ(scene.system.engine.capacity, 1025);
  EXPECT_EQ(scene.system.operands, scene::OperandStore::refetched);
  EXPECT_EQ(scene.system.tag_bits, 22);
  EXPECT_EQ(load("[engine]\nkind = \"pairwise\"\n")->system.tag_bits, 20);
  EXPECT_EQ(load("[engine]\nkind = \"pairwise\"\ncapacity = 2\n")->system.tag_bits, 2);
  EXPECT_EQ(load("[engine]\nkind = \"pairwise\"\ncapacity = 65536\n")->system.tag_bits, 32);
}

TEST_F(EngineSection, APairwiseEngineMayHaveMoreLanes) {
  const auto with = [](const std::string& kind, int lanes) {
    return "[system]\nlanes = " + std::to_string(lanes) + "\n[engine]\nkind = \"" + kind + "\"\n";
  };
  EXPECT_TRUE(load(with("pairwise", 513)).ok());
  EXPECT_TRUE(load(with("pairwise", 4096)).ok());
  EXPECT_NE(error(with("pairwise", 4097)).find("1..4096"), std::string::npos);
  EXPECT_NE(error(with("none", 513)).find("1..512"), std::string::npos);
  EXPECT_TRUE(load("[engine]\nkind = \"pairwise\"\n[[lanes]]\ncount = 4096\n").ok());
  EXPECT_NE(error("[[lanes]]\ncount = 300\n[[lanes]]\ncount = 213\n").find("at most 512"),
            std::string::npos);
}

TEST_F(EngineSection, ReportsAllButGreaterUnlessToldOtherwise) {
  const auto report = [this](const std::string& more) {
    return load("[engine]\nkind = \"pairwise\"\n" + more)->system.engine.report;
  };
  EXPECT_EQ(report(""), (VerdictSet{Verdict::less, Verdict::equal, Verdict::unordered}));
  EXPECT_EQ(report("report = [\"greater\", \"less\"]\n"),
            (VerdictSet{Verdict::less, Verdict::greater}));
}

TEST_F(EngineSection, WhatTheEngineDecidesMayBeRepeated) {
  EXPECT_TRUE(load("[engine]\nkind = \"pairwise\"\n[system]\noperands = \"refetched\"\n"
                   "tag_bits = 20\n")
                  .ok());
}

const std::string nearest = "f = \"(p - ci)^2\"\ng = \"(p - cj)^2\"\n";
const std::string arg_min = "[engine]\nkind = \"arg_min\"\n";

TEST_F(EngineSection, ArgMinDecidesOrderOperandsAndTag) {
  const scene::Scene scene = load(arg_min + "tag_bits = 9\n", nearest).value();
  EXPECT_EQ(scene.system.engine.kind, scene::EngineKind::arg_min);
  EXPECT_EQ(scene.system.engine.row_tag_bits, 9);
  EXPECT_EQ(scene.system.order, scene::ResultOrder::in_order);
  EXPECT_EQ(scene.system.operands, scene::OperandStore::refetched);
  EXPECT_EQ(scene.system.tag_bits, 1);
  EXPECT_EQ(load(arg_min, nearest)->system.engine.row_tag_bits, 16);
  EXPECT_TRUE(load(arg_min + "[system]\norder = \"in_order\"\noperands = \"refetched\"\n"
                             "tag_bits = 1\nreferences = 1\n",
                   nearest)
                  .ok());
}

TEST_F(EngineSection, ArgMinTellsItsMistakes) {
  const auto told = [this](const std::string& more) { return error(arg_min + more, nearest); };
  EXPECT_EQ(told("[system]\nreferences = 0\n"),
            ":10: system.references: the arg-min engine needs every verdict: received 0; accepted "
            "1..16");
  EXPECT_EQ(told("[system]\norder = \"tagged\"\n"),
            ":10: system.order: the arg-min engine decides it: received \"tagged\"; accepted "
            "\"in_order\", or no key");
  EXPECT_EQ(told("[system]\noperands = \"carried\"\n"),
            ":10: system.operands: the arg-min engine decides it: received \"carried\"; accepted "
            "\"refetched\", or no key: the engine's memories hold the operands");
  EXPECT_EQ(told("[system]\ntag_bits = 8\n"),
            ":10: system.tag_bits: the arg-min engine decides it: received 8; accepted 1, or no "
            "key: a row's tag is engine.tag_bits wide");
  EXPECT_EQ(
      told("[data]\nfile = \"points.csv\"\n"),
      ":9: data.pairs: the arg-min engine compares candidates for each row: received nothing; "
      "accepted pairs = \"arg_min\"");
  EXPECT_NE(told("capacity = 7\n").find("engine.capacity"), std::string::npos);
  EXPECT_NE(error("[engine]\nkind = \"pairwise\"\ntag_bits = 7\n").find("engine.tag_bits"),
            std::string::npos);
  EXPECT_EQ(
      error(arg_min, "f = \"xi\"\ng = \"xj\"\n"),
      ":8: engine.kind: the arg-min engine compares candidates i and j for a row: received the "
      "inputs xi, xj; accepted names that end in i or j for candidates, and others for the "
      "row");
}

TEST_F(EngineSection, MistakesAreToldInOneLine) {
  const std::string engine = "[engine]\nkind = \"pairwise\"\n";
  EXPECT_EQ(
      error("[engine]\ncapacity = 7\n"),
      ":7: engine.kind: missing beside other keys of the engine: received nothing; accepted kind = "
      "\"pairwise\", \"arg_min\" or \"none\"");
  EXPECT_EQ(error("[engine]\nkind = \"pairs\"\n"),
            ":8: engine.kind: not a choice: received \"pairs\"; accepted none, "
            "pairwise, arg_min");
  EXPECT_EQ(error(engine + "capacity = 1\n"),
            ":9: engine.capacity: out of range: received 1; accepted an integer 2..65536");
  const std::string list = "; accepted a list of one or more of less, equal, greater, unordered";
  EXPECT_EQ(error(engine + "report = \"less\"\n"),
            ":9: engine.report: no list of choices: received \"less\"" + list);
  EXPECT_EQ(error(engine + "report = []\n"),
            ":9: engine.report: no list of choices: received an array of 0" + list);
  EXPECT_EQ(error(engine + "report = [\"les\"]\n"),
            ":9: engine.report: not a choice: received \"les\"" + list);
  const std::string as_bitmap =
      ":9: engine.report: has verdicts; the key report_as says how their pairs leave: received "
      "\"bitmap\"; accepted report_as = \"bitmap\", and in report a list of one or more of less, "
      "equal, greater, unordered";
  EXPECT_EQ(error(engine + "report = \"bitmap\"\n"), as_bitmap);
  EXPECT_EQ(error(engine + "report = [\"bitmap\"]\n"), as_bitmap);
  EXPECT_EQ(error(engine + "report = [\"less\", \"less\"]\n"),
            ":9: engine.report: named twice: received \"less\"" + list);
  EXPECT_EQ(error(engine + "[system]\noperands = \"carried\"\n"),
            ":10: system.operands: the pairwise engine decides it: received \"carried\"; accepted "
            "\"refetched\", or no key: the engine's memory holds the operands");
  EXPECT_EQ(error(engine + "[system]\ntag_bits = 26\n"),
            ":10: system.tag_bits: the pairwise engine decides it: received 26; accepted 20, the "
            "numbers of two of 1024 items, or no key");
  EXPECT_EQ(error(engine + data),
            ":9: data.pairs: the pairwise engine compares every two items, or those of two tables: "
            "received nothing; accepted pairs = \"all\" or pairs = \"cross\"");
}

TEST_F(EngineSection, ASecondTierIsALaneInFixedPoint) {
  const std::string engine = "[engine]\nkind = \"pairwise\"\n";
  EXPECT_FALSE(load(engine)->second_tier.has_value());
  const scene::Scene scene =
      load(engine + "[second_tier]\nformat = \"q13\"\nmultipliers = \"logic\"\n").value();
  ASSERT_TRUE(scene.second_tier.has_value());
  EXPECT_EQ(scene.second_tier->format_name(), "q13");
  EXPECT_EQ(scene.second_tier->multipliers, scene::Multipliers::logic);
  for (const std::string format : {"s17e8", "block9", "q9g70", "seven"}) {
    EXPECT_EQ(
        error(engine + "[second_tier]\nformat = \"" + format + "\"\n"),
        ":10: second_tier.format: a second tier is a lane in fixed point, or none: received \"" +
            format + "\"; accepted \"none\", or qW with W 2..48, likewise W + G of qWgG");
  }
  EXPECT_NE(error(engine + "[second_tier]\nmultipliers = \"logic\"\n").find("second_tier.format"),
            std::string::npos);
  EXPECT_NE(error(engine + "[second_tier]\nformat = \"q13\"\nwidth = 3\n").find("unknown"),
            std::string::npos);
}

/// A plan without a second tier is laid over a scene that has one.
TEST_F(EngineSection, ASecondTierCanBeLeftOut) {
  const std::string engine = "[engine]\nkind = \"pairwise\"\n";
  EXPECT_FALSE(load(engine)->leaves_out_second_tier);
  EXPECT_FALSE(load(engine + "[second_tier]\nformat = \"q13\"\n")->leaves_out_second_tier);
  const scene::Scene scene =
      load(engine + "[second_tier]\nformat = \"none\"\nmultipliers = \"logic\"\n").value();
  EXPECT_FALSE(scene.second_tier.has_value());
  EXPECT_TRUE(scene.leaves_out_second_tier);
}

TEST_F(EngineSection, ASecondTierOfStreamsSaysHowManyLanesItHas) {
  const std::string tier = "[second_tier]\nformat = \"q13\"\n";
  const scene::Scene scene = load(tier + "count = 3\n").value();
  EXPECT_EQ(scene.second_tier->format_name(), "q13");
  EXPECT_EQ(scene.second_tier_count, 3);
  const scene::Scene open = load(tier + "count = \"auto\"\n").value();
  EXPECT_TRUE(open.second_tier.has_value());
  EXPECT_FALSE(open.second_tier_count.has_value());
  EXPECT_NE(error(tier).find("second_tier.count: missing: how many lanes the second tier has"),
            std::string::npos);
  EXPECT_NE(error(tier + "count = 0\n").find("second_tier.count: out of range"), std::string::npos);
  EXPECT_TRUE(load("[second_tier]\nformat = \"none\"\n")->leaves_out_second_tier);
  EXPECT_NE(error("[engine]\nkind = \"pairwise\"\n" + tier + "count = 3\n")
                .find("second_tier.count: an engine's second tier has a lane for each group"),
            std::string::npos);
}

TEST_F(EngineSection, AnArgMinEngineHasNoSecondTier) {
  const std::string tier = "[second_tier]\nformat = \"q13\"\n";
  EXPECT_NE(error("[engine]\nkind = \"arg_min\"\n" + tier, "f = \"xi - y\"\ng = \"xj\"\n")
                .find("second_tier.format: the arg-min engine has lanes of one tier"),
            std::string::npos);
}

TEST_F(EngineSection, InputsMustBeColumnsOfTwoItems) {
  EXPECT_EQ(error("[engine]\nkind = \"pairwise\"\n", "f = \"x\"\ng = \"yj\"\n"),
            ":8: engine.kind: the pairwise engine compares item i with item j: received the input "
            "x; accepted inputs that are a column's name followed by i or j");
}

}  // namespace
}  // namespace mixcmp::test::engine_test
