#include <gtest/gtest.h>

#include "generator/hardware/emit/system.hpp"
#include "model/base/common/counter_random.hpp"
#include "model/base/number/decimal.hpp"
#include "model/base/number/exact.hpp"
#include "tests/support/sphere.hpp"
#include "tests/verilator_tb/fake_system.hpp"

namespace mixcmp::test::sphere_system_test {
namespace {

namespace fs = std::filesystem;

/// Items of all kinds: random spheres, tangent and coincident ones, infinities, NaNs, extremes.
data::Comparisons sphere_pairs(std::size_t random_spheres) {
  const FloatFormat s24e8 = format("s24e8");
  data::Table table{.format = s24e8, .columns = {"cx", "cy", "cz", "r"}};
  for (std::size_t k = 0; k < 4 * random_spheres; ++k) {
    const mpz_class random(static_cast<unsigned long>(counter_random(5, k) >> 11));
    mpq_class value(random, mpz_class(1) << 53);
    value *= k % 4 == 3 ? 25 : 100;
    value.canonicalize();
    table.values.push_back(from_rational(s24e8, value));
  }
  const char* const special[][4] = {{"0", "0", "0", "2"},
                                    {"3", "4", "0", "3"},
                                    {"3", "4", "0", "3"},
                                    {"-3", "-4", "0", "3"},
                                    {"1e6", "1e6", "1e6", "5"},
                                    {"1000003", "1000004", "1e6", "0x1p-20"},
                                    {"0", "0", "0", "0"},
                                    {"-0", "0", "-0", "0"},
                                    {"inf", "0", "0", "1"},
                                    {"0", "0", "0", "inf"},
                                    {"nan", "0", "0", "1"},
                                    {"1", "1", "1", "nan"},
                                    {"1e38", "1e38", "0", "1"},
                                    {"-1e38", "0", "0", "2e38"},
                                    {"1e-38", "2e-38", "0", "1e-38"},
                                    {"1e-45", "0", "0", "1e-45"}};
  for (const auto& sphere : special) {
    for (const char* text : sphere) {
      table.values.push_back(from_text(s24e8, text).value());
    }
  }
  return data::Comparisons::all_pairs(table, test::sphere_graph().inputs()).value();
}

fs::path generate(const design::Design& design, const std::string& folder) {
  const auto system = emit::generate_system(design, "mixcmp generate sphere.toml");
  EXPECT_TRUE(system.ok()) << system.error().to_string();
  const fs::path path = fake_work_dir() / folder;
  const auto written = emit::write_system(*system, path);
  EXPECT_TRUE(written.ok()) << written.error().to_string();
  return path;
}

void expect_pass(const design::Design& design, const std::string& folder,
                 verilator_tb::SimulatorKind simulator, std::size_t random_spheres) {
  const Graph graph = test::sphere_graph();
  for (const verilator_tb::TrafficKind traffic :
       {verilator_tb::TrafficKind::full_rate, verilator_tb::TrafficKind::stressed}) {
    const auto report =
        verilator_tb::verify(design, sphere_pairs(random_spheres),
                             verilator_tb::load_system(generate(design, folder)).value(),
                             {.simulator = simulator,
                              .work_dir = fake_work_dir() / "builds",
                              .traffic = traffic,
                              .resets = traffic == verilator_tb::TrafficKind::stressed ? 4 : 0,
                              .truth = verilator_tb::TruthCheck{.graph = &graph}});
    ASSERT_TRUE(report.ok()) << report.error().to_string();
    EXPECT_TRUE(report->passed()) << to_text(*report);
    EXPECT_EQ(report->truth->wrong_by_lane, 0u) << to_text(*report);
    EXPECT_GT(report->verdicts[0], 0u);
    EXPECT_GT(report->verdicts[2], 0u);
    if (design.references.empty()) {
      EXPECT_GT(report->undecided, 0u);
    } else {
      EXPECT_GT(report->verdicts[1], 0u);
      EXPECT_GT(report->verdicts[3], 0u);
      EXPECT_GT(report->recomputations, 0u);
    }
  }
}

/// Every other row a pair of tangent spheres, which only a reference can decide.
data::Comparisons half_tangent(std::size_t rows) {
  const FloatFormat s24e8 = format("s24e8");
  const auto inputs = test::sphere_graph().inputs();
  data::Table table{.format = s24e8, .columns = inputs};
  for (std::size_t k = 0; k < rows; ++k) {
    const auto scale = static_cast<long>(1 + counter_random(9, k) % 1000);
    const long gap = k % 2 == 0 ? 0 : scale;
    const long values[] = {3 * scale + gap, 0, 4 * scale, 0, gap, 0, 2 * scale, 3 * scale};
    for (const long value : values) {
      table.values.push_back(from_rational(s24e8, value));
    }
  }
  return data::Comparisons::rows(table, inputs).value();
}

TEST(SphereSystem, HalfOfEverythingRecomputed) {
  const auto design = test::sphere_design(format("s12e8"), format("s24e8"), 7, 3);
  const auto data = half_tangent(20'000);
  const auto folder = generate(design, "sphere_half_recomputed");
  for (const verilator_tb::TrafficKind traffic :
       {verilator_tb::TrafficKind::full_rate, verilator_tb::TrafficKind::stressed}) {
    const auto report = verilator_tb::verify(
        design, data, verilator_tb::load_system(folder).value(),
        {.work_dir = fake_work_dir() / "builds", .traffic = traffic, .resets = 6});
    ASSERT_TRUE(report.ok()) << report.error().to_string();
    EXPECT_TRUE(report->passed()) << to_text(*report);
    EXPECT_EQ(report->recomputations, 10'000u);
    EXPECT_EQ(report->verdicts[1], 10'000u);
  }
}

TEST(SphereSystem, OneLaneOneReferenceInVerilator) {
  expect_pass(test::sphere_design(format("s12e8"), format("s24e8"), 1, 1), "sphere_1x1",
              verilator_tb::SimulatorKind::verilator, 100);
}

TEST(SphereSystem, OneLaneOneReferenceInIcarus) {
  expect_pass(test::sphere_design(format("s12e8"), format("s24e8"), 1, 1), "sphere_1x1_icarus",
              verilator_tb::SimulatorKind::icarus, 10);
}

TEST(SphereSystem, SevenLanesThreeReferencesInVerilator) {
  expect_pass(test::sphere_design(format("s12e8"), format("s24e8"), 7, 3), "sphere_7x3",
              verilator_tb::SimulatorKind::verilator, 200);
}

TEST(SphereSystem, InOrderAndRefetchedInVerilator) {
  design::Design design = test::sphere_design(format("s12e8"), format("s24e8"), 3, 2);
  design.system.order = scene::ResultOrder::in_order;
  design.system.operands = scene::OperandStore::refetched;
  expect_pass(design, "sphere_in_order_refetched", verilator_tb::SimulatorKind::verilator, 100);
}

TEST(SphereSystem, RefetchedInIcarus) {
  design::Design design = test::sphere_design(format("s12e8"), format("s24e8"), 2, 1);
  design.system.operands = scene::OperandStore::refetched;
  expect_pass(design, "sphere_refetched_icarus", verilator_tb::SimulatorKind::icarus, 10);
}

TEST(SphereSystem, LanesAloneInVerilator) {
  design::Design design = test::sphere_design(format("s12e8"), format("s24e8"), 2, 0);
  design.system.counter_bits = 0;
  expect_pass(design, "sphere_2x0", verilator_tb::SimulatorKind::verilator, 100);
}

}  // namespace
}  // namespace mixcmp::test::sphere_system_test
