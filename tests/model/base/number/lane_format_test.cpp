#include "model/base/number/lane_format.hpp"

#include <gtest/gtest.h>

/// Tests the names of lanes' formats.
namespace mixcmp::test::lane_format_test {
namespace {

TEST(FixedPoint, NamesAreReadAsTheyAreWritten) {
  for (const char* name : {"q13", "block13", "q13g3", "block2g10", "q48"}) {
    const auto format = FixedPoint::parse(name);
    ASSERT_TRUE(format) << name;
    EXPECT_EQ(format->name(), name);
  }
  EXPECT_EQ(FixedPoint::parse("block7g12"), (FixedPoint{7, true, 12}));
  EXPECT_EQ(FixedPoint::parse("q9"), (FixedPoint{9, false, 0}));
  EXPECT_EQ((FixedPoint{7, true, 12}.operand_bits()), 19);
}

TEST(FixedPoint, OtherWordsAreNone) {
  for (const char* word :
       {"", "q", "block", "q13g", "q13g0", "q013", "q13g03", "qg3", "q13g-1", "q13g3g3", "q+13",
        "13g3", "q13 g3", "q13g3x", "s17e8", "block13h3", "q99999999"}) {
    EXPECT_FALSE(FixedPoint::parse(word)) << word;
  }
}

}  // namespace
}  // namespace mixcmp::test::lane_format_test
