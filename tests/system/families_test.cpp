#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

#include "model/lane/error/profiled_lane.hpp"
#include "model/plan/profile/profiled_error.hpp"
#include "tests/support/simulated_system.hpp"
#include "tests/support/sphere.hpp"
#include "tests/support/sphere_families.hpp"

/// The generated sphere system in simulation, on pairs made to mislead it: every verdict is the
/// golden model's, and where a lane decided, the truth.
namespace mixcmp::test::families_test {
namespace {

struct Case {
  const char* name;
  const char* lane;
  const char* reference;
  Rounding rounding = Rounding::nearest_even;
  Subnormals lane_subnormals = Subnormals::flush;
  Subnormals reference_subnormals = Subnormals::gradual;
  scene::Multipliers multipliers = scene::Multipliers::embedded;
};

void PrintTo(const Case& c, std::ostream* stream) {
  *stream << c.name;
}

class Families : public testing::TestWithParam<Case> {};

design::Design design_of(const Case& c) {
  const Graph graph = sphere_graph();
  design::Design design = sphere_design(format(c.lane), format(c.reference), 2, 1);
  const Arithmetic reduced = {format(c.lane), c.rounding, c.lane_subnormals};
  design.lanes.front().lane =
      relative_lane(lane_graph(graph, format(c.reference), reduced, LaneInputs::exact),
                    std::vector<bool>(8, false))
          .value();
  design.lanes.front().multipliers = c.multipliers;
  design.references.front().structure.multipliers = c.multipliers;
  design.reference =
      reference_graph(graph, {format(c.reference), Rounding::nearest_even, c.reference_subnormals});
  return design;
}

TEST_P(Families, VerdictsAreTheGoldenModelsAndLanesTellTheTruth) {
  const Graph graph = sphere_graph();
  const design::Design design = design_of(GetParam());
  const int precision =
      design::float_lane(design.lanes.front().lane).graph.arithmetic.format.precision();
  std::uint64_t checked = 0;
  for (const SphereFamily& family :
       sphere_families(design.reference.arithmetic.format, precision, 4'000, 7)) {
    const auto data = data::Comparisons::rows(family.pairs, design.inputs);
    ASSERT_TRUE(data.ok()) << data.error().to_string();
    const verilator_tb::VerifyReport report =
        simulate(design, *data, {.truth = verilator_tb::TruthCheck{.graph = &graph}});
    EXPECT_TRUE(report.passed()) << family.name << ":\n" << to_text(report);
    ASSERT_TRUE(report.truth) << family.name;
    checked += report.truth->checked;
    EXPECT_EQ(report.truth->wrong_by_lane, 0u) << family.name << ":\n" << to_text(report);
  }
  // The rest have infinite or NaN operands: 1e6 is too large for binary16.
  EXPECT_GE(checked, 35'000u);
}

INSTANTIATE_TEST_SUITE_P(Systems, Families,
                         testing::Values(Case{"s17e8_of_s53e8", "s17e8", "s53e8"},
                                         Case{"s4e8_of_s24e8", "s4e8", "s24e8"},
                                         Case{"s8e5_of_binary16", "s8e5", "s11e5"},
                                         Case{.name = "s9e8_of_s24e8_of_logic",
                                              .lane = "s9e8",
                                              .reference = "s24e8",
                                              .multipliers = scene::Multipliers::logic},
                                         Case{"s12e6_toward_zero_gradual_of_binary64_flush",
                                              "s12e6", "s53e11", Rounding::toward_zero,
                                              Subnormals::gradual, Subnormals::flush}),
                         [](const auto& instance) { return std::string(instance.param.name); });

/// The paper's form with the error measured on ordinary spheres, then shown tangent ones: the
/// hardware agrees with the golden model, and both are wrong.
TEST(ProfiledLanes, AreWrongOnTangentSpheres) {
  const Graph graph = sphere_graph();
  const FloatFormat s53e8 = format("s53e8");
  design::Design design = sphere_design(format("s8e8"), s53e8, 2, 1);
  const std::vector<SphereFamily> families = sphere_families(s53e8, 8, 4'000, 11);
  const auto family = [&](const std::string& name) {
    const auto found = std::find_if(families.begin(), families.end(),
                                    [&](const auto& candidate) { return candidate.name == name; });
    return data::Comparisons::rows(found->pairs, design.inputs).value();
  };
  TypedGraph typed =
      lane_graph(graph, s53e8, {format("s8e8"), Rounding::nearest_even, Subnormals::flush},
                 LaneInputs::rounded);
  const error::ProfiledError error =
      profile::profile_error(graph, typed, family("uniform"), 4'000, 1);
  design.lanes.front().lane = error::profiled_lane(typed, error.f, error.g);
  const verilator_tb::VerifyReport report =
      simulate(design, family("tangent"), {.truth = verilator_tb::TruthCheck{.graph = &graph}});
  EXPECT_TRUE(report.passed()) << to_text(report);
  EXPECT_FALSE(report.certified);
  EXPECT_GT(report.truth->wrong_by_lane, 0u) << to_text(report);
}

}  // namespace
}  // namespace mixcmp::test::families_test
