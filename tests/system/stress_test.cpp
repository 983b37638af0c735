#include <gtest/gtest.h>

#include "model/comparison/data/uniform_spheres.hpp"
#include "tests/support/simulated_system.hpp"
#include "tests/support/sphere.hpp"

/// Nothing is lost, doubled or mis-tagged in 10^6 comparisons under random stalls and resets. The
/// lane has few bits, so that a good share is recomputed and the paths behind the crossbar work
/// hard.
namespace mixcmp::test::stress_test {
namespace {

struct Shape {
  int lanes;
  int references;
  scene::ResultOrder order;
  scene::OperandStore operands;
};

void PrintTo(const Shape& s, std::ostream* stream) {
  *stream << s.lanes << "x" << s.references;
}

class Stress : public testing::TestWithParam<Shape> {};

TEST_P(Stress, EveryComparisonLeavesOnce) {
  const Shape shape = GetParam();
  design::Design design =
      sphere_design(format("s5e8"), format("s24e8"), shape.lanes, shape.references);
  design.system.order = shape.order;
  design.system.operands = shape.operands;
  const data::Table spheres = data::uniform_spheres(
      {.count = 1'415, .side = 100, .radius_max = 50, .seed = 3}, format("s24e8"));
  const auto data = data::Comparisons::all_pairs(spheres, design.inputs);
  ASSERT_TRUE(data.ok()) << data.error().to_string();
  const verilator_tb::VerifyReport report =
      simulate(design, *data, {.traffic = verilator_tb::TrafficKind::stressed, .resets = 5});
  EXPECT_TRUE(report.passed()) << to_text(report);
  EXPECT_GE(report.comparisons, 1'000'000u);
  EXPECT_EQ(report.resets, 5u);
  EXPECT_GT(report.references == 0 ? report.undecided : report.recomputations, 10'000u);
}

constexpr auto tagged = scene::ResultOrder::tagged;
constexpr auto in_order = scene::ResultOrder::in_order;
constexpr auto carried = scene::OperandStore::carried;
constexpr auto refetched = scene::OperandStore::refetched;

INSTANTIATE_TEST_SUITE_P(
    Shapes, Stress,
    testing::Values(Shape{1, 1, tagged, carried}, Shape{1, 1, in_order, carried},
                    Shape{8, 1, tagged, carried}, Shape{8, 1, in_order, refetched},
                    Shape{7, 3, tagged, refetched}, Shape{7, 3, in_order, carried},
                    Shape{24, 2, tagged, carried}, Shape{24, 2, in_order, carried},
                    Shape{2, 0, tagged, carried}),
    [](const auto& instance) {
      const Shape& s = instance.param;
      return std::to_string(s.lanes) + "x" + std::to_string(s.references) +
             (s.order == tagged ? "_tagged" : "_in_order") +
             (s.operands == carried ? "_carried" : "_refetched");
    });

}  // namespace
}  // namespace mixcmp::test::stress_test
