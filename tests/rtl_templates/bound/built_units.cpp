// The code that reads the Verilated model, and nothing else, since this source is compiled for each
// format.
#include "tests/rtl_templates/bound/built_units.hpp"

#include "Vbound_units.h"
#include "Vbound_units___024root.h"

namespace mixcmp::test {
namespace {

class VerilatedUnits : public BoundSimulation {
public:
  VerilatedUnits() : units_(&context_) {
    units_.aclk = 0;
    units_.eval();
  }

  void apply(const Stimulus& stimulus) override {
    units_.x = static_cast<std::uint64_t>(stimulus.x);
    units_.a = static_cast<std::uint64_t>(stimulus.a);
    units_.b = static_cast<std::uint64_t>(stimulus.b);
    units_.exceptional = stimulus.exceptional;
    units_.aclk = 0;
    units_.eval();
  }

  Bits y(int slot) const override { return units_.rootp->bound_units__DOT__y[slot]; }

  void rise() override {
    units_.aclk = 1;
    units_.eval();
  }

private:
  VerilatedContext context_;
  Vbound_units units_;
};

}  // namespace

BuiltUnits built_units() {
  return {PRECISION, EXPONENT_BITS, BOUND_PRECISION};
}

BoundSimulation& simulation() {
  static VerilatedUnits units;
  return units;
}

}  // namespace mixcmp::test
