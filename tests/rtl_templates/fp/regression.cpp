#include "tests/rtl_templates/fp/regression.hpp"

#include <fmt/core.h>

#include <utility>

#include "model/base/number/decimal.hpp"

namespace mixcmp::test {
namespace {

constexpr uint64_t max_reports = 10;

std::string text(FloatFormat format, Bits bits) {
  return fmt::format("0x{} ({})", to_hex(bits, format.width()), to_text(format, bits));
}

}  // namespace

Regression::Regression(Simulation& simulation, const UnitsUnderTest& units, ColumnRange columns,
                       std::string program)
    : simulation_(simulation),
      units_(units),
      columns_(columns),
      program_(std::move(program)),
      history_(units.max_latency_cycles() + 1) {}

void Regression::feed(const Stimulus& stimulus) {
  Expectation& now = history_[cycle_ % history_.size()];
  now.stimulus = stimulus;
  for (int i = 0; i < UnitsUnderTest::behaviours; ++i) {
    now.answers[i] = units_.answer(i, stimulus);
    if (columns_.has_promises()) now.hazards[i] = units_.hazards(i, stimulus);
  }
  simulation_.apply(stimulus);
  for (int slot = 0; slot < UnitsUnderTest::slots; ++slot) {
    if (columns_.contains(slot)) compare(slot);
  }
  simulation_.rise();
  ++cycle_;
}

void Regression::drain() {
  for (int i = 0; i < units_.max_latency_cycles(); ++i) feed({0, 0});
}

void Regression::compare(int slot) {
  const uint64_t latency = static_cast<uint64_t>(units_.latency_cycles(slot));
  if (cycle_ < latency) return;
  const Expectation& then = history_[(cycle_ - latency) % history_.size()];
  const int behaviour = slot / UnitsUnderTest::columns;
  const HazardSet promised = units_.promised(slot);
  if (promised.meets(then.hazards[behaviour])) {
    const bool all = promised.special_operands && promised.overflow && promised.underflow;
    if (!all || !units_.exceptional_by_hazards_alone(behaviour)) return;
    // A broken promise permits any answer, but no logic for hazards may be left: the flag is 0.
    judge(slot, then.stimulus, {.flag = false, .y_matters = false});
  } else {
    ++kept_promises_[slot];
    judge(slot, then.stimulus, then.answers[behaviour]);
  }
}

void Regression::judge(int slot, const Stimulus& stimulus, const Answer& expected) {
  const bool y_wrong = expected.y_matters && simulation_.y(slot) != expected.y;
  const bool flag_wrong = expected.flag_matters && simulation_.flag(slot) != expected.flag;
  ++answers_;
  if (!y_wrong && !flag_wrong) return;
  if (failures_++ < max_reports) report(slot, stimulus, expected);
}

std::vector<int> Regression::idle_slots() const {
  std::vector<int> idle;
  for (int slot = 0; slot < UnitsUnderTest::slots; ++slot) {
    if (columns_.contains(slot) && kept_promises_[slot] == 0) idle.push_back(slot);
  }
  return idle;
}

void Regression::report(int slot, const Stimulus& stimulus, const Answer& expected) const {
  const FloatFormat operands = units_.operands();
  const FloatFormat format = units_.format(slot);
  fmt::print(
      "WRONG {} -> {}, {}, latency {}\n"
      "  a = {}\n  b = {}\n  expected {} flag {:d}\n  got      {} flag {:d}\n"
      "  from {}; alone: {} pair 0x{} 0x{} {:d}\n",
      operands.name(), units_.result().name(), units_.name(slot), units_.latency_cycles(slot),
      text(operands, stimulus.a), text(operands, stimulus.b), text(format, expected.y),
      expected.flag, text(format, simulation_.y(slot)), simulation_.flag(slot), origin_, program_,
      to_hex(stimulus.a, operands.width()), to_hex(stimulus.b, operands.width()),
      stimulus.exceptional);
}

}  // namespace mixcmp::test
