#include <fmt/core.h>
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <random>
#include <vector>

#include "Vfixed_operands.h"
#include "Vfixed_operands___024root.h"
#include "model/base/number/exact.hpp"
#include "model/judge/golden/fixed_evaluate.hpp"
#include "tests/support/float_samples.hpp"

/// Tests fixed_operand and fixed_grid_operand at some tops and widths against the golden model's
/// inputs. Each cycle has one operand, and each answer is expected in the very cycle that its mask
/// of cuts names.
namespace mixcmp::test::fixed_operands_test {
namespace {

using fixed::FixedLane;
using fixed::FixedNode;

const FloatFormat format = format_of(PRECISION, EXPONENT_BITS);
constexpr int slots = 2 * TOPS * WIDTHS;

/// A lane that is one input in the format of this slot.
FixedLane lane_of(int slot, bool is_promised) {
  const bool is_signed = slot % 2 == 1;
  const int width = FIRST_WIDTH + WIDTH_STEP * ((slot / 2) % WIDTHS);
  const int top = FIRST_TOP + TOP_STEP * (slot / 2 / WIDTHS);
  const FixedFormat fixed_format = {
      .width = width + (is_signed ? 1 : 0), .unit_exponent = top - width, .is_signed = is_signed};
  const FixedNode input{.operation = Operation::input,
                        .input = 0,
                        .is_promised = is_promised,
                        .constant = {},
                        .format = fixed_format,
                        .value = {},
                        .error = {}};
  return {.nodes = {input}, .input_names = {"x"}, .input_format = format, .parts = {}};
}

class FixedOperands : public testing::Test {
protected:
  FixedOperands() : units_(&context_) {
    for (const bool is_promised : {false, true}) {
      for (int slot = 0; slot < slots; ++slot) lanes_.push_back(lane_of(slot, is_promised));
    }
    units_.aclk = 0;
    units_.eval();
  }

  void TearDown() override {
    feed(0);
    feed(0);
    feed(0);
    EXPECT_GT(checked_, 0);
  }

  void feed(Bits x) {
    for (std::size_t word = 0; word * 32 < static_cast<std::size_t>(format.width()); ++word) {
      set_word(units_.x, word, static_cast<std::uint32_t>(x >> (32 * word)));
    }
    units_.aclk = 0;
    units_.eval();
    history_[cycle_ % history_.size()] = x;
    for (int slot = 0; slot < slots && !HasFailure(); ++slot) {
      const auto& answers = units_.rootp->fixed_operands__DOT__answers;
      const auto& on_grid = units_.rootp->fixed_operands__DOT__grid_answers;
      compare(lanes_[slot], slot % 4, answers[slot]);
      compare(lanes_[slots + slot], slot % 8, on_grid[slot]);
    }
    units_.aclk = 1;
    units_.eval();
    ++cycle_;
  }

private:
  /// A port of at most 64 bits is one integer, a wider one an array of words.
  template <class Port>
  static void set_word(Port& port, std::size_t word, std::uint32_t value) {
    if constexpr (std::is_integral_v<Port>) {
      port = word == 0 ? static_cast<Port>(value)
                       : static_cast<Port>(port | static_cast<std::uint64_t>(value) << 32);
    } else {
      port[word] = value;
    }
  }

  void compare(const FixedLane& lane, int cuts, std::uint64_t got) {
    const auto latency = static_cast<std::size_t>(std::popcount(static_cast<unsigned>(cuts)));
    if (cycle_ < latency) return;
    const Bits x = history_[(cycle_ - latency) % history_.size()];
    const std::array<Bits, 1> operands = {x};
    const std::optional<mpz_class> expected = golden::evaluate(lane, operands).front();
    const bool out_of_range = (got >> 63) != 0;
    ++checked_;
    const FixedNode& input = lane.nodes.front();
    const FixedFormat& fixed_format = input.format;
    const std::string what =
        fmt::format("{}{}, cuts {}, x = {}", fixed_format.name(),
                    input.is_promised ? " on grid" : "", cuts, to_hex(x, format.width()));
    ASSERT_EQ(out_of_range, !expected.has_value()) << what;
    if (!expected) return;
    const mpz_class modulus = mpz_class(1) << fixed_format.width;
    const mpz_class packed = *expected < 0 ? mpz_class(*expected + modulus) : *expected;
    EXPECT_EQ(mpz_class(got), packed) << what;
  }

  VerilatedContext context_;
  Vfixed_operands units_;
  std::vector<FixedLane> lanes_;
  std::array<Bits, 4> history_ = {};
  std::size_t cycle_ = 0;
  long checked_ = 0;
};

#if PRECISION + EXPONENT_BITS <= 12
TEST_F(FixedOperands, EveryOperand) {
  for (Bits x = 0; x < Bits{1} << format.width(); ++x) feed(x);
}
#endif

TEST_F(FixedOperands, SpecialOperands) {
  for (const Bits x : special_encodings(format)) feed(x);
}

/// Powers of two and their neighbours: there a magnitude ceases to fit, or a bit is lost.
TEST_F(FixedOperands, NeighboursOfPowersOfTwo) {
  for (int exponent = format.min_exponent(); exponent <= format.max_exponent(); ++exponent) {
    const Bits power = format.pack(false, exponent + format.bias(), 0);
    for (const Bits x : {power - 1, power, power + 1}) {
      feed(x);
      feed(x | format.zero(true));
    }
  }
}

TEST_F(FixedOperands, RandomOperands) {
  std::mt19937_64 random(1);
  constexpr int operands = PRECISION + EXPONENT_BITS <= 12 ? 2'000 : 20'000;  // beside every one
  for (int k = 0; k < operands; ++k) {
    const int top = FIRST_TOP + TOP_STEP * static_cast<int>(random() % TOPS);
    const int exponent = top + 2 - static_cast<int>(random() % (FIRST_WIDTH + WIDTH_STEP * WIDTHS));
    const int biased = std::clamp(exponent + format.bias(), 0, format.max_biased_exponent());
    const Bits fraction = random_encoding(format, random) & low_mask(format.fraction_bits());
    feed(format.pack(random() % 4 == 0, biased, fraction));
  }
}

}  // namespace
}  // namespace mixcmp::test::fixed_operands_test
