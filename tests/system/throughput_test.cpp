#include <gtest/gtest.h>

#include <algorithm>

#include "model/cost/performance/performance.hpp"
#include "tests/system/throughput_cases.hpp"

/// The analytical model against a generated system in simulation.
namespace mixcmp::test::throughput_test {
namespace {

constexpr Shape shape{8, 1, scene::ResultOrder::tagged};

TEST(Throughput, IsEquation8OnBothSidesOfTheOptimalRatio) {
  const design::Design design = design_of(shape);
  for (const double rate : {0.02, 0.25}) {
    const verilator_tb::VerifyReport report = run(design, random_pattern(16'000, rate, 5));
    EXPECT_NEAR(report.recomputation_rate(), rate, 0.02);
    const double expected = performance::equivalent_throughput(
        {{.count = 8, .throughput_per_s = 1, .recomputation_rate = report.recomputation_rate()}},
        {{.count = 1, .throughput_per_s = 1}});
    EXPECT_NEAR(report.comparisons_per_cycle(), expected, throughput_tolerance * expected);
  }
}

/// The first `burst` of every `period` comparisons of a lane are undecided, in all lanes at once.
std::vector<bool> bursts(int burst, int period, int repetitions) {
  std::vector<bool> pattern;
  for (int k = 0; k < period * repetitions; ++k) {
    pattern.insert(pattern.end(), shape.lanes, k % period < burst);
  }
  return pattern;
}

TEST(Throughput, IsFullUpToTheLongestBurstThatSlotsHold) {
  const design::Design design = design_of(shape);
  const int absorbed = performance::absorbed_burst(streams_of(design, 0));
  // A lane whose comparisons come a cycle later meets its reference a cycle later as well.
  constexpr int margin = 2;
  EXPECT_EQ(stalls_of(run(design, bursts(absorbed - margin, 600, 2))), 0u);
  EXPECT_GT(stalls_of(run(design, bursts(absorbed + margin, 600, 2))), 0u);
}

TEST(Throughput, FallsBelowEquation8WhereSlotsDoNotHoldABurst) {
  constexpr int period = 1'000;
  constexpr int burst = 110;  // 88 % of the reference's average capacity
  const design::Design design = design_of(shape);
  std::vector<bool> one_lane(period, false);
  std::fill_n(one_lane.begin(), burst, true);
  const double expected =
      period * shape.lanes / performance::repeated_cycles(streams_of(design, 0), one_lane);
  const verilator_tb::VerifyReport report = run(design, bursts(burst, period, 4));
  EXPECT_NEAR(report.comparisons_per_cycle(), expected, throughput_tolerance * expected);
  EXPECT_LT(report.comparisons_per_cycle(),
            0.9 * predicted_per_cycle(design, report.recomputation_rate()));
}

}  // namespace
}  // namespace mixcmp::test::throughput_test
