#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include "model/base/number/exact.hpp"
#include "model/base/number/verdict.hpp"
#include "model/judge/golden/evaluate.hpp"
#include "model/lane/error/certified_lane.hpp"
#include "model/lane/error/profiled_lane.hpp"
#include "tests/support/float_samples.hpp"
#include "tests/support/graphs.hpp"

/// Tests lanes of several parts on every operand tuple of a small format.
namespace mixcmp::test::lane_parts_test {
namespace {

using error::Lane;
using golden::evaluate_lane;
using golden::LaneResult;
using golden::true_verdict;

using Parts = std::vector<std::pair<std::string, std::string>>;

struct Comparison {
  const char* name;
  Parts parts;
  std::optional<Range> range = {};  ///< the range of every input; many operand tuples break it
};

void PrintTo(const Comparison& comparison, std::ostream* stream) {
  *stream << comparison.name;
}

/// The lane of all parts, and for each part the lane that was made from that part only. The
/// separate lanes judge how the whole lane shares nodes and checks among its parts.
struct Judged {
  Lane lane;
  std::vector<Lane> alone;
};

class JudgedLanes {
public:
  JudgedLanes(const Graph& graph, FloatFormat reference, std::optional<Range> range)
      : graph_(graph), reference_(reference), ranges_(graph.inputs().size(), range) {
    const FloatFormat format = format_of(2, 4);
    const Arithmetic flushing = {format, Rounding::nearest_even, Subnormals::flush};
    const Arithmetic gradual = {format, Rounding::toward_zero, Subnormals::gradual};
    for (const auto& kind :
         {std::optional<BoundKind>(), std::optional(BoundKind::relative),
          std::optional(BoundKind::running), std::optional(BoundKind::constant)}) {
      for (const int digits : {1, 4}) {
        add(flushing, LaneInputs::rounded, {.kind = kind, .bound_digits = digits});
        add(gradual, LaneInputs::exact, {.kind = kind, .bound_digits = digits});
      }
    }
    const auto profiled = [](const TypedGraph& typed) {
      return error::profiled_lane(typed, mpq_class(1, 8), mpq_class(1, 4));
    };
    judged_.push_back(judged(gradual, LaneInputs::exact, profiled));
  }

  const std::vector<Judged>& all() const { return judged_; }

private:
  void add(const Arithmetic& arithmetic, LaneInputs inputs, error::CertifiedOptions options) {
    options.ranges = ranges_;
    if (!error::certified_lane(lane_graph(graph_, reference_, arithmetic, inputs), options).ok()) {
      return;
    }
    judged_.push_back(judged(arithmetic, inputs, [&](const TypedGraph& typed) {
      return error::certified_lane(typed, options).value();
    }));
  }

  template <class Make>
  Judged judged(const Arithmetic& arithmetic, LaneInputs inputs, Make make) const {
    const auto lane = [&](const Graph& graph) {
      return make(lane_graph(graph, reference_, arithmetic, inputs));
    };
    Judged result{lane(graph_), {}};
    for (std::size_t part = 0; part < graph_.parts().size(); ++part) {
      result.alone.push_back(lane(graph_.part(part)));
    }
    return result;
  }

