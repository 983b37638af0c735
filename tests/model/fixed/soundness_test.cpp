#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <optional>

#include "model/golden/fixed_evaluate.hpp"
#include "model/number/decimal.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/graphs.hpp"

/// A fixed-point lane decides as the real numbers do: every operand tuple of small formats, against
/// exact rationals.
namespace mixcmp::test {
namespace {

using fixed::FixedBound;
using fixed::FixedLane;
using golden::LaneResult;

struct Comparison {
  const char* name;
  const char* f;
  const char* g;
  Range range;                           ///< of every input but c
  std::optional<Range> of_c{};           ///< none: `range`
  std::optional<bool> has_norm = false;  ///< none: at some widths
};

void PrintTo(const Comparison& comparison, std::ostream* stream) {
  *stream << comparison.f << " against " << comparison.g;
}

mpq_class exact_value(const Graph& graph, NodeId id, const std::vector<mpq_class>& inputs) {
  const Node& node = graph.nodes()[id];
  const auto operand = [&](int k) { return exact_value(graph, node.operands[k], inputs); };
  switch (node.operation) {
    case Operation::input: return inputs[node.input];
    case Operation::constant: return node.value;
    case Operation::negate: return -operand(0);
    case Operation::absolute: return abs(operand(0));
    case Operation::add: return operand(0) + operand(1);
    case Operation::subtract: return operand(0) - operand(1);
    case Operation::multiply: return operand(0) * operand(1);
    case Operation::square: return operand(0) * operand(0);
    case Operation::minimum: return std::min<mpq_class>(operand(0), operand(1));
    case Operation::maximum: return std::max<mpq_class>(operand(0), operand(1));
    default: ADD_FAILURE() << to_string(node.operation); return 0;
  }
}

Verdict exact_verdict(const Graph& graph, const std::vector<mpq_class>& inputs) {
  const mpq_class f = exact_value(graph, graph.f(), inputs);
  const mpq_class g = exact_value(graph, graph.g(), inputs);
  return f < g ? Verdict::less : f > g ? Verdict::greater : Verdict::equal;
}

/// The lanes of a comparison, by their descriptions.
std::vector<std::pair<std::string, FixedLane>> lanes_of(const Comparison& comparison,
                                                        const Graph& graph, FloatFormat format) {
  std::vector<std::optional<Range>> ranges;
  for (const std::string& input : graph.inputs()) {
    ranges.push_back(input == "c" && comparison.of_c ? *comparison.of_c : comparison.range);
  }
  std::vector<std::pair<std::string, FixedLane>> lanes;
  for (int bits = 1; bits <= 6; ++bits) {
    for (const FixedBound bound : {FixedBound::constant, FixedBound::norm}) {
      const auto lane =
          fixed::fixed_lane(graph, format, {.bits = bits, .bound = bound, .ranges = ranges});
      const char* const name = bound == FixedBound::norm ? "norm" : "constant";
      const bool exists = bound == FixedBound::constant || comparison.has_norm.value_or(lane.ok());
      EXPECT_EQ(lane.ok(), exists) << name;
      if (lane.ok()) lanes.emplace_back(fmt::format("q{}, {}", bits, name), *lane);
    }
  }
  return lanes;
}

std::vector<Bits> unpack(Bits index, FloatFormat format, std::size_t count) {
  std::vector<Bits> inputs(count);
  for (std::size_t k = 0; k < count; ++k) {
    inputs[k] = index >> (k * static_cast<std::size_t>(format.width())) & low_mask(format.width());
  }
  return inputs;
}

/// The operands' values; none where one is infinite or a NaN.
std::optional<std::vector<mpq_class>> values_of(FloatFormat format,
                                                const std::vector<Bits>& inputs) {
  std::vector<mpq_class> values;
  for (const Bits input : inputs) {
    if (format.is_nan(input) || format.is_infinite(input)) return std::nullopt;
    values.push_back(golden::to_rational(format, input));
  }
  return values;
}

std::string describe(FloatFormat format, const std::vector<Bits>& inputs) {
  std::string text;
  for (const Bits input : inputs) text += " " + to_text(format, input);
  return text;
}

class EveryTupleInFixedPoint : public testing::TestWithParam<Comparison> {};

TEST_P(EveryTupleInFixedPoint, IsDecidedAsTheRealNumbersAre) {
  const Graph graph = graph_of(GetParam().f, GetParam().g);
  const std::size_t count = graph.inputs().size();
  const FloatFormat format = count <= 2 ? format_of(4, 4) : MIXCMP_TRIPLE_FORMAT;
  const auto lanes = lanes_of(GetParam(), graph, format);
  std::vector<std::uint64_t> decided(lanes.size(), 0);
  const Bits end = Bits{1} << (count * static_cast<std::size_t>(format.width()));
  for (Bits index = 0; index < end && !HasFailure(); ++index) {
    const std::vector<Bits> inputs = unpack(index, format, count);
    const auto values = values_of(format, inputs);
    for (std::size_t k = 0; k < lanes.size(); ++k) {
      const auto& [name, lane] = lanes[k];
      const LaneResult result = golden::evaluate_lane(lane, inputs);
      if (!result.decided) continue;
      ++decided[k];
      ASSERT_TRUE(values) << name << " decides" << describe(format, inputs);
      EXPECT_EQ(result.verdict, exact_verdict(graph, *values)) << name << describe(format, inputs);
    }
  }
  EXPECT_GT(decided.back(), 0u);
}

INSTANTIATE_TEST_SUITE_P(
    Comparisons, EveryTupleInFixedPoint,
    testing::Values(
        Comparison{"inputs", "a", "b", {0, 4}}, Comparison{"signed_inputs", "a", "b", {-3, 4}},
        Comparison{"constant", "a", "0.3", {0, 1}}, Comparison{"negative", "-a", "-2.5", {0, 3}},
        Comparison{"scaled", "0.3 * a", "b", {0, 3}},
        Comparison{"squares", "a^2", "b^2", {0, 3}, {}, true},
        Comparison{"signed_squares", "a^2", "b^2", {-3, 3}, {}, true},
        Comparison{"distance", "(a - b)^2", "c^2", {0, 3}, {}, true},
        Comparison{"swapped_distance", "c^2", "(a - b)^2", {0, 3}, {}, true},
        Comparison{"signed_distance", "(a - b)^2", "c^2", {-3, 3}, Range{0, 5}, true},
        Comparison{"two_terms", "a^2 + b^2", "c^2", {-2, 2}, Range{0, 3}, true},
        Comparison{"two_radii", "a^2", "(b + c)^2", {0, 3}, Range{0, 6}, true},
        Comparison{"hypotenuse", "a^2 + b^2", "c^2", {0, 6}, {}, true},
        Comparison{"absolute_radius", "a^2", "abs(b - c)^2", {0, 3}, {}, true},
        Comparison{"radius_of_either_sign", "a^2", "(1.3 - b)^2", {0, mpq_class(19, 10)}, {}, true},
        Comparison{"two_norms", "(a - b)^2", "(a - c)^2 + b^2", {0, 3}, {}, true},
        Comparison{"nearer_of_two", "(a - b)^2 + b^2", "(a - c)^2 + c^2", {-3, 3}, {}, true},
        Comparison{"radius_of_two_signs", "a^2", "(b - c)^2", {0, 3}, {}, true},
        Comparison{
            "radius_much_finer", "a^2 + b^2", "c^2", {0, 3}, Range{0, mpq_class(1, 16)}, true},
        Comparison{
            "radius_much_coarser", "(a - b)^2", "c^2", {0, mpq_class(1, 8)}, Range{0, 6}, true},
        Comparison{"against_a_constant", "a^2 + b^2", "2", {-2, 2}},
        Comparison{"rectangle", "a * b", "c", {0, 3}, Range{0, 9}},
        Comparison{"signed_product", "a * b", "c", {-3, 3}},
        Comparison{"absolute", "abs(a - b)", "c", {0, 3}},
        Comparison{"absolute_of_signed", "abs(a)", "abs(b)", {-6, 3}},
        Comparison{"taxi", "abs(a - 1) + abs(b - 1)", "c", {0, 3}},
        Comparison{"minimum", "min(a, b)", "c", {-3, 3}},
        Comparison{"maximum", "max(a^2, b)", "abs(c)", {-3, 3}},
        Comparison{"cancelling_squares", "a^2 - b^2", "c", {0, 3}},
        Comparison{"cube", "a^3", "b", {-2, 2}}, Comparison{"eighth", "a^8", "b", {0, 2}},
        Comparison{"polynomial", "a^3 - 3 * a * b", "b", {-3, 3}},
        Comparison{"scales", "a - c / 1024", "b", {0, 3}, Range{0, 3000}},
        Comparison{"tiny_range", "a", "b", {0, mpq_class(1, 16)}},
        Comparison{"itself", "a - a", "b - b", {0, 3}},
        Comparison{"clamped", "min(max(a - b, 0), 1)", "c", {0, 3}},
        Comparison{"norms", "a^2 + b^2", "(c + 0.7)^2", {-2, 2}, Range{0, 3}, true}),
    [](const auto& parameter) { return parameter.param.name; });

}  // namespace
}  // namespace mixcmp::test
