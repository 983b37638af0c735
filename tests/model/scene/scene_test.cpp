#include "model/scene/scene.hpp"

#include <gtest/gtest.h>

#include <random>

#include "tests/model/scene/scene_fixture.hpp"

namespace mixcmp::test::scene_test {
namespace {

TEST_F(SceneTest, EveryKeyArrives) {
  const Result<scene::Scene> scene = load(sphere_scene);
  ASSERT_TRUE(scene.ok()) << scene.error().to_string();
  EXPECT_EQ(scene->name, "sphere_collision");
  EXPECT_EQ(scene->g_text(), "(ri + rj)^2");
  EXPECT_EQ(scene->graph.inputs(),
            (std::vector<std::string>{"cxi", "cxj", "cyi", "cyj", "czi", "czj", "ri", "rj"}));
  EXPECT_EQ(scene->ranges.at(3)->high, 100);
  EXPECT_EQ(scene->ranges.at(6)->low, 0);
  EXPECT_EQ(scene->ranges.at(6)->high, mpq_class(1, 10));
  EXPECT_EQ(scene->reference.format.name(), "s53e8");
  EXPECT_EQ(scene->reference.subnormals, Subnormals::gradual);
  EXPECT_EQ(scene->reduced.format->name(), "s17e8");
  EXPECT_TRUE(scene->reduced.is_profiled);
  EXPECT_EQ(scene->reduced.inputs, LaneInputs::rounded);
  EXPECT_EQ(*scene->reduced.relative_error_f, mpq_class(1, 10000));
  EXPECT_FALSE(scene->reduced.relative_error_g.has_value());
  EXPECT_EQ(scene->system.device, "virtex5-lx330t");
  EXPECT_EQ(scene->system.lanes, 87);
  EXPECT_FALSE(scene->system.references.has_value());
  EXPECT_EQ(scene->system.slack, 0.25);
  EXPECT_EQ(scene->system.order, scene::ResultOrder::in_order);
  EXPECT_EQ(scene->system.operands, scene::OperandStore::carried);
  ASSERT_TRUE(scene->data.has_value());
  EXPECT_EQ(scene->data->items, "uniform_spheres");
  EXPECT_EQ(scene->data->count, 512);
  EXPECT_EQ(scene->data->side, 100);
  EXPECT_EQ(scene->data->radius_max, 25);
  EXPECT_EQ(scene->data->seed, 7U);
  EXPECT_EQ(scene->data->pairing, data::Pairing::all);
  EXPECT_EQ(scene->notes, std::vector<std::string>{
                              "the range end 0.1 rounds out of its range in s53e8: data of just "
                              "that value are out of range"});
}

/// Registers that are placed for 200 MHz are wasted on a device that reaches a quarter of it.
TEST_F(SceneTest, InputsAreWordsOrDigits) {
  const auto inputs = [&](const std::string& value) {
    const auto scene = load_changed("inputs = \"rounded\"", "inputs = " + value);
    EXPECT_TRUE(scene.ok()) << scene.error().to_string();
    return scene->reduced.inputs;
  };
  EXPECT_EQ(inputs("\"exact\""), LaneInputs::exact);
  EXPECT_EQ(inputs("20"), LaneInputs::of_digits(20));
  EXPECT_EQ(inputs("17"), LaneInputs::of_digits(17));
  EXPECT_EQ(inputs("53"), LaneInputs::of_digits(53));
}

TEST_F(SceneTest, ReducedSystemAndDataMayBeAbsent) {
  const Result<scene::Scene> scene = load(
      "[comparison]\nname = \"n\"\nf = \"x\"\ng = \"y\"\n[reference]\nformat = \"binary64\"\n");
  ASSERT_TRUE(scene.ok()) << scene.error().to_string();
  EXPECT_FALSE(scene->reduced.format.has_value());
  EXPECT_FALSE(scene->reduced.is_profiled);
  EXPECT_EQ(scene->reduced.subnormals, Subnormals::flush);
  EXPECT_FALSE(scene->data.has_value());
  EXPECT_FALSE(scene->ranges.at(0).has_value());
}

TEST_F(SceneTest, SubscriptsNameInputsAndTheirRanges) {
  const std::string text = R"scene([comparison]
name = "nearest"
f = "sum(k in 0..D-1, (p[k] - a[k])^2)"
g = "sum(k in 0..D-1, (p_k_is_none - b[k])^2)"

[let]
D = "2"

[reference]
format = "s53e8"

[inputs]
"p*" = { range = [0, 1] }
"a[*]" = { range = [0, 2] }
"b[1]" = { range = [0, 3] }
)scene";
  const Result<scene::Scene> scene = load(text);
  ASSERT_TRUE(scene.ok()) << scene.error().to_string();
  EXPECT_EQ(scene->graph.inputs(),
            (std::vector<std::string>{"p_0", "a_0", "p_1", "a_1", "p_k_is_none", "b_0", "b_1"}));
  EXPECT_TRUE(scene->notes.empty()) << scene->notes.front();
  EXPECT_EQ(scene->ranges.at(0)->high, 1);
  EXPECT_EQ(scene->ranges.at(3)->high, 2);
  EXPECT_FALSE(scene->ranges.at(5).has_value());
  EXPECT_EQ(scene->ranges.at(6)->high, 3);
  const Result<scene::Scene> twice = load(text + "b_1 = { range = [0, 4] }\n");
  ASSERT_FALSE(twice.ok());
  EXPECT_NE(twice.error().to_string().find(":16: inputs.b_1: the same inputs as \"b[1]\""),
            std::string::npos)
      << twice.error().to_string();
}

TEST_F(SceneTest, KeysOfInputsAreNamesPatternsOrSubscripts) {
  const auto error = [&](const std::string& key) {
    const Result<scene::Scene> scene = load(
        "[comparison]\nname = \"n\"\nf = \"p[2]\"\ng = \"p_x\"\n"
        "[reference]\nformat = \"binary64\"\n[inputs]\n\"" +
        key + "\" = { range = [0, 1] }\n");
    return scene.ok() ? std::string() : scene.error().field + ": " + scene.error().message;
  };
  EXPECT_EQ(error("p[2]"), "");
  EXPECT_EQ(error("p*[*]"), "");
  EXPECT_EQ(error("p[2"), "inputs.p[2: a bracket without its other half");
  EXPECT_EQ(error("p[2]]"), "inputs.p[2]]: a bracket without its other half");
  EXPECT_EQ(error("p]2["), "inputs.p]2[: a bracket without its other half");
  EXPECT_EQ(error("p[2]x"), "inputs.p[2]x: text behind a subscript");
  EXPECT_EQ(error("p[x]"), "inputs.p[x]: a subscript that is no number");
  EXPECT_EQ(error("p[]"), "inputs.p[]: a subscript that is no number");
  EXPECT_EQ(error("p[02]"), "inputs.p[02]: a subscript with a 0 before it");
  EXPECT_EQ(error("[2]"), "inputs.[2]: a subscript of nothing");
}

TEST_F(SceneTest, RangesAreReadExactly) {
  const Result<scene::Scene> scene =
      load_changed("[0, 0.1]", R"(["-0x1.8p-1", "12345678901234567890.123456789012345678901"])");
  ASSERT_TRUE(scene.ok()) << scene.error().to_string();
  EXPECT_EQ(scene->ranges.at(6)->low, mpq_class(-3, 4));
  EXPECT_EQ(scene->ranges.at(6)->high,
            mpq_class("12345678901234567890123456789012345678901/1000000000000000000000"));
}

/// A file with columns a, b and c: numbers of either sign, infinities and NaNs.
constexpr const char* some_rows =
    "a,b,c\n"
    "-0.5,nan,nan\n"
    "inf,-3,nan\n"
    "0.25,-0.125,-inf\n"
    "-0.75,-1e-3,nan\n";

const std::string scene_of_rows = R"([comparison]
name = "rows"
f = "a"
g = "b * c"
[inputs]
a = { range = "data" }
b = { range = "data", grid = "0x1p-60" }
c = { range = [-1, 1] }
[reference]
format = "s24e8"
[data]
file = "rows.csv"
)";

