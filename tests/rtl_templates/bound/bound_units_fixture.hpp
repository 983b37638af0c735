#pragma once

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdint>

#include "tests/rtl_templates/bound/built_units.hpp"
#include "tests/rtl_templates/bound/expected.hpp"

/// Tests the bound units of one format under every mask of cuts. Each cycle has one stimulus, and
/// each answer is expected in the very cycle that its latency names.
namespace mixcmp::test {

inline const FloatFormat lane =
    FloatFormat::make(built_units().precision, built_units().exponent_bits).value();
inline const BoundFormat bound = {.precision = built_units().bound_precision,
                                  .exponent_bits = built_units().exponent_bits};

class BoundUnits : public testing::Test {
protected:
  void TearDown() override {
    for (int i = 0; i < max_latency_cycles; ++i) feed({});
    EXPECT_EQ(wrong_, 0) << "of " << checked_;
    EXPECT_GT(checked_, 0);
  }

  void feed(const Stimulus& stimulus) {
    simulation().apply(stimulus);
    expect(stimulus);
    for (int slot = 0; slot < unit_count * mask_count; ++slot) compare(slot);
    simulation().rise();
    ++cycle_;
  }

private:
  static constexpr int max_latency_cycles = 2, max_reports = 5;

  struct Expectation {
    Stimulus stimulus;
    std::array<Answer, unit_count> answers;
  };

  void expect(const Stimulus& stimulus) {
    Expectation& now = history_[cycle_ % history_.size()];
    now.stimulus = stimulus;
    for (int unit = 0; unit < unit_count; ++unit) {
      now.answers[unit] = expected_.answer(static_cast<Unit>(unit), stimulus);
    }
  }

  void compare(int slot) {
    const Unit unit = static_cast<Unit>(slot / mask_count);
    const auto latency =
        static_cast<std::size_t>(expected_.latency_cycles(unit, slot % mask_count));
    if (cycle_ < latency) return;
    const Expectation& then = history_[(cycle_ - latency) % history_.size()];
    const Answer& answer = then.answers[slot / mask_count];
    const Bits got = simulation().y(slot);
    ++checked_;
    if (((got ^ answer.y) & answer.matters) == 0) return;
    if (wrong_++ >= max_reports) return;
    ADD_FAILURE() << fmt::format(
        "{} CUTS={:02b}: x = {}, a = {}, b = {}, exceptional {:d}: expected {}, got {}",
        to_string(unit), slot % mask_count, to_hex(then.stimulus.x, lane.width()),
        to_hex(then.stimulus.a, bound.width()), to_hex(then.stimulus.b, bound.width()),
        then.stimulus.exceptional, to_hex(answer.y, bound.width()), to_hex(got, bound.width()));
  }

  ExpectedAnswers expected_{lane, bound};
  std::array<Expectation, max_latency_cycles + 1> history_;
  std::size_t cycle_ = 0;
  long checked_ = 0;
  int wrong_ = 0;
};

}  // namespace mixcmp::test
