// The code that reads the Verilated model, and nothing else, since this source is compiled for each
// pair of formats. Usage: PROGRAM exhaustive | special | neighbours COUNT SEED | random COUNT SEED
// | pair A B [FLAG]
//        PROGRAM write FOLDER COUNT SEED: vectors and their answers for fp_units_tb.v
#include "Vfp_units.h"
#include "Vfp_units___024root.h"
#include "tests/rtl_templates/fp/units_program.hpp"

namespace mixcmp::test::fp_units_test {
namespace {

class VerilatedUnits : public Simulation {
public:
  VerilatedUnits() : model_(&context_) {
    model_.aclk = 0;
    model_.eval();
  }

  void apply(const Stimulus& stimulus) override {
    for (int i = 0; i < 4; ++i) {
      model_.a[i] = static_cast<uint32_t>(stimulus.a >> (32 * i));
      model_.b[i] = static_cast<uint32_t>(stimulus.b >> (32 * i));
    }
    model_.exceptional = stimulus.exceptional;
    model_.aclk = 0;
    model_.eval();
  }

  Bits y(int slot) const override {
    Bits value = 0;
    for (int i = 3; i >= 0; --i) value = value << 32 | model_.rootp->fp_units__DOT__y[slot][i];
    return value;
  }

  bool flag(int slot) const override { return model_.rootp->fp_units__DOT__flag[slot] != 0; }

  void rise() override {
    model_.aclk = 1;
    model_.eval();
  }

private:
  VerilatedContext context_;
  Vfp_units model_;
};

}  // namespace
}  // namespace mixcmp::test::fp_units_test

int main(int argc, char** argv) {
  mixcmp::test::fp_units_test::VerilatedUnits simulation;
  return mixcmp::test::run_units({.precision = PRECISION,
                                  .exponent_bits = EXPONENT_BITS,
                                  .result_precision = RESULT_PRECISION,
                                  .result_exponent_bits = RESULT_EXPONENT_BITS,
                                  .some_cuts = SOME_CUTS,
                                  .first_column = FIRST_COLUMN,
                                  .last_column = LAST_COLUMN},
                                 simulation, argc, argv);
}
