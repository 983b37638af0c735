#include <fmt/core.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include "Vmemory_squares.h"
#include "Vmemory_squares___024root.h"

/// Tests squares of many widths, read from memories, against C++'s integers. Each cycle has one
/// pair of operands, and each square is expected in the very cycle that its mask of cuts names.
/// memory_squares.v describes the slots.
namespace mixcmp::test::memory_squares_test {
namespace {

constexpr int singles = 14, pairs = 24;

/// One result of a slot: the square of the operand's low bits.
struct Square {
  int width = 0;  ///< the operand's; 0: there is no such result
  int dropped = 0;
  int missing = 0;  ///< high bits of the whole square that are left out

  static Square make(int width, int dropped, int missing) {
    return {width, dropped < 2 * width - 2 ? dropped : 0, missing};
  }

  std::uint32_t expected(std::uint32_t operand) const {
    const std::int64_t bits = operand & ((std::int64_t{1} << width) - 1);
    const std::int64_t x = bits >> (width - 1) == 0 ? bits : bits - (std::int64_t{1} << width);
    const int kept = 2 * width - dropped - missing;
    return static_cast<std::uint32_t>(x * x >> dropped & ((std::int64_t{1} << kept) - 1));
  }
};

struct Slot {
  explicit Slot(int number) {
    const int pair = number - singles;
    if (pair < 0) {
      a = Square::make(number == 13 ? 15 : number + 1, number % 6, number % 2);
      latency = 1 + number % 2 + number / 2 % 2;
    } else {
      a = Square::make(pair / 4 * 2 + 1 + number % 2, number % 6, number % 2);
      b = Square::make(pair % 4 * 4 + 1, number % 5, number / 4 % 2);
      latency = 1 + (number % 3 == 1) + number / 2 % 2;
    }
  }

  Square a, b;
  int latency;
};

struct Operands {
  std::uint32_t a, b;  ///< each slot takes the lowest bits
};

class MemorySquares : public testing::Test {
protected:
  MemorySquares() : model_(&context_) {
    for (int slot = 0; slot < singles + pairs; ++slot) slots_.emplace_back(slot);
  }

  void feed(const Operands& operands) {
    model_.a = operands.a;
    model_.b = operands.b;
    model_.aclk = 0;
    model_.eval();
    history_[cycle_ % history_.size()] = operands;
    for (std::size_t slot = 0; slot < slots_.size(); ++slot) compare(slot);
    model_.aclk = 1;
    model_.eval();
    ++cycle_;
  }

private:
  void compare(std::size_t number) {
    const Slot& slot = slots_[number];
    if (cycle_ < static_cast<std::size_t>(slot.latency)) return;
    const Operands& operands = history_[(cycle_ - slot.latency) % history_.size()];
    compare(number, number, slot.a, operands.a);
    compare(number, number + slots_.size(), slot.b, operands.b);
  }

  void compare(std::size_t slot, std::size_t result, const Square& square, std::uint32_t operand) {
    if (square.width == 0) return;
    const std::uint32_t got = model_.rootp->memory_squares__DOT__results[result];
    if (got == square.expected(operand)) return;
    FAIL() << fmt::format("slot {}, {} bits of {:#x}: {:#x} instead of {:#x}", slot, square.width,
                          operand, got, square.expected(operand));
  }

  VerilatedContext context_;
  Vmemory_squares model_;
  std::vector<Slot> slots_;
  std::array<Operands, 4> history_ = {};
  std::size_t cycle_ = 0;
};

/// Squares every operand of every slot. The ports read different words: one in order, one from the
/// end.
TEST_F(MemorySquares, EveryOperand) {
  for (std::uint32_t number = 0; number < 1 << 15 && !HasFatalFailure(); ++number) {
    feed({number, ~number});
  }
}

/// Operands of neighbouring cycles are unrelated, so a word that comes a cycle too early or too
/// late is wrong.
TEST_F(MemorySquares, RandomOperands) {
  std::mt19937 random(1);
  for (int k = 0; k < 20'000 && !HasFatalFailure(); ++k) {
    const auto a = static_cast<std::uint32_t>(random());
    feed({a, static_cast<std::uint32_t>(random())});
  }
}

}  // namespace
}  // namespace mixcmp::test::memory_squares_test
