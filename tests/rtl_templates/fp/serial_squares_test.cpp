#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <deque>
#include <optional>
#include <random>
#include <vector>

#include "Vserial_squares.h"
#include "Vserial_squares___024root.h"
#include "model/base/number/decimal.hpp"
#include "model/judge/golden/arithmetic.hpp"
#include "tests/support/float_samples.hpp"

/// Tests fp_serial_square against the golden model's square, in the very cycle that its latency
/// names. Slots are those of serial_squares.v.
namespace mixcmp::test::serial_squares_test {
namespace {

constexpr std::size_t slots = 10;
constexpr int steps = (PRECISION + 5) / 6;

struct Expected {
  Bits a = 0;
  std::array<golden::Rounded, slots / 2> squares = {};  ///< [2 * toward zero + gradual]
  bool keeps_promises = false;
};

class SerialSquares : public testing::Test {
protected:
  const FloatFormat operands_ = FloatFormat::make(PRECISION, EXPONENT_BITS).value();
  const FloatFormat result_ = FloatFormat::make(RESULT_PRECISION, RESULT_EXPONENT_BITS).value();

  /// Squares `a`; then no operand comes before the unit is free, and for `gap` cycles more.
  void feed(Bits a, unsigned gap = 0) {
    cycle(expected(a));
    for (unsigned k = 1; k < steps + gap; ++k) cycle(std::nullopt);
  }

  /// Starts the square of `unfinished`, and that of `a` before it is done: only `a` has an answer.
  void feed_too_early(Bits unfinished, Bits a, int after) {
    cycle(expected(unfinished));
    history_.front().reset();
    for (int k = 1; k < after; ++k) cycle(std::nullopt);
    feed(a);
  }

  void drain() {
    for (int k = 0; k < steps + 9; ++k) cycle(std::nullopt);
  }

  golden::Rounded square(std::size_t variant, Bits a) const {
    const Arithmetic arithmetic = {result_,
                                   variant % 4 < 2 ? Rounding::nearest_even : Rounding::toward_zero,
                                   variant % 2 == 0 ? Subnormals::flush : Subnormals::gradual};
    return golden::square(arithmetic, operands_, a);
  }

private:
  Expected expected(Bits a) const {
    Expected made{.a = a};
    for (std::size_t k = 0; k < made.squares.size(); ++k) made.squares[k] = square(k, a);
    const int exponent = operands_.biased_exponent(a);
    made.keeps_promises = exponent > 0 && exponent < operands_.max_biased_exponent() &&
                          !made.squares.back().exceptional;
    return made;
  }

  /// Runs one cycle. If no operand comes, the input `a` may be anything.
  void cycle(const std::optional<Expected>& expected) {
    history_.push_front(expected);
    if (history_.size() > 32) history_.pop_back();
    model_.start = expected.has_value();
    set(model_.a, expected ? expected->a : noise_() & low_mask(operands_.width()));
    model_.aclk = 0;
    model_.eval();
    for (std::size_t slot = 0; slot < slots && !HasFatalFailure(); ++slot) judge(slot);
    model_.aclk = 1;
    model_.eval();
  }

  template <class Port>
  static void set(Port& port, Bits value) {
    port = static_cast<Port>(value);
  }

  void judge(std::size_t slot) {
    const int outer = slot % 2 == 0 ? 0 : std::popcount(static_cast<unsigned>(SOME_CUTS));
    const auto latency = static_cast<std::size_t>(steps + 3 + outer);
    if (history_.size() <= latency || !history_[latency]) return;
    const Expected& expected = *history_[latency];
    if (slot >= 8 && !expected.keeps_promises) return;
    const golden::Rounded& square = expected.squares[slot / 2];
    const Bits y = model_.rootp->serial_squares__DOT__y[slot];
    const bool flag = model_.rootp->serial_squares__DOT__flag[slot] != 0;
    if (y == square.bits && flag == square.exceptional) return;
    const auto text = [](FloatFormat format, Bits x) {
      return fmt::format("{} ({})", to_hex(x, format.width()), to_text(format, x));
    };
    FAIL() << operands_.name() << " to " << result_.name() << ", slot " << slot
           << ", a = " << text(operands_, expected.a) << ": expected " << text(result_, square.bits)
           << ", exceptional " << square.exceptional << ", got " << text(result_, y)
           << ", exceptional " << flag;
  }

  VerilatedContext context_;
  Vserial_squares model_{&context_};
  std::mt19937_64 noise_{1};
  std::deque<std::optional<Expected>> history_;  ///< the latest cycle first
};

/// Operands whose squares lie anywhere, and half of the time near the ends of the result's range.
class Operands {
public:
  Operands(FloatFormat format, FloatFormat result, std::uint64_t seed)
      : format_(format), result_(result), random_(seed) {}

  Bits next() {
    const Bits a = random_encoding(format_, random_);
    if (random_() % 2 == 0) return a;
    const int least = result_.min_exponent() - result_.precision() - 2;
    const int spread = result_.precision() + 6;
    const int exponent = random_() % 4 == 0 ? result_.max_exponent() / 2 - 1 + below(3)
                                            : least / 2 + below(spread / 2);
    const int biased = std::clamp(exponent + format_.bias(), 0, format_.max_biased_exponent() - 1);
    return format_.pack(random_() % 2 == 0, biased, format_.fraction(a));
  }

  int below(int limit) { return static_cast<int>(random_() % static_cast<unsigned>(limit)); }

private:
  FloatFormat format_;
  FloatFormat result_;
  std::mt19937_64 random_;
};

#ifdef EVERY_OPERAND
TEST_F(SerialSquares, EveryOperand) {
  const Bits count = Bits{1} << operands_.width();
  for (Bits a = 0; a < count && !HasFatalFailure(); ++a) feed(a);
  drain();
}
#else
TEST_F(SerialSquares, SpecialValuesAndTheirNeighbours) {
  for (const Bits special : special_encodings(operands_)) {
    const Bits sign = special & ~operands_.magnitude(~Bits{0});
    for (Bits magnitude : {operands_.magnitude(special) - 1, operands_.magnitude(special),
                           operands_.magnitude(special) + 1}) {
      feed(sign | operands_.magnitude(magnitude));
    }
  }
  drain();
}
#endif

TEST_F(SerialSquares, RandomOperandsOneAfterTheOther) {
  const char* wanted = std::getenv("MIXCMP_SERIAL_SQUARES");
  const int count = wanted == nullptr ? 30'000 : std::atoi(wanted);
  Operands operands(operands_, result_, static_cast<std::uint64_t>(count));
  for (int k = 0; k < count && !HasFatalFailure(); ++k) feed(operands.next());
  drain();
}

TEST_F(SerialSquares, RandomOperandsWithGaps) {
  Operands operands(operands_, result_, 2);
  for (int k = 0; k < 5'000 && !HasFatalFailure(); ++k) {
    feed(operands.next(), static_cast<unsigned>(operands.below(5)));
  }
  drain();
}

/// After a reset the phases begin anew, in the middle of a square.
TEST_F(SerialSquares, AnUnfinishedSquareDoesNotDisturbTheNext) {
  Operands operands(operands_, result_, 3);
  for (int k = 0; k < 5'000 && !HasFatalFailure(); ++k) {
    const Bits unfinished = operands.next();
    feed_too_early(unfinished, operands.next(), 1 + k % (steps - 1));
  }
  drain();
}

}  // namespace
}  // namespace mixcmp::test::serial_squares_test
