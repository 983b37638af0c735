#pragma once

#include <array>
#include <string>

#include "generator/hardware/datapath/units.hpp"
#include "model/base/number/float_format.hpp"
#include "tests/rtl_templates/fp/units_program.hpp"

namespace mixcmp::test {

/// A set of hazards (rtl_templates/fp/README.md): those that a unit was promised not to meet, or
/// those of a stimulus.
struct HazardSet {
  bool special_operands = false;
  bool overflow = false;
  bool underflow = false;
  bool cancellation = false;

  bool meets(const HazardSet& other) const {
    return (special_operands && other.special_operands) || (overflow && other.overflow) ||
           (underflow && other.underflow) || (cancellation && other.cancellation);
  }
  friend bool operator==(const HazardSet&, const HazardSet&) = default;
};

/// The answer that one unit must give. A verdict that was not decided may be anything.
struct Answer {
  Bits y = 0;
  bool flag = false;  ///< exceptional, or decided
  bool y_matters = true;
  bool flag_matters = true;
};

/// The outputs of fp_units.v: the meaning of each slot, its latency and the answer that it must
/// give. A slot is (unit, variant, column), the column counting fastest; a behaviour is a slot
/// without its column. The first columns differ in their masks, the others in their promises.
class UnitsUnderTest {
public:
  static constexpr int masks = 3, columns = masks + 9, variants = 4, units = 13;
  static constexpr int behaviours = units * variants, slots = behaviours * columns;

  /// `some_cuts` is the mask between none and all.
  UnitsUnderTest(FloatFormat operands, FloatFormat result, Bits some_cuts);

  FloatFormat operands() const { return operands_; }
  FloatFormat result() const { return result_; }

  int latency_cycles(int slot) const { return latencies_[slot]; }
  int max_latency_cycles() const;
  /// The right answer, if no promise is broken.
  Answer answer(int behaviour, const Stimulus& stimulus) const;
  HazardSet promised(int slot) const;
  HazardSet hazards(int behaviour, const Stimulus& stimulus) const;
  /// Whether `exceptional` can be caused only by hazards. The root of a negative number is the only
  /// exceptional case without a hazard.
  bool exceptional_by_hazards_alone(int behaviour) const;
  std::string name(int slot) const;
  /// The format of a slot's answers: the result's, or the operands' if the unit has no result
  /// format.
  FloatFormat format(int slot) const;

private:
  int stage_count(int behaviour) const;

  FloatFormat operands_;
  FloatFormat result_;
  std::array<int, slots> latencies_;
};

}  // namespace mixcmp::test
