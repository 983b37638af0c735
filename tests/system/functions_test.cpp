#include <fmt/core.h>
#include <gtest/gtest.h>

#include "model/base/number/exact.hpp"
#include "model/judge/workload/load_comparisons.hpp"
#include "model/scene/scene.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/simulated_system.hpp"

/// Systems whose lanes and references compute functions by piecewise polynomials: the hardware says
/// what the golden model says, and no lane decides against the real numbers.
namespace mixcmp::test::functions_test {
namespace {

using verilator_tb::SimulatorKind;
using verilator_tb::VerifyReport;

struct Case {
  const char* name;
  const char* scene;  ///< the sections that differ
  SimulatorKind simulator = SimulatorKind::verilator;
};

void PrintTo(const Case& c, std::ostream* stream) {
  *stream << c.name;
}

scene::Scene scene_of(const Case& c) {
  const std::string text =
      fmt::format("[comparison]\nname = \"functions\"{}items = \"uniform\"\n", c.scene);
  return scene::load_scene({"functions.toml", text}, {}).value();
}

VerifyReport verified(const scene::Scene& scene, const data::Comparisons& data,
                      verilator_tb::VerifyOptions options) {
  const design::Design design = design::make_design(scene, &data).value();
  options.truth = verilator_tb::TruthCheck{.graph = &scene.graph};
  return simulate(design, data, options);
}

void expect_right(const VerifyReport& report) {
  EXPECT_TRUE(report.passed()) << to_text(report);
  EXPECT_EQ(report.truth->wrong_by_lane, 0u) << to_text(report);
  EXPECT_GT(report.truth->checked, 0u);
  EXPECT_GT(report.recomputations, 0u) << "the lanes decide everything";
  EXPECT_LT(report.recomputations, report.comparisons) << "the lanes decide nothing";
  EXPECT_GT(report.verdicts[static_cast<std::size_t>(Verdict::less)], 0u);
}

class Functions : public testing::TestWithParam<Case> {};

TEST_P(Functions, AreDecidedAsTheGoldenModelSaysAndTruly) {
  const scene::Scene scene = scene_of(GetParam());
  const data::Comparisons data = workload::load_comparisons(scene).value();
  expect_right(verified(scene, data, {.simulator = GetParam().simulator}));
}

const Case exponential = {"exponential", R"toml(
f = "u"
g = "exp(-d)"
[inputs]
u = { range = [0, 1], format = "binary32" }
d = { range = [0, 16], format = "binary32" }
[reference]
format = "q32"
[reduced]
format = "q8"
[system]
lanes = 2
references = 1
[data]
count = 3000
)toml"};

const Case logarithm = {"logarithm", R"toml(
f = "log(p)"
g = "log2(r) - x"
[inputs]
p = { range = [0.01, 1], format = "binary16" }
r = { range = [0.25, 9], format = "binary16" }
x = { range = [-1, 1], format = "binary16" }
[reference]
format = "q20"
[reduced]
format = "q6"
[system]
lanes = 1
references = 1
[data]
count = 3000
)toml",
                        SimulatorKind::icarus};

const Case angles = {"signed_angles_in_two_parts", R"toml(
f = ["sin(a)", "cos(a - b)"]
g = ["cos(b) * c", "tan(0.25 * a)"]
combine = "any"
[inputs]
a = { range = [-3.2, 3.2], format = "binary32" }
b = { range = [-7, 7], format = "binary32" }
c = { range = [-1, 1], format = "binary32" }
[reference]
format = "q24"
[reduced]
format = "q9"
[system]
lanes = 1
references = 1
[data]
count = 3000
)toml"};

/// Operands of int8 and of binary32, lanes of two widths.
const Case mixed = {"int8_and_binary32_in_lanes_of_two_widths", R"toml(
f = "atan(k * 0.125) * x"
g = "tanh(x) + 0.25"
[inputs]
k = { format = "int8" }
x = { range = [-2, 2], format = "binary32" }
[reference]
format = "q28"
[[lanes]]
count = 1
format = "q5"
[[lanes]]
count = 1
format = "q11"
[system]
references = 1
[data]
count = 3000
)toml",
                    SimulatorKind::icarus};

/// Operands near 0, which functions read as their encodings: as the low bits of it, and less the
/// first exponent; by look-ups and by polynomials.
const Case decades = {"operands_of_many_decades", R"toml(
f = "t * log(u) + x / v"
g = "w^-0.5"
[inputs]
u = { range = [0.0001220703125, 1], format = "binary32" }
v = { range = [0.002, 30], format = "binary16" }
w = { range = [0.01, 9], format = "binary32" }
t = { range = [0, 16], format = "binary32" }
x = { range = [-1, 1], format = "binary16" }
[reference]
format = "q30"
[reduced]
format = "q9"
[system]
lanes = 1
references = 1
[data]
count = 3000
)toml"};

