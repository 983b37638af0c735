#include <gtest/gtest.h>

#include <algorithm>

#include "model/plan/optimise/engine_area.hpp"
#include "model/plan/optimise/footprint.hpp"
#include "tests/model/plan/optimise/planning_case.hpp"

namespace mixcmp::test::chain_plan_test {
namespace {

using measured::ComponentKind;
using optimise::Allocation;
using optimise::Infeasible;
using optimise::Optimisation;
using optimise::PrecisionPlan;

/// An arg-min engine of 13 candidates: 12 lanes. Engines with 3 and 12 lanes, memories for one and
/// four references, and a crossbar of up to 16 lanes were measured.
class ChainPlan : public PlanningTest {
protected:
  static constexpr int lanes = 12;
  static constexpr int engine_luts = 500, stage_luts = 20;  ///< of 3 lanes; of each further one
  static constexpr int memory_luts = 90,
                       register_luts = 30;  ///< of one reference; of a further one
  static constexpr int port_luts = 70, crossbar_luts = 111;

  ChainPlan() {
    scene_.system = with_engine(scene_.system, {.kind = scene::EngineKind::arg_min});
    scene_.system.lanes = lanes;
    std::erase_if(table_.rows,
                  [](const auto& row) { return measured::reference_of(row.key) == nullptr; });
    for (const auto& [precision, luts] : {std::pair(8, 120), std::pair(10, 100)}) {
      const measured::Lane lane = lane_of(precision);
      table_.rows.push_back(row_of(measured::Segment{lane, 1}, luts, 2));
      table_.rows.push_back(row_of(measured::Engine{lane, 3}, engine_luts));
      table_.rows.push_back(row_of(measured::Engine{lane, lanes}, engine_luts + 9 * stage_luts));
    }
    for (const char* multipliers : {"embedded", "logic"}) {
      table_.rows.push_back(row_of(measured::ReferencePort{reference(multipliers)}, port_luts));
    }
    table_.rows.push_back(row_of(measured::OperandMemory{1}, memory_luts));
    table_.rows.push_back(row_of(measured::OperandMemory{4}, memory_luts + 3 * register_luts));
    table_.rows.push_back(row_of(measured::Crossbar{1}, crossbar_luts));
    table_.rows.push_back(row_of(measured::Crossbar{16}, crossbar_luts));
    sort();
  }

  static measured::Lane lane_of(int precision) {
    return lane("s" + std::to_string(precision) + "e8", "exact", "relative", "embedded");
  }

  /// The LUTs of a chain with such lanes and so many embedded references, row by row.
  static int luts_of_chain(int lane_luts, int references) {
    const int engine = engine_luts + 9 * stage_luts + (references - 1) * register_luts;
    return lanes * lane_luts + engine + references * (3000 + port_luts + crossbar_luts);
  }

