#include <fmt/core.h>
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cstdlib>
#include <deque>
#include <string>

#include "Vfused_sums.h"
#include "Vfused_sums___024root.h"
#include "model/base/number/decimal.hpp"
#include "model/judge/golden/arithmetic.hpp"
#include "tests/support/fused_operands.hpp"

/// Tests fp_fused_sum and fp_fused_comparison against the golden model. Shapes and slots are those
/// of fused_sums.v.
namespace mixcmp::test::fused_sums_test {
namespace {

constexpr int shapes = PRECISION < 3 ? 7 : 10, of_shape = ALTERNATE ? 2 : 4;
constexpr int slots = of_shape * shapes;

struct Slot {
  int shape;
  int variant;
  bool gradual;

  explicit Slot(int index)
      : shape(index / of_shape),
        variant(index % 2),
        gradual(ALTERNATE ? (shape + variant) % 2 == 1 : index / 2 % 2 == 1) {}
  int result() const { return 2 * shape + gradual; }
};

using Operands = FusedOperandMaker::Operands;

struct Expected {
  Operands operands;
  std::array<golden::Rounded, 2 * shapes> results;  ///< [2 * shape + gradual]
  std::array<Verdict, 2 * shapes> orders;           ///< [2 * shape + gradual]
};

class FusedSums : public testing::Test {
protected:
  const FloatFormat format_ = FloatFormat::make(PRECISION, EXPONENT_BITS).value();

  std::vector<golden::FusedOperands> terms(int shape, const Arithmetic& arithmetic,
                                           const Operands& x) const {
    const auto sum = [&](int k) { return golden::add(arithmetic, format_, x[k], x[k + 1]).bits; };
    const Bits difference = golden::subtract(arithmetic, format_, x[0], x[1]).bits;
    const Bits one = format_.pack(false, format_.bias(), 0);
    switch (shape) {
      case 0: return {{x[0], x[0]}, {x[1], x[1]}, {x[2], x[2]}};
      case 1: return {{x[0], x[1]}, {x[2], x[3], true}};
      case 2: return {{x[0], x[1]}, {x[2], one}};
      case 3: return {{x[0], x[0]}, {x[1], x[2], true}, {x[3], one}};
      case 4: return {{x[0], one}, {x[1], one}, {x[2], one, true}};
      case 5:
        return {{x[0], x[0], true},
                {x[1], x[1], true},
                {x[2], x[2], true},
                {x[3], x[3], true},
                {x[4], x[4], true}};
      case 7: return {{difference, difference}, {sum(2), sum(2)}};
      case 8: return {{difference, difference}, {sum(2), sum(2), true}};
      case 9: return {{sum(0), sum(0)}, {x[2], x[3]}, {x[4], one, true}};
      default: return {{x[0], x[1], true}, {x[2], x[3]}, {x[4], x[4], true}, {x[1], one}};
    }
  }

  void feed(const Operands& x) {
    Expected expected{.operands = x, .results = {}, .orders = {}};
    for (int k = 0; k < 2 * shapes; ++k) {
      const Arithmetic arithmetic = {format_, Rounding::nearest_even,
                                     k % 2 == 0 ? Subnormals::flush : Subnormals::gradual};
      const auto operands = terms(k / 2, arithmetic, x);
      expected.results[k] = golden::fused_sum(arithmetic, format_, operands);
      expected.orders[k] = golden::fused_comparison(arithmetic, format_, operands);
    }
    history_.push_front(expected);
    if (history_.size() > 64) history_.pop_back();
    set(model_.x0, x[0]);
    set(model_.x1, x[1]);
    set(model_.x2, x[2]);
    set(model_.x3, x[3]);
    set(model_.x4, x[4]);
    model_.aclk = 0;
    model_.eval();
    for (int slot = 0; slot < slots && !HasFatalFailure(); ++slot) judge(slot);
    model_.aclk = 1;
    model_.eval();
  }

private:
  template <class Port>
  static void set(Port& port, Bits value) {
    port = static_cast<Port>(value);
  }

  /// The operands and results of a unit's present output; none until its registers are full.
  const Expected* expected_at(int slot, unsigned cuts) const {
    const auto latency =
        static_cast<std::size_t>(Slot(slot).variant == 0 ? 0 : std::popcount(cuts));
    return history_.size() <= latency ? nullptr : &history_[latency];
  }

  std::string describe(int slot, const Expected& expected) const {
    std::string text = fmt::format("shape {}, {}, variant {} of", Slot(slot).shape,
                                   Slot(slot).gradual ? "gradual" : "flush", Slot(slot).variant);
    for (const Bits x : expected.operands) {
      text += fmt::format(" {} ({})", to_hex(x, format_.width()), to_text(format_, x));
    }
    return text;
  }

  void judge(int slot) {
    judge_sum(slot);
    judge_comparison(slot);
  }

  void judge_sum(int slot) {
    const Expected* expected = expected_at(slot, SOME_CUTS);
    if (expected == nullptr) return;
    const golden::Rounded& result = expected->results[Slot(slot).result()];
    const Bits y = model_.rootp->fused_sums__DOT__y[slot];
    const bool exceptional = model_.rootp->fused_sums__DOT__flag[slot] != 0;
    if (y == result.bits && exceptional == result.exceptional) return;
    FAIL() << describe(slot, *expected) << ": expected " << to_hex(result.bits, format_.width())
           << (result.exceptional ? " exceptional" : "") << ", got " << to_hex(y, format_.width())
           << (exceptional ? " exceptional" : "");
  }

  void judge_comparison(int slot) {
    constexpr unsigned comparison_cuts = (1u << 25) - 1;
    const Expected* expected = expected_at(slot, SOME_CUTS & comparison_cuts);
    if (expected == nullptr) return;
    const auto order = static_cast<Verdict>(model_.rootp->fused_sums__DOT__order[slot]);
    const Verdict wanted = expected->orders[Slot(slot).result()];
    if (order == wanted) return;
    FAIL() << describe(slot, *expected) << ": expected verdict " << static_cast<int>(wanted)
           << ", got " << static_cast<int>(order);
  }

  VerilatedContext context_;
  Vfused_sums model_{&context_};
  std::deque<Expected> history_;  ///< the latest first
};

#ifdef EXHAUSTIVE_OPERANDS
TEST_F(FusedSums, EveryTupleOfOperands) {
  FusedOperandMaker maker(format_, 3);
  const Bits count = Bits{1} << format_.width();
  Bits tuples = 1;
  for (int k = 0; k < EXHAUSTIVE_OPERANDS; ++k) tuples *= count;
  for (Bits tuple = 0; tuple < tuples && !HasFatalFailure(); ++tuple) {
    Operands x = maker.next();
    Bits rest = tuple;
    for (int k = 0; k < EXHAUSTIVE_OPERANDS; ++k, rest /= count) x[k] = rest % count;
    feed(x);
  }
  for (int k = 0; k < std::popcount(SOME_CUTS) && !HasFatalFailure(); ++k) feed({});
}
#endif

TEST_F(FusedSums, RandomOperands) {
  const char* wanted = std::getenv("MIXCMP_FUSED_SUMS");
  const int count = wanted == nullptr ? 20'000 : std::atoi(wanted);
  FusedOperandMaker maker(format_, static_cast<std::uint64_t>(count));
  for (int k = 0; k < count && !HasFatalFailure(); ++k) feed(maker.next());
}

}  // namespace
}  // namespace mixcmp::test::fused_sums_test
