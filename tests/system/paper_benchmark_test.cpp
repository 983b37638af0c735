#include <gtest/gtest.h>

#include "model/comparison/data/uniform_spheres.hpp"
#include "tests/support/simulated_system.hpp"
#include "tests/support/sphere.hpp"

/// The paper's 20 benchmarks in simulation: 8192 spheres in a 100-cube, radii up to r. All 33.5
/// million pairs of each are for examples/sphere_collision/run; here a share, spread over all.
namespace mixcmp::test::paper_benchmark_test {
namespace {

class PaperBenchmark : public testing::TestWithParam<int> {};

TEST_P(PaperBenchmark, VerdictsAreTrue) {
  const Graph graph = sphere_graph();
  const design::Design design = sphere_design(format("s12e8"), format("s53e8"), 8, 1);
  const data::Table spheres = data::uniform_spheres({.radius_max = static_cast<double>(GetParam())},
                                                    design.reference.input_format);
  const auto data = data::Comparisons::all_pairs(spheres, design.inputs);
  ASSERT_TRUE(data.ok()) << data.error().to_string();
  EXPECT_EQ(data->size(), 33'550'336u);
  const verilator_tb::VerifyReport report =
      simulate(design, *data,
               {.selection = {.limit = 200'000, .sampling = verilator_tb::Sampling::random},
                .truth = verilator_tb::TruthCheck{.graph = &graph}});
  EXPECT_TRUE(report.passed()) << to_text(report);
  EXPECT_EQ(report.comparisons, 200'000u);
  EXPECT_EQ(report.truth->wrong_by_lane, 0u) << to_text(report);
  EXPECT_GT(report.verdicts[0], 0u) << "no pair collides";
}

INSTANTIATE_TEST_SUITE_P(Radius, PaperBenchmark, testing::Range(5, 105, 5),
                         testing::PrintToStringParamName());

}  // namespace
}  // namespace mixcmp::test::paper_benchmark_test
