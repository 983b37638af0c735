#include "verilator_tb/arg_min_judge.hpp"

#include <gtest/gtest.h>

#include "generator/hardware/emit/system.hpp"
#include "model/base/number/exact.hpp"
#include "model/base/number/verdict.hpp"
#include "model/judge/workload/compare_by_reference.hpp"
#include "model/lane/fixed/fixed_lane.hpp"
#include "tests/support/graphs.hpp"
#include "tests/support/sphere.hpp"

/// The contest of an arg-min engine whose lanes and reference would choose different candidates,
/// without a simulator: the engine's choices are made up.
namespace mixcmp::test::arg_min_judge_test {
namespace {

using Choices = std::vector<std::uint64_t>;
using Point = std::pair<int, int>;

/// The format has eight digits, and so few exponents that squares below 2^-22 vanish.
FloatFormat reference_format() {
  return format("s8e5");
}

Graph squared_distances() {
  return graph_of("(x - cxi)^2 + (y - cyi)^2", "(x - cxj)^2 + (y - cyj)^2");
}

design::LaneGroup block_lanes(int bits, int count) {
  const fixed::FixedOptions options = {.format = {.bits = bits, .is_block = true},
                                       .ranges = std::vector<std::optional<Range>>(6)};
  return {.lane = fixed::fixed_lane(squared_distances(), reference_format(), options).value(),
          .count = count};
}

/// Lanes that do not decide where a square underflows.
design::LaneGroup floating_lanes(int count) {
  const TypedGraph lane =
      lane_graph(squared_distances(), reference_format(), {format("s6e5")}, LaneInputs::exact);
  return {.lane = relative_lane(lane, std::vector<bool>(6, false)).value(), .count = count};
}

design::Design engine_of(std::vector<design::LaneGroup> lanes) {
  const Graph graph = squared_distances();
  design::Design design{.name = "nearest",
                        .inputs = graph.inputs(),
                        .lanes = std::move(lanes),
                        .reference = reference_graph(graph, {reference_format()}),
                        .references = {{.count = 1}},
                        .system = {}};
  design.system = with_engine(design.system, {.kind = scene::EngineKind::arg_min});
  design.system.counter_bits = 0;
  return design;
}

/// Points whose coordinates are multiples of `unit`.
data::Table points(const std::vector<std::string>& columns, const std::vector<Point>& points,
                   const mpq_class& unit) {
  data::Table table{reference_format(), columns, {}, {}};
  for (const auto& [x, y] : points) {
    table.values.push_back(from_rational(table.format, x * unit));
    table.values.push_back(from_rational(table.format, y * unit));
  }
  return table;
}

/// One row, the origin, and these candidates.
data::Comparisons contest(const design::Design& design, const std::vector<Point>& candidates,
                          const mpq_class& unit = 1) {
  return data::Comparisons::arg_min(points({"x", "y"}, {{0, 0}}, unit),
                                    points({"cx", "cy"}, candidates, unit), design.inputs,
                                    workload::compare_by_reference(design.reference))
      .value();
}

struct Judged {
  verilator_tb::VerifyReport report;
  std::vector<verilator_tb::VerifiedResult> results;
};

/// The judge's report and results for an engine that chooses `choice` for the row.
Judged judged(const design::Design& design, const data::Comparisons& comparisons,
              std::uint64_t choice) {
  const Graph truth = squared_distances();
  const emit::Signature signature = emit::generate_system(design, "")->signature;
  Judged judged;
  const verilator_tb::VerifyOptions options = {
      .truth = verilator_tb::TruthCheck{&truth},
      .on_result = [&](const auto& result) { judged.results.push_back(result); }};
  verilator_tb::ArgMinJudge judge(signature, design, comparisons, options);
  judge.take({.candidates = comparisons.tables()[1].rows(), .first = 0, .rows = 1},
             {.response = {.rows = 1, .state = harness::wire::LoadState::complete},
              .rows = {{.index = choice, .cycle_accepted = 1, .cycle_left = 9}},
              .violations = {},
              .lanes = {},
              .answers = {}},
             verilator_tb::ArgMinJudge::Use::figures);
  judged.report = std::move(judge.report());
  return judged;
}

/// The winners of the contest before each of its comparisons.
Choices best_before(const Judged& judged) {
  Choices best;
  for (const auto& result : judged.results) {
    EXPECT_EQ(result.index, best.size());
    EXPECT_EQ(result.items.second, best.size() + 1);
    best.push_back(result.items.first);
  }
  return best;
}

const mpq_class tiny = mpq_class(1, 1 << 14);  ///< up to 7 of it have a square that vanishes

TEST(ArgMinJudge, TakesTheLanesVerdictsWhereTheReferenceUnderflows) {
  const design::Design design = engine_of({block_lanes(8, 2)});
  const data::Comparisons comparisons = contest(design, {{3, 0}, {2, 0}, {1, 0}}, tiny);
  ASSERT_EQ(comparisons.arg_min(0), 0u);
  const Judged right = judged(design, comparisons, 2);
  EXPECT_TRUE(right.report.passed()) << to_text(right.report);
  EXPECT_EQ(right.report.arg_min->rows_unlike_reference, 1u);
  EXPECT_EQ(best_before(right), (Choices{0, 1}));
  EXPECT_EQ(right.report.truth->checked, 2u);
  EXPECT_EQ(right.report.truth->wrong_by_lane, 0u);
  EXPECT_EQ(right.report.truth->reference_alone_wrong, 2u);
  for (const std::uint64_t wrong : {0, 1}) {
    EXPECT_EQ(judged(design, comparisons, wrong).report.mismatch_count, 1u);
  }
}

/// 48^2 + 3^2 < 45^2 + 17^2, but not in eight digits.
TEST(ArgMinJudge, TakesTheReferencesVerdictWhereTheLaneHasNone) {
  const design::Design design = engine_of({block_lanes(5, 1)});
  const data::Comparisons comparisons = contest(design, {{48, 3}, {45, 17}});
  const Judged right = judged(design, comparisons, 1);
  EXPECT_TRUE(right.report.passed()) << to_text(right.report);
  EXPECT_EQ(right.report.recomputations, 1u);
  EXPECT_EQ(right.report.truth->wrong_by_reference, 1u);
  EXPECT_EQ(right.report.arg_min->rows_unlike_reference, 0u);
  EXPECT_EQ(judged(design, comparisons, 0).report.mismatch_count, 1u);
}

/// Nearer candidates win where a lane in block floating point compares them. The floating-point
/// lane asks the reference, in which they are equal.
TEST(ArgMinJudge, AsksTheLaneOfEachPosition) {
  const std::vector<Point> candidates = {{3, 0}, {1, 0}, {2, 0}};
  struct Case {
    std::vector<design::LaneGroup> lanes;
    std::uint64_t choice;
    Choices best_before;
  };
  for (const Case& each : {Case{{floating_lanes(1), block_lanes(8, 1)}, 2, {0, 0}},
                           Case{{block_lanes(8, 1), floating_lanes(1)}, 1, {0, 1}}}) {
    const design::Design design = engine_of(each.lanes);
    const Judged right = judged(design, contest(design, candidates, tiny), each.choice);
    EXPECT_TRUE(right.report.passed()) << to_text(right.report);
    EXPECT_EQ(right.report.recomputations, 1u);
    EXPECT_EQ(best_before(right), each.best_before);
  }
}

}  // namespace
}  // namespace mixcmp::test::arg_min_judge_test
