#include "model/base/number/bound.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "model/base/settings/bound_name.hpp"
#include "model/scene/lane_bound.hpp"

/// Tests bounds, their names, and the order of tables.
namespace mixcmp::test::bound_test {
namespace {

TEST(Bound, NamesAreReadAsTheyAreWritten) {
  for (const char* name : {"relative", "running_1", "running_8", "constant", "profiled",
                           "fixed_norm", "fixed_running", "fixed_grid", "block_running_g2",
                           "fixed_constant_g3", "block_norm_g10", "block_constant"}) {
    const auto bound = settings::parse_bound(name);
    ASSERT_TRUE(bound.ok()) << name;
    EXPECT_EQ(to_string(*bound), name);
  }
  for (const char* word :
       {"fixed_norm_3", "fixed_norm_g0", "fixed_norm_g", "fixed_norm_g03", "relative_g3",
        "running_9", "fixed_norm_g48", "norm", "fixed_relative", "block_profiled"}) {
    EXPECT_FALSE(settings::parse_bound(word).ok()) << word;
  }
}

TEST(Bound, BelongsToFormatsWithItsGuardDigits) {
  const Bound bound{NumberSystem::fixed, BoundKind::norm, 3};
  EXPECT_EQ(bound.fixed_point(9), (FixedPoint{9, false, 3}));
  EXPECT_TRUE(bound.is_for(LaneFormat::parse("q9g3").value()));
  for (const char* other : {"q9", "q9g4", "block9g3", "s9e8"}) {
    EXPECT_FALSE(bound.is_for(LaneFormat::parse(other).value())) << other;
  }
}

TEST(Bound, TablesAreInTheOrderOfNamesThenOfDigits) {
  std::vector<std::string> names;
  std::vector<Bound> bounds(counted_bounds().begin(), counted_bounds().end());
  bounds.push_back({NumberSystem::fixed, BoundKind::running, 10});
  bounds.push_back({NumberSystem::fixed, BoundKind::running, 9});
  std::sort(bounds.begin(), bounds.end());
  for (const Bound& bound : bounds) names.push_back(to_string(bound));
  EXPECT_EQ(names,
            (std::vector<std::string>{"block_constant", "block_norm", "constant", "fixed_constant",
                                      "fixed_norm", "fixed_running_g9", "fixed_running_g10",
                                      "profiled", "relative", "running_1", "running_4"}));
}

TEST(Bound, IsGivenToLanesOfAScene) {
  scene::ReducedSpec reduced;
  reduced.format = FloatFormat::make(11, 8).value();
  const auto with = [&](const char* name) {
    return with_bound(reduced, settings::parse_bound(name).value());
  };
  EXPECT_EQ(with("running_2").error_bound, BoundKind::running);
  EXPECT_EQ(with("running_2").bound_digits, 2);
  EXPECT_EQ(with("running_2").format_name(), "s11e8");
  EXPECT_EQ(with("fixed_running_g3").error_bound, BoundKind::running);
  EXPECT_EQ(with("fixed_running_g3").bound_digits, reduced.bound_digits);
  EXPECT_EQ(with("fixed_running_g3").format_name(), "q11g3");
  EXPECT_EQ(with("block_norm").format_name(), "block11");
  EXPECT_TRUE(with("profiled").is_profiled);
  EXPECT_EQ(with("profiled").error_bound, std::nullopt);
}

}  // namespace
}  // namespace mixcmp::test::bound_test
