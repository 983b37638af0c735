#include <fmt/core.h>
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <random>
#include <vector>

#include "Vlogic_products.h"
#include "Vlogic_products___024root.h"

/// Tests products of logic of many widths against C++'s integers. Each cycle has one pair of
/// operands, and each product is expected in the very cycle that its mask of cuts names.
/// logic_products.v describes the slots.
namespace mixcmp::test::logic_products_test {
namespace {

constexpr int squares = 22, products = 36;

struct Operands {
  std::uint32_t a, b;  ///< each slot takes the lowest bits
};

std::int64_t low_signed(std::uint32_t bits, int width) {
  const std::int64_t value = bits & ((std::int64_t{1} << width) - 1);
  return value >> (width - 1) == 0 ? value : value - (std::int64_t{1} << width);
}

struct Slot {
  explicit Slot(int number)
      : square(number < squares),
        a_width(square ? number + 1 : 2 + (number - squares) / 6 * 3),
        b_width(square ? 1 : 1 + (number - squares) % 6 * 3),
        dropped(number % 3 == 2 && whole() > 3 ? 2 : 0),
        latency(std::popcount(static_cast<unsigned>(37 * number + number / 6) & 127)) {}

  int whole() const { return square ? 2 * a_width : a_width + b_width; }

  std::uint64_t expected(const Operands& operands) const {
    const std::int64_t a = low_signed(operands.a, a_width);
    const std::int64_t b = square ? a : low_signed(operands.b, b_width);
    const int width = whole() - dropped;
    return static_cast<std::uint64_t>(a * b >> dropped) & ((std::uint64_t{1} << width) - 1);
  }

  bool square;
  int a_width, b_width, dropped, latency;
};

class LogicProducts : public testing::Test {
protected:
  LogicProducts() : model_(&context_) {
    for (int slot = 0; slot < squares + products; ++slot) slots_.emplace_back(slot);
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
    const std::uint64_t got = model_.rootp->logic_products__DOT__results[number];
    if (got == slot.expected(operands)) return;
    FAIL() << fmt::format("slot {}, a = {:#x}, b = {:#x}: {:#x} instead of {:#x}", number,
                          operands.a, operands.b, got, slot.expected(operands));
  }

  VerilatedContext context_;
  Vlogic_products model_;
  std::vector<Slot> slots_;
  std::array<Operands, 8> history_ = {};
  std::size_t cycle_ = 0;
};

/// Computes every square of up to 13 bits, and every product of up to 5 by 7 and 8 by 4 bits.
TEST_F(LogicProducts, EveryOperandOfSmallWidths) {
  for (std::uint32_t number = 0; number < 1 << 13 && !HasFatalFailure(); ++number) {
    feed({number, number >> 5});
    feed({number, number >> 8});
  }
}

/// Operands with long runs of equal bits and single ones among them, since digits depend on their
/// neighbours.
TEST_F(LogicProducts, RandomOperands) {
  std::mt19937 random(1);
  const auto operand = [&] {
    const auto bits = static_cast<std::uint32_t>(random());
    const auto shift = random() % 32;
    switch (random() % 4) {
      case 0: return bits;
      case 1: return std::uint32_t{1} << shift;
      case 2: return ~std::uint32_t{0} << shift;
      default: return bits & bits << 1 & bits << 2;
    }
  };
  for (int k = 0; k < 20'000 && !HasFatalFailure(); ++k) {
    const std::uint32_t a = operand();
    feed({a, operand()});
  }
}

}  // namespace
}  // namespace mixcmp::test::logic_products_test
