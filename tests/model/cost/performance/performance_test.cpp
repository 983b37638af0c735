#include "model/cost/performance/performance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace mixcmp::test::performance_test {
namespace {

performance::Datapaths lanes(int count, double throughput, double rate) {
  return {.count = count, .throughput_per_s = throughput, .recomputation_rate = rate};
}
performance::Datapaths references(int count, double throughput) {
  return {.count = count, .throughput_per_s = throughput};
}

TEST(Performance, ThroughputsAggregateOverKinds) {
  EXPECT_EQ(performance::aggregated_throughput({}), 0);
  EXPECT_EQ(performance::aggregated_throughput({lanes(3, 100, 0.5), lanes(2, 50, 0)}), 400);
  EXPECT_EQ(performance::recomputations_per_s({lanes(3, 100, 0.5), lanes(2, 50, 0)}), 150);
}

TEST(Performance, EquivalentThroughputIsTheSlowerSides) {
  // Ten lanes of 100/s ask a reference for a fifth: 200/s. Of 300/s, 200/s and 50/s.
  const std::vector<performance::Datapaths> ten{lanes(10, 100, 0.2)};
  EXPECT_DOUBLE_EQ(performance::equivalent_throughput(ten, {references(1, 300)}), 1000);
  EXPECT_DOUBLE_EQ(performance::equivalent_throughput(ten, {references(1, 200)}), 1000);
  EXPECT_DOUBLE_EQ(performance::equivalent_throughput(ten, {references(1, 50)}), 250);
  EXPECT_DOUBLE_EQ(performance::equivalent_throughput(ten, {}), 0);
  EXPECT_DOUBLE_EQ(performance::equivalent_throughput({lanes(10, 100, 0)}, {}), 1000);
}

TEST(Performance, AtTheOptimalRatioBothSidesAreBusy) {
  const double ratio = performance::optimal_ratio(300, 200, 0.05);  // lanes a reference
  EXPECT_DOUBLE_EQ(ratio, 200 / (300 * 0.05));
  EXPECT_TRUE(std::isinf(performance::optimal_ratio(300, 200, 0)));
  const int below = static_cast<int>(ratio);
  EXPECT_TRUE(performance::references_suffice({lanes(below, 300, 0.05)}, {references(1, 200)}));
  EXPECT_FALSE(
      performance::references_suffice({lanes(below + 1, 300, 0.05)}, {references(1, 200)}));
}

TEST(Performance, EqualityInDecimalsIsEquality) {
  EXPECT_TRUE(performance::references_suffice({lanes(3, 1, 0.1)}, {references(1, 0.3)}));
  EXPECT_TRUE(performance::references_suffice({lanes(10, 1, 0.1)}, {references(1, 1)}));
  EXPECT_FALSE(performance::references_suffice({lanes(10, 1, 0.1 + 1e-11)}, {references(1, 1)}));
}

TEST(Performance, SlackIsRoundedDownWithoutLosingAWhole) {
  const devices::Area area{.luts = 207360, .registers = 10, .dsps = 864, .memories = 7};
  EXPECT_EQ(performance::usable(area, 0.2).luts, 165888);
  EXPECT_EQ(performance::usable(area, 0.2).dsps, 691);
  EXPECT_EQ(performance::usable(area, 0.9).registers, 1);  // 10 (1 - 0.9) is below 1 in doubles
  EXPECT_EQ(performance::usable(area, 0.2).memories, 5);
  EXPECT_EQ(performance::usable(area, 0), area);
  EXPECT_EQ(performance::usable(area, 1).luts, 0);
}

TEST(Performance, LanesAreDealtByRemainder) {
  EXPECT_EQ(performance::lanes_of_references(7, 3), (std::vector<int>{3, 2, 2}));
  EXPECT_EQ(performance::lanes_of_references(2, 5), (std::vector<int>{1, 1, 0, 0, 0}));
  EXPECT_EQ(performance::lanes_of_references(0, 2), (std::vector<int>{0, 0}));
  EXPECT_TRUE(performance::lanes_of_references(3, 0).empty());
  for (int n = 0; n < 40; ++n) {
    const auto served = performance::lanes_of_references(n, 4);
    EXPECT_EQ(std::accumulate(served.begin(), served.end(), 0), n);
  }
}

TEST(Performance, LoadsOfReferencesFollowTheDeal) {
  // Lanes 0..4 ask for 1 each, lanes 5..7 for 10: reference 0 has lanes 0, 3, 6.
  const std::vector<performance::Datapaths> kinds{lanes(5, 2, 0.5), lanes(3, 10, 1)};
  EXPECT_EQ(performance::recomputations_of_references(kinds, 3), (std::vector<double>{12, 12, 11}));
  EXPECT_TRUE(performance::each_reference_suffices(kinds, {references(3, 12)}));
  EXPECT_FALSE(
      performance::each_reference_suffices(kinds, {references(1, 12), references(2, 11.9)}));
}

TEST(Performance, LanesThatDoNotDivideEvenlyNeedMoreThanTheTotal) {
  // Three lanes at one reference, two at the other: 1.2 and 0.8 of a reference's capacity.
  const std::vector<performance::Datapaths> five{lanes(5, 100, 0.4)};
  const std::vector<performance::Datapaths> two{references(2, 100)};
  EXPECT_TRUE(performance::references_suffice(five, two));
  EXPECT_FALSE(performance::each_reference_suffices(five, two));
  EXPECT_DOUBLE_EQ(performance::equivalent_throughput(five, two), 500);
  EXPECT_DOUBLE_EQ(performance::round_robin_throughput(five, two), 250 + 200);
}

TEST(Performance, LanesThatAskForLessThanTheirTurnAreNotHeldUp) {
  // One reference of 90: the first lane asks for 10, the other two for 60 each and get 40.
  const std::vector<performance::Datapaths> kinds{lanes(1, 100, 0.1), lanes(2, 60, 1)};
  EXPECT_DOUBLE_EQ(performance::round_robin_throughput(kinds, {references(1, 90)}), 100 + 40 + 40);
  EXPECT_DOUBLE_EQ(performance::round_robin_throughput(kinds, {references(1, 130)}), 100 + 60 + 60);
}

TEST(Performance, WithoutReferencesOnlyLanesThatNeedNoneWork) {
  EXPECT_DOUBLE_EQ(performance::round_robin_throughput({lanes(4, 10, 0)}, {}), 40);
  EXPECT_DOUBLE_EQ(performance::round_robin_throughput({lanes(4, 10, 1e-9)}, {}), 0);
  EXPECT_TRUE(performance::each_reference_suffices({lanes(4, 10, 0)}, {}));
  EXPECT_FALSE(performance::each_reference_suffices({lanes(4, 10, 1e-9)}, {}));
}

}  // namespace
}  // namespace mixcmp::test::performance_test
