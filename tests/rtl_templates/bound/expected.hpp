#pragma once

#include <array>
#include <string>
#include <vector>

#include "model/base/number/float_format.hpp"
#include "model/lane/error/bound_graph.hpp"
#include "model/lane/error/range_check.hpp"
#include "tests/rtl_templates/bound/built_units.hpp"

namespace mixcmp::test {

/// The units of bound_units.v, in its order.
enum class Unit {
  magnitude_flush,
  magnitude_gradual,
  binade_flush,
  binade_gradual,
  reciprocal,
  add,
  multiply,
  maximum,
  at_most,
  decision,
  decision_guard_5,
  decision_large_guard,
  decision_never,
  sign_alone,
  normal_numbers,
  inner,
  anything,
};
constexpr int unit_count = 17, mask_count = 4;

std::string_view to_string(Unit unit);

/// The answer that a unit must give; bits that are not in `matters` may be anything.
struct Answer {
  Bits y = 0;
  Bits matters = ~Bits{0};
};

/// The golden model's answers for one lane format and bound format.
class ExpectedAnswers {
public:
  ExpectedAnswers(FloatFormat lane, BoundFormat bound) : lane_(lane), bound_(bound) {}

  Answer answer(Unit unit, const Stimulus& stimulus) const;
  /// Cycles from operands to answer under a mask of cuts.
  int latency_cycles(Unit unit, int mask) const;

  FloatFormat lane() const { return lane_; }
  BoundFormat bound() const { return bound_; }

private:
  Answer of_value(Unit unit, const Stimulus& stimulus) const;
  Answer at_most(const Stimulus& stimulus) const;
  Answer decision(Unit unit, const Stimulus& stimulus) const;
  error::RangeCheck range_check(Unit unit) const;

  FloatFormat lane_;
  BoundFormat bound_;
};

/// Zero, every number and infinity: all that a bound may be.
std::vector<Bits> every_bound(BoundFormat format);

}  // namespace mixcmp::test
