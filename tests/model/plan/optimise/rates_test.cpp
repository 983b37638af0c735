#include "model/plan/optimise/rates.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "model/comparison/data/uniform_spheres.hpp"
#include "model/plan/optimise/plan_inputs.hpp"
#include "tests/model/plan/profile/profile_cases.hpp"
#include "tests/support/scratch_directory.hpp"
#include "tests/support/sphere.hpp"

namespace mixcmp::test::rates_test {
namespace {

using optimise::Rate;
using optimise::RateKey;
using optimise::Rates;

constexpr const char* header =
    "inputs,precision,scheme,comparisons,undecided,rate,wrong,wrong_by_lane\n";

class RatesFile : public testing::Test {
protected:
  Result<Rates> read(const std::string& text) {
    const auto path = directory_.path() / "figure5.csv";
    std::ofstream(path) << text;
    return Rates::read(path);
  }

  void expect_refused(const std::string& text, const std::string& words) {
    const auto rates = read(text);
    ASSERT_FALSE(rates.ok());
    EXPECT_NE(rates.error().to_string().find(words), std::string::npos)
        << rates.error().to_string();
  }

  ScratchDirectory directory_;
};

TEST(RateValue, IsTheShareThatWasUndecided) {
  EXPECT_DOUBLE_EQ((Rate{5, 1000}).value(), 0.005);
}

TEST(RateValue, NoneUndecidedIsNotTakenForNever) {
  EXPECT_DOUBLE_EQ((Rate{0, 1000}).value(), 0.003);
  EXPECT_DOUBLE_EQ((Rate{0, 2}).value(), 1);
}

/// Of 64 pairs of items the first `reported` ones are reported.
Rates with_pairs(int reported) {
  profile::RateProfile profile{.comparisons = 64};
  profile.pairs = std::make_shared<performance::PairwiseData>(performance::PairwiseData{
      .set = {.items = 8, .others = 8}, .reported = {(std::uint64_t{1} << reported) - 1}});
  return Rates::of({profile});
}

constexpr performance::PairwiseEngine engine_of_8{.lanes = 8, .lane_latency_cycles = 5};

TEST(RatesOfPairs, KnowWhatIsReportedAndTheCyclesForIt) {
  EXPECT_DOUBLE_EQ(with_pairs(16).reported_share().value(), 0.25);
  EXPECT_GT(with_pairs(60).cycles_per_pair(engine_of_8).value(),
            with_pairs(0).cycles_per_pair(engine_of_8).value());
  EXPECT_FALSE(Rates().reported_share()) << "nothing was counted";
  EXPECT_FALSE(Rates().cycles_per_pair(engine_of_8));
}

TEST(RatesOfPairs, OfTwoDataSetsAreMixedOrThoseWithMoreReports) {
  const Rates a = with_pairs(16), b = with_pairs(60);
  const Rates mixed = a.mixed_with(b, 0.25);
  EXPECT_DOUBLE_EQ(mixed.reported_share().value(), 0.25 + 0.25 * (60.0 / 64 - 0.25));
  EXPECT_DOUBLE_EQ(mixed.cycles_per_pair(engine_of_8).value(),
                   0.75 * a.cycles_per_pair(engine_of_8).value() +
                       0.25 * b.cycles_per_pair(engine_of_8).value());
  EXPECT_FALSE(a.mixed_with(Rates(), 0.25).reported_share());
  for (Rates worst : {a, b, Rates()}) {
    worst.raise_to(b);
    EXPECT_DOUBLE_EQ(worst.reported_share().value(), 60.0 / 64);
    worst.raise_to(a);
    EXPECT_DOUBLE_EQ(worst.reported_share().value(), 60.0 / 64);
  }
}

TEST(RatesOfPairs, MayAssumeThatNothingIsReported) {
  Rates rates;
  rates.assume_nothing_reported({.items = 8, .others = 8});
  EXPECT_DOUBLE_EQ(rates.reported_share().value(), 0);
  EXPECT_EQ(rates.cycles_per_pair(engine_of_8), with_pairs(0).cycles_per_pair(engine_of_8));
}

/// 8.4 M pairs of spheres: twice the comparisons of a sample.
class MeasuredRates : public testing::Test {
protected:
  MeasuredRates() {
    for (auto& range : scene_.ranges) range = Range{0, 100};
  }

  data::Comparisons spheres(double radius_max) const {
    data::Table table =
        data::uniform_spheres({.count = 4097, .radius_max = radius_max}, scene_.reference.format);
    return data::Comparisons::all_pairs(std::move(table), scene_.graph.inputs()).value();
  }

  /// Rates of lanes in q10 and q11.
  std::vector<profile::RateProfile> rates_of(const data::Comparisons& data, bool samples) const {
    const optimise::OptimiseOptions choice{
        .first_precision = 10, .last_precision = 11, .bounds = {norm}, .samples_rates = samples};
    return measure_rates(scene_, data, {LaneInputs::exact, LaneInputs::rounded}, choice, {})
        .value();
  }

