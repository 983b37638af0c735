#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cstdint>

#include "model/error/error_analysis.hpp"
#include "model/golden/evaluate.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/graphs.hpp"

/// A certified lane decides as the real numbers do: every operand tuple of small formats.
namespace mixcmp::test {
namespace {

using model::Bits;
using model::FloatFormat;
using model::Graph;
using model::Lane;
using model::LaneInputs;
using model::golden::evaluate_lane;
using model::golden::LaneResult;
using model::golden::true_verdict;
using model::golden::Verdict;

struct Comparison {
  const char* name;
  const char* f;
  const char* g;
  bool ranges = false;  ///< declares every input non-negative
};

void PrintTo(const Comparison& comparison, std::ostream* stream) {
  *stream << comparison.f << " against " << comparison.g;
}

std::string describe(const Comparison& comparison, const Lane& lane, FloatFormat format,
                     const std::vector<Bits>& inputs) {
  const model::Arithmetic& arithmetic = lane.graph.arithmetic;
  std::string text = fmt::format("{} against {} in {} {} {}, guard {}:", comparison.f, comparison.g,
                                 arithmetic.format.name(), to_string(arithmetic.rounding),
                                 to_string(arithmetic.subnormals),
                                 static_cast<long>(certified_decision(lane).guard_ulp));
  for (const Bits input : inputs) text += " " + model::golden::to_text(format, input);
  return text;
}

/// The certifiable lanes of a comparison, in several formats, roundings and ways to take inputs.
std::vector<Lane> lanes_of(const Graph& graph, FloatFormat reference, bool ranges) {
  const std::vector<bool> nonnegative(graph.inputs().size(), ranges);
  std::vector<Lane> lanes;
  for (const FloatFormat format : {format_of(2, 4), format_of(3, 4), format_of(4, 5)}) {
    for (const model::Arithmetic& arithmetic : every_arithmetic(format)) {
      for (const LaneInputs inputs : {LaneInputs::exact, LaneInputs::rounded}) {
        auto lane = relative_lane(lane_graph(graph, reference, arithmetic, inputs), nonnegative);
        if (lane.ok()) lanes.push_back(std::move(lane).value());
      }
    }
  }
  return lanes;
}

std::vector<Bits> unpack(Bits index, FloatFormat format, size_t count) {
  std::vector<Bits> inputs(count);
  for (size_t k = 0; k < count; ++k) {
    inputs[k] =
        index >> (k * static_cast<size_t>(format.width())) & model::low_mask(format.width());
  }
  return inputs;
}

/// Holds every lane's decisions against the truth, on all tuples of `reference` encodings.
void judge(const Comparison& comparison, FloatFormat reference) {
  const Graph graph = graph_of(comparison.f, comparison.g);
  const size_t count = graph.inputs().size();
  const std::vector<Lane> lanes = lanes_of(graph, reference, comparison.ranges);
  ASSERT_GE(lanes.size(), 12u) << "every format with exact inputs";
  std::vector<std::uint64_t> decided(lanes.size(), 0);
  const Bits end = Bits{1} << (count * static_cast<size_t>(reference.width()));
  for (Bits index = 0; index < end && !testing::Test::HasFailure(); ++index) {
    const std::vector<Bits> inputs = unpack(index, reference, count);
    const Verdict truth = true_verdict(graph, reference, inputs);
    for (size_t k = 0; k < lanes.size(); ++k) {
      const LaneResult result = evaluate_lane(lanes[k], inputs);
      decided[k] += result.decided ? 1 : 0;
      if (!result.decided || result.verdict == truth) continue;
      ADD_FAILURE() << describe(comparison, lanes[k], reference, inputs) << "; truth "
                    << to_string(truth) << ", decided " << to_string(result.verdict);
    }
  }
  for (size_t k = 0; k < lanes.size(); ++k) {
    EXPECT_GT(decided[k], 0u) << describe(comparison, lanes[k], reference, {});
  }
}

class EveryTuple : public testing::TestWithParam<Comparison> {};

TEST_P(EveryTuple, IsDecidedAsTheRealNumbersAre) {
  const size_t count = graph_of(GetParam().f, GetParam().g).inputs().size();
  judge(GetParam(), count <= 2 ? format_of(4, 4) : MIXCMP_TRIPLE_FORMAT);
}

std::string name_of(const testing::TestParamInfo<Comparison>& parameter) {
  return parameter.param.name;
}

INSTANTIATE_TEST_SUITE_P(
    Comparisons, EveryTuple,
    testing::Values(Comparison{"inputs", "a", "b"}, Comparison{"constant", "a", "0.3"},
                    Comparison{"squares", "a^2", "b^2"}, Comparison{"root", "sqrt(a)", "b"},
                    Comparison{"scaled", "0.3 * a", "b"}, Comparison{"doubled", "2 * a", "b / 4"},
                    Comparison{"cube", "a^3", "b"}, Comparison{"negative", "-(a^2)", "-abs(b)"},
                    Comparison{"product", "a * b", "c^2"},
                    Comparison{"distance", "(a - b)^2", "c^2"},
                    Comparison{"difference", "a - b", "c"}, Comparison{"quotient", "a / b", "c"},
                    Comparison{"sum", "a + b", "c"}, Comparison{"sum_in_range", "a + b", "c", true},
                    Comparison{"scaled_sum", "(a + b) * c", "a", true},
                    Comparison{"hypotenuse", "sqrt(a^2 + b^2)", "c"},
                    Comparison{"negative_sum", "-(a^2) - b^2", "-c"},
                    Comparison{"minimum", "min(a, b)", "c"},
                    Comparison{"maximum", "max(a^2, b)", "abs(c)"},
                    Comparison{"mixed_minimum", "min(a * b, c)", "max(a, b / c)"}),
    name_of);

}  // namespace
}  // namespace mixcmp::test
