#include <gtest/gtest.h>

#include <algorithm>

#include "model/comparison/data/uniform_spheres.hpp"
#include "tests/support/simulated_system.hpp"
#include "tests/support/sphere.hpp"

/// Counters that software reads on an AXI4-Lite port, as verify reads and judges them.
namespace mixcmp::test::counter_port_test {
namespace {

using verilator_tb::SimulatorKind;

design::Design with_port(design::Design design, int counter_bits) {
  design.system.counters = scene::CounterAccess::axi_lite;
  design.system.counter_bits = counter_bits;
  return design;
}

data::Comparisons sphere_pairs(const design::Design& design, std::uint64_t count) {
  const data::Table spheres = data::uniform_spheres(
      {.count = count, .side = 100, .radius_max = 50, .seed = 3}, design.reference.input_format);
  return data::Comparisons::all_pairs(spheres, design.inputs).value();
}

std::uint64_t counted(const verilator_tb::VerifyReport& report, const std::string& name) {
  const auto found = std::find_if(report.counters.begin(), report.counters.end(),
                                  [&](const auto& counter) { return counter.name == name; });
  return found == report.counters.end() ? 0 : found->counted;
}

class CounterPort : public testing::TestWithParam<SimulatorKind> {};

TEST_P(CounterPort, TellsWhatEachLaneAndEachReferenceDid) {
  const design::Design design = with_port(sphere_design(format("s5e8"), format("s24e8"), 3, 2), 40);
  const auto report = simulate(
      design, sphere_pairs(design, 40),
      {.simulator = GetParam(), .traffic = verilator_tb::TrafficKind::stressed, .resets = 1});
  EXPECT_TRUE(report.passed()) << to_text(report);
  EXPECT_GT(counted(report, "comparisons"), 0u);
  EXPECT_GT(counted(report, "answers"), 0u);
  EXPECT_EQ(counted(report, "answers"), counted(report, "recomputations"));
}

TEST_P(CounterPort, TellsWhatAnEngineDid) {
  design::Design design = with_port(sphere_design(format("s5e8"), format("s24e8"), 3, 2), 32);
  design.system = with_engine(design.system, {.kind = scene::EngineKind::pairwise, .capacity = 32});
  const auto report = simulate(design, sphere_pairs(design, 20), {.simulator = GetParam()});
  EXPECT_TRUE(report.passed()) << to_text(report);
  EXPECT_GT(counted(report, "busy_cycles"), 0u);
  EXPECT_GT(counted(report, "answers"), 0u);
}

INSTANTIATE_TEST_SUITE_P(Simulators, CounterPort,
                         testing::Values(SimulatorKind::verilator, SimulatorKind::icarus),
                         [](const auto& instance) {
                           return instance.param == SimulatorKind::icarus ? "Icarus" : "Verilator";
                         });

}  // namespace
}  // namespace mixcmp::test::counter_port_test
