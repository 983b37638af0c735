#include "tests/rtl_templates/bound/bound_units_fixture.hpp"

/// Tests with every operand of formats that are small enough.
namespace mixcmp::test::every_operand_test {
namespace {

TEST_F(BoundUnits, EveryPairOfBounds) {
  const std::vector<Bits> bounds = every_bound(bound);
  for (const Bits a : bounds) {
    for (const Bits b : bounds) feed({.a = a, .b = b});
  }
}

TEST_F(BoundUnits, EveryNumberAgainstEveryBound) {
  for (const Bits a : every_bound(bound)) {
    for (Bits x = 0; x < Bits{1} << lane.width(); ++x) {
      feed({.x = x, .a = a, .exceptional = (x ^ a) % 5 == 0});
    }
  }
}

}  // namespace
}  // namespace mixcmp::test::every_operand_test
