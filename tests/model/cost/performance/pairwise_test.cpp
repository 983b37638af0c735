#include "model/cost/performance/pairwise.hpp"

#include <gtest/gtest.h>

namespace mixcmp::test::pairwise_test {
namespace {

using performance::pairwise_cycles;
using performance::pairwise_word_cycles;

TEST(PairwiseCycles, BlocksMeetWhatComesBehindThem) {
  EXPECT_EQ(pairwise_word_cycles(5, 0, 2), 5u + 3 + 1);
  EXPECT_EQ(pairwise_word_cycles(4, 0, 8), 4u);
}

TEST(PairwiseCycles, BlocksOfOneTableMeetTheOther) {
  EXPECT_EQ(pairwise_word_cycles(3, 4, 2), (2u + 4) + (1 + 4));
}

TEST(PairwiseCycles, AreThoseOfWhatTakesLongest) {
  const performance::PairwiseSet words{.items = 5, .lanes = 2, .lane_latency_cycles = 7};
  EXPECT_EQ(pairwise_cycles(words), 9 + 3 + 7);
  performance::PairwiseSet set = words;
  set.exceptions = 20;
  EXPECT_EQ(pairwise_cycles(set), 20 + 3 + 7);
  set.second_tier_cycles = 30;
  EXPECT_EQ(pairwise_cycles(set), 30 + 3 + 7);
  set.recomputations = 40;
  EXPECT_EQ(pairwise_cycles(set), 30 + 3 + 7) << "there are no references";
  set.references = 2;
  EXPECT_EQ(pairwise_cycles(set), 40 + 3 + 7) << "the memory starts one a cycle";
  set.initiation_interval = 16;
  EXPECT_EQ(pairwise_cycles(set), 40 * 8 + 3 + 7);
}

}  // namespace
}  // namespace mixcmp::test::pairwise_test
