#include <string>
#include <vector>

#include "tests/model/scene/scene_fixture.hpp"

/// Tests scenes whose inputs arrive in fixed point.
namespace mixcmp::test::fixed_operands_scene_test {
namespace {

const std::string orientation = R"toml([comparison]
name = "orientation"
f = "(bx-ax)*(cy-ay)"
g = "(by-ay)*(cx-ax)"
[inputs]
"*" = { format = "uint10" }
[reduced]
format = "exact"
)toml";

class FixedOperandsTest : public SceneTest {
protected:
  scene::Scene scene_of(const std::string& text, const std::vector<std::string>& settings = {}) {
    Result<scene::Scene> scene = load(text, settings);
    EXPECT_TRUE(scene.ok()) << scene.error().to_string();
    return std::move(scene).value();
  }

  /// The scene's error, without the path of its file.
  std::string error(const std::string& text, const std::vector<std::string>& settings = {}) {
    const Result<scene::Scene> scene = load(text, settings);
    EXPECT_FALSE(scene.ok()) << text;
    std::string message = scene.ok() ? "" : scene.error().to_string();
    const std::string path = path_.string();
    if (message.starts_with(path)) message.erase(0, path.size());
    return message;
  }
};

TEST_F(FixedOperandsTest, RangeGridReferenceAndLaneFollow) {
  const scene::Scene scene = scene_of(orientation);
  ASSERT_EQ(scene.operand_formats.size(), 6u);
  EXPECT_EQ(scene.operand_formats.front().name(), "uint10");
  EXPECT_EQ(scene.ranges.front(), (Range{0, 1023}));
  EXPECT_EQ(scene.grids.front(), mpq_class(1));
  EXPECT_EQ(scene.reference.format.name(), "s53e11");
  EXPECT_EQ(scene.reduced.format_name(), "q10");
  EXPECT_TRUE(scene.reduced.is_exact);
  EXPECT_EQ(scene.system.references, 0);
}

/// A promised grid makes a lane for operands in floating point exact. The lane checks its operands,
/// so references stay. [-512, 511] needs 10 bits of magnitude, because of 512.
TEST_F(FixedOperandsTest, PromisedGridsMakeLanesExact) {
  std::string promised = orientation + "[reference]\nformat = \"binary32\"\n";
  const std::string format = "{ format = \"uint10\" }";
  const std::string grid = "{ range = [-512, 511], grid = 1 }";
  promised.replace(promised.find(format), format.size(), grid);
  const scene::Scene scene = scene_of(promised);
  EXPECT_EQ(scene.reduced.format_name(), "q10");
  EXPECT_TRUE(scene.reduced.is_exact);
  EXPECT_FALSE(scene.has_fixed_operands());
  EXPECT_EQ(scene.system.references, std::nullopt);
  EXPECT_EQ(scene_of(promised, {"inputs.*.grid=0.5"}).reduced.format_name(), "q11");
  const std::string of_norm = error(promised, {"reduced.error_bound=norm"});
  EXPECT_NE(of_norm.find("only the bound grid makes a lane exact"), std::string::npos) << of_norm;
  const std::string of_integers = error(orientation, {"reduced.error_bound=grid"});
  EXPECT_NE(of_integers.find("there is no grid to rely on"), std::string::npos) << of_integers;
  promised.replace(promised.find(", grid = 1"), 10, "");
  EXPECT_EQ(
      error(promised),
      ":8: reduced.format: no lane is exact: an input has neither a format in fixed point nor "
      "a grid: received \"exact\" with bx in s24e8; accepted inputs with a format such as "
      "uint10, or with a range and a grid, or a format such as q13");
}

/// The only multiple of 4 or 16 in the range [-3, 3] is 0, for which one bit is enough. Ranges
/// without any multiple are refused.
TEST_F(FixedOperandsTest, AGridMayBeCoarserThanTheRange) {
  const std::string text =
      "[comparison]\nname = \"n\"\nf = \"a\"\ng = \"b\"\n[inputs]\n"
      "a = { range = [-3, 3], grid = 4 }\nb = { range = [0, 15], grid = 1 }\n"
      "[reference]\nformat = \"binary32\"\n[reduced]\nformat = \"exact\"\n";
  for (const char* grid : {"inputs.a.grid=4", "inputs.a.grid=16"}) {
    EXPECT_EQ(scene_of(text, {grid}).reduced.format_name(), "q4") << grid;
  }
  std::string far = text;
  far.replace(far.find("[-3, 3]"), 7, "[5, 7]");
  EXPECT_EQ(error(far),
            ":6: inputs.a.grid: the range has no multiple of it: received 4; accepted a power of "
            "two with a multiple in [5, 7]");
}

TEST_F(FixedOperandsTest, ReferencesAreForLanesThatRound) {
  const auto references = [&](const std::vector<std::string>& settings) {
    return scene_of(orientation, settings).system.references;
  };
  EXPECT_EQ(references({"reduced.format=q10"}), 0);
  EXPECT_EQ(references({"reduced.format=q9"}), 1);
  EXPECT_EQ(references({"reduced.format=auto"}), std::nullopt);
  EXPECT_EQ(references({"reduced.format=q9", "system.references=0"}), 0);
  EXPECT_EQ(references({"system.references=2"}), 2);
  const std::string nearest =
      "[comparison]\nname = \"n\"\nf = \"abs(p - ci)\"\ng = \"abs(p - cj)\"\n[inputs]\n"
      "\"*\" = { format = \"uint8\" }\n[reduced]\nformat = \"exact\"\n";
  EXPECT_EQ(scene_of(nearest).system.references, 0);
  const std::string chain = "engine.kind=arg_min", none = "system.references=0";
  EXPECT_EQ(scene_of(nearest, {chain}).system.references, 0);
  EXPECT_EQ(scene_of(nearest, {chain, "reduced.format=q7"}).system.references, 1);
  EXPECT_EQ(scene_of(nearest, {chain, "reduced.format=auto", none}).system.references, 0);
  std::string coarse = nearest;
  coarse.replace(coarse.find("\"exact\""), std::size("\"exact\"") - 1, "\"q7\"");
  EXPECT_EQ(error(coarse + "[engine]\nkind = \"arg_min\"\n[system]\nreferences = 0\n"),
            ":12: system.references: the arg-min engine needs every verdict: received 0; accepted "
            "1..16, or 0 with reduced.format = \"exact\"");
  EXPECT_EQ(scene_of(orientation + "[[references]]\ncount = 3\n").reference_count(), 3);
}

TEST_F(FixedOperandsTest, InputsHaveFormatsOfTheirOwn) {
  const scene::Scene scene = scene_of(R"toml([comparison]
name = "n"
f = "a * b"
g = "c"
[inputs]
a = { format = "q1.6" }
b = { format = "int5" }
[reference]
format = "s24e8"
[reduced]
format = "q8"
)toml",
                                      {"inputs.c.range=[0, 9]"});
  EXPECT_EQ(scene.operand_formats[0].name(), "q1.6");
  EXPECT_EQ(scene.operand_formats[1].name(), "int5");
  EXPECT_EQ(scene.operand_formats[2].name(), "s24e8");
  EXPECT_EQ(scene.ranges[0], (Range{-2, mpq_class(127, 64)}));
  EXPECT_EQ(scene.grids[0], mpq_class(1, 64));
  EXPECT_EQ(scene.ranges[1], (Range{-16, 15}));
  EXPECT_TRUE(scene.has_fixed_operands());
}

