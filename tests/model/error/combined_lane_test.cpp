#include "model/error/combined_lane.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include "model/golden/evaluate.hpp"
#include "model/number/exact.hpp"
#include "model/number/verdict.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/graphs.hpp"

/// Lanes of several parts: every operand tuple of a small format.
namespace mixcmp::test {
namespace {

using error::CombinedLane;
using error::Lane;
using golden::CombinedResult;
using golden::evaluate_lane;
using golden::LaneResult;
using golden::true_verdict;

using Parts = std::vector<std::pair<std::string, std::string>>;

struct Comparison {
  const char* name;
  Parts parts;
  std::optional<Range> range = {};  ///< of every input; many operand tuples break it
};

void PrintTo(const Comparison& comparison, std::ostream* stream) {
  *stream << comparison.name;
}

std::vector<CombinedLane> lanes_of(const Graph& graph, FloatFormat reference,
                                   std::optional<Range> range) {
  const std::vector<std::optional<Range>> ranges(graph.inputs().size(), range);
  std::vector<CombinedLane> lanes;
  const FloatFormat format = format_of(2, 4);
  const auto add = [&](const Arithmetic& arithmetic, LaneInputs inputs) {
    const CombinedGraph typed = lane_graphs(graph, reference, arithmetic, inputs);
    for (error::CandidateLanes& candidate : error::candidate_lanes(typed, ranges)) {
      if (candidate.lane.ok()) lanes.push_back(std::move(candidate.lane).value());
    }
    lanes.push_back(error::certified_lanes(typed, {.ranges = ranges}).value());
  };
  add({format, Rounding::nearest_even, Subnormals::flush}, LaneInputs::rounded);
  add({format, Rounding::toward_zero, Subnormals::gradual}, LaneInputs::exact);
  return lanes;
}

/// What the parts' own decisions come to, and whether one decided for the others.
struct Expected {
  CombinedResult result;
  bool alone;
};

Expected of_parts(const CombinedLane& lane, const std::vector<Bits>& inputs) {
  const bool all = lane.combination == Combination::all;
  const Verdict decides = all ? Verdict::greater : Verdict::less;
  std::size_t decided = 0;
  bool equal = false, outweighed = false;
  for (const Lane& part : lane.parts) {
    const LaneResult result = evaluate_lane(part, inputs);
    if (!result.decided) continue;
    ++decided;
    equal |= result.verdict == Verdict::equal;
    outweighed |= result.verdict == decides;
  }
  const bool every = decided == lane.parts.size();
  if (outweighed) return {{true, decides}, !every};
  const Verdict rest = all ? Verdict::less : Verdict::greater;
  return {{every, equal ? Verdict::equal : rest}, false};
}

class EveryTuple : public testing::TestWithParam<std::tuple<Comparison, Combination>> {};

TEST_P(EveryTuple, IsDecidedAsThePartsSayAndAsTheRealNumbersAre) {
  const auto& [comparison, combination] = GetParam();
  const Graph graph = graph_of(comparison.parts, combination);
  const FloatFormat format = graph.inputs().size() <= 2 ? format_of(3, 4) : format_of(3, 2);
  const std::vector<CombinedLane> lanes = lanes_of(graph, format, comparison.range);
  const std::size_t count = graph.inputs().size();
  const Bits end = Bits{1} << (count * static_cast<std::size_t>(format.width()));
  std::uint64_t decided = 0, alone = 0;
  for (Bits index = 0; index < end && !HasFailure(); ++index) {
    std::vector<Bits> inputs(count);
    for (std::size_t k = 0; k < count; ++k) {
      inputs[k] =
          index >> (k * static_cast<std::size_t>(format.width())) & low_mask(format.width());
    }
    const Verdict truth = true_verdict(graph, format, inputs).value();
    for (const CombinedLane& lane : lanes) {
      const CombinedResult result = evaluate_lane(lane, inputs);
      const Expected expected = of_parts(lane, inputs);
      EXPECT_EQ(result.decided, expected.result.decided) << describe_decision(lane);
      if (!result.decided) continue;
      ++decided;
      alone += expected.alone ? 1 : 0;
      EXPECT_EQ(to_string(result.verdict), to_string(expected.result.verdict))
          << describe_decision(lane);
      EXPECT_EQ(to_string(result.verdict), to_string(truth)) << describe_decision(lane);
    }
  }
  EXPECT_GT(decided, 0u);
  EXPECT_GT(alone, 0u) << "no part ever decided for the others";
}

INSTANTIATE_TEST_SUITE_P(
    Parts, EveryTuple,
    testing::Combine(
        testing::Values(
            Comparison{"intervals", {{"a", "b"}, {"-b", "a"}}},
            Comparison{"shared", {{"a + b", "1"}, {"(a + b) * a", "b"}, {"a", "0.3"}}},
            Comparison{"kinds", {{"a * b", "c^2"}, {"a - b * c", "b"}, {"b", "c"}}},
            Comparison{"ranges", {{"a + b", "c"}, {"b * c - a", "a"}}, Range{mpq_class(1, 2), 3}},
            Comparison{"boxes", {{"max(a, b)", "c"}, {"max(b, c)", "min(a, 1.5)"}}}),
        testing::Values(Combination::all, Combination::any)),
    [](const auto& instance) {
      return fmt::format("{}_{}", std::get<0>(instance.param).name,
                         to_string(std::get<1>(instance.param)));
    });

const error::Lane& part_of(const CombinedLane& lane, std::size_t part) {
  return lane.parts.at(part);
}

CombinedLane lane_of(const Graph& graph, LaneInputs inputs,
                     const std::vector<std::optional<Range>>& ranges) {
  return error::certified_lanes(lane_graphs(graph, format_of(24, 8), {format_of(8, 8)}, inputs),
                                {.ranges = ranges})
      .value();
}

/// One part's operands out of range, or NaN, keep no other part from deciding for all.
TEST(CombinedLane, APartIsHarmedOnlyByWhatItDependsOn) {
  const Graph graph = graph_of({{"a + b", "a * b"}, {"c + d", "c * d"}}, Combination::all);
  const CombinedLane lane =
      lane_of(graph, LaneInputs::exact, std::vector<std::optional<Range>>(4, Range{1, 16}));
  EXPECT_EQ(part_of(lane, 0).checks.size(), 2u);
  EXPECT_EQ(part_of(lane, 1).checks.size(), 2u);
  const FloatFormat format = format_of(24, 8);
  const auto number = [&](int value) { return from_rational(format, mpq_class(value)); };
  const Bits nan = format.quiet_nan(), far = number(1000);
  // 2 + 2 > 1 * ... : part 0 is greater where a = b = 1, part 1 says nothing.
  for (const Bits bad : {nan, far, format.infinity(true)}) {
    const CombinedResult result =
        evaluate_lane(lane, std::vector<Bits>{number(1), number(1), bad, number(2)});
    EXPECT_TRUE(result.decided);
    EXPECT_EQ(result.verdict, Verdict::greater);
    EXPECT_FALSE(
        evaluate_lane(lane, std::vector<Bits>{number(4), number(4), bad, number(2)}).decided);
  }
  const CombinedResult less =
      evaluate_lane(lane, std::vector<Bits>{number(4), number(4), number(5), number(5)});
  EXPECT_TRUE(less.decided);
  EXPECT_EQ(less.verdict, Verdict::less);
}

TEST(CombinedLane, EachPartHasTheBoundThatItNeeds) {
  const Graph graph = graph_of({{"a * b", "c"}, {"a - b * c", "b"}, {"a", "b"}}, Combination::any);
  const CombinedLane lane = lane_of(graph, LaneInputs::exact, std::vector<std::optional<Range>>(3));
  using error::AbsoluteBoundDecision;
  using error::UlpDistanceDecision;
  EXPECT_TRUE(std::holds_alternative<UlpDistanceDecision>(part_of(lane, 0).decision));
  EXPECT_TRUE(std::holds_alternative<AbsoluteBoundDecision>(part_of(lane, 1).decision));
  EXPECT_TRUE(std::holds_alternative<UlpDistanceDecision>(part_of(lane, 2).decision));
  EXPECT_NE(describe_decision(lane).find("any of 3 parts; part 0 certified"), std::string::npos)
      << describe_decision(lane);
}

TEST(CombinedLane, AnErrorNamesThePart) {
  const Graph graph = graph_of({{"a", "b"}, {"a - b * b", "b"}}, Combination::all);
  const auto lane = error::certified_lanes(
      lane_graphs(graph, format_of(24, 8), {format_of(8, 8)}, LaneInputs::exact),
      {.kind = error::ErrorBoundKind::relative});
  ASSERT_FALSE(lane.ok());
  EXPECT_EQ(lane.error().field, "reduced.error_bound");
  EXPECT_NE(lane.error().message.find("of f[1] and g[1], no relative bound"), std::string::npos)
      << lane.error().message;
}

/// What hardware builds: everything once, a single part as it is.
TEST(SharedLane, BuildsWhatPartsHaveInCommonOnce) {
  const Graph graph = graph_of({{"(a - b)^2", "c"}, {"(a - b)^2 + c", "a"}}, Combination::all);
  const CombinedLane lane =
      lane_of(graph, LaneInputs::exact, std::vector<std::optional<Range>>(3, Range{0, 9}));
  const error::SharedLane shared = share(lane);
  const auto count = [&](Operation operation) {
    return std::count_if(shared.graph.nodes.begin(), shared.graph.nodes.end(),
                         [&](const TypedNode& node) { return node.operation == operation; });
  };
  EXPECT_EQ(count(Operation::input), 3);
  EXPECT_EQ(count(Operation::subtract), 1);
  EXPECT_EQ(count(Operation::square), 1);
  EXPECT_EQ(count(Operation::add), 1);
  EXPECT_EQ(shared.checks.size(), 3u) << "each operand is checked once";
  ASSERT_EQ(shared.hazards.size(), shared.graph.nodes.size());
  EXPECT_EQ(shared.parts[0].sides.f, part_of(lane, 0).graph.f);
  const error::SharedLane alone = share(CombinedLane(part_of(lane, 1)));
  EXPECT_EQ(alone.graph.nodes.size(), part_of(lane, 1).graph.nodes.size());
  EXPECT_EQ(alone.hazards, part_of(lane, 1).hazards);
}

}  // namespace
}  // namespace mixcmp::test
