#include <gtest/gtest.h>

#include <fstream>

#include "model/scene/scene.hpp"
#include "tests/support/scratch_directory.hpp"

/// Tests [[lanes]] and [[references]]: lanes and references of several kinds.
namespace mixcmp::test::groups_test {
namespace {

const std::string head = R"([comparison]
name = "n"
f = "a * b"
g = "c"
[inputs]
"*" = { range = [1, 2] }

[reference]
format = "s53e11"
multipliers = "logic"

[reduced]
format = "s17"
inputs = "rounded"
bound_digits = 6
)";

class Groups : public testing::Test {
protected:
  Result<scene::Scene> load(const std::string& text,
                            const std::vector<std::string>& overrides = {}) {
    std::ofstream(path_, std::ios::binary) << text;
    return scene::load_scene(path_, overrides);
  }

  /// The error's text without the file's name in front.
  std::string error(const std::string& tail, const std::vector<std::string>& overrides = {}) {
    const Result<scene::Scene> scene = load(head + tail, overrides);
    EXPECT_FALSE(scene.ok()) << tail;
    const std::string text = scene.ok() ? "" : scene.error().to_string();
    return text.starts_with(path_.string()) ? text.substr(path_.string().size()) : text;
  }

  test::ScratchDirectory directory_;
  std::filesystem::path path_ = directory_.path() / "scene.toml";
};

TEST_F(Groups, WhatAGroupDoesNotSayComesFromReduced) {
  const Result<scene::Scene> scene = load(head +
                                          "[[lanes]]\ncount = 3\n"
                                          "[[lanes]]\ncount = 2\nformat = \"s8e8\"\n"
                                          "inputs = \"exact\"\nmultipliers = \"logic\"\n");
  ASSERT_TRUE(scene.ok()) << scene.error().to_string();
  ASSERT_EQ(scene->lanes.size(), 2U);
  const scene::LaneGroupSpec& plain = scene->lanes[0];
  EXPECT_EQ(plain.count, 3);
  EXPECT_EQ(plain.reduced.format->precision(), 17);
  EXPECT_EQ(plain.reduced.inputs, LaneInputs::rounded);
  EXPECT_EQ(plain.reduced.bound_digits, 6);
  EXPECT_EQ(plain.reduced.multipliers, scene::Multipliers::embedded) << "not the reference's";
  const scene::LaneGroupSpec& other = scene->lanes[1];
  EXPECT_EQ(other.count, 2);
  EXPECT_EQ(other.reduced.format->name(), "s8e8");
  EXPECT_FALSE(other.reduced.exponent_bits_from_ranges);
  EXPECT_EQ(other.reduced.inputs, LaneInputs::exact);
  EXPECT_EQ(other.reduced.bound_digits, 6);
  EXPECT_EQ(other.reduced.multipliers, scene::Multipliers::logic);
  EXPECT_EQ(other.place.line, 18);
  EXPECT_EQ(scene->lane_count(), 5);
}

TEST_F(Groups, OnlyLanesInFixedPointReadSquaresFromMemories) {
  const Result<scene::Scene> scene = load(head +
                                          "[[lanes]]\ncount = 1\nformat = \"q11\"\n"
                                          "multipliers = \"memory\"\n");
  ASSERT_TRUE(scene.ok()) << scene.error().to_string();
  EXPECT_EQ(scene->lanes[0].reduced.multipliers, scene::Multipliers::memory);
  EXPECT_EQ(error("[[lanes]]\ncount = 1\nmultipliers = \"memory\"\n"),
            ":18: lanes.multipliers: only lanes in fixed point read squares from memories: "
            "received \"memory\" in s17e11; accepted embedded or logic, or a format such as q11 or "
            "block11");
  EXPECT_NE(error("multipliers = \"memory\"\n").find(":16: reduced.multipliers:"),
            std::string::npos);
  EXPECT_EQ(error("[[references]]\ncount = 1\nmultipliers = \"memory\"\n"),
            ":18: references.multipliers: not a choice: received \"memory\"; accepted embedded, "
            "logic");
}

TEST_F(Groups, ExponentBitsFromRangesAreChosenForEachGroup) {
  const Result<scene::Scene> scene = load(head +
                                          "[[lanes]]\ncount = 1\n"
                                          "[[lanes]]\ncount = 1\nbound = \"profiled\"\n");
  ASSERT_TRUE(scene.ok()) << scene.error().to_string();
  EXPECT_LT(scene->lanes[0].reduced.format->exponent_bits(), 11);
  EXPECT_EQ(scene->lanes[1].reduced.format->exponent_bits(), 11) << "checks no range";
}

TEST_F(Groups, AutoTakesBackWhatReducedSays) {
  const Result<scene::Scene> scene =
      load(head +
           "error_bound = \"running\"\n[[lanes]]\ncount = 1\nformat = \"auto\"\n"
           "error_bound = \"auto\"\n");
  ASSERT_TRUE(scene.ok()) << scene.error().to_string();
  EXPECT_FALSE(scene->lanes[0].reduced.format.has_value());
  EXPECT_FALSE(scene->lanes[0].reduced.error_bound.has_value());
}

TEST_F(Groups, TagsNameTheLanesOfAGroup) {
  EXPECT_EQ(error("[system]\nlanes_per_group = 5\noperands = \"refetched\"\ntag_bits = 2\n"),
            ":19: system.tag_bits: too few to name the lanes of a group: received 2; accepted at "
            "least 3, "
            "or a smaller system.lanes_per_group than 5");
}

TEST_F(Groups, ReferencesTakeTheirMultipliersFromReference) {
  const Result<scene::Scene> scene = load(
      head + "[[references]]\ncount = 1\n[[references]]\ncount = 2\nmultipliers = \"embedded\"\n");
  ASSERT_TRUE(scene.ok()) << scene.error().to_string();
  ASSERT_EQ(scene->references.size(), 2U);
  EXPECT_EQ(scene->references[0].structure.multipliers, scene::Multipliers::logic);
  EXPECT_EQ(scene->references[1].structure.multipliers, scene::Multipliers::embedded);
  EXPECT_EQ(scene->reference_count(), 3);
}

TEST_F(Groups, ReferencesTakeTheirInitiationIntervalFromReference) {
  const Result<scene::Scene> scene = load(
      head + "[[references]]\ncount = 1\ninitiation_interval = 64\n[[references]]\ncount = 2\n");
  ASSERT_TRUE(scene.ok()) << scene.error().to_string();
  EXPECT_EQ(scene->references[0].structure.initiation_interval, 64);
  EXPECT_EQ(scene->references[1].structure.initiation_interval, 1);
  EXPECT_EQ(
      error("[[references]]\ncount = 1\ninitiation_interval = 65\n"),
      ":18: references.initiation_interval: out of range: received 65; accepted \"auto\" or an "
      "integer 1..64");
}

TEST_F(Groups, ReferencesTakeTheirTargetFromReference) {
  const Result<scene::Scene> scene =
      load(head + "[[references]]\ncount = 1\ntarget_mhz = 450\n[[references]]\ncount = 2\n",
           {"reference.target_mhz=600"});
  ASSERT_TRUE(scene.ok()) << scene.error().to_string();
  EXPECT_EQ(scene->references[0].structure.target_mhz, 450);
  EXPECT_EQ(scene->references[1].structure.target_mhz, 600);
  EXPECT_EQ(load(head)->reference_structure.target_mhz, std::nullopt);
  EXPECT_EQ(error("[[references]]\ncount = 1\ntarget_mhz = 2001\n"),
            ":18: references.target_mhz: out of range: received 2001; accepted an integer 1..2000");
}

TEST_F(Groups, WithoutListsThereIsOneGroupOfEach) {
  const Result<scene::Scene> scene = load(head + "[system]\nlanes = 4\nreferences = \"auto\"\n");
  ASSERT_TRUE(scene.ok()) << scene.error().to_string();
  ASSERT_EQ(scene->lane_groups().size(), 1U);
  EXPECT_EQ(scene->lane_groups()[0].count, 4);
  EXPECT_EQ(scene->lane_groups()[0].reduced.bound_digits, 6);
  EXPECT_EQ(scene->reference_groups()[0].structure.multipliers, scene::Multipliers::logic);
  EXPECT_FALSE(scene->reference_count().has_value());
}

TEST_F(Groups, OneKindIsThatOfReduced) {
  const Result<scene::Scene> scene =
      load(head + "[[lanes]]\ncount = 3\nformat = \"s9e9\"\n[[references]]\ncount = 2\n");
  ASSERT_TRUE(scene.ok()) << scene.error().to_string();
  const scene::Scene one = scene->with_one_kind();
  ASSERT_EQ(one.lane_groups().size(), 1U);
  EXPECT_EQ(one.lane_groups()[0].reduced.format->precision(), 17);
  EXPECT_EQ(one.reference_groups().size(), 1U);
}

TEST_F(Groups, AKeyThatEveryGroupHasIsNotedWhereReducedHasItToo) {
  const Result<scene::Scene> scene = load(head +
                                          "[[lanes]]\ncount = 1\nformat = \"s9e9\"\n"
                                          "[[lanes]]\ncount = 1\nformat = \"s8e9\"\n"
                                          "inputs = \"exact\"\n");
  ASSERT_TRUE(scene.ok()) << scene.error().to_string();
  EXPECT_EQ(scene->notes,
            std::vector<std::string>{"reduced.format is not used: each of [[lanes]] has its own"});
}

TEST_F(Groups, DigitsOfInputsThatReducedGivesMustServeEachLane) {
  std::string text = head;
  text.replace(text.find("\"rounded\""), 9, "20");
  const Result<scene::Scene> scene = load(text +
                                          "[[lanes]]\ncount = 1\nformat = \"s12e9\"\n"
                                          "[[lanes]]\ncount = 1\nformat = \"q13\"\n"
                                          "[[lanes]]\ncount = 1\nformat = \"s24e9\"\n"
                                          "inputs = \"exact\"\n");
  ASSERT_TRUE(scene.ok()) << scene.error().to_string();
  EXPECT_EQ(scene->lanes[0].reduced.inputs, LaneInputs::of_digits(20));
  const Result<scene::Scene> none =
      load(text + "[[lanes]]\ncount = 1\n[[lanes]]\ncount = 1\nformat = \"s24e9\"\n");
  ASSERT_FALSE(none.ok());
  EXPECT_EQ(
      none.error().to_string().substr(path_.string().size()),
      ":18: lanes.inputs: digits out of range: received 20; accepted \"exact\", \"rounded\", or "
      "an integer 24..53, from the lane's digits to the reference's");
}

TEST_F(Groups, MistakesAreToldWithTheLineOfTheirGroup) {
  EXPECT_EQ(error("[[lanes]]\nformat = \"s8e8\"\n"),
            ":16: lanes.count: missing: received nothing; accepted a key count");
  EXPECT_EQ(error("[[lanes]]\ncount = 1\n[[lanes]]\ncount = 0\n"),
            ":19: lanes.count: out of range: received 0; accepted an integer 1..512");
  EXPECT_EQ(error("[[lanes]]\ncount = \"auto\"\n"),
            ":17: lanes.count: wrong type: received \"auto\" (a string); accepted an integer "
            "1..512");
  EXPECT_EQ(error("[[lanes]]\ncount = 1\nbits = 3\n").substr(0, 31),
            ":18: lanes.bits: unknown key: r");
  EXPECT_EQ(
      error("[[lanes]]\ncount = 1\nformat = \"s60e8\"\n"),
      ":18: lanes.format: precision out of range: received \"s60e8\"; accepted \"auto\", "
      "\"exact\", sP or "
      "sPeE with P 4..52 and E 2..15, or binary16, bfloat16, binary32; qW or blockW with W 2..48, "
      "likewise W + G of qWgG and blockWgG");
  EXPECT_EQ(error("[[references]]\ncount = 1\nformat = \"s24e8\"\n"),
            ":18: references.format: unknown key: received format; accepted count, "
            "initiation_interval, multipliers, target_mhz");
}

TEST_F(Groups, CountsAreBoundedInAll) {
  EXPECT_EQ(error("[[lanes]]\ncount = 500\n[[lanes]]\ncount = 13\n"),
            ":19: lanes.count: too many in all: received 513; accepted at most 512 in all");
  EXPECT_EQ(error("[[references]]\ncount = 9\n[[references]]\ncount = 8\n"),
            ":19: references.count: too many in all: received 17; accepted at most 16 in all");
  EXPECT_TRUE(load(head + "[[lanes]]\ncount = 500\n[[lanes]]\ncount = 12\n").ok());
}

TEST_F(Groups, CountsStandInOnePlace) {
  EXPECT_EQ(error("[system]\nlanes = 4\n[[lanes]]\ncount = 1\n"),
            ":17: system.lanes: given beside [[lanes]]: received 4; accepted one of the two");
  EXPECT_EQ(error("[system]\nreferences = 1\n[[references]]\ncount = 1\n"),
            ":17: system.references: given beside [[references]]: received 1; accepted one of the "
            "two");
  EXPECT_EQ(error("[[lanes]]\ncount = 1\n", {"system.lanes=4"}),
            "--set: system.lanes: given beside [[lanes]]: received 4; accepted one of the two");
}

TEST_F(Groups, OnlyListsOfTablesAreLists) {
  EXPECT_EQ(error("[lanes]\ncount = 1\n"),
            ":16: lanes: not a list of tables: received a table with the key \"count\"; accepted "
            "[[lanes]], one table for each kind");
  const Result<scene::Scene> numbers = load("lanes = [1, 2]\n" + head);
  ASSERT_FALSE(numbers.ok());
  EXPECT_EQ(numbers.error().field, "lanes");
  EXPECT_EQ(numbers.error().received, "an array of 2");
  EXPECT_FALSE(load("references = []\n" + head).ok());
}

TEST_F(Groups, AListIsNotChangedByOneKey) {
  const std::string text = error("[[lanes]]\ncount = 1\n", {"lanes.count=4"});
  EXPECT_TRUE(text.starts_with("--set: lanes: a list")) << text;
}

}  // namespace
}  // namespace mixcmp::test::groups_test
