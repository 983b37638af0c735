#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <random>

#include "Vcommon_cuts.h"
#include "Vcommon_cuts___024root.h"

/// Tests the units of common cuts at small widths against C++'s integers. Each cycle has one set of
/// integers, and each answer is expected in the very cycle that its masks of cuts name.
/// common_cuts.v describes the slots.
namespace mixcmp::test::common_cuts_test {
namespace {

constexpr int counts = 3, mosts = 5, width = 2;
constexpr int integer_bits = width + mosts + 1;

using Integers = std::array<int, counts>;

/// The integer that the low bits of `bits` are in two's complement.
int from_low_bits(int bits, int count) {
  const int low = bits & ((1 << count) - 1);
  return low >= 1 << (count - 1) ? low - (1 << count) : low;
}

/// The integers as a slot of this `most` reads them.
Integers read_by(const Integers& integers, int most) {
  Integers read = integers;
  for (int& integer : read) integer = from_low_bits(integer, width + most + 1);
  return read;
}

/// The least k with which the first `count` integers, without k low bits, are -2^width or more and
/// less than 2^width.
int drop_of(const Integers& integers, int count) {
  int dropped = 0;
  const auto fits = [&](int integer) {
    return integer >> dropped >= -(1 << width) && integer >> dropped < 1 << width;
  };
  while (!std::all_of(integers.begin(), integers.begin() + count, fits)) ++dropped;
  return dropped;
}

class CommonCuts : public testing::Test {
protected:
  CommonCuts() : units_(&context_) {
    units_.aclk = 0;
    units_.eval();
  }

  void TearDown() override {
    for (int k = 0; k < 4; ++k) feed({});
    EXPECT_GT(checked_, 0);
  }

  void feed(const Integers& integers) {
    std::uint32_t bits = 0;
    for (int k = 0; k < counts; ++k) {
      const auto low = static_cast<std::uint32_t>(integers[k]) & ((1u << integer_bits) - 1);
      bits |= low << (k * integer_bits);
    }
    units_.integers = bits;
    units_.aclk = 0;
    units_.eval();
    history_[cycle_ % history_.size()] = integers;
    for (int slot = 0; slot < counts * mosts && !HasFailure(); ++slot) compare(slot);
    units_.aclk = 1;
    units_.eval();
    ++cycle_;
  }

private:
  static std::uint64_t answer(int cut) {
    return static_cast<std::uint64_t>(cut & ((2 << width) - 1));
  }

  void compare(int slot) {
    const int count = 1 + slot / mosts, most = 1 + slot % mosts;
    const auto drop_cycles = static_cast<std::size_t>(std::popcount(slot % 4u));
    const std::size_t cut_cycles = drop_cycles + slot / 4 % 2;
    if (cycle_ < cut_cycles) return;
    ++checked_;
    const Integers of_drop = read_by(history_[(cycle_ - drop_cycles) % history_.size()], most);
    EXPECT_EQ(units_.rootp->common_cuts__DOT__drops[slot],
              static_cast<std::uint64_t>(drop_of(of_drop, count)))
        << "slot " << slot << ", first integer " << of_drop[0];
    const Integers of_cut = read_by(history_[(cycle_ - cut_cycles) % history_.size()], most);
    const int dropped = drop_of(of_cut, count), narrow = from_low_bits(of_cut[0], width + 1);
    EXPECT_EQ(units_.rootp->common_cuts__DOT__cut[slot], answer(of_cut[0] >> dropped))
        << "slot " << slot << ", first integer " << of_cut[0];
    EXPECT_EQ(units_.rootp->common_cuts__DOT__narrow_cut[slot], answer(narrow >> dropped))
        << "slot " << slot << ", first integer " << of_cut[0];
  }

  VerilatedContext context_;
  Vcommon_cuts units_;
  std::array<Integers, 8> history_ = {};
  std::size_t cycle_ = 0;
  long checked_ = 0;
};

TEST_F(CommonCuts, OfEveryPairOfIntegers) {
  for (int first = 0; first < 1 << integer_bits; ++first) {
    for (int second = 0; second < 1 << integer_bits; ++second) feed({first, second, second >> 3});
  }
}

TEST_F(CommonCuts, OfThreeIntegersOfAnyMagnitudes) {
  std::mt19937 random(1);
  for (int k = 0; k < 20'000; ++k) {
    Integers integers;
    for (int& integer : integers) {
      const int digits = static_cast<int>(random() % integer_bits);
      integer = static_cast<int>(random() % (1u << digits));
      if (random() % 2 == 0) integer = -integer - 1;
    }
    feed(integers);
  }
}

}  // namespace
}  // namespace mixcmp::test::common_cuts_test
