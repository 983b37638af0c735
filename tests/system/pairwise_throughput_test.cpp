#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "model/comparison/data/uniform_spheres.hpp"
#include "model/judge/golden/fixed_evaluate.hpp"
#include "tests/support/simulated_system.hpp"
#include "tests/support/sphere.hpp"

/// The cycles that a whole engine takes for a set, beside those of the performance model.
namespace mixcmp::test::pairwise_throughput_test {
namespace {

constexpr std::uint64_t items = 700;
constexpr auto logic = scene::Multipliers::logic;

/// An engine and data that give it something to do.
struct Load {
  const char* name;
  int lanes;
  int streams;
  int references;
  int interval;  ///< of the references
  const char* lane_format;
  double radius_max;
  int second_tier = 0;  ///< its bits; 0: none. First lanes are then in fixed point of four bits.
  double tolerance = 0.02;
  const char* device = "virtex6-lx760";
  scene::Multipliers multipliers = scene::Multipliers::embedded;
};

/// The name of a test's parameter.
void PrintTo(const Load& load, std::ostream* out) {
  *out << load.name;
}

design::Design design_of(const Load& load) {
  design::Design design =
      sphere_design(format(load.lane_format), format("s24e8"), load.lanes, load.references);
  design.references.front().structure = {load.multipliers, load.interval};
  design.system = with_engine(design.system, {.kind = scene::EngineKind::pairwise,
                                              .capacity = 1024,
                                              .report = {Verdict::less},
                                              .report_streams = load.streams});
  design.system.device = load.device;
  if (load.second_tier > 0) {
    const FloatFormat reference = design.reference.input_format;
    design.lanes.front().lane = fixed_spheres({.bits = 4}, reference);
    design.second_tier = {.lane = fixed_spheres({.bits = load.second_tier}, reference)};
  }
  return design;
}

constexpr std::uint64_t lanes_per_segment = 8;

/// The verdicts of the first lanes on each pair of items i < j.
class FirstVerdicts {
public:
  FirstVerdicts(const design::Design& design, const data::Comparisons& pairs) {
    const auto& lane = std::get<fixed::FixedLane>(design.lanes.front().lane);
    std::vector<Bits> operands(pairs.input_count());
    std::uint64_t k = 0;
    for (std::uint64_t i = 0; i < items; ++i) {
      for (std::uint64_t j = i + 1; j < items; ++j) {
        pairs.fetch(k++, operands);
        verdicts_[i * items + j] = golden::evaluate_lane(lane, operands);
      }
    }
  }

  bool undecided(std::uint64_t i, std::uint64_t j) const { return !of(i, j).decided; }
  bool reported(std::uint64_t i, std::uint64_t j) const {
    return of(i, j).decided && of(i, j).verdict == Verdict::less;
  }

private:
  const golden::LaneResult& of(std::uint64_t i, std::uint64_t j) const {
    return verdicts_[i * items + j];
  }
  std::vector<golden::LaneResult> verdicts_ = std::vector<golden::LaneResult>(items * items);
};

/// Cycles that the second tier needs for item j, in the segment that holds the items from `first`
/// on: at least one if the tier is told of j.
std::uint64_t second_tier_cycles(const FirstVerdicts& verdicts, std::uint64_t first,
                                 std::uint64_t j) {
  std::uint64_t undecided = 0;
  bool told = j < first + lanes_per_segment;  // it stays
  for (std::uint64_t i = first; i < std::min(first + lanes_per_segment, j); ++i) {
    undecided += verdicts.undecided(i, j) ? 1 : 0;
    told = told || verdicts.reported(i, j);
  }
  return std::max<std::uint64_t>(undecided, told ? 1 : 0);
}

/// Cycles that the second tier of the segment with most to do needs for a whole set.
std::uint64_t second_tier_cycles(const FirstVerdicts& verdicts, std::uint64_t lanes) {
  std::uint64_t most = 0;
  for (std::uint64_t segment = 0; segment < lanes; segment += lanes_per_segment) {
    std::uint64_t cycles = 0;
    for (std::uint64_t first = segment; first < items; first += lanes) {
      for (std::uint64_t j = first; j < items; ++j) {
        cycles += second_tier_cycles(verdicts, first, j);
      }
    }
    most = std::max(most, cycles);
  }
  return most;
}

class PairwiseThroughput : public testing::TestWithParam<Load> {};

TEST_P(PairwiseThroughput, IsThePredictedOne) {
  const Load& load = GetParam();
  const design::Design design = design_of(load);
  const data::Table table =
      data::uniform_spheres({.count = items, .side = 100, .radius_max = load.radius_max, .seed = 3},
                            design.reference.input_format);
  const data::Comparisons pairs = data::Comparisons::all_pairs(table, design.inputs).value();
  const auto report = simulate(design, pairs, {});
  ASSERT_TRUE(report.passed()) << to_text(report);
  double predicted = report.engine->expected_cycles.value();
  if (design.second_tier) {
    const std::uint64_t of_tier =
        second_tier_cycles(FirstVerdicts(design, pairs), static_cast<std::uint64_t>(load.lanes));
    predicted = std::max(predicted, static_cast<double>(of_tier));
  }
  fmt::print("{}: {} cycles, {:.0f} predicted\n", load.name, report.cycles, predicted);
  EXPECT_NEAR(static_cast<double>(report.cycles), predicted, load.tolerance * predicted)
      << to_text(report);
}

INSTANTIATE_TEST_SUITE_P(
    Loads, PairwiseThroughput,
    testing::Values(Load{"FewExceptions", 16, 1, 1, 1, "s12e8", 10},  // words limit
                    Load{"ManyReports", 16, 1, 1, 1, "s12e8", 40},    // the report stream
                    Load{"ManyReportsBesideEachOther", 16, 2, 1, 1, "s12e8", 25},
                    Load{"AFoldedReference", 16, 2, 1, 16, "s8e8", 20},
                    Load{"FoldedReferencesBesideEachOther", 16, 2, 3, 16, "s6e8",
                         20},  // references
                    // It reads its operands in its last phase, and needs the next ones at once.
                    Load{"AReferenceOfTwoCycles", 16, 2, 1, 2, "s4e8", 20},
                    // References that read their operands late.
                    Load{"ALateReference", 16, 2, 1, 16, "s8e8", 20, 0, 0.02, "ice40-hx8k", logic},
                    Load{"LateReferencesBesideEachOther", 16, 2, 3, 16, "s6e8", 20, 0, 0.02,
                         "ice40-hx8k", logic},
                    Load{"ASecondTier", 16, 2, 1, 1, "s12e8", 10, 11, 0.05},  // words
                    // Bursts at one of two tiers hold up the other.
                    Load{"ASecondTierAskedTooOften", 16, 2, 1, 1, "s12e8", 60, 11, 0.1}),
    [](const auto& load) { return std::string(load.param.name); });

}  // namespace
}  // namespace mixcmp::test::pairwise_throughput_test
