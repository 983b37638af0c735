#include <gtest/gtest.h>

#include <deque>

#include "Vscalings.h"
#include "Vscalings___024root.h"
#include "model/judge/golden/arithmetic.hpp"

/// Tests conversions that scale, on every operand, against the golden model's products with powers
/// of two.
namespace mixcmp::test::scalings_test {
namespace {

/// One instance of scalings.v.
struct Slot {
  int scale;
  Arithmetic arithmetic;
  bool promised;
  int latency_cycles;
};

class Scalings : public testing::Test {
protected:
  const FloatFormat operands_ = FloatFormat::make(PRECISION, EXPONENT_BITS).value();
  const FloatFormat result_ = FloatFormat::make(RESULT_PRECISION, RESULT_EXPONENT_BITS).value();
  const int slots_ = 32 * operands_.bias();

  Slot slot(int index) const {
    return {
        .scale = index / 16 - operands_.bias() + 1,
        .arithmetic = {result_, (index & 4) != 0 ? Rounding::toward_zero : Rounding::nearest_even,
                       (index & 8) != 0 ? Subnormals::gradual : Subnormals::flush},
        .promised = (index & 2) != 0,
        .latency_cycles = (index & 1) != 0 ? 3 : 0};
  }

  /// Whether the promise holds: operand and result are zeros or normal numbers.
  bool is_plain(FloatFormat format, Bits bits) const {
    return !format.is_nan(bits) && !format.is_infinite(bits) && !format.is_subnormal(bits);
  }

  void judge(int index, Bits a) {
    const Slot which = slot(index);
    const Bits factor = operands_.pack(false, which.scale + operands_.bias(), 0);
    const auto expected = golden::multiply(which.arithmetic, operands_, a, factor);
    const bool kept =
        is_plain(operands_, a) && is_plain(result_, expected.bits) && !expected.exceptional;
    if (which.promised && !kept) return;
    ++judged_;
    ASSERT_EQ(static_cast<Bits>(model_.rootp->scalings__DOT__y[index]), expected.bits)
        << "slot " << index << ", scale " << which.scale << ", a = " << std::hex
        << static_cast<std::uint64_t>(a);
    ASSERT_EQ(model_.rootp->scalings__DOT__flag[index] != 0, expected.exceptional)
        << "slot " << index << ", scale " << which.scale << ", a = " << std::hex
        << static_cast<std::uint64_t>(a);
  }

  void feed(Bits a) {
    history_.push_front(a);
    model_.a = static_cast<std::remove_reference_t<decltype(model_.a)>>(a);
    model_.aclk = 0;
    model_.eval();
    for (int index = 0; index < slots_ && !HasFatalFailure(); ++index) {
      const auto cycles = static_cast<std::size_t>(slot(index).latency_cycles);
      if (history_.size() > cycles) judge(index, history_[cycles]);
    }
    model_.aclk = 1;
    model_.eval();
  }

  std::uint64_t judged_ = 0;

private:
  VerilatedContext context_;
  Vscalings model_{&context_};
  std::deque<Bits> history_;  ///< the latest first
};

TEST_F(Scalings, EveryOperandIsMultipliedByThePowerOfTwo) {
  const Bits count = Bits{1} << operands_.width();
  for (Bits a = 0; a < count && !HasFatalFailure(); ++a) feed(a);
  for (int k = 0; k < 3 && !HasFatalFailure(); ++k) feed(0);
  EXPECT_GT(judged_, static_cast<std::uint64_t>(slots_) / 2 * static_cast<std::uint64_t>(count));
}

}  // namespace
}  // namespace mixcmp::test::scalings_test
