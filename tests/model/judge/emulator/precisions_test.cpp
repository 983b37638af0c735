#include <gtest/gtest.h>

#include "model/lane/error/certified_lane.hpp"
#include "tests/model/judge/emulator/against_golden.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/sphere.hpp"
#include "tests/support/sphere_families.hpp"

/// Tests the sphere comparison at every precision, on families that were made to be hard.
namespace mixcmp::test::precisions_test {
namespace {

using error::Lane;

Operands operands_of(const data::Table& table) {
  Operands operands(table.columns.size());
  for (std::size_t row = 0; row < table.rows(); ++row) {
    for (std::size_t column = 0; column < operands.size(); ++column) {
      const Bits bits = table.at(row, column);
      operands[column].push_back(table.format.is_nan(bits) ? table.format.quiet_nan() : bits);
    }
  }
  return operands;
}

/// One set of operands for all families, in an order that leaves blocks of one kind.
Operands every_family(FloatFormat reference, int lane_precision) {
  Operands all(8);
  for (const SphereFamily& family : sphere_families(reference, lane_precision, 24, 7)) {
    const Operands operands = operands_of(family.pairs);
    for (std::size_t column = 0; column < all.size(); ++column) {
      all[column].insert(all[column].end(), operands[column].begin(), operands[column].end());
    }
  }
  return all;
}

Lane sphere_lane(FloatFormat reference, Arithmetic reduced, LaneInputs inputs, int bound_digits) {
  TypedGraph graph = lane_graph(sphere_graph(), reference, reduced, inputs);
  const bool relative = inputs == LaneInputs::exact;
  return error::certified_lane(graph, {.kind = relative ? BoundKind::relative : BoundKind::running,
                                       .bound_digits = bound_digits})
      .value();
}

class SpherePrecisions : public testing::TestWithParam<int> {};

TEST_P(SpherePrecisions, EveryFamilyIsEmulatedBitForBit) {
  const int digits = GetParam();
  for (const char* name : {"s53e8", "s53e11"}) {
    const FloatFormat reference = format(name);
    const Operands operands = every_family(reference, digits);
    for (const Arithmetic& reduced :
         every_arithmetic(format_of(digits, reference.exponent_bits()))) {
      expect_golden(sphere_lane(reference, reduced, LaneInputs::exact, 1), operands);
      expect_golden(sphere_lane(reference, reduced, LaneInputs::rounded, 1), operands);
      expect_golden(sphere_lane(reference, reduced, LaneInputs::rounded, 4), operands);
      if (HasFailure()) return;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Digits, SpherePrecisions, testing::Range(4, 53));

class SphereReferences : public testing::TestWithParam<const char*> {};

TEST_P(SphereReferences, EveryFamilyIsEmulatedBitForBit) {
  const FloatFormat reference = format(GetParam());
  for (const Arithmetic& arithmetic : every_arithmetic(reference)) {
    expect_golden(reference_graph(sphere_graph(), arithmetic), every_family(reference, 17));
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, SphereReferences,
                         testing::Values("s53e8", "s53e11", "s24e8", "s11e5", "s24e11", "s53e5"));

}  // namespace
}  // namespace mixcmp::test::precisions_test
