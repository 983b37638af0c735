#include "model/cost/performance/pairwise_flow.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <memory>

#include "model/base/common/counter_random.hpp"

namespace mixcmp::test::pairwise_flow_test {
namespace {

using performance::ItemSet;
using performance::pairwise_word_cycles;
using performance::PairwiseData;
using performance::PairwiseEngine;
using performance::PairwiseFlow;

using Pairs = std::shared_ptr<const PairwiseData>;

/// `is_reported` says by its number whether a pair is.
Pairs data_of(ItemSet set, const std::function<bool(std::uint64_t)>& is_reported) {
  PairwiseData data{.set = set};
  data.reported.resize((data.pairs() + 63) / 64);
  for (std::uint64_t k = 0; k < data.pairs(); ++k) {
    data.reported[k / 64] |= std::uint64_t{is_reported(k)} << k % 64;
  }
  return std::make_shared<PairwiseData>(std::move(data));
}

Pairs none_of(ItemSet set) {
  return std::make_shared<PairwiseData>(PairwiseData{.set = set});
}

/// One in `every` pairs, without a pattern.
bool is_drawn(std::uint64_t pair, std::uint64_t every) {
  return counter_random(0, pair) % every == 0;
}

constexpr PairwiseEngine engine_of_64{
    .lanes = 64, .lanes_per_segment = 8, .streams = 1, .lane_latency_cycles = 6};

/// Words enter one a cycle and pass eight segments in three cycles each.
TEST(PairwiseFlow, WithoutReportsTakesTheCyclesOfItsWords) {
  for (const ItemSet set : {ItemSet{.items = 500}, ItemSet{.items = 65}, ItemSet{.items = 9}}) {
    const auto words = static_cast<double>(pairwise_word_cycles(set.items, 0, 64));
    const double cycles = PairwiseFlow(none_of(set)).cycles(engine_of_64);
    EXPECT_GT(cycles, words) << set.items;
    EXPECT_LT(cycles, words + 24 + 60) << set.items;
  }
}

TEST(PairwiseFlow, ASetEndsWithTheLastWordsAnswer) {
  const PairwiseFlow flow(none_of({.items = 100}));
  PairwiseEngine slower = engine_of_64;
  slower.lane_latency_cycles += 40;
  EXPECT_EQ(flow.cycles(slower), flow.cycles(engine_of_64) + 40);
}

TEST(PairwiseFlow, UndecidedPairsAreReportedWithoutReferences) {
  const ItemSet set{.items = 500};
  PairwiseEngine engine = engine_of_64;
  engine.undecided = 0.03;  // few enough that the queues are simulated
  engine.recomputations_per_cycle = 0;
  const double cycles = PairwiseFlow(none_of(set)).cycles(engine);
  constexpr double reports = 0.03 * 124'750;
  EXPECT_GT(cycles, reports) << "one stream takes a pair a cycle";
  EXPECT_LT(cycles, 1.1 * reports);
}

TEST(PairwiseFlow, LoadsAllTargetsBeforeTheOthersMeetThem) {
  const ItemSet set{.items = 100, .others = 300};
  const auto words = static_cast<double>(pairwise_word_cycles(100, 300, 64));
  const double cycles = PairwiseFlow(none_of(set)).cycles(engine_of_64);
  EXPECT_GT(cycles, 100 + words);
  EXPECT_LT(cycles, 100 + words + 24 + 60);
}

TEST(PairwiseFlow, AStreamTakesOneReportACycle) {
  const PairwiseFlow all(data_of({.items = 600}, [](std::uint64_t) { return true; }));
  EXPECT_DOUBLE_EQ(all.reported_share(), 1);
  for (const int streams : {1, 2, 8}) {
    PairwiseEngine engine = engine_of_64;
    engine.streams = streams;
    EXPECT_NEAR(all.cycles(engine) / (all.pairs() / streams), 1, 0.1) << streams;
  }
}

/// A word with the eight lanes of a segment is one report.
TEST(PairwiseFlow, ABitmapIsOneReport) {
  const PairwiseFlow all(data_of({.items = 300}, [](std::uint64_t) { return true; }));
  PairwiseEngine engine = engine_of_64;
  engine.report_as = scene::ReportForm::bitmap;
  EXPECT_NEAR(all.cycles(engine) / (all.pairs() / 8), 1, 0.15);
  engine.report_as = scene::ReportForm::count;
  EXPECT_EQ(all.cycles(engine), PairwiseFlow(none_of({.items = 300})).cycles(engine_of_64));
}

/// One pair in 100 is reported. Spread out, 64 lanes report in two of three cycles; the same number
/// beside each other fills the queues.
TEST(PairwiseFlow, BurstsTakeLongerThanSpreadReports) {
  constexpr std::uint64_t items = 1000;
  const PairwiseFlow spread(
      data_of({.items = items}, [](std::uint64_t k) { return is_drawn(k, 100); }));
  const PairwiseFlow bursts(
      data_of({.items = items}, [](std::uint64_t k) { return is_drawn(k / 500, 100); }));
  EXPECT_NEAR(bursts.reported_share(), spread.reported_share(), 0.004);
  const auto words = static_cast<double>(pairwise_word_cycles(items, 0, 64));
  EXPECT_LT(spread.cycles(engine_of_64), 1.05 * words);
  EXPECT_GT(bursts.cycles(engine_of_64), 1.2 * words);
}

/// Lanes that leave one pair in 50 undecided ask for 1.28 recomputations a cycle.
TEST(PairwiseFlow, WaitsForItsReferences) {
  const PairwiseFlow flow(none_of({.items = 600}));
  PairwiseEngine engine = engine_of_64;
  engine.undecided = 0.02;
  const double stored = 600;  // by the memory that reads the pairs
  EXPECT_NEAR(flow.cycles(engine) / (0.02 * flow.pairs() + stored), 1, 0.1);
  engine.recomputations_per_cycle = 0.25;
  EXPECT_NEAR(flow.cycles(engine) / (0.02 * flow.pairs() * 4), 1, 0.1);
}

/// The items' memory reads a pair or stores an item: while a set of one block is loaded, each
/// recomputation holds up a word.
TEST(PairwiseFlow, ARecomputationHoldsUpAnItem) {
  const PairwiseFlow flow(none_of({.items = 64}));
  PairwiseEngine engine = engine_of_64;
  const double without = flow.cycles(engine);
  engine.undecided = 0.02;  // 40 pairs, some of them after the last item
  EXPECT_NEAR(flow.cycles(engine) - without, 32, 8);
}

TEST(PairwiseFlow, ASetEndsWithTheLastReferencesAnswer) {
  const PairwiseFlow flow(none_of({.items = 64}));
  PairwiseEngine engine = engine_of_64;
  engine.undecided = 0.02;
  const double at_once = flow.cycles(engine);
  engine.reference_latency_cycles = 100;
  EXPECT_NEAR(flow.cycles(engine) - at_once, 90, 10);
  engine.undecided = 0;
  EXPECT_LT(flow.cycles(engine), at_once) << "no answer is waited for";
}

/// The words that enter first meet few lanes, and half of the second table has all reports: only a
/// sample of all parts knows how many reports there are.
TEST(PairwiseFlow, ASampleStandsForALargeSet) {
  constexpr int items = 8192, lanes = 4096;
  const PairwiseFlow half(
      data_of({.items = items}, [](std::uint64_t k) { return counter_random(1, k) % 2 == 0; }));
  PairwiseEngine engine = engine_of_64;
  engine.lanes = lanes;
  engine.streams = 16;
  double pairs = 0;  // of the first 256 lanes in both blocks, which have the busiest stream
  for (int base = 0; base < items; base += lanes) pairs += 256.0 * (items - base - 128);
  EXPECT_NEAR(half.cycles(engine) / (half.reported_share() * pairs), 1, 0.05);
  const PairwiseFlow cross(data_of({.items = 2048, .others = 8192}, [](std::uint64_t k) {
    return k % 8192 < 4096 && counter_random(1, k) % 2 == 0;
  }));
  engine.lanes = 512;
  engine.streams = 4;
  EXPECT_NEAR(cross.cycles(engine) / (cross.reported_share() * cross.pairs() / 4), 1, 0.05);
}

TEST(PairwiseFlow, OfALargeSetWithFewReportsIsThatOfItsWords) {
  for (const ItemSet set : {ItemSet{.items = 5000}, ItemSet{.items = 20000, .others = 800}}) {
    const PairwiseFlow flow(data_of(set, [](std::uint64_t k) { return is_drawn(k, 1000); }));
    const auto words = static_cast<double>(pairwise_word_cycles(set.items, set.others, 64));
    const double load = set.others > 0 ? static_cast<double>(set.items) : 0;
    EXPECT_NEAR(flow.cycles(engine_of_64) / (words + load), 1, 0.02) << set.items;
  }
}

}  // namespace
}  // namespace mixcmp::test::pairwise_flow_test
