#pragma once

#include <cstdint>

#include "model/base/common/bits.hpp"

namespace mixcmp::test {

/// The inputs of every unit of fp_units.v in one cycle.
struct Stimulus {
  Bits a;
  Bits b;
  bool exceptional = false;  ///< read only by fp_ulp_distance
};

/// The simulated fp_units: one clock cycle at a time.
class Simulation {
public:
  virtual ~Simulation() = default;
  /// Sets the inputs and settles; the outputs are then those before the rising edge.
  virtual void apply(const Stimulus& stimulus) = 0;
  virtual Bits y(int slot) const = 0;
  virtual bool flag(int slot) const = 0;
  virtual void rise() = 0;
};

/// The units that a program was built with, as the model's parameters have them.
struct BuiltUnits {
  int precision, exponent_bits;                ///< the operands'
  int result_precision, result_exponent_bits;  ///< the results'
  const char* some_cuts;                       ///< in hexadecimal: the mask between none and all
  int first_column, last_column;               ///< columns of UnitsUnderTest
};

/// Feeds the vectors that the command line names and compares every answer. Returns the exit code.
int run_units(const BuiltUnits& built, Simulation& simulation, int argc, char** argv);

}  // namespace mixcmp::test
