#include <gtest/gtest.h>

#include "tests/support/every_pair.hpp"
#include "tests/support/simulated_system.hpp"

/// Systems of streams with a second tier. A lane, the second tier or a reference decides a
/// comparison; the result is always the golden model's.
namespace mixcmp::test::second_tier_test {
namespace {

constexpr auto refetched = scene::OperandStore::refetched;
constexpr auto carried = scene::OperandStore::carried;
constexpr auto in_order = scene::ResultOrder::in_order;
constexpr auto tagged = scene::ResultOrder::tagged;
constexpr auto icarus = verilator_tb::SimulatorKind::icarus;
constexpr auto verilator = verilator_tb::SimulatorKind::verilator;

struct Case {
  const char* name;
  int lanes_per_group;
  int second_lanes;
  scene::OperandStore operands;
  scene::ResultOrder order;
  int references;
  int initiation_interval;
  int request_beats;
  int resets;
  verilator_tb::SimulatorKind simulator = verilator;
};

void PrintTo(const Case& c, std::ostream* stream) {
  *stream << c.name;
}

design::Design design_of(const Case& c) {
  design::Design design = byte_design(c.lanes_per_group);
  design.second_tier = few_bit_lanes(byte_graph(), 9, c.second_lanes);
  design.references = {
      {.structure = {scene::Multipliers::embedded, c.initiation_interval}, .count = c.references}};
  design.system.operands = c.operands;
  design.system.order = c.order;
  design.system.counters = scene::CounterAccess::axi_lite;
  design.system.request_beats = c.request_beats;
  return design;
}

std::uint64_t answers_of_references(const verilator_tb::VerifyReport& report) {
  for (const verilator_tb::CounterTotal& counter : report.counters) {
    if (counter.name == "answers") return counter.counted;
  }
  return 0;
}

class SecondTier : public testing::TestWithParam<Case> {};

TEST_P(SecondTier, DecidesEveryPairAsTheGoldenModelDoes) {
  const Case& c = GetParam();
  const std::uint64_t count = c.simulator == icarus ? 3'001 : 65'531;
  verilator_tb::VerifyOptions options = {.judge = verilator_tb::JudgeKind::golden_model,
                                         .traffic = verilator_tb::TrafficKind::stressed,
                                         .resets = c.resets,
                                         .block_size = 4'999};
  options.simulator = c.simulator;
  options.selection.limit = count;
  options.selection.sampling = verilator_tb::Sampling::random;
  const design::Design design = design_of(c);
  const verilator_tb::VerifyReport report = simulate(design, every_pair(design), options);
  EXPECT_TRUE(report.passed()) << to_text(report);
  EXPECT_EQ(report.comparisons, count);
  EXPECT_GT(report.recomputations, count / 8) << to_text(report);
  if (c.resets > 0) return;
  const std::uint64_t answers = answers_of_references(report);
  EXPECT_GT(answers, report.recomputations / 16) << to_text(report);
  EXPECT_LT(answers, report.recomputations / 16 * 15) << to_text(report);
}

INSTANTIATE_TEST_SUITE_P(
    Of, SecondTier,
    testing::Values(Case{"refetched", 1, 2, refetched, in_order, 1, 4, 1, 0},
                    Case{"carried_in_beats", 3, 2, carried, tagged, 2, 8, 4, 4},
                    Case{"groups_refetched", 4, 2, refetched, tagged, 1, 1, 1, 4},
                    Case{"icarus", 2, 2, refetched, in_order, 1, 4, 1, 3, icarus}),
    [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace mixcmp::test::second_tier_test