INSTANTIATE_TEST_SUITE_P(Of, Functions,
                         testing::Values(exponential, logarithm, angles, mixed, decades),
                         [](const auto& instance) { return std::string(instance.param.name); });

/// A function of one item's operands is computed when the item is loaded.
class FunctionsInEngines : public testing::TestWithParam<Case> {};

TEST_P(FunctionsInEngines, AreDecidedAsTheGoldenModelSaysAndTruly) {
  const scene::Scene scene = scene_of(GetParam());
  const data::Comparisons data = workload::load_comparisons(scene).value();
  expect_right(verified(scene, data,
                        {.simulator = GetParam().simulator,
                         .traffic = verilator_tb::TrafficKind::stressed,
                         .resets = 1}));
}

const Case pairwise = {"pairwise", R"toml(
f = "exp(-xi) * wj"
g = "exp(-xj) * wi"
[inputs]
"x*" = { range = [0, 4], format = "binary32" }
"w*" = { format = "uint5" }
[reference]
format = "q24"
[reduced]
format = "q6"
[engine]
kind = "pairwise"
capacity = 64
lanes_per_group = 2
[system]
lanes = 2
references = 1
[data]
count = 60
pairs = "all"
)toml"};

const Case arg_min = {"arg_min", R"toml(
f = "log1p(xi) + abs(py - yi)"
g = "log1p(xj) + abs(py - yj)"
[inputs]
"x*" = { range = [0, 4], format = "binary32" }
"*y*" = { range = [-1, 1], format = "binary16" }
[reference]
format = "q24"
[reduced]
format = "q6"
[engine]
kind = "arg_min"
[system]
lanes = 3
references = 1
[data]
count = 200
with_count = 4
pairs = "arg_min"
)toml",
                      SimulatorKind::icarus};

/// The word of an item has x in fixed point, and an encoding of x of which one function reads fewer
/// bits than the other.
const Case pairwise_decades = {"pairwise_of_many_decades", R"toml(
f = "log(xi) * wj + xj / 64 - 1 / xi"
g = "log(xj) * wi + xi / 64 - 1 / xj"
[inputs]
"x*" = { range = [0.001, 4], format = "binary32" }
"w*" = { range = [0, 4], format = "binary16" }
[reference]
format = "q26"
[reduced]
format = "q8"
[engine]
kind = "pairwise"
capacity = 64
lanes_per_group = 2
[system]
lanes = 2
references = 1
[data]
count = 60
pairs = "all"
)toml"};

INSTANTIATE_TEST_SUITE_P(Of, FunctionsInEngines,
                         testing::Values(pairwise, arg_min, pairwise_decades),
                         [](const auto& instance) { return std::string(instance.param.name); });

/// Every pair of numbers of a small format, infinities and NaNs among them, and numbers outside of
/// the declared range.
class FunctionsOfSmallFormats : public testing::TestWithParam<Case> {};

TEST_P(FunctionsOfSmallFormats, DecideEveryPair) {
  const scene::Scene scene = scene_of(GetParam());
  const FloatFormat arriving = *scene.operand_formats[0].floating(), read = scene.reference.format;
  data::Table table{.format = read, .columns = {"a", "b"}, .values = {}, .labels = {}};
  for (Bits pair = 0; pair < Bits{1} << 2 * arriving.width(); ++pair) {
    for (const Bits operand : {pair >> arriving.width(), pair & ((1 << arriving.width()) - 1)}) {
      table.values.push_back(converted(read, arriving, operand));
    }
  }
  const auto data = data::Comparisons::rows(std::move(table), scene.graph.inputs()).value();
  const VerifyReport report =
      verified(scene, data, {.judge = verilator_tb::JudgeKind::golden_model});
  expect_right(report);
  EXPECT_EQ(report.comparisons, 1u << 14);
  EXPECT_GT(report.verdicts[static_cast<std::size_t>(Verdict::unordered)], 0u);
}

const Case of_both_signs = {"of_both_signs", R"toml(
f = "exp2(a) - 1"
g = "atan(b) * a"
[inputs]
"*" = { range = [-3, 5], format = "s4e3" }
[reference]
format = "q16"
[reduced]
format = "q5"
[system]
lanes = 1
references = 1
[data]
count = 3000
)toml"};

/// The range of a ends at the last power of two of its format.
const Case near_zero = {"near_0", R"toml(
f = "log2(a)"
g = "1 / b - a"
[inputs]
a = { range = [0.03125, 128], format = "s3e4" }
b = { range = [0.03125, 12], format = "s3e4" }
[reference]
format = "q16"
[reduced]
format = "q5"
[system]
lanes = 1
references = 1
[data]
count = 3000
)toml"};

INSTANTIATE_TEST_SUITE_P(Of, FunctionsOfSmallFormats, testing::Values(of_both_signs, near_zero),
                         [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace mixcmp::test::functions_test
