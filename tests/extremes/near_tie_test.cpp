#include "model/comparison/data/near_tie.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "model/base/number/exact.hpp"
#include "model/base/number/verdict.hpp"
#include "model/judge/golden/evaluate.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/sphere.hpp"

/// The search for misleading pairs, held against the golden model.
namespace mixcmp::test::near_tie_test {
namespace {

using data::NearTie;
using data::NearTieShape;
using data::NearTieTarget;

struct Case {
  int precision;
  LaneInputs inputs;
  Rounding rounding;
  double least_contradiction_ulp;  ///< of the best in 200 rows
  NearTieShape shape = NearTieShape::along_axis;
};

void PrintTo(const Case& c, std::ostream* stream) {
  *stream << (c.shape == NearTieShape::diagonal ? "diagonal_" : "") << "s" << c.precision << "_"
          << to_string(c.inputs) << "_" << to_string(c.rounding);
}

class NearTies : public testing::TestWithParam<Case> {
protected:
  const FloatFormat reference_ = format("s53e8");
  const Graph graph_ = sphere_graph();

  NearTieTarget target() const {
    return {GetParam().precision, GetParam().inputs, GetParam().rounding, GetParam().shape,
            reference_};
  }
  TypedGraph lane() const {
    const Arithmetic reduced = {format_of(GetParam().precision, 8), GetParam().rounding,
                                Subnormals::flush};
    return lane_graph(graph_, reference_, reduced, GetParam().inputs);
  }
  static NearTie tie_of_row(const NearTieTarget& target, std::uint64_t row) {
    data::RowRandom random(1, 0, row);
    return near_tie(target, {.attempts = 32, .enough_ulp = 100}, random);
  }
  std::vector<Bits> encode(const data::DyadicPair& pair) const {
    std::vector<Bits> operands;
    for (const mpz_class& number : pair.numbers) {
      mpq_class value = number;
      mpq_div_2exp(value.get_mpq_t(), value.get_mpq_t(), static_cast<mp_bitcnt_t>(-pair.exponent));
      operands.push_back(from_rational(reference_, value));
      EXPECT_EQ(to_rational(reference_, operands.back()), value);
    }
    return operands;
  }
};

TEST_P(NearTies, DeceiveTheGoldenModelAsFarAsTheyClaim) {
  const TypedGraph typed = lane();
  const FloatFormat reduced = typed.arithmetic.format;
  for (std::uint64_t row = 0; row < 100; ++row) {
    const NearTie tie = tie_of_row(target(), row);
    const std::vector<Bits> operands = encode(tie.pair);
    const auto values = golden::evaluate(typed, operands);
    const mpq_class f = to_rational(reduced, values[typed.f()].bits);
    const mpq_class g = to_rational(reduced, values[typed.g()].bits);
    const mpq_class difference = (f - g) / std::max(f, g);
    const double computed_ulp = std::ldexp(difference.get_d(), GetParam().precision);
    const Verdict truth = golden::true_verdict(graph_, reference_, operands).value();
    ASSERT_NE(truth, Verdict::equal);
    EXPECT_NEAR(truth == Verdict::less ? computed_ulp : -computed_ulp, tie.contradiction_ulp, 1e-9)
        << row;
  }
}

TEST_P(NearTies, ComeCloseToWhatIsProven) {
  double most = 0;
  for (std::uint64_t row = 0; row < 200; ++row) {
    most = std::max(most, tie_of_row(target(), row).contradiction_ulp);
  }
  EXPECT_GT(most, GetParam().least_contradiction_ulp);
  if (GetParam().inputs == LaneInputs::exact) {
    EXPECT_LT(most, GetParam().rounding == Rounding::nearest_even ? 8 : 10);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Lanes, NearTies,
    testing::Values(Case{6, LaneInputs::exact, Rounding::nearest_even, 5},
                    Case{11, LaneInputs::exact, Rounding::nearest_even, 7.3},
                    Case{17, LaneInputs::exact, Rounding::nearest_even, 7.8},
                    Case{24, LaneInputs::exact, Rounding::nearest_even, 7.9},
                    Case{40, LaneInputs::exact, Rounding::nearest_even, 7.9},
                    Case{52, LaneInputs::exact, Rounding::nearest_even, 7.9},
                    Case{6, LaneInputs::exact, Rounding::toward_zero, 5},
                    Case{11, LaneInputs::exact, Rounding::toward_zero, 8},
                    Case{17, LaneInputs::exact, Rounding::toward_zero, 9},
                    Case{24, LaneInputs::exact, Rounding::toward_zero, 9},
                    Case{40, LaneInputs::exact, Rounding::toward_zero, 9},
                    Case{17, LaneInputs::exact, Rounding::nearest_even, 4.9,
                         NearTieShape::diagonal},
                    Case{24, LaneInputs::exact, Rounding::toward_zero, 5.9, NearTieShape::diagonal},
                    Case{17, LaneInputs::rounded, Rounding::nearest_even, 40},
                    Case{17, LaneInputs::rounded, Rounding::toward_zero, 40},
                    Case{17, LaneInputs::of_digits(20), Rounding::nearest_even, 5},
                    Case{17, LaneInputs::of_digits(20), Rounding::toward_zero, 5}),
    testing::PrintToStringParamName());

}  // namespace
}  // namespace mixcmp::test::near_tie_test
