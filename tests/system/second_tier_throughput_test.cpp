#include <gtest/gtest.h>

#include <bit>
#include <random>

#include "generator/hardware/emit/scheduled_system.hpp"
#include "model/cost/performance/performance.hpp"
#include "tests/support/sphere.hpp"
#include "tests/system/throughput_cases.hpp"

/// The analytical model of systems of streams with a second tier, against generated ones.
namespace mixcmp::test::second_tier_throughput_test {
namespace {

constexpr std::size_t comparisons = 120'000;

struct Load {
  const char* name;
  int lanes;
  int second_lanes;
  int initiation_interval;
  double rate;   ///< the part that the first tier leaves undecided
  double again;  ///< the part of these that the second tier leaves undecided
};

void PrintTo(const Load& load, std::ostream* stream) {
  *stream << load.name;
}

design::Design design_of(const Load& load) {
  design::Design design = sphere_design(format("s5e8"), format("s24e8"), load.lanes, 1);
  design.lanes.front().lane = fixed_spheres({.bits = 8}, format("s24e8"));
  design.second_tier = {.lane = fixed_spheres({.bits = 13}, format("s24e8")),
                        .count = load.second_lanes};
  design.references.front().structure.initiation_interval = load.initiation_interval;
  return design;
}

/// A pair that lanes decide (f = 9, g = 0.81), one that the second tier decides (f = 1), or one
/// that touches (f = g = 1). s24e8 is binary32.
void append_pair(data::Table& table, const design::Design& design, bool undecided, bool again) {
  for (const std::string& input : design.inputs) {
    float value = 1;
    if (input == "cxi") value = undecided ? 2 : 4;
    if (input == "ri" || input == "rj") value = again ? 0.5f : 0.45f;
    table.values.push_back(std::bit_cast<std::uint32_t>(value));
  }
}

data::Comparisons pairs(const design::Design& design, const Load& load) {
  data::Table table{format("s24e8"), design.inputs, {}, {}};
  std::mt19937 engine(7);
  std::bernoulli_distribution undecided(load.rate), again(load.again);
  for (std::size_t k = 0; k < comparisons; ++k) {
    const bool asks = undecided(engine);
    append_pair(table, design, asks, asks && again(engine));
  }
  return data::Comparisons::rows(std::move(table), design.inputs).value();
}

double predicted_per_cycle(const design::Design& design, const Load& load) {
  const rtl::SystemShape shape = emit::schedule_system(design)->shape;
  const performance::LaneStreams second = {
      .order = scene::ResultOrder::in_order,
      .lane_latency_cycles = shape.second_tier->schedule.latency_cycles,
      .reference_latency_cycles = shape.reference_groups[0].schedule.latency_cycles,
      .initiation_interval_cycles = load.initiation_interval,
      .slots = 1 << shape.second_tier_slot_bits,
      .lanes_served = load.second_lanes};
  double sum = 0;
  for (const int served : performance::lanes_of_references(load.lanes, load.second_lanes)) {
    const performance::LaneStreams first = {
        .order = shape.order,
        .lane_latency_cycles = shape.lane_groups[0].schedule.latency_cycles,
        .slots = 1 << shape.slot_bits,
        .lanes_served = served};
    sum += served * performance::two_tier_throughput(first, second, load.rate, load.again);
  }
  return sum;
}

class SecondTierThroughput : public testing::TestWithParam<Load> {};

TEST_P(SecondTierThroughput, IsThePredictedOne) {
  const Load& load = GetParam();
  const design::Design design = design_of(load);
  const verilator_tb::VerifyReport report = simulate(design, pairs(design, load), {});
  EXPECT_TRUE(report.passed()) << to_text(report);
  EXPECT_NEAR(report.recomputation_rate(), load.rate, 0.01);
  const double expected = predicted_per_cycle(design, load);
  EXPECT_NEAR(report.comparisons_per_cycle(), expected, throughput_tolerance * expected);
}

INSTANTIATE_TEST_SUITE_P(Loads, SecondTierThroughput,
                         testing::Values(Load{"at_ease", 8, 2, 1, 0.1, 0.1},
                                         Load{"busy", 8, 1, 1, 0.1, 0.1},
                                         Load{"second_tier_asked_too_often", 8, 1, 1, 0.2, 0.05},
                                         Load{"folded_reference", 12, 3, 16, 0.1, 0.02},
                                         Load{"reference_asked_too_often", 8, 2, 4, 0.2, 0.3}),
                         [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace mixcmp::test::second_tier_throughput_test