  static constexpr Bound norm{NumberSystem::fixed, BoundKind::norm};

private:
  scene::Scene scene_ = scene_of(sphere_graph(), format_of(53, 8), {format_of(8, 8)});
};

TEST_F(MeasuredRates, OfFewDigitsAreThoseOfASampleOfLargeData) {
  const data::Comparisons data = spheres(40);
  const auto counted = rates_of(data, true);
  ASSERT_EQ(counted.size(), 2u) << "lanes in fixed point are counted for one kind of inputs";
  EXPECT_EQ(counted[0].comparisons, data.size() / 2);
  EXPECT_EQ(counted[1].comparisons, data.size());
  const Rates rates = Rates::of(counted), all = Rates::of(rates_of(data, false));
  const RateKey ten{LaneInputs::exact, norm, 10}, eleven{LaneInputs::exact, norm, 11};
  EXPECT_NEAR(rates.find(ten)->value() / all.find(ten)->value(), 1, 0.02);
  EXPECT_EQ(rates.find(ten)->comparisons, data.size() / 2);
  EXPECT_EQ(rates.find(eleven)->undecided, all.find(eleven)->undecided);
  EXPECT_EQ(rates.reported_share(), all.reported_share());
}

/// Small spheres are rarely close.
TEST_F(MeasuredRates, OfRareRecomputationsAreThoseOfAllData) {
  const data::Comparisons data = spheres(1);
  const auto counted = rates_of(data, true);
  ASSERT_EQ(counted.size(), 1u);
  EXPECT_EQ(counted[0].comparisons, data.size());
  const RateKey ten{LaneInputs::exact, norm, 10};
  EXPECT_EQ(Rates::of(counted).find(ten)->undecided,
            Rates::of(rates_of(data, false)).find(ten)->undecided);
}

TEST_F(RatesFile, GivesWhatAProfileCounted) {
  const auto rates = read(std::string(header) + "exact,8,relative,1000,5,5e-3,0,0\n" +
                          "rounded,9,running_4,1000,7,7e-3,0,0\n" +
                          "exact,8,lanes_alone,1000,0,0,3,3\nexact,53,reference,1000,0,0,0,0\n");
  ASSERT_TRUE(rates.ok()) << rates.error().to_string();
  EXPECT_EQ(rates->keys().size(), 2u);
  EXPECT_EQ(rates->find({LaneInputs::rounded, {{}, BoundKind::running, 4}, 9})->undecided, 7u);
  EXPECT_FALSE(rates->find({LaneInputs::exact, {{}, BoundKind::running, 4}, 9}));
}

TEST_F(RatesFile, KnowsInputsByTheirDigits) {
  const auto rates = read(std::string(header) + "20,8,relative,1000,5,5e-3,0,0\n" +
                          "rounded,8,relative,1000,7,7e-3,0,0\n");
  ASSERT_TRUE(rates.ok()) << rates.error().to_string();
  const Bound relative;
  EXPECT_EQ(rates->find({LaneInputs::of_digits(20), relative, 8})->undecided, 5u);
  EXPECT_FALSE(rates->find({LaneInputs::of_digits(21), relative, 8}));
  expect_refused(std::string(header) + "2,8,relative,1000,5,5e-3,0,0\n", ":2: inputs");
}

TEST_F(RatesFile, RatesInFixedPointAreThoseOfAnyInputs) {
  const auto rates = read(std::string(header) + "20,8,fixed_norm,1000,5,5e-3,0,0\n");
  ASSERT_TRUE(rates.ok()) << rates.error().to_string();
  const Bound norm{NumberSystem::fixed, BoundKind::norm};
  EXPECT_EQ(rates->find({LaneInputs::exact, norm, 8})->undecided, 5u);
  EXPECT_EQ(rates->find({LaneInputs::rounded, norm, 8})->undecided, 5u);
  EXPECT_FALSE(rates->find({LaneInputs::exact, norm, 9}));
}

TEST_F(RatesFile, OtherFilesAreRefused) {
  expect_refused("a,b,c\n1,2,3\n", "not a table of recomputation rates");
}

TEST_F(RatesFile, TwoRowsForTheSameAreRefused) {
  const std::string row = "exact,8,relative,1000,5,5e-3,0,0\n";
  expect_refused(std::string(header) + row + "exact,9,relative,1000,0,0,0,0\n" + row,
                 ":4: a second row for the same");
}

TEST_F(RatesFile, AMistakeIsNamedByLineAndColumn) {
  expect_refused(std::string(header) + "exact,8,relative,1000,5,5e-3,0,0\nexact,x,relative,1,1\n",
                 ":3: precision");
  expect_refused(std::string(header) + "exact,8,relative,1000,1001,1,0,0\n", ":2: undecided");
  expect_refused(std::string(header) + "exact,8,relative,0,0,0,0,0\n", ":2: comparisons");
  expect_refused(std::string(header) + "both,8,relative,1,0,0,0,0\n", ":2: inputs");
}

}  // namespace
}  // namespace mixcmp::test::rates_test
