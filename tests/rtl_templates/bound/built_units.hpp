#pragma once

#include "model/base/common/bits.hpp"

/// The interface of the tests, which are compiled once, to the model of one format.
namespace mixcmp::test {

/// The inputs of every unit of bound_units.v in one cycle: a lane's number and two bounds.
struct Stimulus {
  Bits x = 0;
  Bits a = 0;
  Bits b = 0;
  bool exceptional = false;
};

/// The simulated bound_units: one clock cycle at a time.
class BoundSimulation {
public:
  virtual ~BoundSimulation() = default;
  /// Sets the inputs and settles; the outputs are then those before the rising edge.
  virtual void apply(const Stimulus& stimulus) = 0;
  virtual Bits y(int slot) const = 0;
  virtual void rise() = 0;
};

/// The parameters with which the units were built.
struct BuiltUnits {
  int precision, exponent_bits;  ///< the lane's
  int bound_precision;           ///< digits of a bound
};

BuiltUnits built_units();
BoundSimulation& simulation();

}  // namespace mixcmp::test