  Result<Optimisation> attempt() const {
    return optimise::optimise(scene_, device_, table_, rates_, options_);
  }
  std::string refusal() const {
    const auto found = attempt();
    return found.ok() ? "nothing" : found.error().to_string();
  }
};

TEST_F(ChainPlan, HasALaneForEachCandidateButTheFirst) {
  for (const int luts : {10'000, 1'000'000}) {
    device_.available = {.luts = luts, .registers = 1'000'000, .dsps = 10'000};
    const Optimisation found = optimise_now();
    for (const PrecisionPlan& plan : found.plans) {
      ASSERT_NE(plan.allocation(), nullptr) << luts;
      EXPECT_EQ(plan.allocation()->lane_count(), lanes);
    }
  }
}

TEST_F(ChainPlan, TakesWhatItsRowsTakeTogether) {
  device_.available.dsps = 60;
  const Optimisation found = optimise_now();
  const PrecisionPlan& plan = found.plans.front();
  EXPECT_EQ(plan.precision, 8);
  ASSERT_NE(plan.allocation(), nullptr);
  EXPECT_EQ(plan.allocation()->reference_count(), 1);
  EXPECT_EQ(plan.allocation()->used.luts, luts_of_chain(120, 1));
  EXPECT_EQ(plan.allocation()->used.dsps, lanes * 2 + 20);
}

TEST_F(ChainPlan, EachFurtherReferenceHasAPortAPartOfTheMemoryAndOfTheCrossbar) {
  rates_ = rates_of({{8, 80'000}, {10, 80'000}});  // 12 x 0.08 keep one reference busy, not two
  for (auto& row : table_.rows) {
    if (auto* reference = measured::reference_of(row.key)) reference->initiation_interval = 2;
  }
  sort();
  scene_.reference_structure.initiation_interval = 2;
  device_.available = {.luts = 30'000, .registers = 30'000, .dsps = 200};
  const Optimisation found = optimise_now();
  const PrecisionPlan& plan = found.plans.front();
  ASSERT_NE(plan.allocation(), nullptr);
  EXPECT_EQ(plan.allocation()->reference_count(), 2);
  EXPECT_EQ(plan.allocation()->used.luts, luts_of_chain(120, 2));
}

TEST_F(ChainPlan, OfEquallyFastPrecisionsTheSmallestIsBest) {
  EXPECT_EQ(optimise_now().best()->precision, 10) << "120 LUTs a lane at 8 digits, 100 at 10";
}

TEST_F(ChainPlan, IsNeverShort) {
  device_.available.dsps = 60;
  device_.available.luts = (luts_of_chain(100, 1) * 5 + 3) / 4;  // a fifth is slack
  const Optimisation fits = optimise_now();
  ASSERT_NE(fits.best(), nullptr);
  EXPECT_EQ(fits.best()->precision, 10);
  device_.available.luts -= 2;
  const Optimisation found = optimise_now();
  EXPECT_EQ(found.best(), nullptr);
  const auto& why = std::get<Infeasible>(found.plans.back().result);
  ASSERT_EQ(why.shortages.size(), 1u);
  EXPECT_EQ(why.shortages.front().resource, "lut");
  EXPECT_EQ(why.shortages.front().needed, luts_of_chain(100, 1));
}

TEST_F(ChainPlan, AsksForNoMoreRecomputationsThanTheMemoryStarts) {
  rates_ = rates_of({{8, 84'000}, {10, 84'000}});  // 12 x 0.084 > 1
  device_.available = {.luts = 1'000'000, .registers = 1'000'000, .dsps = 10'000};
  EXPECT_EQ(optimise_now().best(), nullptr);
  rates_ = rates_of({{8, 83'000}, {10, 83'000}});
  EXPECT_NE(optimise_now().best(), nullptr);
}

TEST_F(ChainPlan, ReferencesAloneAreNoMoreThanItsLanes) {
  device_.available = {.luts = 1'000'000, .registers = 1'000'000, .dsps = 10'000};
  EXPECT_EQ(std::get<Allocation>(optimise_now().reference_only).lane_count(), lanes);
}

TEST_F(ChainPlan, TellsHowManyTheDeviceHasRoomFor) {
  device_.available = {.luts = 100'000, .registers = 100'000, .dsps = 10'000};
  const int room = 80'000 / luts_of_chain(100, 1);
  const auto notes = optimise_now().notes;
  EXPECT_TRUE(std::any_of(notes.begin(), notes.end(), [&](const std::string& note) {
    return note.find("room for " + std::to_string(room) + " such engines") != std::string::npos;
  }));
}

/// Lanes of 20 cycles have 64 slots, those of 30 have 128. All lanes of a chain have the slots of
/// the slowest, and each row was measured with its own.
TEST_F(ChainPlan, DoesNotMixLanesOfDifferentBuffers) {
  const measured::Lane slow = lane("s8e8", "exact", "relative", "logic");
  for (const measured::ComponentKey& key : std::initializer_list<measured::ComponentKey>{
           measured::Segment{slow, 1}, measured::Engine{slow, 3}, measured::Engine{slow, lanes}}) {
    table_.rows.push_back(row_of(key, 130));
    table_.rows.back().latency_cycles = 30;
  }
  sort();
  device_.available.dsps = 40;  // for 6 embedded lanes beside an embedded reference
  const PrecisionPlan plan = optimise_now().plans.front();
  ASSERT_NE(plan.allocation(), nullptr);
  ASSERT_EQ(plan.lanes.size(), 1u);
  EXPECT_EQ(plan.lanes.front().measured.latency_cycles, 30);
}

TEST_F(ChainPlan, ATableWithoutAPartIsRefused) {
  const auto all = table_.rows;
  for (const auto& [kind, words] :
       {std::pair(ComponentKind::engine, "engines of two sizes"),
        std::pair(ComponentKind::operand_memory, "operand memories of two sizes"),
        std::pair(ComponentKind::crossbar, "a crossbar"),
        std::pair(ComponentKind::reference_port, "the port of a reference")}) {
    table_.rows = all;
    std::erase_if(table_.rows, [&](const auto& row) { return kind_of(row.key) == kind; });
    EXPECT_NE(refusal().find(words), std::string::npos) << refusal();
  }
}

TEST_F(ChainPlan, NeedsItsNumberOfLanes) {
  scene_.system.lanes.reset();
  const auto found = attempt();
  ASSERT_FALSE(found.ok());
  EXPECT_EQ(found.error().field, "system.lanes");
}

TEST_F(ChainPlan, AnEngineToBeGeneratedIsHeldAgainstTheSameAreas) {
  design::Design design = sphere_design(format_of(8, 8), format_of(53, 8), lanes, 2);
  design.system.engine = scene_.system.engine;
  const optimise::Footprint footprint = optimise::footprint_of(design, &table_, device_);
  EXPECT_TRUE(footprint.measured);
  EXPECT_EQ(footprint.amounts[0], luts_of_chain(120, 2));
}

/// Memories that grow with the number of candidates make a chain's area bend upwards.
TEST_F(ChainPlan, TakesWhatTheLargerEngineTakesHoweverLittleTheSmallerDoes) {
  measured::Measurement segment;
  for (auto& row : table_.rows) {
    const auto* engine = std::get_if<measured::Engine>(&row.key);
    if (engine != nullptr && engine->segments == 3) row.area.luts = 30;
    if (std::holds_alternative<measured::OperandMemory>(row.key)) row.area.luts = 0;
    if (std::holds_alternative<measured::Segment>(row.key)) segment = row;
  }
  std::set<std::string> missing;
  optimise::EngineUse use = {.kind = scene::EngineKind::arg_min};
  const optimise::EngineArea area = optimise::engine_area(table_, segment, use, missing).value();
  EXPECT_GE(area.own.luts, 0);
  EXPECT_EQ(area.own.luts + lanes * (area.group.luts - segment.area.luts),
            engine_luts + 9 * stage_luts);
}

/// Lanes that are not exact, in a table with references.
TEST_F(ChainPlan, WithoutReferencesLanesMustBeExact) {
  EXPECT_EQ(refusal(), "nothing");
  scene_.system.references = 0;
  EXPECT_NE(refusal().find("lane"), std::string::npos) << refusal();
}

/// An engine without references has no memory of operands, so nothing of its area is theirs.
TEST_F(ChainPlan, WithoutReferencesTheEngineIsWhollyItsOwn) {
  const auto own = [&](bool recomputes) {
    const auto segment = std::find_if(table_.rows.begin(), table_.rows.end(), [](const auto& row) {
      return std::holds_alternative<measured::Segment>(row.key);
    });
    std::set<std::string> missing;
    const optimise::EngineUse use = {.kind = scene::EngineKind::arg_min, .recomputes = recomputes};
    const auto area = optimise::engine_area(table_, *segment, use, missing);
    return area ? area->own.luts : -1;
  };
  EXPECT_GT(own(false), own(true));
  std::erase_if(table_.rows, [](const auto& row) {
    return std::holds_alternative<measured::OperandMemory>(row.key);
  });
  EXPECT_GT(own(false), 0);
}

TEST_F(ChainPlan, IsSlowerWhereItsReferencesCannotKeepUp) {
  expect_plans_at_rates(rates_of({{8, 400'000}, {10, 300'000}}));
}

/// Rows do not overtake: of 12 lanes and one reference at half of the clock, each lane leaves 10 %
/// undecided, so a row takes 1.2 recomputations.
TEST_F(ChainPlan, WaitsForItsBusiestReference) {
  device_.available = {.luts = 100'000, .registers = 1'000'000, .dsps = 10'000};
  const Optimisation found = optimise_now();
  const PrecisionPlan& plan = *found.best();
  ASSERT_EQ(plan.allocation()->reference_count(), 1);
  const auto more = at_rates(plan, scene_, rates_of({{8, 100'000}, {10, 100'000}}));
  ASSERT_TRUE(more);
  const double own = plan.throughput_per_s();
  EXPECT_NEAR(more->throughput_per_s, own / 1.2, own * 1e-9);
}

}  // namespace
}  // namespace mixcmp::test::chain_plan_test