  const Graph& graph_;
  FloatFormat reference_;
  std::vector<std::optional<Range>> ranges_;
  std::vector<Judged> judged_;
};

/// The combination of the parts' own decisions. `alone` says that a decided part decides for
/// undecided ones.
struct Expected {
  LaneResult result;
  bool alone;
};

Expected of_parts(const Judged& judged, const std::vector<Bits>& inputs) {
  const bool all = judged.lane.graph.combination == Combination::all;
  const Verdict decides = all ? Verdict::greater : Verdict::less;
  std::size_t decided = 0;
  bool equal = false, outweighed = false;
  for (const Lane& part : judged.alone) {
    const LaneResult result = evaluate_lane(part, inputs);
    if (!result.decided) continue;
    ++decided;
    equal |= result.verdict == Verdict::equal;
    outweighed |= result.verdict == decides;
  }
  const bool every = decided == judged.alone.size();
  if (outweighed) return {{true, decides}, !every};
  const Verdict rest = all ? Verdict::less : Verdict::greater;
  return {{every, equal ? Verdict::equal : rest}, false};
}

/// Compares the decisions of lanes on every operand tuple with those of their parts and with the
/// real numbers.
void hold_on_every_tuple(const Graph& graph, FloatFormat format, const std::vector<Judged>& lanes) {
  const std::size_t count = graph.inputs().size();
  const Bits end = Bits{1} << (count * static_cast<std::size_t>(format.width()));
  std::uint64_t decided = 0, alone = 0;
  for (Bits index = 0; index < end && !testing::Test::HasFailure(); ++index) {
    std::vector<Bits> inputs(count);
    for (std::size_t k = 0; k < count; ++k) {
      inputs[k] =
          index >> (k * static_cast<std::size_t>(format.width())) & low_mask(format.width());
    }
    const Verdict truth = true_verdict(graph, format, inputs).value();
    for (const Judged& judged : lanes) {
      const Lane& lane = judged.lane;
      const LaneResult result = evaluate_lane(lane, inputs);
      const Expected expected = of_parts(judged, inputs);
      EXPECT_EQ(result.decided, expected.result.decided) << describe_criterion(lane);
      if (!result.decided) continue;
      ++decided;
      alone += expected.alone ? 1 : 0;
      EXPECT_EQ(to_string(result.verdict), to_string(expected.result.verdict))
          << describe_criterion(lane);
      if (!lane.certified()) continue;
      EXPECT_EQ(to_string(result.verdict), to_string(truth)) << describe_criterion(lane);
    }
  }
  EXPECT_GT(decided, 0u);
  EXPECT_GT(alone, 0u) << "no part ever decided for the others";
}

class EveryTuple : public testing::TestWithParam<std::tuple<Comparison, Combination>> {};

TEST_P(EveryTuple, IsDecidedAsThePartsSayAndAsTheRealNumbersAre) {
  const auto& [comparison, combination] = GetParam();
  const Graph graph = graph_of(comparison.parts, combination);
  const FloatFormat format = graph.inputs().size() <= 2 ? format_of(3, 4) : format_of(3, 2);
  hold_on_every_tuple(graph, format, JudgedLanes(graph, format, comparison.range).all());
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

/// The bounds of a quotient and of a root hold on a condition. The condition names a node whose
/// number in the lane of both parts differs from its number in the part's own lane.
TEST(EveryTupleOfAPart, IsDecidedWhereTheConditionsOfItsOwnNodesHold) {
  const FloatFormat format = format_of(3, 4);
  for (const char* f : {"b / (a * a - b)", "sqrt(a * a - b)"}) {
    const Graph graph = graph_of({{"a + b", "1.5"}, {f, "a"}}, Combination::all);
    const auto lane = [&](const Graph& of) {
      const auto typed = lane_graph(of, format, {format_of(2, 4)}, LaneInputs::rounded);
      return error::certified_lane(typed, {.kind = BoundKind::running}).value();
    };
    const Judged judged{lane(graph), {lane(graph.part(0)), lane(graph.part(1))}};
    hold_on_every_tuple(graph, format, {judged});
  }
}

Lane lane_of(const Graph& graph, LaneInputs inputs,
             const std::vector<std::optional<Range>>& ranges) {
  return error::certified_lane(lane_graph(graph, format_of(24, 8), {format_of(8, 8)}, inputs),
                               {.ranges = ranges})
      .value();
}

/// Operands of one part that are out of range or NaN keep no other part from deciding for all.
TEST(Lane, APartIsHarmedOnlyByWhatItDependsOn) {
  const Graph graph = graph_of({{"a + b", "a * b"}, {"c + d", "c * d"}}, Combination::all);
  const Lane lane =
      lane_of(graph, LaneInputs::exact, std::vector<std::optional<Range>>(4, Range{1, 16}));
  EXPECT_EQ(lane.parts[0].checks.size(), 2u);
  EXPECT_EQ(lane.parts[1].checks.size(), 2u);
  const FloatFormat format = format_of(24, 8);
  const auto number = [&](int value) { return from_rational(format, mpq_class(value)); };
  const Bits nan = format.quiet_nan(), far = number(1000);
  // Part 0 is greater, since 2 + 2 > 1; part 1 is undecided.
  for (const Bits bad : {nan, far, format.infinity(true)}) {
    const LaneResult result =
        evaluate_lane(lane, std::vector<Bits>{number(1), number(1), bad, number(2)});
    EXPECT_TRUE(result.decided);
    EXPECT_EQ(result.verdict, Verdict::greater);
    EXPECT_FALSE(
        evaluate_lane(lane, std::vector<Bits>{number(4), number(4), bad, number(2)}).decided);
  }
  const LaneResult less =
      evaluate_lane(lane, std::vector<Bits>{number(4), number(4), number(5), number(5)});
  EXPECT_TRUE(less.decided);
  EXPECT_EQ(less.verdict, Verdict::less);
}

TEST(Lane, EachPartHasTheBoundThatItNeeds) {
  const Graph graph = graph_of({{"a * b", "c"}, {"a - b * c", "b"}, {"a", "b"}}, Combination::any);
  const Lane lane = lane_of(graph, LaneInputs::exact, std::vector<std::optional<Range>>(3));
  using error::AbsoluteBoundCriterion;
  using error::UlpDistanceCriterion;
  EXPECT_TRUE(std::holds_alternative<UlpDistanceCriterion>(lane.parts[0].criterion));
  EXPECT_TRUE(std::holds_alternative<AbsoluteBoundCriterion>(lane.parts[1].criterion));
  EXPECT_TRUE(std::holds_alternative<UlpDistanceCriterion>(lane.parts[2].criterion));
  EXPECT_NE(describe_criterion(lane).find("any of 3 parts; part 0 certified"), std::string::npos)
      << describe_criterion(lane);
}

TEST(Lane, AnErrorNamesThePart) {
  const Graph graph = graph_of({{"a", "b"}, {"a - b * b", "b"}}, Combination::all);
  const auto lane = error::certified_lane(
      lane_graph(graph, format_of(24, 8), {format_of(8, 8)}, LaneInputs::exact),
      {.kind = BoundKind::relative});
  ASSERT_FALSE(lane.ok());
  EXPECT_EQ(lane.error().field, "reduced.error_bound");
  EXPECT_NE(lane.error().message.find("of f[1] and g[1], no relative bound"), std::string::npos)
      << lane.error().message;
}

TEST(Lane, HasWhatPartsHaveInCommonOnce) {
  const Graph graph = graph_of({{"(a - b)^2", "c"}, {"(a - b)^2 + c", "a"}}, Combination::all);
  const Lane lane =
      lane_of(graph, LaneInputs::exact, std::vector<std::optional<Range>>(3, Range{0, 9}));
  const auto count = [&](Operation operation) {
    return std::count_if(lane.graph.nodes.begin(), lane.graph.nodes.end(),
                         [&](const TypedNode& node) { return node.operation == operation; });
  };
  EXPECT_EQ(count(Operation::input), 3);
  EXPECT_EQ(count(Operation::subtract), 1);
  EXPECT_EQ(count(Operation::square), 1);
  EXPECT_EQ(count(Operation::add), 1);
  EXPECT_EQ(lane.checks.size(), 3u) << "each operand is checked once";
  EXPECT_EQ(lane.hazards.size(), lane.graph.nodes.size());
}

TEST(Lane, ANodeThatPartsShareKeepsTheHazardsOfEither) {
  const Graph graph = graph_of({{"a + b", "c"}, {"a + b", "a"}}, Combination::all);
  const TypedGraph typed =
      lane_graph(graph, format_of(24, 8), {format_of(8, 8)}, LaneInputs::rounded);
  const error::Hazards none = {false, false, false, false}, all;
  std::vector<Lane> lanes;
  for (const error::Hazards& hazards : {none, all}) {
    lanes.push_back(
        error::one_part_lane(part_of(typed, lanes.size()).graph, error::UlpDistanceCriterion{}));
    lanes.back().hazards.assign(lanes.back().graph.nodes.size(), hazards);
  }
  for (const bool swapped : {false, true}) {
    if (swapped) std::swap(lanes[0].hazards[0], lanes[1].hazards[0]);
    auto next = lanes.begin();
    const Lane lane = error::lane_of_parts(typed, [&](const TypedGraph&) -> Result<Lane> {
                        return *next++;
                      }).value();
    const auto part_0 = nodes_of_part(lane, 0), part_1 = nodes_of_part(lane, 1);
    for (std::size_t id = swapped ? 1 : 0; id < lane.hazards.size(); ++id) {
      EXPECT_EQ(lane.hazards[id], part_1[id] ? all : none) << id;
      EXPECT_TRUE(part_0[id] || part_1[id]);
    }
    EXPECT_EQ(lane.hazards[0], all) << "whichever part needs it";
  }
}

/// An extracted part has the criterion, checks and nodes of the lane that was made of that part
/// only. It keeps the hazards of nodes that it shared.
TEST(Lane, APartIsTheLaneOfThatPart) {
  const Graph graph =
      graph_of({{"(a - b)^2", "c"}, {"(a - b)^2 + c", "a - b * c"}, {"a", "b"}}, Combination::any);
  const std::vector<std::optional<Range>> ranges = {Range{1, 9}, std::nullopt, Range{-1, 9}};
  const Lane lane = lane_of(graph, LaneInputs::rounded, ranges);
  for (std::size_t part = 0; part < 3; ++part) {
    const Lane extracted = part_of(lane, part);
    const Lane alone = lane_of(graph.part(part), LaneInputs::rounded, ranges);
    EXPECT_EQ(extracted.criterion().index(), alone.criterion().index()) << part;
    EXPECT_EQ(describe_criterion(extracted), describe_criterion(alone)) << part;
    EXPECT_EQ(extracted.checks, alone.checks) << part;
    EXPECT_EQ(extracted.graph.nodes.size(), alone.graph.nodes.size()) << part;
  }
}

}  // namespace
}  // namespace mixcmp::test::lane_parts_test