TEST_F(SceneTest, RangesAreTakenFromTheData) {
  std::ofstream(directory_.path() / "rows.csv") << some_rows;
  const Result<scene::Scene> scene = load(scene_of_rows);
  ASSERT_TRUE(scene.ok()) << scene.error().to_string();
  EXPECT_EQ(scene->ranges.at(0), (Range{mpq_class(-3, 4), mpq_class(1, 4)}));
  EXPECT_EQ(scene->ranges.at(1)->low, -3);
  EXPECT_LT(scene->ranges.at(1)->high, mpq_class(-999, 1'000'000));
  EXPECT_GT(scene->ranges.at(1)->high, mpq_class(-1001, 1'000'000));
  EXPECT_EQ(scene->ranges.at(2)->high, 1);
  EXPECT_EQ(scene->data_ranges, (std::vector<bool>{true, true, false}));
}

TEST_F(SceneTest, ARangeThatTheDataDoNotHaveIsAnError) {
  std::ofstream(directory_.path() / "rows.csv") << some_rows;
  const auto error_of = [&](const std::string& scene, const std::vector<std::string>& settings) {
    const Result<scene::Scene> loaded = load(scene, settings);
    return loaded.ok() ? "" : loaded.error().to_string();
  };
  EXPECT_EQ(error_of(scene_of_rows, {"inputs.c={ range = \"data\" }"}),
            "--set: inputs.c.range: the data have no finite number for c: received \"data\"; "
            "accepted [low, high], low <= high");
  EXPECT_EQ(error_of(scene_of_rows.substr(0, scene_of_rows.find("[data]")), {}),
            path_.string() +
                ":6: inputs.a.range: the scene has no [data] to take it from: received \"data\"; "
                "accepted [low, high], low <= high");
  EXPECT_EQ(error_of(scene_of_rows, {"data.file=rows.pdb"}).substr(0, 30),
            "--set: data.file: cannot read ");
}

