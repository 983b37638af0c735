#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <random>

#include "Vblock_units.h"
#include "Vblock_units___024root.h"

/// Tests the units of block floating point at small widths against C++'s integers. Each cycle has
/// one set of operands, and each answer is expected in the very cycle that its mask of cuts names.
/// block_units.v describes the slots.
namespace mixcmp::test::block_units_test {
namespace {

constexpr int counts = 9, widths = 6;
constexpr int exponent_bits = 3, fraction_bits = 3;
constexpr std::uint32_t most = 7;  ///< the exponent of infinities and NaNs

struct Operands {
  std::uint32_t exponents = 0;  ///< the first in the lowest bits
  std::uint32_t x = 0;
  std::uint32_t largest = 1;
};

/// The answer {not_finite, largest} for the first `count` exponents.
std::uint64_t maximum(const Operands& operands, int count) {
  std::uint32_t largest = 1;
  for (int k = 0; k < count; ++k) {
    largest = std::max(largest, operands.exponents >> (exponent_bits * k) & most);
  }
  return (largest == most ? 8u : 0u) | largest;
}

/// The magnitude in units of 2^(E+1-width), with all bits inverted if the sign bit is set.
std::uint64_t integer(const Operands& operands, int width, bool is_signed) {
  const std::uint32_t exponent = operands.x >> fraction_bits & most;
  const std::uint32_t fraction = operands.x & 7;
  const std::uint32_t significand = exponent == 0 ? fraction : fraction | 8;
  const std::uint32_t below = operands.largest - std::max(exponent, 1u);
  const std::uint32_t magnitude = (significand << width) >> (fraction_bits + 1 + below);
  const bool negative = operands.x >> 6 != 0;
  if (!is_signed) return magnitude;
  return (negative ? ~magnitude : magnitude) & ((2u << width) - 1);
}

class BlockUnits : public testing::Test {
protected:
  BlockUnits() : units_(&context_) {
    units_.aclk = 0;
    units_.eval();
  }

  void TearDown() override {
    for (int k = 0; k < 4; ++k) feed({});
    EXPECT_GT(checked_, 0);
  }

  void feed(const Operands& operands) {
    units_.exponents = operands.exponents;
    units_.x = operands.x;
    units_.largest = operands.largest;
    units_.aclk = 0;
    units_.eval();
    history_[cycle_ % history_.size()] = operands;
    for (int slot = 0; slot < counts && !HasFailure(); ++slot) {
      compare(maximum(then(slot), slot + 1), units_.rootp->block_units__DOT__maxima[slot], slot,
              slot);
    }
    for (int slot = 0; slot < 2 * widths && !HasFailure(); ++slot) {
      const int cuts = slot / 2 % 4;
      compare(integer(then(cuts), 1 + slot / 2, slot % 2 == 1),
              units_.rootp->block_units__DOT__integers[slot], cuts, slot);
    }
    units_.aclk = 1;
    units_.eval();
    ++cycle_;
  }

private:
  static std::size_t latency(int cuts) {
    return static_cast<std::size_t>(std::popcount(static_cast<unsigned>(cuts)));
  }
  const Operands& then(int cuts) const {
    return history_[(cycle_ - latency(cuts)) % history_.size()];
  }

  void compare(std::uint64_t expected, std::uint64_t got, int cuts, int slot) {
    if (cycle_ < latency(cuts)) return;
    ++checked_;
    const Operands& operands = then(cuts);
    EXPECT_EQ(got, expected) << "slot " << slot << ", exponents " << operands.exponents << ", x "
                             << operands.x << ", largest " << operands.largest;
  }

  VerilatedContext context_;
  Vblock_units units_;
  std::array<Operands, 8> history_ = {};
  std::size_t cycle_ = 0;
  long checked_ = 0;
};

TEST_F(BlockUnits, FindTheLargestOfAnyThreeExponents) {
  for (std::uint32_t exponents = 0; exponents < 512; ++exponents) feed({.exponents = exponents});
}

TEST_F(BlockUnits, FindTheLargestWhereverItStands) {
  std::mt19937 random(1);
  for (int k = 0; k < 20'000; ++k) {
    Operands operands;
    const std::uint32_t top = random() % (most + 1);
    for (int operand = 0; operand < counts; ++operand) {
      operands.exponents |= random() % (top + 1) << (exponent_bits * operand);
    }
    feed(operands);
  }
}

/// Aligns every operand to every largest exponent that is not below its own.
TEST_F(BlockUnits, AlignEveryOperand) {
  for (std::uint32_t largest = 1; largest < most; ++largest) {
    for (std::uint32_t x = 0; x < 128; ++x) {
      if ((x >> fraction_bits & most) <= largest) feed({.x = x, .largest = largest});
    }
  }
}

}  // namespace
}  // namespace mixcmp::test::block_units_test
