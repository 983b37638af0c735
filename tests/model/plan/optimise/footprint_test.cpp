#include "model/plan/optimise/footprint.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/model/plan/optimise/planning_case.hpp"

namespace mixcmp::test::footprint_test {
namespace {

using optimise::Footprint;

/// Footprints of sphere systems: s8e8 lanes, exact inputs and a relative bound, as the table of
/// PlanningTest has them: 240 LUTs and 2 DSPs each, 20 LUTs of streams; a reference 3000 LUTs and
/// 20 DSPs.
class FootprintTest : public PlanningTest {
protected:
  FootprintTest() {
    std::sort(table_.rows.begin(), table_.rows.end(),
              [](const auto& a, const auto& b) { return a.key < b.key; });
  }

  design::Design design(int lanes, int references = 1) {
    return sphere_design(format("s8e8"), format("s53e8"), lanes, references);
  }

  std::string excess(const design::Design& design, const measured::Characterisation* table) {
    return excess_of(optimise::footprint_of(design, table, device_), design, device_, "table.csv")
        .value_or("");
  }
};

TEST_F(FootprintTest, AddsUpWhatWasMeasured) {
  const Footprint footprint = optimise::footprint_of(design(10), &table_, device_);
  EXPECT_TRUE(footprint.measured);
  const int crossbar = 111;  // of 8 ports, the most that were measured below 10
  EXPECT_EQ(footprint.amounts[0], 10 * (240 + fifo_64_luts) + 3000 + crossbar);
  EXPECT_EQ(footprint.amounts[2], 10 * 2 + 20);
}

TEST_F(FootprintTest, LanesInLockStepShareAScoreboardAndAPort) {
  design::Design grouped = design(12);
  grouped.system.lanes_per_group = 6;
  const int crossbar = 10;  // of one port: less than 8 are asked for
  EXPECT_EQ(optimise::footprint_of(grouped, &table_, device_).amounts[0],
            12 * 240 + 2 * fifo_64_luts + 3000 + crossbar);
}

TEST_F(FootprintTest, TakesTheRowOfTheReferenceAtHand) {
  design::Design placed = design(7);
  placed.references.front().structure.target_mhz = 400;
  EXPECT_FALSE(optimise::footprint_of(placed, &table_, device_).measured);
  table_.rows.push_back(reference_row("embedded", 3100, 20));
  measured::reference_of(table_.rows.back().key)->target_mhz = 400;
  std::sort(table_.rows.begin(), table_.rows.end(),
            [](const auto& a, const auto& b) { return a.key < b.key; });
  const auto luts = [&](const design::Design& made) {
    return optimise::footprint_of(made, &table_, device_).amounts[0];
  };
  EXPECT_EQ(luts(placed), luts(design(7)) + 100);
  placed.reference.arithmetic.sums = Sums::fused;
  EXPECT_FALSE(optimise::footprint_of(placed, &table_, device_).measured);
}

TEST_F(FootprintTest, CountsACrossbarOfNoMorePortsThanThereAre) {
  const Footprint footprint = optimise::footprint_of(design(7), &table_, device_);
  const int crossbar = 10;  // of 1 port; that of 8, also measured, is larger
  EXPECT_EQ(footprint.amounts[0], 7 * (240 + fifo_64_luts) + 3000 + crossbar);
}

TEST_F(FootprintTest, MeasuredAreasAreHeldAgainstWhatTheDeviceHas) {
  EXPECT_EQ(excess(design(15), &table_), "");  // 50 of 50 DSPs
  EXPECT_EQ(excess(design(16), &table_),
            "16 lanes and 1 reference do not fit small: at least 52 dsp of 50; areas measured, "
            "table.csv");
  const std::string both = excess(design(400), &table_);
  EXPECT_NE(both.find("of 10000, 107111 ff of 20000, 820 dsp of 50"), std::string::npos) << both;
}

TEST_F(FootprintTest, WithoutATableTheRoughCostModelSpeaksOfPlainExcessAlone) {
  device_.available.luts = 100000;
  EXPECT_EQ(excess(design(1), nullptr), "");
  const Footprint one = optimise::footprint_of(design(1, 0), nullptr, device_);
  EXPECT_FALSE(one.measured);
  const int fitting = static_cast<int>(device_.available.luts / one.amounts[0]);
  EXPECT_EQ(excess(design(fitting, 0), nullptr), "");
  const std::string many = excess(design(2 * fitting, 0), nullptr);
  EXPECT_NE(many.find("lut of 100000; a rough estimate before synthesis"), std::string::npos)
      << many;
}

TEST_F(FootprintTest, ATableWithoutTheLaneIsNotUsed) {
  const design::Design other = sphere_design(format("s9e8"), format("s53e8"), 1, 1);
  EXPECT_FALSE(optimise::footprint_of(other, &table_, device_).measured);
}

TEST_F(FootprintTest, EmbeddedMultipliersTakeProductsOutOfTheEstimate) {
  const Footprint embedded = optimise::footprint_of(design(1), nullptr, device_);
  device_.available.dsps = 0;
  EXPECT_GT(optimise::footprint_of(design(1), nullptr, device_).amounts[0], embedded.amounts[0]);
}

}  // namespace
}  // namespace mixcmp::test::footprint_test
