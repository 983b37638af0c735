#include <string>
#include <vector>

#include "model/comparison/expression/typed_graph.hpp"
#include "tests/model/scene/scene_fixture.hpp"

/// Tests scenes whose inputs arrive in floating-point formats of their own.
namespace mixcmp::test::float_operands_scene_test {
namespace {

const std::string products = R"toml([comparison]
name = "n"
f = "a * b"
g = "c"
[inputs]
a = { format = "bfloat16" }
b = { format = "E5M2", range = [-2, 3] }
[reference]
format = "binary32"
[reduced]
format = "s17e8"
)toml";

class FloatOperandsTest : public SceneTest {
protected:
  scene::Scene scene_of(const std::string& text, const std::vector<std::string>& settings = {}) {
    Result<scene::Scene> scene = load(text, settings);
    EXPECT_TRUE(scene.ok()) << scene.error().to_string();
    return std::move(scene).value();
  }

  std::string error(const std::string& text, const std::vector<std::string>& settings = {}) {
    const Result<scene::Scene> scene = load(text, settings);
    EXPECT_FALSE(scene.ok()) << text;
    std::string message = scene.ok() ? "" : scene.error().to_string();
    const std::string path = path_.string();
    if (message.starts_with(path)) message.erase(0, path.size());
    return message;
  }
};

TEST_F(FloatOperandsTest, EachInputHasAFormatAndMayHaveARange) {
  const scene::Scene scene = scene_of(products);
  ASSERT_EQ(scene.operand_formats.size(), 3u);
  EXPECT_EQ(scene.operand_formats[0].name(), "s8e8");
  EXPECT_EQ(scene.operand_formats[1].name(), "s3e5");
  EXPECT_EQ(scene.operand_formats[2].name(), "s24e8");
  EXPECT_FALSE(scene.ranges[0].has_value());
  EXPECT_EQ(scene.ranges[1], (Range{-2, 3}));
  EXPECT_FALSE(scene.has_fixed_operands());
  EXPECT_EQ(scene.graph.arriving_format(0)->name(), "s8e8");
  EXPECT_FALSE(scene.graph.arriving_format(2).has_value()) << "the reference's format";
}

TEST_F(FloatOperandsTest, TheReferencesFormatIsNoOtherFormat) {
  const scene::Scene scene = scene_of(products, {"inputs.a.format=binary32"});
  EXPECT_EQ(scene.operand_formats[0].name(), "s24e8");
  EXPECT_FALSE(scene.graph.arriving_format(0).has_value());
}

TEST_F(FloatOperandsTest, MistakesNameTheKey) {
  EXPECT_TRUE(error(products, {"inputs.a.format=float16"})
                  .starts_with("--set: inputs.a.format: not a format of operands: received "
                               "\"float16\"; accepted binary16 (the same format); uint1"));
  const std::string wide = error(products, {"inputs.a.format=binary64"});
  EXPECT_TRUE(
      wide.starts_with("--set inputs.a.format: reference.format: it does not hold every "
                       "number of a in s53e11"))
      << wide;
  EXPECT_TRUE(wide.ends_with("received s24e8; accepted a format with more digits or exponent bits"))
      << wide;
  EXPECT_EQ(error(products, {"inputs.b.range=[70000, 80000]"}),
            "--set: inputs.b.range: s3e5 has no number in the range: received [70000, 80000]; "
            "accepted [low, high], low <= high, or \"data\"");
  for (const char* none : {"[-1.2, -1.1]", "[1.1, 1.2]", "[1e-6, 2e-6]", "[-9e9, -8e9]"}) {
    const std::string told = error(products, {std::string("inputs.b.range=") + none});
    EXPECT_NE(told.find("has no number in the range"), std::string::npos) << told;
  }
  for (const char* some : {"[1.1, 1.25]", "[-1.25, -1.1]", "[1e-6, 16e-6]", "[57344, 9e9]"}) {
    EXPECT_TRUE(load(products, {std::string("inputs.b.range=") + some}).ok()) << some;
  }
  EXPECT_EQ(error(products, {"inputs.b*={ format = \"E5M2\" }"}),
            "--set: inputs.b*: every input that it matches has a key of its own: received \"b*\"; "
            "accepted a pattern that decides for some input, or the inputs' own keys");
  EXPECT_EQ(error(products, {"inputs.a.grid=1"}),
            "--set: inputs.a.grid: a grid without a range: received 1; accepted a range beside it");
  EXPECT_EQ(
      error(products, {"reference.format=exact"}),
      "--set: reference.format: for a reference that rounds nothing each input needs a format: "
      "received none for c; accepted a format such as uint10 or binary32, or a reference in one "
      "such as s53e11");
  const std::vector<std::string> exact = {"reference.format=exact", "inputs.c.format=binary16",
                                          "reduced.format=s8e6"};
  EXPECT_EQ(scene_of(products, exact).reference.format.name(), "s11e9");
  const std::string fused =
      "[comparison]\nname = \"n\"\nf = \"a * b - c * b\"\ng = \"e\"\n[inputs]\n"
      "e = { format = \"binary32\" }\n"
      "\"*\" = { format = \"binary16\", range = [0, 1024], grid = 1 }\n[reduced]\n"
      "format = \"s8e8\"\n[reference]\nformat = \"exact\"\n";
  EXPECT_EQ(scene_of(fused).reference.format.name(), "s24e9");
  EXPECT_NE(
      error(fused, {"reference.sums=fused"}).find("reference.sums: a fused sum may cut digits"),
      std::string::npos);
}

TEST_F(FloatOperandsTest, ReferencesMayComputeInFixedPoint) {
  const std::string ranges =
      "[comparison]\nname = \"n\"\nf = \"sqrt(a)\"\ng = \"b\"\n[inputs]\n"
      "a = { format = \"binary16\", range = [0, 9] }\n"
      "b = { format = \"bfloat16\", range = [0, 9] }\n[reduced]\n"
      "format = \"q7\"\n[reference]\nformat = \"q30\"\n";
  const scene::Scene scene = scene_of(ranges);
  EXPECT_EQ(scene.reference_fixed_point->name(), "q30");
  EXPECT_EQ(scene.reference.format.name(), "s11e8") << "which holds both formats";
  EXPECT_TRUE(scene.has_fixed_references());
  EXPECT_NE(error(ranges, {"reference.initiation_interval=4"})
                .find("a reference in fixed point takes a comparison in every cycle"),
            std::string::npos);
  EXPECT_NE(error(ranges, {"reference.sums=fused"}).find("fuses no sums"), std::string::npos);
  EXPECT_NE(error(ranges, {"reference.format=q49"}).find("out of range: received \"q49\""),
            std::string::npos);
  EXPECT_NE(error(ranges, {"reference.format=q9g2"})
                .find("has neither guard digits nor blocks: received \"q9g2\""),
            std::string::npos);
  EXPECT_NE(error(ranges, {"comparison.g=a / (a - b)"})
                .find("reference.format: the divisor may be below 0 and above it"),
            std::string::npos);
  EXPECT_TRUE(load(ranges, {"comparison.g=b * 1e9"}).ok()) << "no number of the operands' formats";
  EXPECT_NE(error(products, {"reference.format=q30"})
                .find("each input needs a format: received none for c; accepted a format"),
            std::string::npos);
}

/// E4M3: its largest number is 448, and 4 exponent bits do not hold it.
TEST_F(FloatOperandsTest, AFormatWithoutInfinitiesIsOneOfOperandsOnly) {
  const std::vector<std::string> e4m3 = {"inputs.a.format=E4M3"};
  const auto with = [&](const char* setting) { return std::vector{e4m3[0], std::string(setting)}; };
  const scene::Scene scene = scene_of(products, e4m3);
  EXPECT_EQ(scene.operand_formats[0].name(), "E4M3");
  EXPECT_EQ(scene.graph.arriving_format(0)->name(), "E4M3");
  const std::string narrow = error(products, with("reference.format=s24e4"));
  EXPECT_NE(narrow.find("it does not hold every number of a in E4M3"), std::string::npos) << narrow;
  EXPECT_TRUE(load(products, with("inputs.a.range=[440, 1000]")).ok());
  EXPECT_NE(error(products, with("inputs.a.range=[449, 1000]")).find("E4M3 has no number in the"),
            std::string::npos);
  for (const char* other : {"reference.format=E4M3", "reduced.format=E4M3"}) {
    const std::string told = error(products, {other});
    EXPECT_NE(told.find("a format of operands only, since it has no infinities"), std::string::npos)
        << told;
    EXPECT_NE(told.find("sPeE"), std::string::npos) << told;
  }
}

TEST_F(FloatOperandsTest, RangesThatTheFormatRoundsOutAreNoted) {
  const scene::Scene scene = scene_of(products, {"inputs.a.range=[0, 1.99]"});
  ASSERT_EQ(scene.notes.size(), 1u);
  EXPECT_EQ(scene.notes[0],
            "the range end 1.99 rounds out of its range in s8e8: data of just that value are out "
            "of range");
}

TEST_F(FloatOperandsTest, AColumnHasOneFormat) {
  const std::string pairs = R"toml([comparison]
name = "n"
f = "xi"
g = "xj"
[inputs]
xi = { format = "bfloat16", range = [0, 1] }
xj = { range = [0, 1] }
[reference]
format = "binary32"
[reduced]
format = "s9e8"
)toml";
  EXPECT_EQ(
      error(pairs, {"engine.kind=pairwise"}),
      "--set: engine.kind: xi and xj are the same column of an engine's items, in two formats: "
      "received s8e8 and s24e8; accepted one format for both, or engine.kind = \"none\"");
  EXPECT_TRUE(error(pairs, {"data.items=uniform", "data.pairs=all"})
                  .find("the same column of the data, in two formats") != std::string::npos);
}

/// A product of eight and three digits fits 17 digits: nothing is rounded, and inputs are converted
/// even if `inputs` asks for more digits.
TEST_F(FloatOperandsTest, LanesKnowTheDigits) {
  const scene::Scene scene = scene_of(products, {"inputs.c.format=binary16"});
  const Arithmetic lane{*scene.reduced.format, Rounding::nearest_even, Subnormals::flush};
  const TypedGraph graph = lane_graph(scene.graph, scene.reference.format, lane, LaneInputs::exact);
  int conversions = 0;
  for (const TypedNode& node : graph.nodes) {
    if (node.operation == Operation::convert) ++conversions;
    if (node.operation != Operation::multiply) continue;
    EXPECT_EQ(node.operand_format.name(), "s17e8");
    EXPECT_EQ(node.operand_digits(), 8);
  }
  EXPECT_EQ(conversions, 3);
}

}  // namespace
}  // namespace mixcmp::test::float_operands_scene_test
