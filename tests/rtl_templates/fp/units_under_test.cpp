#include "tests/rtl_templates/fp/units_under_test.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <string_view>

#include "model/base/number/verdict.hpp"
#include "model/judge/golden/arithmetic.hpp"

namespace mixcmp::test {
namespace {

enum UnitSlot {
  add,
  subtract,
  multiply,
  square,
  divide,
  square_root,
  convert,
  logic_multiply,
  logic_square,
  minimum_maximum,
  comparison,
  ulp_distance,
  ulp_distance_wide,
};

struct Behaviour {
  UnitSlot unit;
  bool gradual;      ///< NONNEGATIVE of fp_ulp_distance
  bool toward_zero;  ///< MAXIMUM; the interval decision; the larger guards
};

Behaviour behaviour_of(int index) {
  return {static_cast<UnitSlot>(index / UnitsUnderTest::variants), (index & 2) != 0,
          (index & 1) != 0};
}

int population_count(Bits bits) {
  return std::popcount(static_cast<uint64_t>(bits)) +
         std::popcount(static_cast<uint64_t>(bits >> 64));
}

Operation operation_of(UnitSlot unit) {
  switch (unit) {
    case add: return Operation::add;
    case subtract: return Operation::subtract;
    case multiply:
    case logic_multiply: return Operation::multiply;
    case square:
    case logic_square: return Operation::square;
    case divide: return Operation::divide;
    case square_root: return Operation::square_root;
    case convert: return Operation::convert;
    case minimum_maximum: return Operation::minimum;
    case comparison:
    case ulp_distance:
    case ulp_distance_wide: break;
  }
  MIXCMP_CHECK(!"not an operation");
}

Bits guard_of(FloatFormat format, const Behaviour& behaviour) {
  const Bits widest = Bits{3} << (format.width() - 2);
  if (behaviour.unit == ulp_distance) return behaviour.toward_zero ? 5 : 0;
  return behaviour.toward_zero ? widest : 1;
}

/// The answer by the packed encodings as integers with a sign; -0 and +0 are the same. The
/// difference of two would need 129 bits, so it is compared without being computed.
Answer ulp_distance_answer(FloatFormat format, const Behaviour& behaviour,
                           const Stimulus& stimulus) {
  const Bits f = format.magnitude(stimulus.a), g = format.magnitude(stimulus.b);
  const bool f_negative = format.sign(stimulus.a), g_negative = format.sign(stimulus.b);
  const bool promise_broken =
      behaviour.gradual && ((f_negative && f != 0) || (g_negative && g != 0));
  if (promise_broken) return {.y_matters = false, .flag_matters = false};

  const bool like = f_negative == g_negative || f == 0 || g == 0;
  const bool unlike_signs = f_negative != g_negative && !(f == 0 && g == 0);
  const Bits distance = unlike_signs ? f + g : std::max(f, g) - std::min(f, g);
  const bool less = unlike_signs ? f_negative : (f != g && (f < g) != f_negative);
  const bool equal = like && distance == 0;
  const bool decided = !stimulus.exceptional && distance >= guard_of(format, behaviour);
  return {
      .y = static_cast<Bits>(equal ? 1 : (less ? 0 : 2)), .flag = decided, .y_matters = decided};
}

Answer interval_answer(FloatFormat format, const Stimulus& stimulus) {
  const bool unordered = format.is_nan(stimulus.a) || format.is_nan(stimulus.b);
  const bool greater = !format.sign(stimulus.a) && !format.is_zero(stimulus.a);
  const bool less = format.sign(stimulus.b) && !format.is_zero(stimulus.b);
  const bool decided = !unordered && (greater || less);
  return {.y = static_cast<Bits>(greater ? 2 : 0), .flag = decided, .y_matters = decided};
}

golden::Rounded rounded(const Arithmetic& result, FloatFormat operands, const Behaviour& behaviour,
                        const Stimulus& stimulus) {
  const Arithmetic same{operands, result.rounding, result.subnormals};
  const Bits a = stimulus.a, b = stimulus.b;
  switch (behaviour.unit) {
    case add: return golden::add(result, operands, a, b);
    case subtract: return golden::subtract(result, operands, a, b);
    case multiply:
    case logic_multiply: return golden::multiply(result, operands, a, b);
    case square:
    case logic_square: return golden::square(result, operands, a);
    case divide: return golden::divide(result, operands, a, b);
    case square_root: return golden::square_root(result, operands, a);
    case convert: return golden::convert(result, operands, a);
    case minimum_maximum:
      return behaviour.toward_zero ? golden::maximum(same, a, b) : golden::minimum(same, a, b);
    case comparison:
    case ulp_distance:
    case ulp_distance_wide: break;
  }
  MIXCMP_CHECK(!"not an operation");
}

bool has_promises(UnitSlot unit) {
  return unit <= minimum_maximum;
}

bool has_two_operands(UnitSlot unit) {
  return unit != square && unit != logic_square && unit != square_root && unit != convert;
}

HazardSet operand_hazards(FloatFormat format, Bits operand) {
  const bool special = format.is_nan(operand) || format.is_infinite(operand);
  return {.special_operands = special, .underflow = format.is_subnormal(operand)};
}

/// A format whose exponent range is so wide that no result of these formats leaves it.
FloatFormat with_unbounded_exponent(FloatFormat format) {
  return FloatFormat::make(format.precision(), FloatFormat::max_exponent_bits).value();
}

/// The hazards of a result: whether `unbounded`, which has the same precision, lies above or below
/// the format's range.
HazardSet result_hazards(FloatFormat format, FloatFormat unbounded_format, Bits unbounded) {
  const int exponent = unbounded_format.biased_exponent(unbounded) - unbounded_format.bias();
  const bool finite =
      !unbounded_format.is_nan(unbounded) && !unbounded_format.is_infinite(unbounded);
  const bool zero = unbounded_format.is_zero(unbounded);
  return {.overflow = finite && exponent > format.max_exponent(),
          .underflow = !zero && exponent < format.min_exponent()};
}

bool unlike_signs(FloatFormat format, const Stimulus& stimulus) {
  return format.sign(stimulus.a) != format.sign(stimulus.b);
}

void include(HazardSet& all, const HazardSet& more) {
  all.special_operands |= more.special_operands;
  all.overflow |= more.overflow;
  all.underflow |= more.underflow;
}

}  // namespace

UnitsUnderTest::UnitsUnderTest(FloatFormat operands, FloatFormat result, Bits some_cuts)
    : operands_(operands), result_(result) {
  for (int slot = 0; slot < slots; ++slot) {
    const std::array<Bits, masks> cuts = {0, ~Bits{0}, some_cuts};
    const Bits stages = low_mask(stage_count(slot / columns));
    latencies_[slot] = population_count(cuts[std::min(slot % columns, masks - 1)] & stages);
  }
}

int UnitsUnderTest::max_latency_cycles() const {
  return *std::max_element(latencies_.begin(), latencies_.end());
}

int UnitsUnderTest::stage_count(int behaviour) const {
  const datapath::DelayTable delays;
  const Behaviour which = behaviour_of(behaviour);
  const auto count = [](const datapath::Unit& unit) {
    return static_cast<int>(unit.stages.size());
  };
  if (which.unit == comparison && which.toward_zero) {
    return count(datapath::interval_decision_unit(operands_, delays));
  }
  if (which.unit == comparison) return count(datapath::compare_unit(operands_, delays));
  if (which.unit == ulp_distance || which.unit == ulp_distance_wide) {
    return count(datapath::ulp_distance_unit(operands_, delays));
  }
  const TypedNode node{.operation = operation_of(which.unit),
                       .operand_format = operands_,
                       .format = which.unit == minimum_maximum ? operands_ : result_};
  const Subnormals subnormals = which.gradual ? Subnormals::gradual : Subnormals::flush;
  const bool logic = which.unit == logic_multiply || which.unit == logic_square;
  const auto multipliers = logic ? scene::Multipliers::logic : scene::Multipliers::embedded;
  return count(datapath::unit_for(node, subnormals, {}, multipliers, delays));
}

Answer UnitsUnderTest::answer(int behaviour, const Stimulus& stimulus) const {
  const Behaviour which = behaviour_of(behaviour);
  const Subnormals subnormals = which.gradual ? Subnormals::gradual : Subnormals::flush;
  if (which.unit == ulp_distance || which.unit == ulp_distance_wide) {
    return ulp_distance_answer(operands_, which, stimulus);
  }
  if (which.unit == comparison && which.toward_zero) return interval_answer(operands_, stimulus);
  if (which.unit == comparison) {
    const Verdict verdict = golden::compare(operands_, subnormals, stimulus.a, stimulus.b);
    return {.y = static_cast<Bits>(verdict), .flag_matters = false};
  }
  const Arithmetic result{
      result_, which.toward_zero ? Rounding::toward_zero : Rounding::nearest_even, subnormals};
  const golden::Rounded value = rounded(result, operands_, which, stimulus);
  return {.y = value.bits, .flag = value.exceptional};
}

HazardSet UnitsUnderTest::promised(int slot) const {
  if (!has_promises(behaviour_of(slot / columns).unit)) return {};
  const int column = slot % columns;
  const int bits = column == columns - 1 ? 15 : std::max(column - (masks - 1), 0);
  return {(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, (bits & 8) != 0};
}

HazardSet UnitsUnderTest::hazards(int behaviour, const Stimulus& stimulus) const {
  const Behaviour which = behaviour_of(behaviour);
  if (!has_promises(which.unit)) return {};
  HazardSet all = operand_hazards(operands_, stimulus.a);
  if (has_two_operands(which.unit)) include(all, operand_hazards(operands_, stimulus.b));
  if (which.unit == minimum_maximum) return all;

  const Arithmetic unbounded{with_unbounded_exponent(result_),
                             which.toward_zero ? Rounding::toward_zero : Rounding::nearest_even,
                             which.gradual ? Subnormals::gradual : Subnormals::flush};
  const golden::Rounded value = rounded(unbounded, operands_, which, stimulus);
  include(all, result_hazards(result_, unbounded.format, value.bits));
  const bool zero_divisor =
      operands_.is_zero(stimulus.b) || (!which.gradual && operands_.is_subnormal(stimulus.b));
  all.overflow |= which.unit == divide && zero_divisor;
  all.cancellation = (which.unit == add || which.unit == subtract) &&
                     unlike_signs(operands_, stimulus) != (which.unit == subtract) &&
                     !operands_.is_zero(stimulus.a) && !operands_.is_zero(stimulus.b);
  return all;
}

bool UnitsUnderTest::exceptional_by_hazards_alone(int behaviour) const {
  const UnitSlot unit = behaviour_of(behaviour).unit;
  return has_promises(unit) && unit != square_root;
}

std::string UnitsUnderTest::name(int slot) const {
  static constexpr std::array<std::string_view, minimum_maximum> names = {"fp_add",
                                                                          "fp_add SUBTRACT",
                                                                          "fp_multiply",
                                                                          "fp_square",
                                                                          "fp_divide",
                                                                          "fp_square_root",
                                                                          "fp_convert",
                                                                          "fp_multiply EMBEDDED=0",
                                                                          "fp_square EMBEDDED=0"};
  static constexpr std::array<std::string_view, masks> mask_names = {"none", "all", "some"};
  const Behaviour which = behaviour_of(slot / columns);
  const HazardSet promises = promised(slot);
  std::string cuts = fmt::format("CUTS={}", mask_names[std::min(slot % columns, masks - 1)]);
  if (promises.special_operands) cuts += " SPECIAL_OPERANDS=0";
  if (promises.overflow) cuts += " OVERFLOW=0";
  if (promises.underflow) cuts += " UNDERFLOW=0";
  if (promises.cancellation) cuts += " CANCELLATION=0";
  if (which.unit == ulp_distance || which.unit == ulp_distance_wide) {
    return fmt::format("fp_ulp_distance GUARD_ULP=0x{} NONNEGATIVE={:d} {}",
                       to_hex(guard_of(operands_, which), operands_.width()), which.gradual, cuts);
  }
  if (which.unit == comparison && which.toward_zero) return "fp_interval_decision " + cuts;
  if (which.unit == comparison)
    return fmt::format("fp_compare GRADUAL={:d} {}", which.gradual, cuts);
  if (which.unit == minimum_maximum) {
    return fmt::format("fp_minimum_maximum MAXIMUM={:d} GRADUAL={:d} {}", which.toward_zero,
                       which.gradual, cuts);
  }
  return fmt::format("{} GRADUAL={:d} TOWARD_ZERO={:d} {}", names[which.unit], which.gradual,
                     which.toward_zero, cuts);
}

FloatFormat UnitsUnderTest::format(int slot) const {
  return slot / columns / variants < minimum_maximum ? result_ : operands_;
}

}  // namespace mixcmp::test
