#include <gtest/gtest.h>

#include <algorithm>

#include "model/judge/golden/arithmetic.hpp"
#include "tests/model/judge/emulator/against_golden.hpp"
#include "tests/model/judge/emulator/hard_operands.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/lane_inputs.hpp"

/// Tests single operations on every operand there is, or on operands that are hard.
namespace mixcmp::test::operations_test {
namespace {

using error::Lane;

constexpr Operation operations[] = {Operation::negate,   Operation::absolute,    Operation::add,
                                    Operation::subtract, Operation::multiply,    Operation::square,
                                    Operation::divide,   Operation::square_root, Operation::minimum,
                                    Operation::maximum};

Lane lane_of(Operation operation, FloatFormat reference, Arithmetic reduced, LaneInputs inputs,
             Bits guard) {
  return error::one_part_lane(lane_graph(graph_of(operation), reference, reduced, inputs),
                              error::UlpDistanceCriterion{guard, false});
}

/// All combinations of `values`.
Operands every_tuple(const std::vector<Bits>& values, int operand_count) {
  Operands operands(static_cast<std::size_t>(operand_count));
  for (const Bits a : values) {
    for (const Bits b : operand_count == 2 ? values : std::vector<Bits>{0}) {
      operands[0].push_back(a);
      if (operand_count == 2) operands[1].push_back(b);
    }
  }
  return operands;
}

std::vector<Bits> every_encoding(FloatFormat format) {
  std::vector<Bits> encodings;
  for (Bits bits = 0; bits < Bits{1} << format.width(); ++bits) encodings.push_back(bits);
  return encodings;
}

/// Special encodings that double also holds.
std::vector<Bits> special_doubles(FloatFormat format) {
  const FloatFormat narrow =
      format_of(std::min(format.precision(), 53), std::min(format.exponent_bits(), 11));
  std::vector<Bits> encodings = special_encodings(narrow);
  for (Bits& bits : encodings) bits = golden::convert({format}, narrow, bits).bits;
  return encodings;
}

struct Formats {
  int precision, exponent_bits, lane_precision, lane_exponent_bits;
};

class SmallFormats : public testing::TestWithParam<Formats> {};

TEST_P(SmallFormats, EveryOperandPairOfEveryOperation) {
  const Formats formats = GetParam();
  const FloatFormat reference = format_of(formats.precision, formats.exponent_bits);
  const FloatFormat lane = format_of(formats.lane_precision, formats.lane_exponent_bits);
  Bits guard = 0;
  for (const Operation operation : operations) {
    const Operands operands = every_tuple(every_encoding(reference), arity(operation));
    for (const Arithmetic& reduced : every_arithmetic(lane)) {
      for (const LaneInputs inputs : all_inputs(lane.precision())) {
        guard = guard == 9 ? 0 : guard + 1;
        expect_golden(lane_of(operation, reference, reduced, inputs, guard), operands);
        if (HasFailure()) return;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, SmallFormats,
                         testing::Values(Formats{3, 4, 3, 3}, Formats{3, 4, 3, 4},
                                         Formats{4, 3, 3, 3}, Formats{4, 3, 3, 4},
                                         Formats{4, 3, 2, 2}, Formats{3, 4, 5, 5}));

/// Tests all pairs of special values and their neighbours. Some formats are as wide as double's.
class SpecialValues : public testing::TestWithParam<Formats> {};

TEST_P(SpecialValues, EveryPairOfEveryOperation) {
  const Formats formats = GetParam();
  const FloatFormat reference = format_of(formats.precision, formats.exponent_bits);
  const FloatFormat lane = format_of(formats.lane_precision, formats.lane_exponent_bits);
  for (const Operation operation : operations) {
    const Operands operands = every_tuple(special_doubles(reference), arity(operation));
    for (const Arithmetic& reduced : every_arithmetic(lane)) {
      for (const LaneInputs inputs : all_inputs(lane.precision())) {
        expect_golden(lane_of(operation, reference, reduced, inputs, 3), operands);
      }
      expect_golden(
          reference_graph(graph_of(operation), {reference, reduced.rounding, reduced.subnormals}),
          operands);
      if (HasFailure()) return;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Formats, SpecialValues,
    testing::Values(Formats{53, 8, 17, 8}, Formats{53, 8, 52, 8}, Formats{53, 11, 24, 11},
                    Formats{53, 11, 52, 11}, Formats{53, 11, 53, 11}, Formats{53, 9, 30, 9},
                    Formats{53, 10, 30, 10}, Formats{24, 8, 17, 8}, Formats{24, 8, 24, 11},
                    Formats{53, 11, 17, 5}, Formats{53, 5, 17, 11}, Formats{53, 2, 2, 2},
                    Formats{113, 15, 17, 8}, Formats{54, 8, 17, 8}, Formats{24, 12, 17, 8}));

/// Tests results half way between two numbers, and next to that: there rounding twice goes wrong.
class HalfWay : public testing::TestWithParam<int> {};

TEST_P(HalfWay, IsRoundedOnce) {
  const int digits = GetParam();
  std::mt19937_64 random(static_cast<unsigned>(digits));
  for (const int reference_digits : {digits, std::min(digits + 1, 53), 53}) {
    const FloatFormat reference = format_of(reference_digits, 8);
    for (const Operation operation : operations) {
      Operands operands(static_cast<std::size_t>(arity(operation)));
      for (int k = 0; k < 600; ++k) {
        const auto [a, b] = hard_operands(operation, reference, digits, random);
        operands[0].push_back(a);
        if (arity(operation) == 2) operands[1].push_back(b);
      }
      for (const Arithmetic& reduced : every_arithmetic(format_of(digits, 8))) {
        if (reduced.subnormals == Subnormals::gradual) continue;
        expect_golden(lane_of(operation, reference, reduced, LaneInputs::exact, 2), operands);
        expect_golden(lane_of(operation, reference, reduced, LaneInputs::rounded, 2), operands);
      }
      if (HasFailure()) return;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Digits, HalfWay, testing::Range(2, 54));

}  // namespace
}  // namespace mixcmp::test::operations_test