/// The exact lane leaves b to a reference where it is off its grid, so references are as for
/// floats.
TEST_F(FixedOperandsTest, BesideFloatsReferencesComputeInFloatingPoint) {
  const std::string text =
      "[comparison]\nname = \"n\"\nf = \"a * b\"\ng = \"1\"\n[inputs]\n"
      "a = { format = \"uint8\" }\nb = { range = [0, 15], grid = 0.5 }\n"
      "[reference]\nformat = \"binary32\"\n[reduced]\nformat = \"exact\"\n";
  const scene::Scene scene = scene_of(text);
  EXPECT_EQ(scene.reduced.format_name(), "q8");
  EXPECT_EQ(scene.reduced.error_bound, BoundKind::grid);
  EXPECT_TRUE(scene.has_fixed_operands());
  EXPECT_FALSE(scene.has_only_fixed_operands());
  EXPECT_EQ(scene.system.references, std::nullopt);
  EXPECT_EQ(scene.graph.arriving_format(0)->name(), "uint8");
  const std::vector<std::string> folded = {"reference.initiation_interval=4",
                                           "reference.sums=fused"};
  EXPECT_EQ(scene_of(text, folded).reference_structure.initiation_interval, 4);
  EXPECT_TRUE(scene_of(orientation).has_only_fixed_operands());
  EXPECT_FALSE(scene_of(sphere_scene).has_only_fixed_operands());
}

