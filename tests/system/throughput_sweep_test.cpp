#include <gtest/gtest.h>

#include <string>

#include "tests/system/throughput_cases.hpp"

/// The analytical model against generated systems of several p_L / p_H, from no recomputation to
/// nothing else.
namespace mixcmp::test::throughput_sweep_test {
namespace {

/// Enough that filling and emptying the system takes far less than the measured time.
constexpr std::size_t comparisons = 120'000;

class ThroughputSweep : public testing::TestWithParam<Shape> {};

TEST_P(ThroughputSweep, IsThePredictedOneAtEveryRecomputationRate) {
  const design::Design design = design_of(GetParam());
  for (const double rate : {0.0, 0.02, 0.04, 0.1, 0.125, 0.25, 0.5, 1.0}) {
    const verilator_tb::VerifyReport report = run(design, random_pattern(comparisons, rate, 7));
    EXPECT_NEAR(report.recomputation_rate(), rate, 0.02);
    const double expected = predicted_per_cycle(design, report.recomputation_rate());
    EXPECT_NEAR(report.comparisons_per_cycle(), expected, throughput_tolerance * expected)
        << "R_R = " << rate;
  }
}

using scene::ResultOrder;

INSTANTIATE_TEST_SUITE_P(Shapes, ThroughputSweep,
                         testing::Values(Shape{1, 1, ResultOrder::tagged},
                                         Shape{7, 3, ResultOrder::tagged},
                                         Shape{24, 2, ResultOrder::tagged},
                                         Shape{8, 1, ResultOrder::in_order},
                                         Shape{6, 1, ResultOrder::tagged, 4}),
                         [](const auto& instance) {
                           const Shape& s = instance.param;
                           return std::to_string(s.lanes) + "x" + std::to_string(s.references) +
                                  (s.order == ResultOrder::tagged ? "_tagged" : "_in_order") +
                                  (s.initiation_interval == 1 ? "" : "_folded");
                         });

}  // namespace
}  // namespace mixcmp::test::throughput_sweep_test
