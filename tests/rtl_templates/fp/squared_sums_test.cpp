#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <deque>
#include <random>
#include <utility>
#include <vector>

#include "Vsquared_sums.h"
#include "Vsquared_sums___024root.h"
#include "model/base/number/decimal.hpp"
#include "model/judge/golden/arithmetic.hpp"
#include "tests/support/float_samples.hpp"

/// Tests fp_squared_sum against the golden model's sum and the square of that sum. Slots are those
/// of squared_sums.v.
namespace mixcmp::test::squared_sums_test {
namespace {

constexpr std::size_t slots = 8;

struct Expected {
  Bits a = 0, b = 0;
  std::array<Bits, slots / 2> squares = {};  ///< [2 * subtract + gradual]
};

class SquaredSums : public testing::Test {
protected:
  const FloatFormat format_ = FloatFormat::make(PRECISION, EXPONENT_BITS).value();

  Bits square(std::size_t which, Bits a, Bits b) const {
    const Arithmetic arithmetic = {format_, Rounding::nearest_even,
                                   which % 2 == 0 ? Subnormals::flush : Subnormals::gradual};
    const auto sum = which < 2 ? golden::add(arithmetic, format_, a, b)
                               : golden::subtract(arithmetic, format_, a, b);
    return golden::square(arithmetic, format_, sum.bits).bits;
  }

  void feed(Bits a, Bits b) {
    Expected expected{.a = a, .b = b};
    for (std::size_t k = 0; k < expected.squares.size(); ++k) expected.squares[k] = square(k, a, b);
    history_.push_front(expected);
    if (history_.size() > 32) history_.pop_back();
    set(model_.a, a);
    set(model_.b, b);
    model_.aclk = 0;
    model_.eval();
    for (std::size_t slot = 0; slot < slots && !HasFatalFailure(); ++slot) judge(slot);
    model_.aclk = 1;
    model_.eval();
  }

  /// Runs until the last operands have left the registers.
  void drain() {
    for (int k = 0; k < std::popcount(SOME_CUTS) && !HasFatalFailure(); ++k) feed(0, 0);
  }

private:
  template <class Port>
  static void set(Port& port, Bits value) {
    port = static_cast<Port>(value);
  }

  void judge(std::size_t slot) {
    const auto latency = static_cast<std::size_t>(slot % 2 == 0 ? 0 : std::popcount(SOME_CUTS));
    if (history_.size() <= latency) return;
    const Expected& expected = history_[latency];
    const Bits square = expected.squares[slot / 2];
    const Bits y = model_.rootp->squared_sums__DOT__y[slot];
    if (y == square) return;
    const auto text = [&](Bits x) {
      return fmt::format("{} ({})", to_hex(x, format_.width()), to_text(format_, x));
    };
    FAIL() << format_.name() << ", slot " << slot << ", a = " << text(expected.a)
           << ", b = " << text(expected.b) << ": expected " << text(square) << ", got " << text(y);
  }

  VerilatedContext context_;
  Vsquared_sums model_{&context_};
  std::deque<Expected> history_;  ///< the latest first
};

/// Pairs of unrelated numbers, of nearby numbers, of a number and one a few units away, and of
/// either kind with zero, an infinity, a NaN or an end of the range. Half of the numbers are small
/// enough for their squares to be subnormal.
class Pairs {
public:
  Pairs(FloatFormat format, std::uint64_t seed)
      : format_(format), specials_(special_encodings(format)), random_(seed) {}

  std::pair<Bits, Bits> next() {
    const Bits a = first();
    switch (random_() % 5) {
      case 0: return {a, random_encoding(format_, random_)};
      case 1: return {a, random_encoding_near(format_, a, random_)};
      case 2: return {a, specials_[random_() % specials_.size()]};
      case 3: return {a, with_sign(format_.magnitude(a) ^ (Bits{1} << random_place()))};
      default: return {a, with_sign(format_.magnitude(a) + random_() % 5)};
    }
  }

private:
  Bits first() {
    const Bits a = random_encoding(format_, random_);
    if (random_() % 2 == 0) return a;
    const int spread = format_.precision() + 8;
    const int exponent = format_.bias() / 2 - spread / 2 + static_cast<int>(random_() % spread);
    return format_.pack(false, std::max(exponent, 0), format_.fraction(a));
  }
  std::uint64_t random_place() {
    return random_() % static_cast<std::uint64_t>(format_.fraction_bits());
  }
  Bits with_sign(Bits magnitude) {
    const Bits sign = Bits{random_() % 2} << (format_.width() - 1);
    return std::min(magnitude, format_.magnitude(format_.infinity(false))) | sign;
  }

  FloatFormat format_;
  std::vector<Bits> specials_;
  std::mt19937_64 random_;
};

#ifdef EVERY_PAIR
TEST_F(SquaredSums, EveryPairOfOperands) {
  const Bits count = Bits{1} << format_.width();
  for (Bits a = 0; a < count && !HasFatalFailure(); ++a) {
    for (Bits b = 0; b < count && !HasFatalFailure(); ++b) feed(a, b);
  }
  drain();
}
#else
TEST_F(SquaredSums, SpecialValues) {
  const std::vector<Bits> specials = special_encodings(format_);
  for (const Bits a : specials) {
    for (const Bits b : specials) feed(a, b);
  }
  drain();
}

TEST_F(SquaredSums, RandomPairs) {
  const char* wanted = std::getenv("MIXCMP_SQUARED_SUMS");
  const int count = wanted == nullptr ? 50'000 : std::atoi(wanted);
  Pairs pairs(format_, static_cast<std::uint64_t>(count));
  for (int k = 0; k < count && !HasFatalFailure(); ++k) {
    const auto [a, b] = pairs.next();
    feed(a, b);
  }
  drain();
}
#endif

}  // namespace
}  // namespace mixcmp::test::squared_sums_test