TEST_F(FixedOperandsTest, ScenesWithoutThemAreAsBefore) {
  const scene::Scene scene = scene_of(sphere_scene);
  EXPECT_FALSE(scene.has_fixed_operands());
  EXPECT_FALSE(scene.system.references.has_value());
  for (const OperandFormat& format : scene.operand_formats) EXPECT_EQ(format.name(), "s53e8");
}

TEST_F(FixedOperandsTest, MistakesNameTheKey) {
  EXPECT_TRUE(error(orientation, {"inputs.*.format=uint65"})
                  .starts_with("--set: inputs.*.format: not a format of operands: "
                               "received \"uint65\"; accepted uint1..uint64, "));
  EXPECT_EQ(error(orientation, {"inputs.*.range=[0, 3]"}),
            "--set: inputs.*.range: it follows from the input's format: received an array of 2; "
            "accepted no such key beside format");
  EXPECT_EQ(error(orientation, {"reduced.format=s17e6"}),
            "--set: reduced.format: a lane in floating point takes no operands in fixed point: "
            "received \"s17e6\"; accepted \"exact\", \"auto\", or qW such as q13");
  EXPECT_EQ(error(orientation, {"reference.format=s11e5", "inputs.*.format=uint12"}),
            "--set: reference.format: it does not hold every number of bx in uint12: received "
            "s11e5; accepted \"exact\", or a format with more digits or exponent bits");
  EXPECT_EQ(error(orientation + "[[lanes]]\ncount = 1\nformat = \"s9e6\"\n"),
            ":9: lanes.format: a lane in floating point takes no operands in fixed point: "
            "received \"s9e6\"; accepted \"exact\", \"auto\", or qW such as q13");
}

TEST_F(FixedOperandsTest, ReferencesAreNotFolded) {
  EXPECT_EQ(error(orientation, {"reduced.format=q9", "reference.initiation_interval=4"}),
            "--set: reference.initiation_interval: a reference in fixed point takes a "
            "comparison in every cycle: received 4; accepted 1");
  EXPECT_EQ(scene_of(orientation, {"reference.initiation_interval=auto"})
                .reference_structure.initiation_interval,
            1);
}

TEST_F(FixedOperandsTest, WhatCannotBeExactSaysWhy) {
  const std::string root =
      "[comparison]\nname = \"n\"\nf = \"sqrt(a)\"\ng = \"b\"\n[inputs]\n"
      "a = { format = \"uint10\" }\nb = { format = \"int10\" }\n[reduced]\n"
      "format = \"exact\"\n";
  EXPECT_EQ(error(root),
            ": reference.format: no reference is exact: square roots are rounded: received "
            "sqrt(a); accepted the squares of both sides, or a format such as s53e11");
  EXPECT_EQ(
      error(root + "[reference]\nformat = \"s40e8\"\n"),
      ":9: reduced.format: no lane is exact: square roots are rounded: received \"exact\" with "
      "sqrt in f or g; accepted the squares of both sides, or a format such as q13");
}

TEST_F(FixedOperandsTest, ColumnsOfAnEngineHaveOneFormat) {
  const std::string pairs = R"toml([comparison]
name = "n"
f = "xi"
g = "xj"
[inputs]
xi = { format = "uint4" }
xj = { format = "uint5" }
[reduced]
format = "exact"
[engine]
kind = "pairwise"
)toml";
  EXPECT_EQ(error(pairs),
            ":11: engine.kind: xi and xj are the same column of an engine's items, in two "
            "formats: received uint4 and uint5; accepted one format for both, or engine.kind = "
            "\"none\"");
  EXPECT_EQ(scene_of(pairs, {"inputs.xi.format=uint5"}).operand_formats[0].name(), "uint5");
}

}  // namespace
}  // namespace mixcmp::test::fixed_operands_scene_test
