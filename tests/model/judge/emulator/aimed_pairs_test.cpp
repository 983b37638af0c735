#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "model/judge/emulator/emulator.hpp"
#include "tests/support/sphere.hpp"

/// Tests lanes in fixed point on millions of pairs of spheres that nearly touch. They are closer to
/// a tie than a lane can see, or just beyond. Every decided verdict must be the truth, which 64-bit
/// integers compute.
namespace mixcmp::test::aimed_pairs_test {
namespace {

using emulator::Emulator;

/// Coordinates and radii below 100 in steps of 2^-16: 23 bits. A lane sees the first W of them.
constexpr int step_bits = 16;
constexpr std::int64_t largest = 100 << step_bits;
constexpr std::size_t block = 4096;

class AimedPairs {
public:
  explicit AimedPairs(int bits)
      : reach_(24.0 * std::ldexp(1, 7 - bits + step_bits)), random_(bits) {
    for (std::size_t k = 0; k < columns_.size(); ++k) pointers_.push_back(columns_[k].data());
  }

  void next() {
    for (std::size_t k = 0; k < block; ++k) make(k);
  }

  emulator::OperandColumns operands() const { return pointers_; }
  Decision truth(std::size_t k) const { return truth_[k]; }

private:
  std::int64_t below(std::int64_t end) {
    return static_cast<std::int64_t>(random_() % static_cast<std::uint64_t>(end));
  }

  /// Makes radii whose sum differs from the centres' distance by at most `reach_` steps.
  void make(std::size_t k) {
    std::int64_t f = 0;
    for (std::size_t axis = 0; axis < 6; axis += 2) {
      const std::int64_t a = below(largest), b = below(largest);
      f += (a - b) * (a - b);
      put(axis, k, a);
      put(axis + 1, k, b);
    }
    const double aimed = std::sqrt(static_cast<double>(f)) +
                         reach_ * (static_cast<double>(random_() >> 11) * 0x1p-52 - 1);
    const auto sum = std::clamp(static_cast<std::int64_t>(aimed), std::int64_t{0}, 2 * largest - 2);
    const std::int64_t least = std::max(std::int64_t{0}, sum - largest + 1);
    const std::int64_t first = least + below(sum - 2 * least + 1);
    put(6, k, first);
    put(7, k, sum - first);
    const std::int64_t g = sum * sum;
    truth_[k] = f < g ? Decision::less : f > g ? Decision::greater : Decision::equal;
  }

  void put(std::size_t operand, std::size_t k, std::int64_t steps) {
    columns_[operand][k] = std::ldexp(static_cast<double>(steps), -step_bits);
  }

  double reach_;  ///< 24 units of the lane
  std::mt19937_64 random_;
  std::array<std::array<double, block>, 8> columns_;
  std::vector<const double*> pointers_;
  std::array<Decision, block> truth_;
};

class AimedAt : public testing::TestWithParam<int> {};

TEST_P(AimedAt, NoVerdictIsWrong) {
  const std::vector<std::optional<Range>> ranges(8, Range{0, 100});
  const Emulator lane(
      fixed::fixed_lane(sphere_graph(), format("s53e8"),
                        {.format = {GetParam()}, .bound = BoundKind::norm, .ranges = ranges})
          .value());
  AimedPairs pairs(GetParam());
  std::vector<Decision> decisions(block);
  std::uint64_t undecided = 0, all = 0;
  for (; all < MIXCMP_AIMED_PAIRS; all += block) {
    pairs.next();
    lane.decide(pairs.operands(), block, decisions);
    for (std::size_t k = 0; k < block; ++k) {
      undecided += decisions[k] == Decision::undecided ? 1 : 0;
      if (decisions[k] == Decision::undecided || decisions[k] == pairs.truth(k)) continue;
      FAIL() << "pair " << all + k;
    }
  }
  EXPECT_GT(undecided, all / 20);
  EXPECT_LT(undecided, all - all / 20);
  EXPECT_EQ(lane.fallbacks(), 0u);
}

INSTANTIATE_TEST_SUITE_P(Bits, AimedAt, testing::Values(7, 9, 11, 13, 15, 17, 19, 21));

}  // namespace
}  // namespace mixcmp::test::aimed_pairs_test
