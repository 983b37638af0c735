#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "model/lane/error/certified_lane.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/graphs.hpp"
#include "tests/support/simulated_system.hpp"
#include "tests/support/sphere.hpp"

/// Systems that compare several parts: the hardware is the golden model bit for bit, and where a
/// lane decided, its verdict is the truth; on every pair of encodings, NaNs and infinities too.
namespace mixcmp::test::parts_test {
namespace {

struct Case {
  const char* name;
  std::vector<std::pair<std::string, std::string>> parts;
  Combination combination;
  const char* lane = "s3e4";
  LaneInputs inputs = LaneInputs::rounded;
  std::optional<Range> range = {};
  bool certified = true;
};

void PrintTo(const Case& c, std::ostream* stream) {
  *stream << c.name;
}

error::Lane lane_of(const Case& c, const TypedGraph& graph, std::size_t inputs) {
  if (!c.certified) return error::profiled_lane(graph, mpq_class(1, 8), mpq_class(1, 8));
  const std::vector<std::optional<Range>> ranges(inputs, c.range);
  return error::certified_lane(graph, {.ranges = ranges}).value();
}

design::Design design_of(const Case& c, const Graph& graph, FloatFormat reference) {
  const TypedGraph reduced = lane_graph(graph, reference, {format(c.lane)}, c.inputs);
  return {.name = "parts",
          .inputs = graph.inputs(),
          .lanes = {{.lane = lane_of(c, reduced, graph.inputs().size()), .inputs = c.inputs}},
          .reference = reference_graph(graph, {reference}),
          .references = {{}},
          .system = {}};
}

data::Table every_pair(FloatFormat format) {
  data::Table table{.format = format, .columns = {"a", "b"}, .values = {}, .labels = {}};
  const Bits count = Bits{1} << format.width();
  for (Bits a = 0; a < count; ++a) {
    for (Bits b = 0; b < count; ++b) table.values.insert(table.values.end(), {a, b});
  }
  return table;
}

class SeveralParts : public testing::TestWithParam<Case> {};

TEST_P(SeveralParts, AreDecidedAsTheGoldenModelSaysAndTruly) {
  const Case& c = GetParam();
  const Graph graph = graph_of(c.parts, c.combination);
  const FloatFormat s4e4 = format_of(4, 4);
  const design::Design design = design_of(c, graph, s4e4);
  const auto data = data::Comparisons::rows(every_pair(s4e4), design.inputs);
  ASSERT_TRUE(data.ok()) << data.error().to_string();
  const verilator_tb::VerifyReport report =
      simulate(design, *data, {.truth = verilator_tb::TruthCheck{.graph = &graph}});
  EXPECT_TRUE(report.passed()) << to_text(report);
  EXPECT_EQ(report.comparisons, 65'536u);
  EXPECT_GT(report.recomputations, 50u);
  EXPECT_LT(report.recomputations, 62'000u) << "the lane decides nothing worth testing";
  const auto seen = std::count_if(report.verdicts.begin(), report.verdicts.end(),
                                  [](std::uint64_t count) { return count > 0; });
  EXPECT_GE(seen, 3) << to_text(report);
  if (c.certified) {
    EXPECT_EQ(report.truth->wrong_by_lane, 0u) << to_text(report);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Systems, SeveralParts,
    testing::Values(
        Case{"all_of_two", {{"a", "b"}, {"-b", "max(a, 0.25)"}}, Combination::all},
        Case{"any_of_two", {{"a", "b"}, {"-b", "max(a, 0.25)"}}, Combination::any},
        // Bounds of three kinds, parts of different latency, nodes in common.
        Case{"all_of_four",
             {{"a * b", "b"}, {"a * b - a", "b^2"}, {"sqrt(abs(a))", "a / b"}, {"b", "a * b"}},
             Combination::all,
             "s4e5",
             LaneInputs::exact},
        // A divisor and a radicand that the second part must not trust too close to zero.
        Case{"all_with_conditions",
             {{"a * b", "b"}, {"a / (b - 0.3)", "sqrt(a - 0.3)"}},
             Combination::all,
             "s4e5"},
        Case{"any_in_ranges",
             {{"a + b", "a * b"}, {"a - b * b", "b"}, {"b", "3"}},
             Combination::any,
             "s3e5",
             LaneInputs::rounded,
             Range{mpq_class(1, 2), 4}},
        Case{"any_profiled",
             {{"a * b", "b"}, {"a + b", "a"}},
             Combination::any,
             "s3e4",
             LaneInputs::rounded,
             std::nullopt,
             false}),
    [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace mixcmp::test::parts_test
