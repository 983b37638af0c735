#include "generator/present/report/plan_shares.hpp"

#include <gtest/gtest.h>

/// The area shares of a plan's parts, by numbers that are easy to add up.
namespace mixcmp::test::plan_shares_test {
namespace {

using devices::Area;

/// 24 lanes in groups of 12 that take 100 LUTs each, one reference, and 50 LUTs for all of them.
class PlanShares : public testing::Test {
protected:
  PlanShares() {
    optimise::LaneImplementation lanes;
    lanes.measured.key = measured::Segment{};
    lanes.kind = {.name = "q7", .area = {.luts = 100}, .group = 12};
    plan_.lanes.push_back(lanes);
    plan_.problem.references.push_back({.name = "s53e8", .area = {.luts = 40}});
    plan_.result = optimise::Allocation{.lanes = {24}, .references = {1}, .used = {.luts = 290}};
  }

  std::vector<std::pair<std::string, int>> luts() const {
    std::vector<std::pair<std::string, int>> luts;
    for (const report::PartShare& part : report::shares_of(plan_)) {
      luts.emplace_back(part.name, part.area.luts);
    }
    return luts;
  }

  optimise::PrecisionPlan plan_;
};

using Luts = std::vector<std::pair<std::string, int>>;

TEST_F(PlanShares, WholeSegmentsWhereNoLaneWasMeasuredAlone) {
  plan_.lanes.front().second_tier = Area{.luts = 20};
  EXPECT_EQ(luts(), (Luts{{"24 x q7", 200}, {"1 x reference s53e8", 40}, {"engine", 50}}));
}

TEST_F(PlanShares, LanesAndSecondTiersWithoutWhatIsAroundThem) {
  plan_.lanes.front().datapath = Area{.luts = 5};
  plan_.lanes.front().second_tier = Area{.luts = 20};
  EXPECT_EQ(luts(), (Luts{{"24 x q7", 120},
                          {"second tier", 40},
                          {"segments of the lanes", 40},
                          {"1 x reference s53e8", 40},
                          {"engine", 50}}));
}

/// A predicted lane beside a measured segment may seem larger than its share of the segment.
TEST_F(PlanShares, NoPartIsLessThanNothing) {
  plan_.lanes.front().datapath = Area{.luts = 9};
  EXPECT_EQ(luts(), (Luts{{"24 x q7", 200}, {"1 x reference s53e8", 40}, {"engine", 50}}));
}

TEST_F(PlanShares, AnEngineWithACrossbarTellsOfBoth) {
  plan_.problem.communication.crossbar.assign(25, Area{.luts = 7});
  EXPECT_EQ(luts(),
            (Luts{{"24 x q7", 200}, {"1 x reference s53e8", 40}, {"crossbar", 7}, {"engine", 43}}));
}

TEST_F(PlanShares, LanesOneByOneHaveScoreboards) {
  plan_.lanes.front().measured.key = measured::Lane{};
  plan_.lanes.front().kind.group = 1;
  plan_.lanes.front().kind.area.luts = 10;
  plan_.lanes.front().datapath = Area{.luts = 6};
  EXPECT_EQ(luts(), (Luts{{"24 x q7", 144},
                          {"scoreboards of the lanes", 96},
                          {"1 x reference s53e8", 40},
                          {"crossbar", 10}}));
}

}  // namespace
}  // namespace mixcmp::test::plan_shares_test
