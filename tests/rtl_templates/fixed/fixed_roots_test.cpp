#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

#include "Vfixed_roots.h"
#include "Vfixed_roots___024root.h"

/// Tests fixed_square_root on every operand of small widths. Each cycle has one operand, and each
/// answer is expected in the very cycle that its mask of cuts names. fixed_roots.v describes the
/// slots.
namespace mixcmp::test::fixed_roots_test {
namespace {

constexpr int widths = 9, shifts = 9;
constexpr int slots = widths * shifts * 4;

struct Slot {
  explicit Slot(int number)
      : a_width(1 + number / (4 * shifts)),
        shift(std::max(number / 4 % shifts - 4, 1 - a_width)),
        width((a_width + shift + 1) / 2 + number / 2 % 2),
        cuts(static_cast<unsigned>(number * 7 + number / 8) & ((1u << width) - 1)) {}

  std::uint64_t expected(int bits) const {
    const int a = bits & ((1 << a_width) - 1);
    const int radicand = shift < 0 ? a >> -shift : a << shift;
    int root = 0;
    while ((root + 1) * (root + 1) <= radicand) ++root;
    return static_cast<std::uint64_t>(root);
  }

  int a_width, shift, width;
  unsigned cuts;
};

TEST(FixedSquareRoot, IsTheRootRoundedDown) {
  VerilatedContext context;
  Vfixed_roots units(&context);
  constexpr int operands = 1 << widths, longest = 8;
  const auto operand = [](int cycle) { return cycle * 37 % operands; };  // neighbours differ
  for (int cycle = 0; cycle < operands + longest; ++cycle) {
    units.a = static_cast<std::uint16_t>(operand(cycle));
    units.aclk = 0;
    units.eval();
    for (int number = 0; number < slots; ++number) {
      const Slot slot(number);
      const int latency = std::popcount(slot.cuts);
      if (cycle < latency) continue;
      const int a = operand(cycle - latency);
      ASSERT_EQ(units.rootp->fixed_roots__DOT__roots[number], slot.expected(a))
          << fmt::format("slot {}: a = {} of {} bits, shift {}, cuts {:#x}", number, a,
                         slot.a_width, slot.shift, slot.cuts);
    }
    units.aclk = 1;
    units.eval();
  }
}

}  // namespace
}  // namespace mixcmp::test::fixed_roots_test
