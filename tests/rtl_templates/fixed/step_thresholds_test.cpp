#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <random>

#include "Vstep_thresholds.h"
#include "Vstep_thresholds___024root.h"

/// Tests the thresholds of running bounds at small widths against C++'s integers. Each cycle has
/// one set of integers, and each answer is expected in the very cycle that its mask of cuts names.
/// step_thresholds.v describes the slots.
namespace mixcmp::test::step_thresholds_test {
namespace {

constexpr int counts = 3, lasts = 7, kept = 1, width = 12;
constexpr int integer_bits = kept + lasts + 1;

using Integers = std::array<int, counts>;

/// The integer that the low bits of `bits` are in two's complement.
int from_low_bits(int bits, int count) {
  const int low = bits & ((1 << count) - 1);
  return low >= 1 << (count - 1) ? low - (1 << count) : low;
}

/// The integers as a slot of this `last` reads them.
Integers read_by(const Integers& integers, int last) {
  Integers read = integers;
  for (int& integer : read) integer = from_low_bits(integer, kept + last + 1);
  return read;
}

/// The least k >= 0 with -2^(kept + k) <= n < 2^(kept + k) for the first `count` integers n.
int step_of(const Integers& integers, int count) {
  int step = 0;
  const auto fits = [&](int integer) {
    const int power = 1 << (kept + step);
    return -power <= integer && integer < power;
  };
  while (!std::all_of(integers.begin(), integers.begin() + count, fits)) ++step;
  return step;
}

std::uint64_t threshold_of(int slot, int step) {
  return static_cast<std::uint64_t>(101 * (8 * slot + step)) % (1u << width);
}

class StepThresholds : public testing::Test {
protected:
  StepThresholds() : units_(&context_) {
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
    for (int slot = 0; slot < counts * lasts && !HasFailure(); ++slot) compare(slot);
    units_.aclk = 1;
    units_.eval();
    ++cycle_;
  }

private:
  void compare(int slot) {
    const int count = 1 + slot / lasts, last = 1 + slot % lasts;
    const auto cycles = static_cast<std::size_t>(std::popcount(slot % 8u));
    if (cycle_ < cycles) return;
    ++checked_;
    const Integers read = read_by(history_[(cycle_ - cycles) % history_.size()], last);
    const int step = step_of(read, count);
    EXPECT_EQ(units_.rootp->step_thresholds__DOT__thresholds[slot], threshold_of(slot, step))
        << "slot " << slot << ", step " << step << ", the first " << count << " of "
        << testing::PrintToString(read);
  }

  VerilatedContext context_;
  Vstep_thresholds units_;
  std::array<Integers, 8> history_ = {};
  std::size_t cycle_ = 0;
  long checked_ = 0;
};

TEST_F(StepThresholds, OfEveryPairOfIntegers) {
  for (int first = 0; first < 1 << integer_bits; ++first) {
    for (int second = 0; second < 1 << integer_bits; ++second) feed({first, second, second >> 3});
  }
}

TEST_F(StepThresholds, OfThreeIntegersOfAnyMagnitudes) {
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
}  // namespace mixcmp::test::step_thresholds_test
