#include <gtest/gtest.h>

#include "tests/support/simulated_system.hpp"
#include "tests/support/sphere.hpp"
#include "tests/support/sphere_families.hpp"

/// The generated sphere system in simulation, on pairs made to mislead it: every verdict is the
/// golden model's, and where a lane decided, the truth.
namespace mixcmp::test {
namespace {

struct Case {
  const char* name;
  const char* lane;
  const char* reference;
  model::Rounding rounding = model::Rounding::nearest_even;
  model::Subnormals lane_subnormals = model::Subnormals::flush;
  model::Subnormals reference_subnormals = model::Subnormals::gradual;
};

void PrintTo(const Case& c, std::ostream* stream) {
  *stream << c.name;
}

class Families : public testing::TestWithParam<Case> {};

model::Design design_of(const Case& c) {
  const model::Graph graph = sphere_graph();
  model::Design design = sphere_design(format(c.lane), format(c.reference), 2, 1);
  const model::Arithmetic reduced = {format(c.lane), c.rounding, c.lane_subnormals};
  design.lane = model::certified_lane(model::lane_graph(graph, format(c.reference), reduced,
                                                        model::LaneInputs::exact),
                                      std::vector<bool>(8, false))
                    .value();
  design.reference = model::reference_graph(
      graph, {format(c.reference), model::Rounding::nearest_even, c.reference_subnormals});
  return design;
}

TEST_P(Families, VerdictsAreTheGoldenModelsAndLanesTellTheTruth) {
  const model::Graph graph = sphere_graph();
  const model::Design design = design_of(GetParam());
  const int precision = design.lane.graph.arithmetic.format.precision();
  for (const SphereFamily& family :
       sphere_families(design.reference.arithmetic.format, precision, 4'000, 7)) {
    const auto data = model::Comparisons::rows(family.pairs, design.inputs);
    ASSERT_TRUE(data.ok()) << data.error().to_string();
    const tb::VerifyReport report =
        simulate(design, *data, {.truth = tb::TruthCheck{.graph = &graph}});
    EXPECT_TRUE(report.passed()) << family.name << ":\n" << to_text(report);
    ASSERT_TRUE(report.truth) << family.name;
    EXPECT_EQ(report.truth->checked, 4'000u) << family.name;
    EXPECT_EQ(report.truth->wrong_by_lane, 0u) << family.name << ":\n" << to_text(report);
  }
}

INSTANTIATE_TEST_SUITE_P(Systems, Families,
                         testing::Values(Case{"s17e8_of_s53e8", "s17e8", "s53e8"},
                                         Case{"s4e8_of_s24e8", "s4e8", "s24e8"},
                                         Case{"s8e5_of_binary16", "s8e5", "s11e5"},
                                         Case{"s12e6_toward_zero_gradual_of_binary64_flush",
                                              "s12e6", "s53e11", model::Rounding::toward_zero,
                                              model::Subnormals::gradual,
                                              model::Subnormals::flush}),
                         [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace mixcmp::test
