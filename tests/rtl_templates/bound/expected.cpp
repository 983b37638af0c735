#include "tests/rtl_templates/bound/expected.hpp"

#include <algorithm>

#include "model/base/common/check.hpp"
#include "model/judge/golden/bound_arithmetic.hpp"
#include "model/judge/golden/evaluate.hpp"

namespace mixcmp::test {
namespace {

using error::RequiredSign;

constexpr Answer anything = {.matters = 0};

Bits guard_ulp(Unit unit, FloatFormat lane) {
  if (unit == Unit::decision_guard_5) return 5;
  if (unit == Unit::decision_large_guard) return low_mask(lane.width() - 4);
  return unit == Unit::decision_never ? low_mask(lane.width()) : 0;
}

bool is_gradual(Unit unit) {
  return unit == Unit::magnitude_gradual || unit == Unit::binade_gradual;
}

bool has_two_cuts(Unit unit) {
  switch (unit) {
    case Unit::magnitude_flush:
    case Unit::magnitude_gradual:
    case Unit::add:
    case Unit::multiply:
    case Unit::decision:
    case Unit::decision_guard_5:
    case Unit::decision_large_guard:
    case Unit::decision_never: return true;
    case Unit::binade_flush:
    case Unit::binade_gradual:
    case Unit::reciprocal:
    case Unit::maximum:
    case Unit::at_most:
    case Unit::sign_alone:
    case Unit::normal_numbers:
    case Unit::inner:
    case Unit::anything: return false;
  }
  MIXCMP_CHECK(false);
}

}  // namespace

std::string_view to_string(Unit unit) {
  static constexpr std::array<std::string_view, unit_count> names = {
      "bound_magnitude GRADUAL=0",
      "bound_magnitude GRADUAL=1",
      "bound_binade GRADUAL=0",
      "bound_binade GRADUAL=1",
      "bound_reciprocal",
      "bound_add",
      "bound_multiply",
      "bound_maximum",
      "bound_at_most",
      "bound_decision",
      "bound_decision GUARD_ULP=5",
      "bound_decision of a large guard",
      "bound_decision of the largest guard",
      "fp_range_check SIGN=1",
      "fp_range_check of normal numbers",
      "fp_range_check SIGN=2 within limits",
      "fp_range_check of anything"};
  return names[static_cast<std::size_t>(unit)];
}

int ExpectedAnswers::latency_cycles(Unit unit, int mask) const {
  return has_two_cuts(unit) ? (mask & 1) + (mask >> 1) : mask & 1;
}

Answer ExpectedAnswers::answer(Unit unit, const Stimulus& stimulus) const {
  switch (unit) {
    case Unit::magnitude_flush:
    case Unit::magnitude_gradual:
    case Unit::binade_flush:
    case Unit::binade_gradual:
    case Unit::reciprocal: return of_value(unit, stimulus);
    case Unit::add: return {golden::bound_add(bound_, stimulus.a, stimulus.b)};
    case Unit::multiply: return {golden::bound_multiply(bound_, stimulus.a, stimulus.b)};
    case Unit::maximum: return {std::max(stimulus.a, stimulus.b)};
    case Unit::at_most: return at_most(stimulus);
    case Unit::decision:
    case Unit::decision_guard_5:
    case Unit::decision_large_guard:
    case Unit::decision_never: return decision(unit, stimulus);
    case Unit::sign_alone:
    case Unit::normal_numbers:
    case Unit::inner:
    case Unit::anything: return {!golden::passes(range_check(unit), lane_, stimulus.x)};
  }
  MIXCMP_CHECK(false);
}

Answer ExpectedAnswers::of_value(Unit unit, const Stimulus& stimulus) const {
  const Bits x = stimulus.x;
  if (unit == Unit::reciprocal) return {golden::bound_reciprocal(bound_, lane_, x)};
  if (lane_.is_subnormal(x) && !is_gradual(unit)) return anything;
  const bool binade = unit == Unit::binade_flush || unit == Unit::binade_gradual;
  if (lane_.is_nan(x) && !binade) return anything;
  return {binade ? golden::bound_binade(bound_, lane_, x)
                 : golden::bound_magnitude(bound_, lane_, x)};
}

Answer ExpectedAnswers::at_most(const Stimulus& stimulus) const {
  if (lane_.is_nan(stimulus.x)) return anything;
  return {golden::bound_is_at_most(bound_, stimulus.a, lane_, stimulus.x)};
}

Answer ExpectedAnswers::decision(Unit unit, const Stimulus& stimulus) const {
  constexpr Bits decided = 4, greater = 2;
  if (stimulus.exceptional) return {0, decided};
  if (lane_.is_nan(stimulus.x)) return anything;
  const Bits limit = stimulus.a << (lane_.precision() - bound_.precision);
  if (lane_.magnitude(stimulus.x) <= limit + guard_ulp(unit, lane_)) return {0, decided};
  return {decided | (lane_.sign(stimulus.x) ? 0 : greater)};
}

error::RangeCheck ExpectedAnswers::range_check(Unit unit) const {
  const int exponent_bits = lane_.exponent_bits();
  const Bits exponents = Bits{1} << exponent_bits;
  if (unit == Unit::sign_alone) return {.sign = RequiredSign::nonnegative};
  if (unit == Unit::normal_numbers) {
    return {.leading_bits = exponent_bits, .least = 1, .greatest = exponents - 2};
  }
  if (unit == Unit::inner) {
    return {.sign = RequiredSign::nonpositive,
            .leading_bits = exponent_bits + 1,
            .least = 3,
            .greatest = exponents};
  }
  return {.leading_bits = lane_.width() - 1, .greatest = ~Bits{0}};
}

std::vector<Bits> every_bound(BoundFormat format) {
  std::vector<Bits> bounds = {0};
  for (Bits bound = format.smallest(); bound <= format.infinity(); ++bound) bounds.push_back(bound);
  return bounds;
}

}  // namespace mixcmp::test