TEST_F(SceneTest, ExactKeyBeatsPattern) {
  const Result<scene::Scene> scene =
      load_changed("[inputs]", "[inputs]\ncxj = { range = [-2.5, 1_000] }");
  ASSERT_TRUE(scene.ok()) << scene.error().to_string();
  EXPECT_EQ(scene->ranges.at(1)->low, mpq_class(-5, 2));
  EXPECT_EQ(scene->ranges.at(1)->high, 1000);
  EXPECT_EQ(scene->ranges.at(0)->high, 100);
  EXPECT_EQ(scene->nonnegative_inputs(),
            (std::vector<bool>{true, false, true, true, true, true, true, true}));
}

TEST_F(SceneTest, EveryPartOfAMessageIsCutAtItsLimit) {
  const Result<scene::Scene> scene = load_changed("(ri + rj)^2", std::string(1'000'000, 'a'));
  ASSERT_FALSE(scene.ok());
  const std::string text = scene.error().to_string();
  EXPECT_LT(text.size(), 1000U);
  EXPECT_NE(text.find("aaa...; accepted a letter"), std::string::npos) << text;
  EXPECT_EQ((Error{.message = "m", .received = "\x1b[2J\xff\xc3\xa9\n"}.to_string()),
            "m: received ?[2J?\xc3\xa9\n");
}

TEST_F(SceneTest, MoreThan64VariantsAreRefused) {
  std::string text = sphere_scene;
  for (int k = 0; k < 65; ++k) {
    text += "[[variant]]\nname = \"v" + std::to_string(k) + "\"\ng = \"rj + ri\"\n";
  }
  const Result<scene::Scene> scene = load(text);
  ASSERT_FALSE(scene.ok());
  EXPECT_EQ(scene.error().to_string(),
            path_.string() + ":224: variant: too many variants: received 65; accepted at most 64");
}

