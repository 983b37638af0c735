#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include "Vfixed_units.h"
#include "Vfixed_units___024root.h"

/// Tests every unit of fixed point at small widths on every operand against C++'s integers. Each
/// cycle has one pair of operands, and each answer is expected in the very cycle that its mask of
/// cuts names. fixed_units.v describes the slots.
namespace mixcmp::test::fixed_units_test {
namespace {

constexpr int widths = 5, kinds = 13, decisions = 96, checks = 80, overflows = 36, tables = 40,
              floatings = 24;
constexpr int slots = kinds * widths * widths * 4;

struct Operands {
  int a, b;  ///< each slot takes the lowest bits
  bool flag;
};

/// The lowest bits of a number, without a sign.
int low(int bits, int width) {
  return bits & ((1 << width) - 1);
}

/// The lowest bits of a number, in two's complement.
int low_signed(int bits, int width) {
  const int value = low(bits, width);
  return value >> (width - 1) == 0 ? value : value - (1 << width);
}

struct Slot {
  explicit Slot(int number)
      : kind(number / (4 * widths * widths)),
        a_width(1 + number / (4 * widths) % widths),
        b_width(1 + number / 4 % widths),
        dropped(whole() > 1 ? number % 2 : 0),
        width(std::max(1, whole() - dropped - number / 2 % 2)),
        cuts((number + number / 4) % 4) {}

  int whole() const {
    switch (kind) {
      case 2: return a_width + b_width;
      case 3: return 2 * a_width;
      case 6: return a_width;
      case 7: return a_width + b_width + 2;
      case 8: return 2 * a_width + 2;
      case 9:
      case 10: return a_width + b_width + 1;
      case 11: return std::max(a_width, b_width + 2) + 1;
      case 12: return std::max(a_width, b_width + 3) + 1;
      default: return std::max(a_width, b_width) + 1;
    }
  }

  int latency() const {
    const bool one_stage = kind < 2 || kind == 6 || kind > 10;
    return std::popcount(static_cast<unsigned>(one_stage ? cuts % 2 : cuts));
  }

  std::uint64_t expected(const Operands& operands) const {
    const int a = low_signed(operands.a, a_width), b = low_signed(operands.b, b_width);
    const int a_positive = low(operands.a, a_width), b_positive = low(operands.b, b_width);
    const std::array results = {a + b,
                                a - b,
                                a * b,
                                a * a,
                                std::min(a, b),
                                std::max(a, b),
                                std::abs(a),
                                a_positive * b_positive,
                                a_positive * a_positive,
                                a_positive * b,
                                a * b_positive,
                                a + b * 4,
                                a - b * 8};
    return static_cast<std::uint64_t>(results[kind] >> dropped) & ((1u << width) - 1);
  }

  int kind, a_width, b_width, dropped, width, cuts;
};

/// The answer {verdict, decided}. The verdict bits have their value even if the comparison is
/// undecided.
std::uint64_t answer(bool greater, bool equal, bool decided) {
  return (greater ? 4u : 0u) | (equal ? 2u : 0u) | (decided ? 1u : 0u);
}

std::uint64_t constant_decision(int slot, const Operands& operands) {
  const int difference = low_signed(operands.a, 5);
  const int less_to = slot % 16 - 13, greater_from = slot % 16 - 12 + slot / 16;
  const bool exact = slot / 2 % 3 > 0, unordered = slot / 2 % 3 == 2 && operands.flag;
  const bool greater = difference >= greater_from, less = difference <= less_to;
  return answer(greater || unordered, (exact && !greater && !less) || unordered,
                (greater || less || exact) && !operands.flag);
}

/// 2^k for the least k with square < 4^k.
int power_above_root(int square) {
  int power = 1;
  while (square >= power * power) power *= 2;
  return power;
}

std::uint64_t norm_decision(int slot, const Operands& operands) {
  const int difference = low_signed(operands.a, 6);
  const bool root = slot % 5 == 4;
  const int radius = root ? power_above_root(operands.b) : operands.b & 7;
  const bool far = !root && (operands.b & 8) != 0;
  const bool greater = far || difference >= (radius << slot % 3) + slot / 3 % 8;
  const bool less = !far && difference < -(radius << slot / 24 % 3);
  const bool swapped = slot / 2 % 2 == 1;
  return answer(swapped ? less : greater, false, (greater || less) && !operands.flag);
}

std::uint64_t out_of_range(int slot, const Operands& operands) {
  const int value = low_signed(operands.a, 4);
  const int least = slot / 5 - 8, greatest = least + (slot % 5) * (slot % 5);
  return value < least || value > greatest ? 1 : 0;
}

std::uint64_t overflow(int slot, const Operands& operands) {
  const int width = 1 + slot / 6, narrower = 1 + slot % 6;
  if (narrower >= width) return 0;
  return low_signed(operands.a, width) != low_signed(operands.a, narrower) ? 1 : 0;
}

/// A table's words are consecutive bits of a pattern of 127 bits that repeats itself.
std::uint64_t table_word(int slot, const Operands& operands) {
  constexpr std::uint64_t high = 0x5a3c91d7e04f2b68, low = 0xc6f17a950d3e8b24;
  constexpr std::array address_bits = {1, 2, 6, 7, 10};
  constexpr std::array word_bits = {1, 7, 24, 43};
  const int address = (operands.b << 6 | operands.a) & ((1 << address_bits[slot / 8]) - 1);
  const int width = word_bits[slot / 2 % 4];
  std::uint64_t word = 0;
  for (int k = 0; k < width; ++k) {
    const int bit = (address * width + k) % 127;
    word |= (bit < 64 ? low >> bit & 1 : high >> (bit - 64) & 1) << k;
  }
  return word;
}

/// The exponent field and the fraction. A field of ones stands for the highest bit.
std::uint64_t floating_code(int slot, const Operands& operands) {
  constexpr std::array widths_of_numbers = {2, 3, 5, 8, 9, 11};
  const int width = widths_of_numbers[slot / 4];
  const auto ones = std::bit_ceil(static_cast<unsigned>(width)) - 1;
  auto number = static_cast<unsigned>(operands.b << 6 | operands.a) & ((1U << width) - 1);
  unsigned zeros = 0;
  while (zeros < ones && zeros < static_cast<unsigned>(width) && (number >> (width - 1)) == 0) {
    number = number << 1 & ((1U << width) - 1);
    ++zeros;
  }
  const unsigned fraction = number & ((1U << (width - 1)) - 1);
  return std::uint64_t{ones - zeros} << (width - 1) | fraction;
}

class FixedUnits : public testing::Test {
protected:
  FixedUnits() : units_(&context_) {
    units_.aclk = 0;
    units_.eval();
  }

