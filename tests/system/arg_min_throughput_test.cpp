#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "model/base/common/counter_random.hpp"
#include "model/base/number/exact.hpp"
#include "model/comparison/expression/parser.hpp"
#include "model/judge/golden/fixed_evaluate.hpp"
#include "model/judge/workload/compare_by_reference.hpp"
#include "model/judge/workload/load_comparisons.hpp"
#include "model/lane/fixed/fixed_lane.hpp"
#include "tests/support/simulated_system.hpp"
#include "tests/support/sphere.hpp"
#include "verilator_tb/engine_model.hpp"

/// The cycles that a whole arg-min engine takes for a stream of rows, beside those of the
/// performance model.
namespace mixcmp::test::arg_min_throughput_test {
namespace {

/// An engine and data that give it something to do.
struct Load {
  const char* name;
  int lanes;
  int references;
  int interval;  ///< of the references
  int bits;      ///< of the lanes, in fixed point
  std::size_t rows;
  double tolerance = 0.05;
};

/// The name of a test's parameter.
void PrintTo(const Load& load, std::ostream* out) {
  *out << load.name;
}

Graph squared_distances() {
  Graph graph;
  const NodeId f = parse_expression(graph, "(x - cxi)^2 + (y - cyi)^2", {}).value();
  graph.compare(f, parse_expression(graph, "(x - cxj)^2 + (y - cyj)^2", {}).value());
  return graph;
}

design::Design design_of(const Load& load) {
  const Graph graph = squared_distances();
  const std::vector<std::optional<Range>> ranges(6, Range{0, 8});
  design::LaneGroup lanes{
      .lane = fixed::fixed_lane(graph, format("s24e8"),
                                {.format = {.bits = load.bits}, .ranges = ranges})
                  .value(),
      .count = load.lanes};
  design::Design design{.name = "nearest",
                        .inputs = graph.inputs(),
                        .lanes = {std::move(lanes)},
                        .reference = reference_graph(graph, {format("s24e8")}),
                        .references = {{.structure = {.initiation_interval = load.interval},
                                        .count = load.references}},
                        .system = {}};
  design.system =
      with_engine(design.system, {.kind = scene::EngineKind::arg_min, .row_tag_bits = 11});
  return design;
}

/// Points of the plane in [0, 8).
data::Table points(const std::vector<std::string>& columns, std::size_t count, std::uint64_t seed) {
  constexpr std::uint64_t steps = 1 << 20;
  data::Table table{format("s24e8"), columns, {}, {}};
  for (std::size_t k = 0; k < columns.size() * count; ++k) {
    const std::uint64_t step = counter_random(seed, k) % steps;
    table.values.push_back(from_rational(table.format, mpq_class(8 * step, steps)));
  }
  return table;
}

data::Comparisons data_of(const Load& load, const design::Design& design) {
  return data::Comparisons::arg_min(points({"x", "y"}, load.rows, 1),
                                    points({"cx", "cy"}, load.lanes + std::size_t{1}, 2),
                                    design.inputs, workload::compare_by_reference(design.reference))
      .value();
}

/// The cycles by the comparisons that the golden model says the lanes leave undecided.
double predicted_cycles(const design::Design& design, const data::Comparisons& rows) {
  const auto& lane = std::get<fixed::FixedLane>(design.lanes.front().lane);
  const performance::Chain chain = verilator_tb::chain_of(design);
  std::vector<Bits> operands(rows.input_count());
  const auto undecided = [&](std::uint64_t row, int stage) {
    const auto lanes = static_cast<std::uint64_t>(chain.lanes);
    rows.fetch(row * lanes + static_cast<std::uint64_t>(stage), operands);
    return !golden::evaluate_lane(lane, operands).decided;
  };
  return performance::chain_cycles(chain, rows.table().rows(), undecided);
}

class ArgMinThroughput : public testing::TestWithParam<Load> {};

TEST_P(ArgMinThroughput, IsThePredictedOne) {
  const Load& load = GetParam();
  const design::Design design = design_of(load);
  const data::Comparisons rows = data_of(load, design);
  const auto report = simulate(design, rows, {});
  ASSERT_TRUE(report.passed()) << to_text(report);
  const double predicted = predicted_cycles(design, rows);
  const double expected = report.arg_min->expected_cycles.value();
  fmt::print("{}: {} cycles, {:.0f} predicted, {:.0f} by the rate {:.2e} alone\n", load.name,
             report.cycles, predicted, expected, report.recomputation_rate());
  EXPECT_NEAR(static_cast<double>(report.cycles), predicted, load.tolerance * predicted)
      << to_text(report);
  EXPECT_NEAR(static_cast<double>(report.cycles), expected, load.tolerance * expected);
}

/// The protein's atoms past the centres of its residues, whose recomputations come in clusters.
TEST(ArgMinThroughputOf, TheResiduesOfTheExampleIsThePredictedOne) {
  const std::string file = std::string(MIXCMP_SOURCE_DIR) + "/examples/kmeans/residues_chain.toml";
  const std::vector<std::string> overrides = {"reduced.format=q13"};
  const scene::Scene scene = scene::load_scene(file, overrides).value();
  const data::Comparisons rows = workload::load_comparisons(scene).value();
  const design::Design design = design::make_design(scene, &rows).value();
  const double predicted = predicted_cycles(design, rows);
  const auto report = simulate(design, rows, {});
  ASSERT_TRUE(report.passed()) << to_text(report);
  fmt::print("residues: {} cycles, {:.0f} predicted\n", report.cycles, predicted);
  EXPECT_NEAR(static_cast<double>(report.cycles), predicted, 0.05 * predicted) << to_text(report);
}

INSTANTIATE_TEST_SUITE_P(
    Loads, ArgMinThroughput,
    testing::Values(Load{"FewUndecided", 15, 1, 1, 14, 800},      // rows limit
                    Load{"SomeUndecided", 15, 1, 1, 11, 800},     // recomputations in turn
                    Load{"OneInEveryLane", 15, 2, 1, 9, 800},     // each lane holds up once
                    Load{"AFoldedReference", 15, 1, 16, 8, 800},  // the reference
                    // No plan has lanes that ask for 2.4 operands a cycle.
                    Load{"TheMemoryAskedTooOften", 15, 2, 1, 7, 800, 0.1}),
    [](const auto& load) { return std::string(load.param.name); });

}  // namespace
}  // namespace mixcmp::test::arg_min_throughput_test