TEST_F(SceneTest, TablesOfTooManyKeysAreRefusedAtOnce) {
  std::string text = sphere_scene + "[let]\n";
  for (int k = 0; k < 100'000; ++k) text += "l" + std::to_string(k) + " = \"1\"\n";
  const Result<scene::Scene> scene = load(text);
  ASSERT_FALSE(scene.ok());
  EXPECT_EQ(scene.error().to_string(),
            path_.string() +
                ":32: let: too many keys: received 100000; accepted at most 4096 in "
                "one table");
  std::string deep = "a";
  for (int k = 0; k < 1000; ++k) deep += ".a";
  const Result<scene::Scene> levels = load(deep.substr(0, 99) + " = 1\n");
  ASSERT_FALSE(levels.ok());
  EXPECT_EQ(levels.error().message, "nested too deeply");
  for (int k = 0; k < 500'000; ++k) deep += ".a";
  for (const std::string& hostile :
       {deep + " = 1\n", "[" + deep + "]\n", "x = { y = 1, " + deep + " = 1 }\n"}) {
    const Result<scene::Scene> parts = load("\n" + hostile);
    ASSERT_FALSE(parts.ok());
    EXPECT_EQ(parts.error().to_string(),
              path_.string() +
                  ":2: TOML syntax: a key of too many parts: received more than 1000 "
                  "dots; accepted section.key");
  }
}

TEST_F(SceneTest, NotesTellOfInexactConstantsAndUnusedThings) {
  std::string text = sphere_scene;
  text.replace(text.find("\"(ri + rj)^2\""), 13, "\"(ri + rj)^2 + 0.1\"");
  text.replace(text.find("bound = \"profiled\"\n"), 19, "");
  text.replace(text.find("[0, 0.1]"), 8, "[0, 1]");
  text += "[let]\nspare = \"cxi\"\n";
  const Result<scene::Scene> scene = load(text);
  ASSERT_TRUE(scene.ok()) << scene.error().to_string();
  EXPECT_EQ(scene->notes,
            (std::vector<std::string>{
                "let spare is not used by f or g",
                "constant 0.1 is inexact in s53e8: rounded, off by about 5.55112e-18",
                "reduced.relative_error_f and _g are not used: a certified bound proves its own"}));
}

TEST_F(SceneTest, ConstantsThatOneKindOfLaneUsesAreUsed) {
  std::string text = sphere_scene;
  text.replace(text.find("lanes = 87\n"), 11, "");
  text += "[[lanes]]\ncount = 1\n[[lanes]]\ncount = 1\nbound = \"certified\"\n";
  const Result<scene::Scene> scene = load(text);
  ASSERT_TRUE(scene.ok()) << scene.error().to_string();
  for (const std::string& note : scene->notes) {
    EXPECT_EQ(note.find("are not used"), std::string::npos) << note;
  }
}

TEST_F(SceneTest, LetsAreShared) {
  const std::string text =
      "[comparison]\nname = \"n\"\nf = \"d^2\"\ng = \"d * e\"\n[let]\nd = \"x - y\"\ne = \"d\"\n"
      "[reference]\nformat = \"binary64\"\n";
  const Result<scene::Scene> scene = load(text);
  ASSERT_TRUE(scene.ok()) << scene.error().to_string();
  EXPECT_EQ(scene->graph.f(), scene->graph.g());
}

struct Mistake {
  std::string from;
  std::string to;
  std::string error;  ///< the error behind the file's name
};

class SceneMistake : public SceneTest, public testing::WithParamInterface<Mistake> {};

TEST_P(SceneMistake, IsToldInOneLine) {
  const Result<scene::Scene> scene = load_changed(GetParam().from, GetParam().to);
  ASSERT_FALSE(scene.ok()) << GetParam().to;
  EXPECT_EQ(scene.error().to_string(), path_.string() + GetParam().error);
}

INSTANTIATE_TEST_SUITE_P(
    Sections, SceneMistake,
    testing::Values(
        Mistake{
            "[reduced]", "[redcued]",
            ":13: redcued: unknown section: received redcued; accepted reduced (the nearest), "
            "comparison, variant, let, inputs, reference, lanes, second_tier, references, system, "
            "engine, data"},
        Mistake{
            "[comparison]", "x = 1\n[comparison]",
            ":1: x: a key outside of any section: received x; accepted comparison, variant, let, "
            "inputs, reference, reduced, lanes, second_tier, references, system, engine, data"},
        Mistake{"[comparison]", "reduced = 3\n[comparison]",
                ":14:1: TOML syntax: Error while parsing table header: cannot redefine existing "
                "integer 'reduced' as table"},
        Mistake{"[inputs]", "[!]",
                ":6:2: TOML syntax: Error while parsing key: expected bare key starting character "
                "or string delimiter, saw '!'"},
        Mistake{"[reference]\nformat = \"s53e8\"\n", "",
                ": reference.format: missing: received nothing; accepted a key format"},
        Mistake{"[reference]\nformat = \"s53e8\"\n", "[reference]\n",
                ":10: reference.format: missing: received nothing; accepted a key format"},
        Mistake{"format = \"s53e8\"", "fromat = \"s53e8\"",
                ":11: reference.fromat: unknown key: received fromat; accepted format (the "
                "nearest), initiation_interval, multipliers, subnormals, sums, target_mhz"},
        Mistake{"format = \"s53e8\"", "format = \"s53e8\"\nsums = \"exact\"",
                ":12: reference.sums: not a choice: received \"exact\"; accepted composed, fused"},
        Mistake{"slack = 0.25", "slck = 0.25",
                ":23: system.slck: unknown key: received slck; accepted slack (the nearest), "
                "counter_bits, counters, device, input_registers, lanes, lanes_per_group, "
                "operand_memory, operands, "
                "order, prefix, references, request_beats, tag_bits, target_mhz"},
        Mistake{"slack = 0.25", "request_beats = 6",
                ":23: system.request_beats: not a power of two: received 6; accepted 1, 2, 4, 8, "
                "16 or \"auto\""},
        Mistake{"slack = 0.25", "operand_memory = \"registers\"",
                ":23: system.operand_memory: not a choice: received \"registers\"; accepted logic, "
                "block"},
        Mistake{"seed = 7", "sead = 7",
                ":30: data.sead: unknown key: received sead; accepted seed (the nearest), "
                "columns, count, family, file, items, pairs, radius_max, side, with, "
                "with_columns, with_count"}));

INSTANTIATE_TEST_SUITE_P(
    Types, SceneMistake,
    testing::Values(
        Mistake{"name = \"sphere_collision\"", "name = 3",
                ":2: comparison.name: wrong type: received 3 (an integer); accepted a string"},
        Mistake{"inputs = \"rounded\"", "inputs = 16",
                ":16: reduced.inputs: digits out of range: received 16; accepted \"exact\", "
                "\"rounded\", or an integer 17..53, from the lane's digits to the reference's"},
        Mistake{"inputs = \"rounded\"", "inputs = 54",
                ":16: reduced.inputs: digits out of range: received 54; accepted \"exact\", "
                "\"rounded\", or an integer 17..53, from the lane's digits to the reference's"},
        Mistake{"inputs = \"rounded\"", "inputs = \"round\"",
                ":16: reduced.inputs: not a choice: received \"round\"; accepted \"exact\", "
                "\"rounded\", or an integer 17..53, from the lane's digits to the reference's"},
        Mistake{"inputs = \"rounded\"", "inputs = 20.0",
                ":16: reduced.inputs: not a choice: received 20; accepted \"exact\", "
                "\"rounded\", or an integer 17..53, from the lane's digits to the reference's"},
        Mistake{"format = \"s17e8\"\nbound = \"profiled\"\ninputs = \"rounded\"", "inputs = 3",
                ":14: reduced.inputs: digits out of range: received 3; accepted \"exact\", "
                "\"rounded\", or an integer 4..53"},
        Mistake{"count = 512", "count = 512.0",
                ":28: data.count: wrong type: received 512 (a number); accepted an integer "
                "1..16777216"},
        Mistake{"lanes = 87", "lanes = \"many\"",
                ":21: system.lanes: wrong type: received \"many\" (a string); accepted \"auto\" or "
                "an integer 1..512"},
        Mistake{"slack = 0.25", "slack = \"0.25\"",
                ":23: system.slack: wrong type: received \"0.25\"; accepted a number from 0 to "
                "0.95"},
        Mistake{"slack = 0.25", "slack = 2020-01-01",
                ":23: system.slack: wrong type: received a date or time; accepted a number from 0 "
                "to 0.95"},
        Mistake{"\"r*\" = { range = [0, 0.1] }", "\"r*\" = [0, 0.1]",
                ":8: inputs.r*: wrong type: received an array of 2; accepted { range = [low, high] "
                "}, low <= high, or { range = \"data\" }, and a grid beside it; or { format = "
                "\"uint10\" }, or { format = \"bfloat16\" } with or without a range"}));

INSTANTIATE_TEST_SUITE_P(
    Values, SceneMistake,
    testing::Values(
        Mistake{"sphere_collision", "sphere-collision",
                ":2: comparison.name: not a name: received \"sphere-collision\"; accepted a letter "
                "or '_', then letters, digits and '_', at most 64, no Verilog or SystemVerilog "
                "keyword, no simulator's own word"},
        Mistake{"sphere_collision", "module",
                ":2: comparison.name: \"module\" is a Verilog or SystemVerilog keyword: received "
                "\"module\"; accepted a letter or '_', then letters, digits and '_', at most 64, "
                "no Verilog or SystemVerilog keyword, no simulator's own word"},
        Mistake{"s53e8", "s10e8",
                ":11: reference.format: precision out of range: received \"s10e8\"; accepted "
                "\"exact\", "
                "qW such as q40, sPeE with P 11..113 and E 2..15, or binary16, binary32, binary64, "
                "binary128"},
        Mistake{"s53e8", "double",
                ":11: reference.format: not a floating-point format: received \"double\"; accepted "
                "\"exact\", qW such as q40, sPeE with P 11..113 and E 2..15, or binary16, "
                "binary32, binary64, "
                "binary128"},
        Mistake{
            "s17e8", "s3e8",
            ":14: reduced.format: precision out of range: received \"s3e8\"; accepted \"auto\", "
            "\"exact\", "
            "sP or sPeE with P 4..52 and E 2..15, or binary16, bfloat16, binary32; qW or blockW "
            "with W 2..48, likewise W + G of qWgG and blockWgG"},
        Mistake{"s17e8", "s53",
                ":14: reduced.format: precision out of range: received \"s53\"; accepted \"auto\", "
                "\"exact\", "
                "sP or sPeE with P 4..52 and E 2..15, or binary16, bfloat16, binary32; qW or "
                "blockW with W 2..48, likewise W + G of qWgG and blockWgG"},
        Mistake{"s17e8", "float",
                ":14: reduced.format: not a floating-point format: received \"float\"; accepted "
                "\"auto\", \"exact\", sP or sPeE with P 4..52 and E 2..15, or binary16, bfloat16, "
                "binary32; "
                "qW or blockW with W 2..48, likewise W + G of qWgG and blockWgG"},
        Mistake{"s17e8", "q40g20",
                ":14: reduced.format: bits out of range: received \"q40g20\"; accepted \"auto\", "
                "\"exact\", "
                "sP or sPeE with P 4..52 and E 2..15, or binary16, bfloat16, binary32; qW or "
                "blockW with W 2..48, likewise W + G of qWgG and blockWgG"},
        Mistake{"s17e8", "s53e8",
                ":14: reduced.format: precision out of range: received \"s53e8\"; accepted "
                "\"auto\", \"exact\", sP or sPeE with P 4..52 and E 2..15, or binary16, bfloat16, "
                "binary32; "
                "qW or blockW with W 2..48, likewise W + G of qWgG and blockWgG"},
        Mistake{"s53e8", "s16e8",
                ":14: reduced.format: precision out of range: received \"s17e8\"; accepted "
                "\"auto\", \"exact\", sP or sPeE with P 4..16 and E 2..15, or binary16, bfloat16; "
                "P at most "
                "the reference's; qW or blockW with W 2..16, likewise W + G of qWgG and blockWgG"},
        Mistake{"\"profiled\"", "\"profield\"",
                ":15: reduced.bound: not a choice: received \"profield\"; accepted profiled (the "
                "nearest), certified"},
        Mistake{"1e-4", "-1e-4",
                ":17: reduced.relative_error_f: out of range: received -0.0001; accepted a number "
                "of at least 0 and below 1"},
        Mistake{"lanes = 87", "lanes = 513",
                ":21: system.lanes: out of range: received 513; accepted \"auto\" or an integer "
                "1..512"},
        Mistake{"references = \"auto\"", "references = 17",
                ":22: system.references: out of range: received 17; accepted \"auto\" or an "
                "integer 0..16"},
        Mistake{"slack = 0.25", "slack = nan",
                ":23: system.slack: out of range: received nan; accepted a number from 0 to 0.95"},
        Mistake{"slack = 0.25", "counter_bits = 7",
                ":23: system.counter_bits: out of range: received 7; accepted 0 (no counters) or "
                "an integer 8..64"},
        Mistake{"slack = 0.25", "counters = \"axi_lite\"\ncounter_bits = 0",
                ":23: system.counters: contradicts counter_bits = 0: received \"axi_lite\"; "
                "accepted \"none\""},
        Mistake{
            "slack = 0.25", "counters = \"none\"\ncounter_bits = 32",
            ":24: system.counter_bits: contradicts counters = \"none\": received 32; accepted 0"},
        Mistake{"slack = 0.25", "counters = \"axi_lite\"\ncounter_bits = 15",
                ":24: system.counter_bits: too narrow for counters = \"axi_lite\": received 15; "
                "accepted an integer 16..64"},
        Mistake{"count = 512", "count = 0",
                ":28: data.count: out of range: received 0; accepted an integer 1..16777216"},
        Mistake{"\"uniform_spheres\"", "\"cubes\"",
                ":27: data.items: not a choice: received \"cubes\"; accepted uniform, "
                "uniform_spheres, sphere_family"},
        Mistake{"seed = 7", "file = \"a.csv\"",
                ":27: data.items: two sources of data: received items and file; accepted items = "
                "\"uniform\", \"uniform_spheres\" or \"sphere_family\", or file = a .pdb, .csv or "
                ".npy file"},
        Mistake{"items = \"uniform_spheres\"\n", "",
                ":26: data: no source of data: received neither items nor file; accepted items = "
                "\"uniform\", \"uniform_spheres\" or \"sphere_family\", or file = a .pdb, .csv or "
                ".npy file"},
        Mistake{
            "items = \"uniform_spheres\"", "file = \"a.txt\"",
            ":27: data.file: not a data file by its ending: received \"a.txt\"; accepted a file "
            "that ends in .pdb, .csv or .npy"},
        Mistake{"pairs = \"all\"", "pairs = \"some\"",
                ":31: data.pairs: not a choice: received \"some\"; accepted all, cross, arg_min"}));

INSTANTIATE_TEST_SUITE_P(
    Inputs, SceneMistake,
    testing::Values(
        Mistake{"\"r*\"", "\"q*\"",
                ":8: inputs.q*: matches no input of f and g: received \"q*\"; accepted cxi, cxj, "
                "cyi, cyj, czi, czj, ri, rj"},
        Mistake{"\"r*\"", "\"*i\"",
                ":8: inputs.*i: two patterns match the input cxi: received \"c*\" and \"*i\"; "
                "accepted one pattern, or the exact key cxi"},
        Mistake{"range = [0, 100]", "rnage = [0, 100]",
                ":7: inputs.c*.rnage: unknown key: received rnage; accepted range (the nearest), "
                "format, grid"},
        Mistake{"range = [0, 100]", "range = [100, 0]",
                ":7: inputs.c*.range: the range is empty: received [100, 0]; accepted [low, high], "
                "low <= high, or \"data\""},
        Mistake{"range = [0, 100]", "range = [0]",
                ":7: inputs.c*.range: not a range: received an array of 1; accepted [low, high], "
                "low <= high, or \"data\""},
        Mistake{"range = [0, 100]", "range = [0, inf]",
                ":7: inputs.c*.range: the high end is not a finite number: received inf; accepted "
                "[low, high], low <= high, or \"data\"; ends are finite numbers, as fractions at "
                "most 131072 bits above and below the bar"},
        Mistake{"range = [0, 100]", "range = [\"1e-99999999\", 1]",
                ":7: inputs.c*.range: the low end needs too many digits: received "
                "\"1e-99999999\"; accepted [low, high], low <= high, or \"data\"; ends are "
                "finite numbers, as fractions at most 131072 bits above and below the bar"},
        Mistake{"range = [0, 100]", "range = [\"zero\", 1]",
                ":7: inputs.c*.range: the low end is not a finite number: received \"zero\"; "
                "accepted [low, high], low <= high, or \"data\"; ends are finite numbers, as "
                "fractions at most 131072 bits above and below the bar"},
        Mistake{"range = [0, 100]", "range = \"date\"",
                ":7: inputs.c*.range: not a range: received \"date\"; accepted [low, high], low <= "
                "high, or \"data\""}));

INSTANTIATE_TEST_SUITE_P(
    Expressions, SceneMistake,
    testing::Values(
        Mistake{"(ri + rj)^2", "(ri + rj)^0",
                ":4:16: comparison.g: power out of range: received 0; accepted a number other than "
                "0 of at most 1024 either side (16 if it is whole and below 0), a fraction over at "
                "most 1000000"},
        Mistake{
            "g = \"(ri + rj)^2\"", "g = '''ri\n  + $'''",
            ":5:5: comparison.g: unexpected character: received '$'; accepted a number, a name, "
            "a function call, '(' or '-'"},
        Mistake{"g = \"(ri + rj)^2\"", "g = \"\"",
                ":4:6: comparison.g: unexpected end: received the end; accepted a number, a name, "
                "a function call, '(' or '-'"},
        Mistake{"(ri + rj)^2", "\\u0072i + $",
                ":4: comparison.g: unexpected character at character 6 of the text: received '$'; "
                "accepted a number, a name, a function call, '(' or '-'"},
        Mistake{"[inputs]", "[let]\nspare = \"1 +* 2\"\n[inputs]",
                ":7:13: let.spare: unexpected character: received '*'; accepted a number, a name, "
                "a function call, '(' or '-'"},
        Mistake{"[inputs]", "[let]\nri = \"1 + rj\"\nrj = \"ri\"\n[inputs]",
                ":8:7: let.rj: a let needs itself: received ri -> rj -> ri; accepted lets without "
                "cycles"},
        Mistake{"[inputs]", "[let]\nsqrt = \"1\"\n[inputs]",
                ":7: let.sqrt: sqrt is a function: received \"sqrt\"; accepted a letter or '_', "
                "then letters, digits and '_', at most 64, no Verilog or SystemVerilog keyword, no "
                "simulator's own word, no function"},
        Mistake{"(ri + rj)^2", "ri + 1e40",
                ":11: reference.format: it cannot hold the constant about 1e+40: received s53e8; "
                "accepted a format with more exponent bits"},
        Mistake{"(ri + rj)^2", "ri + 1e-80",
                ":11: reference.format: it cannot hold the constant about 1e-80: received s53e8; "
                "accepted a format with more exponent bits"}));

TEST_F(SceneTest, MistakesInTomlAreToldInTheSameForm) {
  const Result<scene::Scene> scene = load_changed("slack = 0.25", "slack = = 0.25");
  ASSERT_FALSE(scene.ok());
  EXPECT_EQ(scene.error().file, path_.string());
  EXPECT_EQ(scene.error().line, 23);
  EXPECT_GT(scene.error().column, 0);
  EXPECT_EQ(scene.error().to_string().find('\n'), std::string::npos);
}

TEST_F(SceneTest, ExpressionsWithoutInputsAreRefused) {
  const Result<scene::Scene> scene = load(
      "[comparison]\nname = \"n\"\nf = \"1\"\ng = \"2\"\n[reference]\nformat = \"binary64\"\n");
  ASSERT_FALSE(scene.ok());
  EXPECT_EQ(scene.error().to_string(),
            path_.string() +
                ":3: comparison.f: f and g name no input: received constants only; "
                "accepted at least one input name");
}

TEST_F(SceneTest, MissingFilesAreTold) {
  const Result<scene::Scene> scene = scene::load_scene(directory_.path() / "none.toml", {});
  ASSERT_FALSE(scene.ok());
  EXPECT_EQ(scene.error().message, "cannot read the file");
  EXPECT_EQ(scene.error().received, "no such file");
  EXPECT_FALSE(scene::load_scene(directory_.path(), {}).ok());
}

TEST_F(SceneTest, MutatedScenesGiveErrorsNotCrashes) {
  std::mt19937 random(1);
  int errors = 0;
  for (int round = 0; round < 3000; ++round) {
    std::string text = sphere_scene;
    for (auto changes = 1 + random() % 4; changes > 0; --changes) {
      const std::size_t place = random() % text.size();
      switch (random() % 4) {
        case 0: text[place] = static_cast<char>(random() % 256); break;
        case 1: text.erase(place, random() % 20); break;
        case 2: text.insert(place, 1, sphere_scene[random() % sphere_scene.size()]); break;
        default: text.insert(place, sphere_scene, random() % sphere_scene.size(), random() % 60);
      }
    }
    const Result<scene::Scene> scene = load(text);
    if (scene.ok()) continue;
    ++errors;
    ASSERT_EQ(scene.error().file, path_.string()) << text;
    ASSERT_FALSE(scene.error().message.empty()) << text;
  }
  EXPECT_GT(errors, 2000);
}

}  // namespace
}  // namespace mixcmp::test::scene_test
