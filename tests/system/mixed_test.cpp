#include <gtest/gtest.h>

#include "generator/hardware/emit/system.hpp"
#include "model/comparison/data/uniform_spheres.hpp"
#include "tests/support/mixed_spheres.hpp"
#include "tests/support/simulated_system.hpp"

/// Lanes and references of several kinds in one system: every verdict is that of the lane it went
/// through, and each kind's counts are told apart.
namespace mixcmp::test::mixed_test {
namespace {

struct Streams {
  scene::ResultOrder order;
  scene::OperandStore operands;
  verilator_tb::SimulatorKind simulator;
};

std::string name_of(const Streams& s) {
  return std::string(to_string(s.order)) + "_" + std::string(to_string(s.operands)) +
         (s.simulator == verilator_tb::SimulatorKind::icarus ? "_Icarus" : "_Verilator");
}

void PrintTo(const Streams& streams, std::ostream* stream) {
  *stream << name_of(streams);
}

design::Design with_streams(const Streams& streams) {
  design::Design design = mixed_sphere_design();
  design.system.order = streams.order;
  design.system.operands = streams.operands;
  return design;
}

data::Comparisons pairs_of_spheres(const design::Design& design) {
  const data::Table spheres = data::uniform_spheres(
      {.count = 120, .side = 100, .radius_max = 50, .seed = 5}, design.reference.input_format);
  return data::Comparisons::all_pairs(spheres, design.inputs).value();
}

class Mixed : public testing::TestWithParam<Streams> {
protected:
  verilator_tb::VerifyReport run(const design::Design& design,
                                 verilator_tb::VerifyOptions options) {
    options.simulator = GetParam().simulator;
    if (options.simulator == verilator_tb::SimulatorKind::icarus) options.selection.limit = 700;
    return simulate(design, pairs_of_spheres(design), options);
  }
};

void expect_groups_add_up(const verilator_tb::VerifyReport& report) {
  std::uint64_t comparisons = 0, recomputations = 0;
  for (const verilator_tb::GroupReport& group : report.groups) {
    EXPECT_GT(group.comparisons, 0u) << group.name;
    // A short run may leave a kind without a close comparison.
    if (report.requested > 5'000) {
      EXPECT_GT(group.recomputations, 0u) << group.name;
    }
    EXPECT_EQ(group.mismatches, 0u) << group.name;
    comparisons += group.comparisons;
    recomputations += group.recomputations;
  }
  EXPECT_EQ(comparisons, report.comparisons);
  EXPECT_EQ(recomputations, report.recomputations);
  EXPECT_GT(recomputations, 20u);
}

TEST_P(Mixed, PassesUnderStallsAndResets) {
  const Graph graph = sphere_graph();
  const verilator_tb::VerifyReport report =
      run(with_streams(GetParam()), {.traffic = verilator_tb::TrafficKind::stressed,
                                     .resets = 5,
                                     .block_size = 1'000,
                                     .truth = verilator_tb::TruthCheck{.graph = &graph}});
  EXPECT_TRUE(report.passed()) << to_text(report);
  EXPECT_EQ(report.lanes, 7);
  EXPECT_EQ(report.references, 3);
  ASSERT_EQ(report.groups.size(), 4u);
  EXPECT_EQ(report.truth->wrong_by_lane, 0u);
  expect_groups_add_up(report);
}

class MixedInVerilator : public Mixed {};

TEST_P(MixedInVerilator, EachKindHasItsLatencyAndItsRate) {
  const design::Design design = with_streams(GetParam());
  const emit::Signature signature = emit::generate_system(design, "").value().signature;
  const verilator_tb::VerifyReport report = run(design, {});
  ASSERT_TRUE(report.passed()) << to_text(report);
  const int channel = GetParam().order == scene::ResultOrder::tagged ? 5 : 4;
  for (std::size_t k = 0; k < report.groups.size(); ++k) {
    const auto expected =
        static_cast<std::uint64_t>(signature.lane_groups[k].latency_cycles + channel);
    const verilator_tb::Latency& decided = report.groups[k].latencies.decided;
    ASSERT_GT(decided.count, 0u) << report.groups[k].name;
    EXPECT_GE(decided.minimum_cycles, expected) << report.groups[k].name;
    // In order, a decided one may always have to wait for one that is recomputed.
    if (GetParam().order != scene::ResultOrder::tagged) continue;
    EXPECT_EQ(decided.minimum_cycles, expected) << report.groups[k].name;
  }
  const auto rate = [&](std::size_t k) {
    return static_cast<double>(report.groups[k].recomputations) /
           static_cast<double>(report.groups[k].comparisons);
  };
  EXPECT_LT(rate(2) * 4, rate(0)) << "nine digits decide more than six\n" << to_text(report);
  EXPECT_LT(rate(0), rate(1)) << "rounded inputs decide less than exact ones\n" << to_text(report);
}

/// The hardware is right: only the judge takes the golden model of one kind for another's.
TEST_P(MixedInVerilator, TheGoldenModelOfAnotherKindIsFoundOut) {
  const design::Design design = with_streams(GetParam());
  design::Design mistaken = design;
  std::swap(mistaken.lanes[0].lane, mistaken.lanes[1].lane);
  const std::filesystem::path rtl = generate_to(design, "mistaken_" + name_of(GetParam()));
  const auto report = verilator_tb::judge_system(verilator_tb::load_system(rtl).value(), mistaken,
                                                 pairs_of_spheres(design),
                                                 {.simulator = GetParam().simulator,
                                                  .work_dir = test_work_dir("builds"),
                                                  .selection = {.limit = 1'000}});
  ASSERT_TRUE(report.ok()) << report.error().to_string();
  EXPECT_FALSE(report->passed());
  EXPECT_GT(report->groups[0].mismatches, 0u);
  EXPECT_GT(report->groups[1].mismatches, 0u);
  EXPECT_EQ(report->groups[2].mismatches, 0u) << "this kind is judged by its own model";
  EXPECT_EQ(report->groups[3].mismatches, 0u);
}

constexpr auto tagged = scene::ResultOrder::tagged;
constexpr auto in_order = scene::ResultOrder::in_order;
constexpr auto carried = scene::OperandStore::carried;
constexpr auto refetched = scene::OperandStore::refetched;

INSTANTIATE_TEST_SUITE_P(
    Spheres, Mixed,
    testing::Values(Streams{tagged, carried, verilator_tb::SimulatorKind::verilator},
                    Streams{in_order, refetched, verilator_tb::SimulatorKind::verilator},
                    Streams{tagged, carried, verilator_tb::SimulatorKind::icarus},
                    Streams{in_order, refetched, verilator_tb::SimulatorKind::icarus},
                    Streams{tagged, refetched, verilator_tb::SimulatorKind::icarus},
                    Streams{in_order, carried, verilator_tb::SimulatorKind::icarus}),
    [](const auto& instance) { return name_of(instance.param); });

INSTANTIATE_TEST_SUITE_P(
    Spheres, MixedInVerilator,
    testing::Values(Streams{tagged, carried, verilator_tb::SimulatorKind::verilator},
                    Streams{in_order, refetched, verilator_tb::SimulatorKind::verilator}),
    [](const auto& instance) { return name_of(instance.param); });

/// A kind that is not certified may be wrong; it does not excuse the certified ones.
TEST(MixedCertainty, OnlyCertifiedLanesMustTellTheTruth) {
  verilator_tb::VerifyReport report;
  report.requested = report.comparisons = 10;
  report.truth = verilator_tb::TruthCount{.checked = 10, .wrong_by_lane = 1};
  report.groups = {{.name = "profiled", .wrong_by_lane = 1}, {.name = "proven", .certified = true}};
  EXPECT_TRUE(report.passed());
  report.groups[1].wrong_by_lane = 1;
  EXPECT_FALSE(report.passed());
}

}  // namespace
}  // namespace mixcmp::test::mixed_test
