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

TEST(BusyShare, IsThatOfLanesWithAnItem) {
  EXPECT_DOUBLE_EQ(performance::busy_share({.items = 5}, 2), 10.0 / (2 * (5 + 3 + 1)));
  EXPECT_DOUBLE_EQ(performance::busy_share({.items = 4}, 8), 6.0 / (8 * 4))
      << "lanes without items";
  EXPECT_DOUBLE_EQ(performance::busy_share({.items = 3, .others = 4}, 2), 12.0 / (2 * 11));
}

TEST(ReportWords, AreWhatAGroupSends) {
  scene::EngineSpec engine;
  engine.lanes_per_group = 4;
  EXPECT_DOUBLE_EQ(performance::report_words(engine, 0.25, 0.125), 1 + 0.5);
  engine.report_as = scene::ReportForm::bitmap;
  EXPECT_DOUBLE_EQ(performance::report_words(engine, 0.5, 0.125), 1 - 0.0625 + 0.5);
  engine.report_as = scene::ReportForm::count;
  EXPECT_DOUBLE_EQ(performance::report_words(engine, 0.5, 0.125), 0.5);
}

/// Five groups on two streams: one of the streams has three.
TEST(CyclesBetweenReports, AreThoseOfTheBusiestStream) {
  scene::EngineSpec engine;
  engine.report_streams = 2;
  EXPECT_DOUBLE_EQ(performance::cycles_between_reports(engine, 5, 0.5), 1.5);
  EXPECT_DOUBLE_EQ(performance::cycles_between_reports(engine, 4, 0.5), 1);
  EXPECT_DOUBLE_EQ(performance::cycles_between_reports(engine, 2, 0.5), 1) << "never below one";
}

}  // namespace
}  // namespace mixcmp::test::pairwise_test
