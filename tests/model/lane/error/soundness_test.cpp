#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <optional>

#include "model/base/number/decimal.hpp"
#include "model/base/number/verdict.hpp"
#include "model/judge/golden/evaluate.hpp"
#include "model/lane/error/certified_lane.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/graphs.hpp"
#include "tests/support/lane_inputs.hpp"

/// Tests that a certified lane decides as the real numbers do, on every operand tuple of small
/// formats.
namespace mixcmp::test::soundness_test {
namespace {

using error::Lane;
using golden::evaluate_lane;
using golden::LaneResult;
using golden::true_verdict;

struct Comparison {
  const char* name;
  const char* f;
  const char* g;
  std::optional<Range> range = {};  ///< the range of every input; many operand tuples break it
};

void PrintTo(const Comparison& comparison, std::ostream* stream) {
  *stream << comparison.f << " against " << comparison.g;
}

std::string describe(const Comparison& comparison, const Lane& lane, FloatFormat format,
                     const std::vector<Bits>& inputs) {
  const Arithmetic& arithmetic = lane.graph.arithmetic;
  std::string text = fmt::format("{} against {} in {} {} {}, {}:", comparison.f, comparison.g,
                                 arithmetic.format.name(), to_string(arithmetic.rounding),
                                 to_string(arithmetic.subnormals), describe_criterion(lane));
  for (const Bits input : inputs) text += " " + to_text(format, input);
  return text;
}

/// The certifiable lanes of a comparison: every kind of bound, in several formats, roundings and
/// ways to take inputs.
std::vector<Lane> lanes_of(const Graph& graph, FloatFormat reference, std::optional<Range> range) {
  const std::vector<std::optional<Range>> ranges(graph.inputs().size(), range);
  std::vector<Lane> lanes;
  for (const FloatFormat format : {format_of(2, 4), format_of(4, 5)}) {
    for (const Arithmetic& arithmetic : every_arithmetic(format)) {
      for (const LaneInputs inputs : all_inputs(format.precision())) {
        const auto typed = lane_graph(graph, reference, arithmetic, inputs);
        for (error::CandidateLane& candidate : error::candidate_lanes(typed, ranges)) {
          if (candidate.lane.ok()) lanes.push_back(*candidate.lane);
        }
      }
    }
  }
  return lanes;
}

std::vector<Bits> unpack(Bits index, FloatFormat format, size_t count) {
  std::vector<Bits> inputs(count);
  for (size_t k = 0; k < count; ++k) {
    inputs[k] = index >> (k * static_cast<size_t>(format.width())) & low_mask(format.width());
  }
  return inputs;
}

/// Compares every lane's decisions with the truth, on all tuples of `reference` encodings.
void judge(const Comparison& comparison, FloatFormat reference) {
  const Graph graph = graph_of(comparison.f, comparison.g);
  const size_t count = graph.inputs().size();
  const std::vector<Lane> lanes = lanes_of(graph, reference, comparison.range);
  ASSERT_GE(lanes.size(), 32u) << "every format, running bounds of both kinds at least";
  std::vector<std::uint64_t> decided(lanes.size(), 0);
  const Bits end = Bits{1} << (count * static_cast<size_t>(reference.width()));
  for (Bits index = 0; index < end && !testing::Test::HasFailure(); ++index) {
    const std::vector<Bits> inputs = unpack(index, reference, count);
    const Verdict truth = true_verdict(graph, reference, inputs).value();
    for (size_t k = 0; k < lanes.size(); ++k) {
      const LaneResult result = evaluate_lane(lanes[k], inputs);
      decided[k] += result.decided ? 1 : 0;
      if (!result.decided || result.verdict == truth) continue;
      ADD_FAILURE() << describe(comparison, lanes[k], reference, inputs) << "; truth "
                    << to_string(truth) << ", decided " << to_string(result.verdict);
    }
  }
  for (size_t k = 0; k < lanes.size(); ++k) {
    // A bound of few digits may exceed every difference that a lane of these digits can tell.
    const bool is_able =
        std::holds_alternative<error::UlpDistanceCriterion>(lanes[k].criterion()) ||
        lanes[k].graph.arithmetic.format.precision() > 3;
    if (is_able) {
      EXPECT_GT(decided[k], 0u) << describe(comparison, lanes[k], reference, {});
    }
  }
}

class EveryTuple : public testing::TestWithParam<Comparison> {};

TEST_P(EveryTuple, IsDecidedAsTheRealNumbersAre) {
  const size_t count = graph_of(GetParam().f, GetParam().g).inputs().size();
  judge(GetParam(), count <= 2 ? MIXCMP_PAIR_FORMAT : MIXCMP_TRIPLE_FORMAT);
}

std::string name_of(const testing::TestParamInfo<Comparison>& parameter) {
  return parameter.param.name;
}

INSTANTIATE_TEST_SUITE_P(
    Comparisons, EveryTuple,
    testing::Values(
        Comparison{"inputs", "a", "b"}, Comparison{"constant", "a", "0.3"},
        Comparison{"squares", "a^2", "b^2"}, Comparison{"root", "sqrt(a)", "b"},
        Comparison{"scaled", "0.3 * a", "b"}, Comparison{"doubled", "2 * a", "b / 4"},
        Comparison{"cube", "a^3", "b"}, Comparison{"cancelling", "a - b", "a / 3"},
        Comparison{"apart", "(a - b)^2", "abs(b)"},
        Comparison{"doubled_product", "2 * (a * b)", "-abs(c)"},
        Comparison{"negative", "-(a^2)", "-abs(b)"}, Comparison{"product", "a * b", "c^2"},
        Comparison{"distance", "(a - b)^2", "c^2"}, Comparison{"difference", "a - b", "c"},
        Comparison{"quotient", "a / b", "c"}, Comparison{"sum", "a + b", "c"},
        Comparison{"sum_in_range", "a + b", "c", Range{0, 6}},
        Comparison{"scaled_sum", "(a + b) * c", "a", Range{mpq_class(1, 4), 3}},
        Comparison{"hypotenuse", "sqrt(a^2 + b^2)", "c"},
        Comparison{"negative_sum", "-(a^2) - b^2", "-c"}, Comparison{"minimum", "min(a, b)", "c"},
        Comparison{"maximum", "max(a^2, b)", "abs(c)"},
        Comparison{"cancelling_squares", "a^2 - b^2", "c"},
        Comparison{"polynomial", "a^3 - 3 * a * b", "b"},
        Comparison{"quotient_of_differences", "(a - b) / (b - c)", "a"},
        Comparison{"root_of_difference", "sqrt(a - b)", "c"},
        Comparison{"root_of_sum", "sqrt((a - b)^2 + c)", "a"},
        Comparison{"clamped", "min(max(a - b, 0), 1)", "c / 3"},
        Comparison{"selected_constant", "min(a, 0.3) - b", "0.1"},
        Comparison{"tiny_constant", "a^2 + 1e-9", "b"},
        Comparison{"differences_in_range", "(a - b)^2", "c^2 / a", Range{1, 5}},
        Comparison{"quotient_in_range", "(a - b) / c", "a / b", Range{-6, -2}},
        Comparison{"mixed_minimum", "min(a * b, c)", "max(a, b / c)"}),
    name_of);

}  // namespace
}  // namespace mixcmp::test::soundness_test
