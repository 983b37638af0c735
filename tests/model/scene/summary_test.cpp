#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "generator/present/report/summary_report.hpp"
#include "model/judge/workload/load_comparisons.hpp"
#include "tests/support/scratch_directory.hpp"

namespace mixcmp::test::summary_test {
namespace {

const std::filesystem::path examples = MIXCMP_SOURCE_DIR "/examples";
/// The choices with which the examples are read, since their own choices may change.
const std::vector<std::string> choices = {"reference.format=s53e8",    "reduced.format=s17e8",
                                          "reduced.inputs=exact",      "system.lanes=8",
                                          "inputs.c*={range=[0,100]}", "inputs.r*={range=[1,100]}"};

scene::Scene load(const std::filesystem::path& path,
                  const std::vector<std::string>& overrides = {}) {
  Result<scene::Scene> scene = scene::load_scene(path, overrides);
  EXPECT_TRUE(scene.ok()) << scene.error().to_string();
  return std::move(scene).value();
}

const scene::RangeQuestion& event(const scene::DatapathSummary& datapath,
                                  const std::string& question) {
  for (const scene::RangeQuestion& finding : datapath.events) {
    if (finding.question == question) return finding;
  }
  ADD_FAILURE() << "no " << question;
  return datapath.events.front();
}

TEST(Summary, NamesFormatsOfOperandsAndTheirWidening) {
  std::vector<std::string> formats(choices.begin(), choices.end() - 2);  // without ranges
  formats.emplace_back("inputs.c*={format=\"bfloat16\"}");
  formats.emplace_back("inputs.r*={format=\"E4M3\",range=[1,100]}");
  const scene::Scene scene = load(examples / "sphere_collision/scene.toml", formats);
  const std::string text = report::to_text(scene::summarise(scene, nullptr));
  EXPECT_NE(text.find("s8e8 (bfloat16), widened to s53e8, no range\n"), std::string::npos) << text;
  EXPECT_NE(text.find("E4M3, widened to s53e8, [1, 100]\n"), std::string::npos) << text;
}

TEST(Summary, CountsTheSphereComparison) {
  const scene::Scene scene = load(examples / "sphere_collision/scene.toml", choices);
  const scene::Summary summary = scene::summarise(scene, nullptr);
  ASSERT_EQ(summary.datapaths.size(), 2U);
  const auto count = [](const scene::DatapathSummary& datapath, Operation operation,
                        const std::string& operands, const std::string& result) {
    int total = 0;
    for (const scene::OperatorCount& counted : datapath.operators) {
      const bool same = counted.operation == operation &&
                        counted.operand_format.name() == operands &&
                        counted.format.name() == result;
      total += same ? counted.count : 0;
    }
    return total;
  };
  const scene::DatapathSummary& reference = summary.datapaths[0];
  EXPECT_EQ(reference.operators.size(), 3U);
  EXPECT_EQ(count(reference, Operation::subtract, "s53e8", "s53e8"), 3);
  EXPECT_EQ(count(reference, Operation::square, "s53e8", "s53e8"), 4);
  EXPECT_EQ(count(reference, Operation::add, "s53e8", "s53e8"), 3);
  const scene::DatapathSummary& lane = summary.datapaths[1];
  EXPECT_EQ(lane.operators.size(), 4U);
  EXPECT_EQ(count(lane, Operation::subtract, "s53e8", "s17e8"), 3);
  EXPECT_EQ(count(lane, Operation::square, "s17e8", "s17e8"), 4);
  EXPECT_EQ(count(lane, Operation::add, "s17e8", "s17e8"), 2);
  EXPECT_EQ(count(lane, Operation::add, "s53e8", "s17e8"), 1);
}

TEST(Summary, TellsWhatTheRangesRuleOut) {
  const scene::Scene scene = load(examples / "sphere_collision/scene.toml", choices);
  const scene::Summary summary = scene::summarise(scene, nullptr);
  EXPECT_EQ(summary.sides[0].value.high, 30'000);
  EXPECT_EQ(summary.sides[1].value.high, 40'000);
  EXPECT_EQ(summary.sides[0].negative.answer, scene::Possibility::ruled_out);
  EXPECT_EQ(summary.sides[0].zero.answer, scene::Possibility::possible);
  EXPECT_EQ(event(summary.datapaths[0], "overflow").answer, scene::Possibility::ruled_out);
  EXPECT_EQ(event(summary.datapaths[0], "underflow").answer, scene::Possibility::possible);
  EXPECT_EQ(summary.datapaths[0].events.size(), 2U);  // no division, no root
}

/// If a * b overflows, the reference goes on with 1 / inf = 0, and divides by it.
TEST(Summary, FollowsTheReferencePastAnOverflow) {
  const test::ScratchDirectory directory;
  const auto path = directory.path() / "scene.toml";
  std::ofstream(path)
      << "[comparison]\nname = \"n\"\nf = \"c / (1 / (a * b))\"\n"
         "g = \"1 / (a * b)\"\n[inputs]\nc = { range = [0, 1] }\n"
         "a = { range = [1, 1e30] }\nb = { range = [1, 1e30] }\n[reference]\nformat = \"s24e8\"\n";
  const scene::Summary summary = scene::summarise(load(path), nullptr);
  EXPECT_EQ(event(summary.datapaths[0], "division by zero").answer, scene::Possibility::possible);
  EXPECT_EQ(summary.sides[1].zero.answer, scene::Possibility::possible);
  EXPECT_EQ(summary.sides[1].value.low, 0);
}

TEST(Summary, MissingRangesLeaveItUnknown) {
  const test::ScratchDirectory directory;
  const auto path = directory.path() / "scene.toml";
  std::ofstream(path) << "[comparison]\nname = \"n\"\nf = \"sqrt(x) / y\"\ng = \"x + z^2\"\n"
                         "[inputs]\ny = { range = [0, 1] }\n[reference]\nformat = \"binary32\"\n";
  const scene::Scene scene = load(path);
  const scene::Summary summary = scene::summarise(scene, nullptr);
  ASSERT_EQ(summary.datapaths.size(), 1U);
  const scene::RangeQuestion root = event(summary.datapaths[0], "root of a negative number");
  EXPECT_EQ(root.answer, scene::Possibility::unknown);
  EXPECT_EQ(root.rangeless, std::vector<std::string>{"x"});
  EXPECT_EQ(root.operations, std::vector<std::string>{"sqrt(x)"});
  EXPECT_EQ(event(summary.datapaths[0], "overflow").rangeless,
            (std::vector<std::string>{"x", "z"}));
  EXPECT_EQ(summary.sides[1].negative.answer, scene::Possibility::unknown);
  const std::string text = report::to_text(summary);
  EXPECT_NE(text.find("unknown: no range for x; in sqrt(x)\n"), std::string::npos) << text;
  EXPECT_NE(text.find("  reduced            auto"), std::string::npos) << text;
}

TEST(Summary, TellsOfDataThatBreakTheRanges) {
  const auto path = examples / "protein_clash/scene.toml";
  const scene::Scene good = load(path);
  const data::Comparisons data = workload::load_comparisons(good).value();
  EXPECT_EQ(scene::summarise(good, &data).data->out_of_range, 0U);
  EXPECT_EQ(scene::summarise(good, &data).data->comparisons, 207'046U);
  const scene::Scene narrow = load(path, {"inputs.r*={ range = [1.2, 1.85] }"});
  const scene::Summary summary = scene::summarise(narrow, &data);
  EXPECT_EQ(summary.data->out_of_range, 4U);  // the four selenium atoms
  EXPECT_EQ(summary.data->first_out_of_range, "A 151 MSE SE: r = 1.9 is outside [1.2, 1.85] of ri");
}

TEST(Summary, OnlyTheItemsThatAnInputTakesCount) {
  const test::ScratchDirectory directory;
  const auto path = directory.path() / "scene.toml";
  std::ofstream(directory.path() / "data.csv") << "x\n9\n1\n2\n8\n";
  std::ofstream(path) << "[comparison]\nname = \"n\"\nf = \"xi\"\ng = \"xj\"\n[inputs]\n"
                         "xi = { range = [0, 5] }\n[reference]\nformat = \"binary32\"\n"
                         "[data]\nfile = \"data.csv\"\npairs = \"all\"\n";
  const scene::Scene scene = load(path);
  const data::Comparisons data = workload::load_comparisons(scene).value();
  const scene::Summary summary = scene::summarise(scene, &data);
  EXPECT_EQ(summary.data->out_of_range, 1U);  // 9; 8 is never an xi
  EXPECT_EQ(summary.data->first_out_of_range, "data.csv:2: x = 9 is outside [0, 5] of xi");
}

TEST(Summary, BothTablesAreHeldAgainstTheRanges) {
  const test::ScratchDirectory directory;
  const auto path = directory.path() / "scene.toml";
  std::ofstream(directory.path() / "points.csv") << "p\n1\n2\n7\n";
  std::ofstream(directory.path() / "centres.csv") << "c\n9\n1\n4\n8\n";
  std::ofstream(path) << "[comparison]\nname = \"n\"\nf = \"abs(p - ci)\"\ng = \"abs(p - cj)\"\n"
                         "[inputs]\np = { range = [0, 5] }\ncj = { range = [0, 5] }\n"
                         "[reference]\nformat = \"binary32\"\n[data]\nfile = \"points.csv\"\n"
                         "with = \"centres.csv\"\npairs = \"arg_min\"\n";
  const scene::Scene scene = load(path);
  const data::Comparisons data = workload::load_comparisons(scene).value();
  const scene::Summary summary = scene::summarise(scene, &data);
  EXPECT_EQ(summary.data->rows, 3U);
  EXPECT_EQ(summary.data->with_rows, 4U);
  EXPECT_EQ(summary.data->comparisons, 9U);
  EXPECT_EQ(summary.data->out_of_range, 2U);  // the point 7, the centre 8; 9 is never a cj
  EXPECT_EQ(summary.data->first_out_of_range, "points.csv:4: p = 7 is outside [0, 5] of p");
  const std::string text = report::to_text(summary);
  EXPECT_NE(text.find("  with               centres.csv\n  candidates         4\n"),
            std::string::npos)
      << text;
}

TEST(Summary, JsonHoldsTheSame) {
  const scene::Scene scene = load(examples / "protein_clash/scene.toml", choices);
  const data::Comparisons data = workload::load_comparisons(scene).value();
  const nlohmann::json json = report::to_json(scene::summarise(scene, &data));
  EXPECT_EQ(json["name"], "protein_clash");
  EXPECT_EQ(json["inputs"].size(), 8U);
  EXPECT_EQ(json["inputs"][6]["name"], "ri");
  EXPECT_EQ(json["inputs"][6]["range"][1], "100");
  EXPECT_EQ(json["f"]["negative"]["answer"], "ruled out");
  EXPECT_EQ(json["g"]["zero"]["answer"], "ruled out");
  EXPECT_EQ(json["datapaths"]["lane"]["format"], "s17e8");
  EXPECT_EQ(json["datapaths"]["reference"]["operators"][0]["count"], 3);
  EXPECT_EQ(json["data"]["comparisons"], 207'046U);
  EXPECT_EQ(json["system"]["lanes"], 8);
}

/// Theorem 12 of docs/error_bounds.md: one product, gradual underflow, terms below 2^m together.
TEST(Summary, TellsWhichFusedSumsMayErrByMoreThanComposedOnes) {
  const auto loose = [](const std::string& f, const std::string& range,
                        const std::string& subnormals) {
    const test::ScratchDirectory directory;
    const auto path = directory.path() / "loose.toml";
    std::ofstream(path) << "[comparison]\nname = \"loose\"\nf = \"" << f << "\"\ng = \"e\"\n"
                        << "[inputs]\n\"*\" = { range = " << range << " }\n[reference]\n"
                        << "format = \"s24e8\"\nsums = \"fused\"\nsubnormals = \"" << subnormals
                        << "\"\n";
    const scene::Scene scene = load(path);
    return scene::summarise(scene, nullptr).reference.first_loose_sum;
  };
  EXPECT_EQ(loose("max(a * b + c, d)", "[0, 1]", "gradual"), "a * b + c");
  EXPECT_EQ(loose("max(a * b + c, d)", "[0, 1]", "flush"), "");
  EXPECT_EQ(loose("max(a * b + c * d, d)", "[0, 1]", "gradual"), "");
  EXPECT_EQ(loose("a * b + c", "[0, 1]", "gradual"), "") << "compared, not rounded";
  EXPECT_EQ(loose("max(a * b + c, d)", "[\"0x1p-126\", 1]", "gradual"), "");
  EXPECT_EQ(loose("max(a * b + c, d)", "[\"0x1p-128\", 1]", "gradual"), "a * b + c");
}

TEST(Summary, DeeplySharedExpressionsPrintShort) {
  const test::ScratchDirectory directory;
  const auto path = directory.path() / "scene.toml";
  std::string lets = "d0 = \"x\"\n";
  for (int k = 1; k <= 50; ++k) {
    const std::string below = "d" + std::to_string(k - 1);
    lets += "d" + std::to_string(k) + " = \"" + below + " * (" + below + " + 1)\"\n";
  }
  std::ofstream(path) << "[comparison]\nname = \"n\"\nf = \"d50\"\ng = \"1\"\n[let]\n"
                      << lets << "[reference]\nformat = \"binary128\"\n";
  const scene::Scene scene = load(path);
  const scene::Summary summary = scene::summarise(scene, nullptr);
  EXPECT_LT(report::to_text(summary).size(), 10'000U);
  std::vector<std::string> operations = event(summary.datapaths[0], "overflow").operations;
  const std::set<std::string> different(operations.begin(), operations.end());
  EXPECT_EQ(operations.size(), different.size()) << "most are cut short to the same words";
}

}  // namespace
}  // namespace mixcmp::test::summary_test
