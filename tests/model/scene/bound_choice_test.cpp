#include "model/scene/bound_choice.hpp"

#include <gtest/gtest.h>

/// The names of the kinds of bounds.
namespace mixcmp::test::bound_choice_test {
namespace {

using scene::BoundChoice;
using Kind = BoundChoice::Kind;

TEST(BoundChoice, NamesAreReadAsTheyAreWritten) {
  for (const char* name :
       {"relative", "running_1", "running_8", "constant", "profiled", "fixed_norm", "fixed_running",
        "block_running_g2", "fixed_constant_g3", "block_norm_g10", "block_constant"}) {
    const auto choice = scene::parse_bound_choice(name);
    ASSERT_TRUE(choice.ok()) << name;
    EXPECT_EQ(to_string(*choice), name);
  }
  for (const char* word : {"fixed_norm_3", "fixed_norm_g0", "fixed_norm_g", "fixed_norm_g03",
                           "relative_g3", "running_9", "fixed_norm_g48"}) {
    EXPECT_FALSE(scene::parse_bound_choice(word).ok()) << word;
  }
}

TEST(BoundChoice, BelongsToFormatsWithItsGuardDigits) {
  const BoundChoice choice{Kind::fixed_norm, 3};
  EXPECT_EQ(choice.fixed_point(9), (FixedPoint{9, false, 3}));
  EXPECT_TRUE(choice.is_for(LaneFormat::parse("q9g3").value()));
  for (const char* other : {"q9", "q9g4", "block9g3", "s9e8"}) {
    EXPECT_FALSE(choice.is_for(LaneFormat::parse(other).value())) << other;
  }
}

}  // namespace
}  // namespace mixcmp::test::bound_choice_test
