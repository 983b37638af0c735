#include <gtest/gtest.h>

#include "model/judge/golden/evaluate.hpp"
#include "model/lane/fixed/fixed_lane.hpp"
#include "tests/support/graphs.hpp"
#include "tests/support/simulated_system.hpp"
#include "tests/support/sphere.hpp"

/// Systems whose references round sums once: each verdict is the golden model's.
namespace mixcmp::test::fused_reference_test {
namespace {

using verilator_tb::SimulatorKind;

struct Case {
  const char* name;
  std::vector<std::pair<std::string, std::string>> parts;
  int interval = 1;
  Subnormals subnormals = Subnormals::gradual;
  scene::Multipliers multipliers = scene::Multipliers::embedded;
  SimulatorKind simulator = SimulatorKind::verilator;
  const char* reference = "s4e4";
};

void PrintTo(const Case& c, std::ostream* stream) {
  *stream << c.name;
}

/// A lane of so few bits that references decide most comparisons.
design::Design design_of(const Case& c) {
  const Graph graph = graph_of(c.parts, Combination::any);
  const Range range = {-6, 6};
  const fixed::FixedOptions options = {.format = {2, false, 0},
                                       .bound = {},
                                       .ranges = {graph.inputs().size(), std::optional(range)}};
  const Arithmetic arithmetic = {format(c.reference), Rounding::nearest_even, c.subnormals,
                                 Sums::fused};
  return {.name = "fused",
          .inputs = graph.inputs(),
          .lanes = {{.lane = fixed::fixed_lane(graph, format(c.reference), options).value(),
                     .count = 3}},
          .reference = reference_graph(graph, arithmetic),
          .references = {{.structure = {c.multipliers, c.interval}, .count = 1}},
          .system = {}};
}

/// Every pair of encodings, NaNs and infinities too; in Icarus every `step`-th.
data::Comparisons pairs(const design::Design& design, Bits step) {
  const FloatFormat format = design.reference.input_format;
  data::Table table{.format = format, .columns = {"a", "b"}, .values = {}, .labels = {}};
  const Bits count = Bits{1} << (2 * format.width());
  for (Bits pair = 0; pair < count; pair += step) {
    table.values.insert(table.values.end(),
                        {pair >> format.width(), pair & low_mask(format.width())});
  }
  return data::Comparisons::rows(table, design.inputs).value();
}

/// Verdicts that composed arithmetic would give differently.
int unlike_composed(const design::Design& design, const TypedGraph& composed,
                    const data::Comparisons& data) {
  int unlike = 0;
  std::vector<Bits> operands(design.inputs.size());
  for (std::uint64_t k = 0; k < data.size(); ++k) {
    data.fetch(k, operands);
    const Verdict verdict = golden::evaluate_reference(design.reference, operands);
    unlike += verdict == golden::evaluate_reference(composed, operands) ? 0 : 1;
  }
  return unlike;
}

class FusedReference : public testing::TestWithParam<Case> {};

TEST_P(FusedReference, DecidesAsTheGoldenModelDoes) {
  const Case& c = GetParam();
  const design::Design design = design_of(c);
  const data::Comparisons data = pairs(design, c.simulator == SimulatorKind::icarus ? 7 : 1);
  const verilator_tb::VerifyReport report =
      simulate(design, data,
               {.simulator = c.simulator,
                .judge = verilator_tb::JudgeKind::golden_model,
                .traffic = verilator_tb::TrafficKind::stressed,
                .resets = 2});
  EXPECT_TRUE(report.passed()) << to_text(report);
  EXPECT_EQ(report.comparisons, data.size());
  EXPECT_GT(report.recomputations, data.size() / 4) << to_text(report);
  Arithmetic composed = design.reference.arithmetic;
  composed.sums = Sums::composed;
  const Graph graph = graph_of(c.parts, Combination::any);
  EXPECT_GT(unlike_composed(design, reference_graph(graph, composed), data), 0);
}

INSTANTIATE_TEST_SUITE_P(
    Of, FusedReference,
    testing::Values(
        Case{"squares", {{"(a - b)^2 + (a + b)^2 + b^2", "(a - 1.5)^2 + 0.3"}}},
        Case{"products_and_signs", {{"a * b - abs(b) * a + 0.7", "-a * max(a, b) - b^2 + a"}}},
        Case{"flushed_logic",
             {{"a^2 - 2 * a * b + b^2", "a * b - 0.4"}},
             1,
             Subnormals::flush,
             scene::Multipliers::logic},
        Case{"parts_share_a_sum", {{"a^2 + b^2 + 1", "3 * b"}, {"a", "a^2 + b^2 - b * 1.5"}}},
        Case{"sums_of_sums", {{"(a^2 + b * 0.7)^2 + a * b", "b * (a + b + 0.3)"}}},
        Case{"squares_of_sums", {{"(a - b)^2 + (a + 1.5)^2", "(a + b)^2 * 1.5 + (b - 0.3)^2"}}},
        Case{"products_alone", {{"a * b", "a - 0.3"}, {"b", "a^2"}}},
        Case{"roots_of_sums", {{"sqrt((a - b)^2 + a * a)", "b + 0.3"}}},
        Case{"folded_4", {{"(a - b)^2 + (a + b)^2 + b^2", "a * b + b * 1.25 + a"}}, 4},
        Case{"squares_icarus",
             {{"(a - b)^2 + (a + b)^2 + b^2", "(a - 1.5)^2 + 0.3"}},
             1,
             Subnormals::gradual,
             scene::Multipliers::embedded,
             SimulatorKind::icarus},
        Case{"squares_of_sums_icarus",
             {{"(a - b)^2 + (a + 1.5)^2", "(a + b)^2 * 1.5 + (b - 0.3)^2"}},
             1,
             Subnormals::flush,
             scene::Multipliers::embedded,
             SimulatorKind::icarus},
        Case{"products_icarus",
             {{"a * b - abs(b) * a + 0.7", "-a * max(a, b) - b^2 + a"}},
             1,
             Subnormals::gradual,
             scene::Multipliers::logic,
             SimulatorKind::icarus}),
    [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace mixcmp::test::fused_reference_test
