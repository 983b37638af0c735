#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "model/base/number/decimal.hpp"
#include "model/judge/golden/fixed_evaluate.hpp"
#include "tests/support/bounded_comparisons.hpp"
#include "tests/support/float_samples.hpp"

/// Tests that a fixed-point lane decides as the real numbers do, on every operand tuple of small
/// formats. The judge is exact rationals or, with roots, intervals of as many digits as are needed.
namespace mixcmp::test::soundness_test {
namespace {

using golden::LaneResult;

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
    case Operation::divide: return operand(0) / operand(1);
    case Operation::minimum: return std::min<mpq_class>(operand(0), operand(1));
    case Operation::maximum: return std::max<mpq_class>(operand(0), operand(1));
    default: ADD_FAILURE() << to_string(node.operation); return 0;
  }
}

bool has_roots(const Graph& graph) {
  return std::any_of(graph.nodes().begin(), graph.nodes().end(),
                     [](const Node& node) { return node.operation == Operation::square_root; });
}

Verdict exact_verdict(const Graph& graph, const std::vector<mpq_class>& inputs) {
  const mpq_class f = exact_value(graph, graph.f(), inputs);
  const mpq_class g = exact_value(graph, graph.g(), inputs);
  return f < g ? Verdict::less : f > g ? Verdict::greater : Verdict::equal;
}

std::vector<Bits> unpack(Bits index, FloatFormat format, std::size_t count) {
  std::vector<Bits> inputs(count);
  for (std::size_t k = 0; k < count; ++k) {
    inputs[k] = index >> (k * static_cast<std::size_t>(format.width())) & low_mask(format.width());
  }
  return inputs;
}

/// The operands' values; none if one is infinite or a NaN.
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

const std::vector<FixedPoint> formats_with_guards = {
    {1, false, 1}, {1, false, 5}, {2, false, 3}, {3, false, 1}, {4, false, 4},
    {1, true, 1},  {1, true, 4},  {2, true, 2},  {3, true, 6},  {5, true, 1}};

class EveryTupleInFixedPoint : public testing::TestWithParam<BoundedComparison> {};

TEST_P(EveryTupleInFixedPoint, IsDecidedAsTheRealNumbersAre) {
  const Graph graph = GetParam().graph();
  const bool roots = has_roots(graph);
  const std::size_t count = graph.inputs().size();
  const FloatFormat format = count <= 2 ? format_of(4, 4) : MIXCMP_TRIPLE_FORMAT;
  const std::vector<int> widths = {1, 2, 3, 4, 5, 6};
  std::vector<NamedFixedLane> lanes = fixed_lanes(GetParam(), format, widths);
  for (NamedFixedLane& lane : block_lanes(GetParam(), format, widths)) {
    lanes.push_back(std::move(lane));
  }
  for (NamedFixedLane& lane : guarded_lanes(GetParam(), format, formats_with_guards)) {
    lanes.push_back(std::move(lane));
  }
  for (NamedFixedLane& lane : grid_lanes(GetParam(), format, {2, 4, 6})) {
    lanes.push_back(std::move(lane));
  }
  std::vector<std::uint64_t> decided(lanes.size(), 0);
  const Bits end = Bits{1} << (count * static_cast<std::size_t>(format.width()));
  for (Bits index = 0; index < end && !HasFailure(); ++index) {
    const std::vector<Bits> inputs = unpack(index, format, count);
    const auto values = values_of(format, inputs);
    std::optional<Verdict> truth;  // computed once a lane decides
    for (std::size_t k = 0; k < lanes.size(); ++k) {
      const auto& [name, lane] = lanes[k];
      const LaneResult result = golden::evaluate_lane(lane, inputs);
      if (!result.decided) continue;
      ++decided[k];
      ASSERT_TRUE(values) << name << " decides" << describe(format, inputs);
      if (!truth) {
        truth = roots ? golden::true_verdict(graph, format, inputs) : exact_verdict(graph, *values);
      }
      EXPECT_EQ(result.verdict, truth) << name << describe(format, inputs);
    }
  }
  // Lanes of few digits may have an error above every difference.
  std::map<std::string, std::uint64_t> by_bound;
  for (std::size_t k = 0; k < lanes.size(); ++k) {
    by_bound[lanes[k].name.substr(lanes[k].name.find(", "))] += decided[k];
  }
  for (const auto& [bound, number] : by_bound) EXPECT_GT(number, 0u) << "no lane decides" << bound;
}

INSTANTIATE_TEST_SUITE_P(Comparisons, EveryTupleInFixedPoint,
                         testing::ValuesIn(bounded_comparisons()),
                         [](const auto& parameter) { return parameter.param.name; });

/// Otherwise EveryTuple would try none of them.
TEST(GridLanes, ExistForManyOfTheComparisons) {
  int comparisons = 0;
  for (const BoundedComparison& comparison : bounded_comparisons()) {
    comparisons += grid_lanes(comparison, format_of(4, 4), {6}).empty() ? 0 : 1;
  }
  EXPECT_GE(comparisons, 20);
}

}  // namespace
}  // namespace mixcmp::test::soundness_test
