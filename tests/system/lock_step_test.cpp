#include <gtest/gtest.h>

#include "tests/support/every_pair.hpp"
#include "tests/support/simulated_system.hpp"

/// Groups of lanes in lock step: whichever of a word's comparisons are undecided, each result is
/// the golden model's.
namespace mixcmp::test::lock_step_test {
namespace {

struct Case {
  const char* name;
  int lanes_per_group;
  scene::OperandStore operands = scene::OperandStore::carried;
  scene::ResultOrder order = scene::ResultOrder::tagged;
  int references = 2;
  int initiation_interval = 1;
  int request_beats = 1;
  scene::CounterAccess counters = scene::CounterAccess::ports;
  verilator_tb::SimulatorKind simulator = verilator_tb::SimulatorKind::verilator;
};

void PrintTo(const Case& c, std::ostream* stream) {
  *stream << c.name;
}

design::Design design_of(const Case& c) {
  design::Design design = byte_design(c.lanes_per_group);
  if (c.references > 0) {
    design.references.push_back({.structure = {scene::Multipliers::embedded, c.initiation_interval},
                                 .count = c.references});
  }
  design.system.operands = c.operands;
  design.system.order = c.order;
  design.system.counters = c.counters;
  design.system.request_beats = c.request_beats;
  return design;
}

class LockStep : public testing::TestWithParam<Case> {};

TEST_P(LockStep, DecidesEveryPairAsTheGoldenModelDoes) {
  const Case& c = GetParam();
  const bool icarus = c.simulator == verilator_tb::SimulatorKind::icarus;
  // The last word is not full, and blocks end inside of words.
  const std::uint64_t count = icarus ? 3'001 : 65'531;
  verilator_tb::VerifyOptions options = {.judge = verilator_tb::JudgeKind::golden_model,
                                         .traffic = verilator_tb::TrafficKind::stressed,
                                         .resets = 4,
                                         .block_size = 4'999};
  options.simulator = c.simulator;
  options.selection.limit = count;
  options.selection.sampling = verilator_tb::Sampling::random;
  const design::Design design = design_of(c);
  const verilator_tb::VerifyReport report = simulate(design, every_pair(design), options);
  EXPECT_TRUE(report.passed()) << to_text(report);
  EXPECT_EQ(report.comparisons, count);
  EXPECT_GT(report.recomputations + report.undecided, count / 8) << to_text(report);
  EXPECT_EQ(report.recomputations == 0, c.references == 0);
}

constexpr auto refetched = scene::OperandStore::refetched;
constexpr auto carried = scene::OperandStore::carried;
constexpr auto in_order = scene::ResultOrder::in_order;
constexpr auto tagged = scene::ResultOrder::tagged;
constexpr auto axi_lite = scene::CounterAccess::axi_lite;
constexpr auto icarus = verilator_tb::SimulatorKind::icarus;
constexpr auto ports = scene::CounterAccess::ports;

INSTANTIATE_TEST_SUITE_P(
    Of, LockStep,
    testing::Values(Case{"nine_refetched_in_order_folded", 9, refetched, in_order, 1, 16},
                    Case{"three_carried_in_beats", 3, carried, tagged, 2, 8, 4, axi_lite},
                    Case{"four_alone", 4, carried, tagged, 0, 1, 1, axi_lite},
                    Case{"three_refetched_icarus", 3, refetched, tagged, 2, 1, 1, axi_lite, icarus},
                    Case{"four_carried_icarus", 4, carried, in_order, 2, 1, 1, ports, icarus}),
    [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace mixcmp::test::lock_step_test
