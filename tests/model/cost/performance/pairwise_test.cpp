#include "model/cost/performance/pairwise.hpp"

#include <gtest/gtest.h>

namespace mixcmp::test::pairwise_test {
namespace {

using performance::pairwise_word_cycles;

TEST(PairwiseWords, BlocksMeetWhatComesBehindThem) {
  EXPECT_EQ(pairwise_word_cycles(5, 0, 2), 5u + 3 + 1);
  EXPECT_EQ(pairwise_word_cycles(4, 0, 8), 4u);
}

TEST(PairwiseWords, BlocksOfOneTableMeetTheOther) {
  EXPECT_EQ(pairwise_word_cycles(3, 4, 2), (2u + 4) + (1 + 4));
}

}  // namespace
}  // namespace mixcmp::test::pairwise_test