  void feed(const Operands& operands) {
    units_.a = static_cast<std::uint8_t>(operands.a);
    units_.b = static_cast<std::uint8_t>(operands.b);
    units_.flag = operands.flag;
    units_.aclk = 0;
    units_.eval();
    history_[cycle_ % history_.size()] = operands;
    compare_all();
    units_.aclk = 1;
    units_.eval();
    ++cycle_;
  }

private:
  void compare_all() {
    for (int slot = 0; slot < slots; ++slot) {
      const Slot unit(slot);
      compare(
          units_.rootp->fixed_units__DOT__results[slot], unit.latency(),
          [&](const Operands& operands) { return unit.expected(operands); }, "unit", slot);
    }
    for (int slot = 0; slot < decisions; ++slot) {
      compare(
          units_.rootp->fixed_units__DOT__decisions[slot], slot % 2,
          [&](const Operands& operands) { return constant_decision(slot, operands); },
          "decision by constants", slot);
      compare(
          units_.rootp->fixed_units__DOT__decisions[decisions + slot],
          std::popcount(static_cast<unsigned>(slot % 8)),
          [&](const Operands& operands) { return norm_decision(slot, operands); },
          "decision by a norm", slot);
    }
    for (int slot = 0; slot < checks; ++slot) {
      compare(
          units_.rootp->fixed_units__DOT__checks[slot], slot % 2,
          [&](const Operands& operands) { return out_of_range(slot, operands); }, "check", slot);
    }
    for (int slot = 0; slot < overflows; ++slot) {
      const bool is_wires = slot % 6 >= slot / 6;
      compare(
          units_.rootp->fixed_units__DOT__overflows[slot], is_wires ? 0 : slot % 2,
          [&](const Operands& operands) { return overflow(slot, operands); }, "overflow", slot);
    }
    for (int slot = 0; slot < tables; ++slot) {
      compare(
          units_.rootp->fixed_units__DOT__tables[slot], slot % 2,
          [&](const Operands& operands) { return table_word(slot, operands); }, "table", slot);
    }
    for (int slot = 0; slot < floatings; ++slot) {
      compare(
          units_.rootp->fixed_units__DOT__floatings[slot], slot % 2 + slot / 2 % 2,
          [&](const Operands& operands) { return floating_code(slot, operands); }, "floating",
          slot);
    }
  }

  template <class Expected>
  void compare(std::uint64_t got, int latency, const Expected& expected, const char* what,
               int slot) {
    if (cycle_ < static_cast<std::size_t>(latency)) return;
    const Operands& operands = history_[(cycle_ - latency) % history_.size()];
    if (got == expected(operands)) return;
    FAIL() << fmt::format("{} {}, a = {:#x}, b = {:#x}, flag {}: {:#x} instead of {:#x}", what,
                          slot, operands.a, operands.b, operands.flag, got, expected(operands));
  }

  VerilatedContext context_;
  Vfixed_units units_;
  std::array<Operands, 5> history_ = {};
  std::size_t cycle_ = 0;
};

TEST_F(FixedUnits, EveryOperand) {
  for (int number = 0; number < 1 << 12 && !HasFatalFailure(); ++number) {
    feed({number & 63, number >> 6 & 31, number >> 11 == 1});
  }
}

}  // namespace
}  // namespace mixcmp::test::fixed_units_test
