#include "verilator_tb/expected_words.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <random>

#include "tests/support/mixed_spheres.hpp"
#include "verilator_tb/judgement.hpp"

/// The emulator's words are those of the golden model, comparison by comparison.
namespace mixcmp::test::expected_words_test {
namespace {

/// Lanes of all number systems; three references of two makes.
design::Design every_kind_of_lane() {
  design::Design design = mixed_sphere_design();
  design.lanes.push_back({.lane = fixed_spheres({.bits = 9}, format("s24e8")), .count = 2});
  design.lanes.push_back(
      {.lane = fixed_spheres({.bits = 7, .is_block = true}, format("s24e8")), .count = 1});
  return design;
}

/// Spheres of radii such that many pairs nearly touch; a few have coordinates out of the ranges,
/// negative radii, infinities and NaNs.
data::Comparisons spheres(std::size_t count) {
  data::Table table{.format = format("s24e8"), .columns = {"cx", "cy", "cz", "r"}};
  std::mt19937_64 random(5);
  std::uniform_real_distribution<float> coordinate(0, 100), radius(20, 35);
  const FloatFormat& single = table.format;
  const Bits odd[] = {0x42c80001, 0xc0000000, single.infinity(false), single.quiet_nan(), 1, 0};
  for (std::size_t k = 0; k < count; ++k) {
    for (int column = 0; column < 4; ++column) {
      const float value = column < 3 ? coordinate(random) : radius(random);
      const bool is_odd = random() % 64 == 0;
      table.values.push_back(is_odd ? odd[random() % std::size(odd)]
                                    : Bits{std::bit_cast<std::uint32_t>(value)});
    }
  }
  return data::Comparisons::all_pairs(table, sphere_graph().inputs()).value();
}

void expect_words_of_golden_model(const design::Design& design) {
  const data::Comparisons comparisons = spheres(90);
  std::vector<std::uint64_t> indices(comparisons.size());
  for (std::size_t k = 0; k < indices.size(); ++k) indices[k] = k;
  std::shuffle(indices.begin(), indices.end(), std::mt19937_64(1));
  const verilator_tb::ExpectedWords expected(design, comparisons);
  std::vector<Bits> operands(comparisons.input_count());
  for (std::size_t group = 0; group < design.lanes.size(); ++group) {
    ASSERT_TRUE(expected.emulates(group));
    const std::vector<ResultWord> words = expected.find(group, indices);
    int decided = 0, others = 0;
    for (std::size_t k = 0; k < indices.size(); ++k) {
      comparisons.fetch(indices[k], operands);
      ASSERT_EQ(words[k], verilator_tb::expected_word(design, group, operands))
          << "group " << group << ", comparison " << indices[k];
      ++(words[k].is_decided_by_lane() ? decided : others);
    }
    EXPECT_GT(decided, 100) << "group " << group;
    EXPECT_GT(others, 100) << "group " << group;
  }
}

TEST(ExpectedWords, AreThoseOfTheGoldenModel) {
  expect_words_of_golden_model(every_kind_of_lane());
}

TEST(ExpectedWords, OfTwoTiersAreThoseOfTheGoldenModel) {
  design::Design design = every_kind_of_lane();
  design.second_tier = {.lane = fixed_spheres({.bits = 11}, format("s24e8"))};
  expect_words_of_golden_model(design);
  design.system.engine.kind = scene::EngineKind::pairwise;
  expect_words_of_golden_model(design);
}

TEST(ExpectedWords, OfASecondTierSayWhetherItsAnswerCameThroughACrossbar) {
  design::Design design = sphere_design(format("s5e8"), format("s24e8"), 1, 1);
  design.second_tier = {.lane = fixed_spheres({.bits = 24}, format("s24e8"))};
  const std::vector<Bits> far_apart_in_24_bits = {
      Bits{0x42480000}, Bits{0x424c0000},  // cx: 50 and 51, and the sum of radii is 0.99
      Bits{0x42480000}, Bits{0x42480000}, Bits{0x42480000},
      Bits{0x42480000}, Bits{0x3f000000}, Bits{0x3efae148}};
  const auto word = [&] { return verilator_tb::expected_word(design, 0, far_apart_in_24_bits); };
  EXPECT_EQ(word(), ResultWord::recomputed(Verdict::greater));
  design.system.engine.kind = scene::EngineKind::pairwise;
  EXPECT_EQ(word(), ResultWord::decided(Verdict::greater));
}

TEST(ExpectedWords, OfASecondTierTooWideFor128BitsAreLeftToTheGoldenModel) {
  design::Design design = every_kind_of_lane();
  const data::Comparisons comparisons = spheres(3);
  design.second_tier = {.lane = fixed_spheres({.bits = 40}, format("s24e8"))};
  EXPECT_TRUE(verilator_tb::ExpectedWords(design, comparisons).emulates(0));
  design.second_tier = {.lane = fixed_spheres({.bits = 70}, format("s24e8"))};
  EXPECT_FALSE(verilator_tb::ExpectedWords(design, comparisons).emulates(0));
}

TEST(ExpectedWords, OfIntegersTooWideFor128BitsAreLeftToTheGoldenModel) {
  design::Design design = mixed_sphere_design();
  design.lanes.push_back({.lane = fixed_spheres({.bits = 70}, format("s24e8")), .count = 1});
  const data::Comparisons comparisons = spheres(3);
  const verilator_tb::ExpectedWords expected(design, comparisons);
  EXPECT_TRUE(expected.emulates(0));
  EXPECT_FALSE(expected.emulates(design.lanes.size() - 1));
}

TEST(ExpectedWords, AreUndecidedWithoutReferences) {
  design::Design design = every_kind_of_lane();
  design.references.clear();
  expect_words_of_golden_model(design);
}

}  // namespace
}  // namespace mixcmp::test::expected_words_test
